// Packed frames, as engine/view/frame_packing.hpp describes them.

export interface ColumnHead {
    name: string;
    width: 2 | 4;
    low: number;
    high: number;
    bytes: number;
}

export interface FrameHead {
    time: number;
    step: number;
    particles: number;
    columns: ColumnHead[];
}

const inflate = async (bytes: Uint8Array<ArrayBuffer>): Promise<Uint8Array> => {
    const stream = new Response(bytes).body!.pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
};

const highestStep = 65534;

/** A frame whose columns are unpacked when they are asked for, once. */
export class Frame {
    readonly head: FrameHead;
    private readonly offsets = new Map<string, [ColumnHead, number]>();
    private readonly steps16 = new Map<string, Uint16Array>();
    private readonly numbers = new Map<string, Float32Array>();
    private readonly identities = new Map<string, Uint32Array>();

    constructor(private readonly packed: Uint8Array<ArrayBuffer>) {
        const view = new DataView(packed.buffer, packed.byteOffset);
        const length = view.getUint32(0, true);
        this.head = JSON.parse(new TextDecoder().decode(packed.subarray(4, 4 + length))) as FrameHead;
        let offset = 4 + length;
        for (const column of this.head.columns) {
            this.offsets.set(column.name, [column, offset]);
            offset += column.bytes;
        }
    }

    get count(): number {
        return this.head.particles;
    }

    /** Held in memory. [bytes] */
    get size(): number {
        let size = this.packed.byteLength;
        for (const store of [this.steps16, this.numbers, this.identities])
            for (const column of store.values()) size += column.byteLength;
        return size;
    }

    has(name: string): boolean {
        return this.offsets.has(name) || (name === "speed" && this.offsets.has("velocity_x"));
    }

    range(name: string): [number, number] {
        const found = this.offsets.get(name);
        return found ? [found[0].low, found[0].high] : [0, 0];
    }

    private async planes(name: string): Promise<Uint8Array> {
        const found = this.offsets.get(name);
        if (!found) throw new Error(`the frame at ${this.head.time} s lacks ${name}`);
        const [column, offset] = found;
        return inflate(this.packed.subarray(offset, offset + column.bytes));
    }

    /** 0 … 65534 between the column's low and high end, 65535 = no value. */
    async steps(name: string): Promise<Uint16Array> {
        const known = this.steps16.get(name);
        if (known) return known;
        const planes = await this.planes(name);
        const n = this.count;
        const values = new Uint16Array(n);
        let before = 0;
        for (let i = 0; i < n; ++i) {
            const folded = planes[i] | (planes[n + i] << 8);
            before = (before + ((folded >>> 1) ^ -(folded & 1))) & 0xffff;
            values[i] = before;
        }
        this.steps16.set(name, values);
        return values;
    }

    async values(name: string): Promise<Float32Array> {
        const known = this.numbers.get(name);
        if (known) return known;
        const values = this.offsets.has(name) ? await this.plainValues(name) : await this.speed();
        this.numbers.set(name, values);
        return values;
    }

    private async plainValues(name: string): Promise<Float32Array> {
        const [low, high] = this.range(name);
        const steps = await this.steps(name);
        this.steps16.delete(name);
        const values = new Float32Array(steps.length);
        const scale = (high - low) / highestStep;
        for (let i = 0; i < steps.length; ++i) values[i] = steps[i] > highestStep ? NaN : low + scale * steps[i];
        return values;
    }

    private async speed(): Promise<Float32Array> {
        const names = ["velocity_x", "velocity_y", "velocity_z"].filter((name) => this.offsets.has(name));
        const parts = await Promise.all(names.map((name) => this.values(name)));
        for (const name of names) this.numbers.delete(name); // of use for this alone
        const speed = new Float32Array(this.count);
        for (const part of parts) for (let i = 0; i < speed.length; ++i) speed[i] += part[i] * part[i];
        for (let i = 0; i < speed.length; ++i) speed[i] = Math.sqrt(speed[i]);
        return speed;
    }

    async numbersOf(name: string): Promise<Uint32Array> {
        const known = this.identities.get(name);
        if (known) return known;
        const planes = await this.planes(name);
        const n = this.count;
        const values = new Uint32Array(n);
        let before = 0;
        for (let i = 0; i < n; ++i) {
            const folded = planes[i] | (planes[n + i] << 8) | (planes[2 * n + i] << 16) | (planes[3 * n + i] << 24);
            before = (before + ((folded >>> 1) ^ -(folded & 1))) | 0;
            values[i] = before;
        }
        this.identities.set(name, values);
        return values;
    }

    /** Place of one particle [m]; positions must have been unpacked. */
    place(i: number): [number, number, number] {
        const at = (name: string) => {
            const steps = this.steps16.get(name);
            if (!steps) return 0;
            const [low, high] = this.range(name);
            return low + ((high - low) * steps[i]) / highestStep;
        };
        return [at("x"), at("y"), at("z")];
    }
}
