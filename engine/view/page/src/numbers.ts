// Numbers and names as people read them.

const prefixes: [number, string][] = [
    [1e9, "G"],
    [1e6, "M"],
    [1e3, "k"],
    [1, ""],
];

/** What a unit is shown in, for values up to `size`: 12000 Pa as 12 kPa, 0.02 m as 20 mm. */
export const shownUnit = (unit: string, size: number): { unit: string; factor: number } => {
    if (unit === "m" && size > 0 && size < 0.5) return { unit: "mm", factor: 1e3 };
    if (unit.startsWith("Pa")) {
        const [value, letter] = prefixes.find(([limit]) => size >= limit) ?? prefixes[3];
        return { unit: letter + unit, factor: 1 / value };
    }
    return { unit, factor: 1 };
};

/** With so many significant digits, without a tail of zeros. */
export const short = (value: number, digits = 3): string => {
    if (!Number.isFinite(value)) return "–";
    if (value === 0) return "0";
    const size = Math.abs(value);
    if (size >= 1e6 || size < 1e-4)
        return value
            .toExponential(digits - 1)
            .replace(/\.?0+e/, "e")
            .replace("e+", "e");
    const text = value.toPrecision(digits);
    const plain = text.includes("e") ? String(Math.round(value)) : text;
    return (plain.includes(".") ? plain.replace(/\.?0+$/, "") : plain).replace("-", "−");
};

/** A step of 1, 2 or 5 times a power of ten, at least `least`. */
export const evenStep = (least: number): number => {
    const power = 10 ** Math.floor(Math.log10(least));
    return power * ([1, 2, 5, 10].find((k) => k * power >= least * (1 - 1e-9)) ?? 10);
};

/** Decimals that tell multiples of a step apart. */
export const decimals = (step: number): number => Math.max(0, -Math.floor(Math.log10(step) + 1e-9));

const words: Record<string, string> = { von_mises: "von Mises stress", green: "Green" };

export const fieldLabel = (name: string): string => {
    if (words[name]) return words[name];
    return name
        .split("_")
        .map((word) => words[word] ?? word)
        .join(" ");
};

export const withUnit = (label: string, unit: string): string => (unit ? `${label} [${unit}]` : label);

/** Enough decimals for the steps between frames. */
export const timeText = (time: number, end: number): string =>
    `t = ${time.toFixed(Math.max(0, 4 - Math.ceil(Math.log10(Math.max(end, 1e-3)) + 1)))} s`;
