// The page: what belongs together is in the other files; here it is joined.
import { Camera, type Vec3 } from "./camera";
import { Colors } from "./colors";
import { Curves } from "./curves";
import { cssColor, element, make, rgb } from "./dom";
import { FrameStore } from "./frames";
import { short, timeText } from "./numbers";
import { Overlay } from "./overlay";
import { pickAt, showPicked, type Picked } from "./pick";
import { Picture, type Look } from "./picture";
import { Player } from "./player";
import { source, type Run } from "./run";
import { showHead, showKeys, showSummary } from "./texts";
import type { Frame } from "./unpack";

/** Frames that are unpacked before their turn. */
const ahead = 4;
/** Between questions for new frames [ms]. */
const pollEvery = 1000;
const speeds = [1, 2, 5, 10, 20, 30, 60];

/** How the page is doing, for tests. */
const status = {
    ready: false,
    frames: 0,
    particles: 0,
    frame: -1,
    drawn: 0,
    time: 0,
    playing: false,
    fps: 0,
    errors: [] as string[],
};
Object.assign(window, { sluice: status });

const tell = (problem: unknown): void => {
    const words = problem instanceof Error ? problem.message : String(problem);
    status.errors.push(words);
    const box = element("message");
    box.hidden = false;
    box.textContent = words;
};
window.addEventListener("error", (event) => tell(event.error ?? event.message));
window.addEventListener("unhandledrejection", (event) => tell(event.reason));

class Page {
    private readonly store: FrameStore;
    private readonly camera: Camera;
    private readonly picture: Picture;
    private readonly overlay = new Overlay(
        element<HTMLCanvasElement>("underlay"),
        element<HTMLCanvasElement>("overlay"),
    );
    private readonly colors: Colors;
    private readonly curves: Curves;
    private readonly player: Player;
    private readonly shown: boolean[];
    private frame: Frame | null = null;
    private picked: Picked | null = null;
    private pickedPlace: Vec3 | null = null;
    private size = 1;
    private drawAsked = false;

    constructor(
        private run: Run,
        private readonly from = source(),
    ) {
        this.store = new FrameStore(from);
        this.camera = new Camera(run.dimension, run.up);
        this.picture = new Picture(element<HTMLCanvasElement>("picture"), run);
        this.colors = new Colors(run, () => void this.recolor());
        this.curves = new Curves((time) => void this.player.go(this.frameAt(time)));
        this.player = new Player(
            (index) => this.show(index),
            () => this.showPlaying(),
        );
        this.shown = run.groups.map(() => true);
        element("stage").classList.toggle("solid-stage", run.dimension === 3);
        this.connect();
        this.connectMouse();
        this.showGroups();
        this.take(run);
    }

    async start(): Promise<void> {
        new ResizeObserver(() => this.resize()).observe(element("stage"));
        this.resize();
        this.setLooks();
        showSummary(this.run, await this.from.summary());
        this.curves.set(await this.from.probes());
        await this.player.go(this.run.live ? this.run.frames.length - 1 : 0);
        await showPicked(null, this.run, null);
        status.ready = true;
        if (this.run.live) setTimeout(() => void this.poll(), pollEvery);
    }

    /** A head, new or again. */
    private take(run: Run): void {
        this.run = run;
        this.player.count = status.frames = run.frames.length;
        element<HTMLInputElement>("slider").max = String(run.frames.length - 1);
        showHead(run);
        element("follow-label").hidden = !run.live;
    }

    private async poll(): Promise<void> {
        let wait = pollEvery;
        try {
            const run = await this.from.run();
            const grown = run.frames.length !== this.run.frames.length;
            const atEnd = this.player.index >= this.run.frames.length - 1;
            const ended = run.status !== this.run.status;
            this.take(run);
            if (grown || ended) {
                showSummary(run, await this.from.summary());
                this.curves.set(await this.from.probes());
                this.colors.update(run);
                this.setLooks();
                if (this.camera.untouched) this.fit();
            }
            const follow = element<HTMLInputElement>("follow").checked && !this.player.playing;
            if (grown && follow && atEnd) await this.player.go(run.frames.length - 1);
            else this.showCounter();
            if (run.more) wait = 0;
            element("message").hidden = true;
        } catch (problem) {
            element("message").hidden = false;
            element("message").textContent = "The server does not answer any more; what was loaded can still be seen.";
            void problem;
            wait = 5 * pollEvery;
        }
        setTimeout(() => void this.poll(), wait);
    }

