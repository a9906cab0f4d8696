// Elements by id, and made.

export const element = <T extends HTMLElement = HTMLElement>(id: string): T => {
    const found = document.getElementById(id);
    if (!found) throw new Error(`the page lacks #${id}`);
    return found as T;
};

export const make = <K extends keyof HTMLElementTagNameMap>(
    tag: K,
    properties: Partial<HTMLElementTagNameMap[K]> = {},
    ...children: (Node | string)[]
): HTMLElementTagNameMap[K] => {
    const made = Object.assign(document.createElement(tag), properties);
    made.append(...children);
    return made;
};

export const cssColor = (name: string): string =>
    getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** "#98a1ab" as parts of one. */
export const rgb = (color: string): [number, number, number] =>
    [1, 3, 5].map((at) => parseInt(color.slice(at, at + 2), 16) / 255) as [number, number, number];
