// Frames in memory: those shown last, and those that will be shown next.
import type { Source } from "./run";
import { Frame } from "./unpack";

/** What may be kept unpacked. A browser's tab has some GB; 200 frames of 100,000 particles in 3D take 0.4 GB. [bytes] */
const budget = 700e6;

export class FrameStore {
    /** In the order of their last use. */
    private readonly kept = new Map<number, Promise<Frame>>();
    private readonly sizes = new Map<number, number>();

    constructor(private readonly source: Source) {}

    get(index: number): Promise<Frame> {
        let frame = this.kept.get(index);
        if (frame) this.kept.delete(index);
        else {
            frame = this.source.frame(index).then((bytes) => new Frame(bytes));
            frame.catch(() => this.kept.delete(index)); // may be asked for again
        }
        this.kept.set(index, frame);
        return frame;
    }

    /** To be called when columns have been unpacked. */
    note(index: number, frame: Frame): void {
        this.sizes.set(index, frame.size);
        let sum = 0;
        for (const size of this.sizes.values()) sum += size;
        for (const old of [...this.kept.keys()]) {
            if (sum <= budget || old === index) break;
            sum -= this.sizes.get(old) ?? 0;
            this.kept.delete(old);
            this.sizes.delete(old);
        }
    }
}
