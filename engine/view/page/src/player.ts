// Which frame is shown, and when the next one is.

export class Player {
    index = 0;
    playing = false;
    count = 0;
    loop = true;
    perSecond = 20;
    /** Frames shown per second while playing, over the last second. */
    measured = 0;
    private last = 0;
    private shown: number[] = [];
    private busy = false;

    /** `show` ends when the frame is on the screen. */
    constructor(
        private readonly show: (index: number) => Promise<void>,
        private readonly changed: () => void,
    ) {}

    async go(index: number): Promise<void> {
        this.index = Math.max(0, Math.min(this.count - 1, index));
        if (this.busy) return; // the one on its way looks again when it is done
        this.busy = true;
        try {
            let done = -1;
            while (done !== this.index) await this.show((done = this.index));
        } finally {
            this.busy = false;
        }
    }

    toggle(playing = !this.playing): void {
        if (playing && this.index === this.count - 1) void this.go(0);
        this.playing = playing && this.count > 1;
        this.changed();
        if (this.playing) requestAnimationFrame((now) => this.tick((this.last = now)));
    }

    private tick(now: number): void {
        if (!this.playing) return;
        requestAnimationFrame((next) => this.tick(next));
        if (this.busy || now - this.last < 1000 / this.perSecond - 4) return;
        this.shown = [...this.shown.filter((at) => now - at < 1000), now];
        this.measured = this.shown.length;
        this.last = now;
        if (this.index + 1 < this.count) void this.go(this.index + 1);
        else if (this.loop) void this.go(0);
        else this.toggle(false);
    }
}
