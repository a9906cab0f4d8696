// A run as the page is given it: in its own elements, or by `sluice view --serve`.

/** Low and high end of the colours, and of all values; null: the medium has none. */
export type Ranges = [number, number, number, number] | null;

export interface Field {
    name: string;
    unit: string;
    ranges: [Ranges, Ranges, Ranges];
}

export const media = ["fluid", "solid", "wall"] as const;

export interface Group {
    name: string;
    medium: number;
    spacing: number;
}

export interface Plane {
    name: string;
    point: [number, number, number];
    normal: [number, number, number];
}

export interface Run {
    version: string;
    live: boolean;
    more?: boolean;
    title: string;
    directory: string;
    status: string;
    dimension: 2 | 3;
    end: number;
    up: [number, number, number];
    bounds: [[number, number], [number, number], [number, number]];
    groups: Group[];
    planes: Plane[];
    fields: Field[];
    maps: Record<string, number[]>;
    /** Time, step, particles. */
    frames: [number, number, number][];
}

export interface Effect {
    on: boolean;
    name: string;
    why: string;
    equation: string;
}

export interface Summary {
    effects?: Record<string, Effect>;
    [key: string]: unknown;
}

export interface Source {
    run(): Promise<Run>;
    summary(): Promise<Summary>;
    probes(): Promise<string>;
    frame(index: number): Promise<Uint8Array<ArrayBuffer>>;
}

const text = (id: string) => document.getElementById(id)?.textContent ?? "";

const bytesOf = (base64: string): Uint8Array<ArrayBuffer> => {
    const letters = atob(base64);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
    return bytes;
};

const json = (words: string): Summary => {
    try {
        return JSON.parse(words) as Summary;
    } catch {
        return {}; // a run that has no summary yet
    }
};

const stored: Source = {
    run: async () => JSON.parse(text("run")) as Run,
    summary: async () => json(text("summary")),
    probes: async () => text("probes"),
    frame: async (index) => bytesOf(text(`frame-${index}`)),
};

const asked = async (path: string) => {
    const answer = await fetch(path, { cache: "no-store" });
    if (!answer.ok) throw new Error(`${path}: ${answer.status} ${await answer.text()}`);
    return answer;
};

const served: Source = {
    run: async () => (await (await asked("run.json")).json()) as Run,
    summary: async () => json(await (await asked("summary.json")).text()),
    probes: async () => (await asked("probes.csv")).text(),
    frame: async (index) => new Uint8Array(await (await asked(`frame/${index}`)).arrayBuffer()),
};

export const source = (): Source => (document.getElementById("run") ? stored : served);