    private frameAt(time: number): number {
        let best = 0;
        this.run.frames.forEach(([t], k) => {
            if (Math.abs(t - time) < Math.abs(this.run.frames[best][0] - time)) best = k;
        });
        return best;
    }

    private get fields(): (string | null)[] {
        return this.colors.choices.map((choice) => choice?.field ?? null);
    }

    private async show(index: number): Promise<void> {
        const frame = await this.store.get(index);
        const put = await this.picture.load(frame, this.fields);
        this.store.note(index, frame);
        put();
        this.frame = frame;
        Object.assign(status, {
            frame: index,
            particles: frame.count,
            time: frame.head.time,
            fps: this.player.measured,
        });
        this.showCounter();
        element<HTMLInputElement>("slider").value = String(index);
        this.curves.setTime(frame.head.time);
        if (this.picked) this.pickedPlace = await showPicked(frame, this.run, this.picked);
        this.redraw();
        if (this.player.playing) this.prepare(index);
    }

    private prepare(index: number): void {
        for (let k = 1; k <= ahead; ++k) {
            const next = (index + k) % this.player.count;
            void this.store.get(next).then(async (frame) => {
                await this.picture.prepare(frame, this.fields);
                this.store.note(next, frame);
            });
        }
    }

    private async recolor(): Promise<void> {
        this.setLooks();
        if (this.frame) (await this.picture.load(this.frame, this.fields))();
        this.redraw();
    }

    private setLooks(): void {
        const wall = rgb(cssColor("--wall"));
        const maps = Object.keys(this.run.maps);
        this.picture.setLooks(
            this.run.groups.map(({ medium }, g): Look => {
                const choice = this.colors.choices[medium];
                const map = choice?.field ? maps.indexOf(choice.map) : -1;
                const plain: Look["plain"][] = [[0.27, 0.55, 0.78], [0.82, 0.5, 0.26], wall];
                return {
                    shown: this.shown[g],
                    map,
                    low: choice?.low ?? 0,
                    high: choice?.high ?? 1,
                    plain: choice?.field ? wall : plain[medium],
                };
            }),
        );
        this.redraw();
    }

    private redraw(): void {
        if (this.drawAsked) return;
        this.drawAsked = true;
        requestAnimationFrame(() => {
            this.drawAsked = false;
            status.drawn = this.picture.draw(this.camera, this.size);
            const radius = this.picked
                ? 0.5 * this.size * this.run.groups[this.picked.group].spacing * this.camera.pixelsPerMetre
                : 0;
            this.overlay.draw(this.camera, this.run, this.pickedPlace && { place: this.pickedPlace, radius });
        });
    }

    private resize(): void {
        const stage = element("stage");
        this.camera.width = Math.max(1, stage.clientWidth);
        this.camera.height = Math.max(1, stage.clientHeight);
        if (this.camera.untouched) this.fit();
        this.redraw();
    }

    private fit(): void {
        this.camera.fit(this.run.bounds, Math.max(...this.run.groups.map((group) => group.spacing)));
        this.redraw();
    }

    private showCounter(): void {
        const { frames, end } = this.run;
        element("counter").textContent = `${this.player.index + 1} / ${frames.length}`;
        const time = frames[this.player.index]?.[0] ?? 0;
        element("clock").textContent = timeText(
            time,
            (Math.max(end, frames.at(-1)?.[0] ?? 0) / Math.max(1, frames.length)) * 10,
        );
    }

    private showPlaying(): void {
        status.playing = this.player.playing;
        element("play").textContent = this.player.playing ? "Pause" : "Play";
    }

    private showGroups(): void {
        element("groups").replaceChildren(
            ...this.run.groups.map((group, g) => {
                const box = make("input", { type: "checkbox", checked: true });
                box.onchange = () => {
                    this.shown[g] = box.checked;
                    this.setLooks();
                };
                const medium = make("span", { className: "muted" }, ["fluid", "solid", "wall"][group.medium]);
                return make(
                    "label",
                    { className: "row" },
                    make("span", { className: "check" }, box, group.name),
                    medium,
                );
            }),
        );
    }

