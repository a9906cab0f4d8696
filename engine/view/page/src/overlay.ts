// Lines and words behind the particles (walls in 2D, the box in 3D), and over them (rulers, axes, the picked one).
import type { Camera, Vec3 } from "./camera";
import { cssColor } from "./dom";
import { decimals, evenStep, shownUnit } from "./numbers";
import type { Run } from "./run";

/** Between the rulers' labels [px]. */
const labelDistance = 90;
const font = '11px system-ui, "Segoe UI", Helvetica, Arial, "Liberation Sans", sans-serif';

export class Overlay {
    private readonly behind: CanvasRenderingContext2D;
    private readonly above: CanvasRenderingContext2D;
    private drawn = "";
    private ringed = false;

    constructor(behind: HTMLCanvasElement, above: HTMLCanvasElement) {
        this.behind = behind.getContext("2d")!;
        this.above = above.getContext("2d")!;
    }

    draw(camera: Camera, run: Run, picked: { place: Vec3; radius: number } | null): void {
        // Both change with the view, not from frame to frame.
        const state = [camera.clip(), camera.width, camera.height, run.bounds, cssColor("--page")].join();
        const fresh = state !== this.drawn;
        this.drawn = state;
        if (fresh) {
            this.clear(this.behind, camera);
            if (run.dimension === 2) this.planes(camera, run);
            else this.box(camera, run);
        }
        if (!fresh && !picked && !this.ringed) return;
        this.ringed = picked !== null;
        this.clear(this.above, camera);
        if (run.dimension === 2) this.rulers(camera);
        else this.triad(camera);
        if (picked) this.ring(camera, picked);
    }

    private clear(context: CanvasRenderingContext2D, camera: Camera): void {
        const ratio = window.devicePixelRatio || 1;
        const [w, h] = [Math.round(camera.width * ratio), Math.round(camera.height * ratio)];
        const { canvas } = context;
        if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.clearRect(0, 0, camera.width, camera.height);
        context.font = font;
        context.lineWidth = 1;
    }

    /** Mirror walls are whole planes. */
    private planes(camera: Camera, run: Run): void {
        const context = this.behind;
        const clip = camera.clip();
        const far = camera.width + camera.height;
        context.strokeStyle = cssColor("--wall");
        for (const { point, normal } of run.planes) {
            const [x, y] = camera.project(point, clip);
            const along = [normal[1], normal[0]]; // on the screen, y points down
            context.lineWidth = 1.5;
            this.line(context, x - far * along[0], y - far * along[1], x + far * along[0], y + far * along[1]);
        }
        context.lineWidth = 1;
    }

    private rulers(camera: Camera): void {
        const context = this.above;
        const scale = camera.pixelsPerMetre;
        const step = evenStep(labelDistance / scale);
        const { unit, factor } = shownUnit("m", Math.max(camera.width, camera.height) / scale);
        const digits = decimals(step * factor);
        const [left, top] = camera.placeAt(0, 0);
        const [right, bottom] = camera.placeAt(camera.width, camera.height);
        context.fillStyle = cssColor("--muted");
        context.strokeStyle = cssColor("--muted");
        const label = (value: number) =>
            (value * factor)
                .toFixed(digits)
                .replace("-", "−")
                .replace(/^−(0(\.0*)?)$/, "$1");
        context.textAlign = "center";
        for (let k = Math.ceil(left / step); k * step <= right; ++k) {
            const x = Math.round((k * step - left) * scale) + 0.5;
            this.line(context, x, camera.height, x, camera.height - 5);
            if (x > 60 && x < camera.width - 40) this.word(label(k * step), x, camera.height - 9);
        }
        context.textAlign = "left";
        for (let k = Math.ceil(bottom / step); k * step <= top; ++k) {
            const y = Math.round((top - k * step) * scale) + 0.5;
            this.line(context, 0, y, 5, y);
            if (y > 40 && y < camera.height - 24) this.word(label(k * step), 9, y + 4);
        }
        this.word(unit, 9, camera.height - 9);
    }

    private box(camera: Camera, run: Run): void {
        const clip = camera.clip();
        const corner = (k: number) => run.bounds.map((range, axis) => range[(k >> axis) & 1]) as Vec3;
        this.behind.strokeStyle = cssColor("--line");
        for (let k = 0; k < 8; ++k)
            for (const axis of [1, 2, 4]) {
                if (k & axis) continue;
                const [a, b] = [camera.project(corner(k), clip), camera.project(corner(k | axis), clip)];
                this.line(this.behind, a[0], a[1], b[0], b[1]);
            }
    }

    private triad(camera: Camera): void {
        const context = this.above;
        const [x, y, length] = [44, camera.height - 44, 26];
        context.fillStyle = context.strokeStyle = cssColor("--muted");
        context.textAlign = "center";
        camera.triad.forEach(([right, up], axis) => {
            const [dx, dy] = [right * length, -up * length];
            this.line(context, x, y, x + dx, y + dy);
            this.word("xyz"[axis], x + dx * 1.38, y + dy * 1.38 + 4);
        });
    }

    private ring(camera: Camera, { place, radius }: { place: Vec3; radius: number }): void {
        const context = this.above;
        const [x, y] = camera.project(place, camera.clip());
        context.strokeStyle = cssColor("--page");
        context.lineWidth = 4;
        const arc = () => {
            context.beginPath();
            context.arc(x, y, Math.max(6, radius + 3), 0, 2 * Math.PI);
            context.stroke();
        };
        arc();
        context.strokeStyle = cssColor("--accent");
        context.lineWidth = 2;
        arc();
    }

    /** With a rim in the page's colour, to be read on particles too. */
    private word(words: string, x: number, y: number): void {
        const context = this.above;
        const ink = context.strokeStyle;
        context.strokeStyle = cssColor("--page");
        context.lineWidth = 3;
        context.lineJoin = "round";
        context.strokeText(words, x, y);
        context.strokeStyle = ink;
        context.lineWidth = 1;
        context.fillText(words, x, y);
    }

    private line(context: CanvasRenderingContext2D, x0: number, y0: number, x1: number, y1: number): void {
        context.beginPath();
        context.moveTo(x0, y0);
        context.lineTo(x1, y1);
        context.stroke();
    }
}