    private connect(): void {
        const { player } = this;
        const click = (id: string, deed: () => void) => (element(id).onclick = deed);
        const go = (index: number) => {
            player.toggle(false);
            void player.go(index);
        };
        click("play", () => player.toggle());
        click("first", () => go(0));
        click("last", () => go(player.count - 1));
        click("back", () => go(player.index - 1));
        click("next", () => go(player.index + 1));
        click("home", () => this.fit());
        click("theme", () => this.turnTheme());
        const panel = () => document.body.classList.toggle("no-panel");
        click("panel-toggle", panel);
        click("help-toggle", () => element<HTMLDialogElement>("help").showModal());
        element("slider").oninput = () => go(Number(element<HTMLInputElement>("slider").value));
        element("loop").onchange = () => (player.loop = element<HTMLInputElement>("loop").checked);
        element("size").oninput = () => {
            this.size = Number(element<HTMLInputElement>("size").value);
            this.redraw();
        };
        const speed = element<HTMLSelectElement>("speed");
        for (const value of speeds)
            speed.append(
                make("option", { value: String(value), selected: value === player.perSecond }, `${value} frames/s`),
            );
        speed.onchange = () => (player.perSecond = Number(speed.value));
        const faster = (by: number) => {
            speed.selectedIndex = Math.max(0, Math.min(speeds.length - 1, speed.selectedIndex + by));
            player.perSecond = Number(speed.value);
        };
        const keys: Record<string, (event: KeyboardEvent) => void> = {
            " ": () => player.toggle(),
            Home: () => go(0),
            End: () => go(player.count - 1),
            ArrowLeft: (event) => go(player.index - (event.shiftKey ? 10 : 1)),
            ArrowRight: (event) => go(player.index + (event.shiftKey ? 10 : 1)),
            "+": () => faster(1),
            "=": () => faster(1),
            "-": () => faster(-1),
            r: () => this.fit(),
            p: panel,
            t: () => this.turnTheme(),
            "?": () => element<HTMLDialogElement>("help").showModal(),
        };
        document.addEventListener("keydown", (event) => {
            const at = event.target as HTMLElement;
            const typing = at.tagName === "SELECT" || (at instanceof HTMLInputElement && at.type === "number");
            const deed = keys[event.key.length === 1 ? event.key.toLowerCase() : event.key];
            if (!deed || typing || event.ctrlKey || event.metaKey || event.altKey) return;
            event.preventDefault();
            deed(event);
        });
    }

    private connectMouse(): void {
        const canvas = element("overlay");
        let moved = 0;
        canvas.onpointerdown = (event) => {
            canvas.setPointerCapture(event.pointerId);
            moved = 0;
        };
        canvas.onpointermove = (event) => {
            if (event.buttons) {
                moved += Math.abs(event.movementX) + Math.abs(event.movementY);
                const turn = this.run.dimension === 3 && event.buttons === 1 && !event.shiftKey;
                if (turn) this.camera.turn(event.movementX, event.movementY);
                else this.camera.pan(event.movementX, event.movementY);
                this.redraw();
            }
            if (this.run.dimension === 2) {
                const [x, y] = this.camera.placeAt(event.offsetX, event.offsetY);
                element("place").textContent = `x = ${short(x, 4)} m, y = ${short(y, 4)} m`;
            }
        };
        canvas.onpointerleave = () => (element("place").textContent = "");
        canvas.onpointerup = (event) => {
            if (moved < 4 && event.button === 0) void this.pick(event.offsetX, event.offsetY);
        };
        canvas.ondblclick = () => this.fit();
        canvas.oncontextmenu = (event) => event.preventDefault();
        canvas.addEventListener(
            "wheel",
            (event) => {
                event.preventDefault();
                const lines = event.deltaMode === 1 ? 30 * event.deltaY : event.deltaY;
                this.camera.zoom(Math.exp(0.0015 * lines), event.offsetX, event.offsetY);
                this.redraw();
            },
            { passive: false },
        );
    }

    private async pick(x: number, y: number): Promise<void> {
        if (!this.frame) return;
        this.picked = await pickAt(this.frame, this.run, this.camera, this.shown, this.size, x, y);
        this.pickedPlace = await showPicked(this.frame, this.run, this.picked);
        this.redraw();
    }

    private turnTheme(): void {
        setTheme(theme() === "dark" ? "light" : "dark");
        this.curves.build();
        this.setLooks();
    }
}

const theme = () => document.documentElement.dataset.theme;
const setTheme = (name: string): void => {
    document.documentElement.dataset.theme = name;
    element("theme").textContent = name === "dark" ? "Light" : "Dark";
};

const begin = async (): Promise<void> => {
    setTheme(matchMedia("(prefers-color-scheme: dark)").matches ? "dark" : "light");
    showKeys();
    const page = new Page(await source().run());
    await page.start();
};
begin().catch(tell);
