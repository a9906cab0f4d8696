// What part of space is on the screen: a flat window in 2D, an orbit in 3D.
import { m4 } from "twgl.js";
import type { Run } from "./run";

export type Vec3 = [number, number, number];

/** Of the free height or width that the run takes up at first. */
const fill = 0.88;
/** Opening of the view from below to above: about that of a 50 mm lens, so that depth is felt and little distorted. */
const fieldOfView = (30 * Math.PI) / 180;
const degree = Math.PI / 180;

export class Camera {
    width = 1; // of the picture [css pixels]
    height = 1;
    private center: Vec3 = [0, 0, 0];
    private span = 1; // 2D: height of the window; 3D: distance of the eye [m]
    private azimuth = 30 * degree;
    private elevation = 20 * degree;
    private readonly up: Vec3;
    private readonly right: Vec3;
    private readonly front: Vec3;
    untouched = true;

    constructor(
        private readonly dimension: 2 | 3,
        up: Vec3,
    ) {
        // The axis most against gravity is up; a scene may have it along any.
        const axis = dimension === 2 ? 1 : up.reduce((best, u, k) => (Math.abs(u) > Math.abs(up[best]) ? k : best), 0);
        const unit = (k: number, sign = 1): Vec3 => [0, 1, 2].map((j) => (j === k ? sign : 0)) as Vec3;
        this.up = unit(axis, dimension === 3 && up[axis] < 0 ? -1 : 1);
        this.right = axis === 0 ? unit(1) : unit(0);
        const [a, b] = [this.right, this.up];
        this.front = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    }

    fit(bounds: Run["bounds"], margin: number): void {
        this.center = bounds.map(([low, high]) => 0.5 * (low + high)) as Vec3;
        const size = bounds.map(([low, high]) => high - low + margin);
        if (this.dimension === 2) this.span = Math.max(size[1], (size[0] * this.height) / this.width) / fill;
        else {
            // Seen from the start's direction the corners of the box must lie within the opening.
            this.azimuth = 30 * degree;
            this.elevation = 20 * degree;
            this.span = 1e3 * Math.hypot(...size);
            let reach = 0;
            const [right, top, toEye] = this.axes();
            for (let corner = 0; corner < 8; ++corner) {
                const c = size.map((s, k) => (corner & (1 << k) ? 0.5 : -0.5) * s) as Vec3;
                const dot = (a: Vec3) => a[0] * c[0] + a[1] * c[1] + a[2] * c[2];
                const half = Math.tan(fieldOfView / 2);
                const needed = Math.max((Math.abs(dot(right)) * this.height) / this.width, Math.abs(dot(top))) / half;
                reach = Math.max(reach, needed / fill + dot(toEye));
            }
            this.span = reach;
        }
        this.untouched = true;
    }

    /** Right, up and towards the eye on the screen. */
    private axes(): [Vec3, Vec3, Vec3] {
        const [ca, sa] = [Math.cos(this.azimuth), Math.sin(this.azimuth)];
        const [ce, se] = [Math.cos(this.elevation), Math.sin(this.elevation)];
        const mix = (a: number, b: number, c: number): Vec3 =>
            [0, 1, 2].map((k) => a * this.right[k] + b * this.front[k] + c * this.up[k]) as Vec3;
        return [mix(ca, -sa, 0), mix(-sa * se, -ca * se, ce), mix(sa * ce, ca * ce, se)];
    }

    /** Screen pixels that a length of one metre takes at the centre. */
    get pixelsPerMetre(): number {
        return this.dimension === 2
            ? this.height / this.span
            : this.height / (2 * Math.tan(fieldOfView / 2) * this.span);
    }

    /** Of the eye from the centre, where a metre is pixelsPerMetre pixels long; 1 in 2D. [m] */
    get eyeDistance(): number {
        return this.dimension === 2 ? 1 : this.span;
    }

    /** From space to clip coordinates. */
    clip(): m4.Mat4 {
        if (this.dimension === 2) {
            const half = 0.5 * this.span;
            const side = (half * this.width) / this.height;
            const view = m4.translation([-this.center[0], -this.center[1], 0]);
            return m4.multiply(m4.ortho(-side, side, -half, half, -1, 1), view);
        }
        const [, top, toEye] = this.axes();
        const eye = this.center.map((c, k) => c + this.span * toEye[k]) as Vec3;
        const view = m4.inverse(m4.lookAt(eye, this.center, top));
        const lens = m4.perspective(fieldOfView, this.width / this.height, 0.02 * this.span, 20 * this.span);
        return m4.multiply(lens, view);
    }

    /** Css pixels from the upper left corner, and the depth. */
    project(place: Vec3, clip: m4.Mat4): Vec3 {
        const p = m4.transformPoint(clip, place) as unknown as Vec3;
        return [(0.5 + 0.5 * p[0]) * this.width, (0.5 - 0.5 * p[1]) * this.height, p[2]];
    }

    /** In 2D: the place under a pixel. */
    placeAt(x: number, y: number): Vec3 {
        const s = this.pixelsPerMetre;
        return [this.center[0] + (x - this.width / 2) / s, this.center[1] - (y - this.height / 2) / s, 0];
    }

    pan(dx: number, dy: number): void {
        const s = this.pixelsPerMetre;
        if (this.dimension === 2) this.center = [this.center[0] - dx / s, this.center[1] + dy / s, 0];
        else {
            const [right, top] = this.axes();
            this.center = this.center.map((c, k) => c - (dx / s) * right[k] + (dy / s) * top[k]) as Vec3;
        }
        this.untouched = false;
    }

    turn(dx: number, dy: number): void {
        this.azimuth -= dx * 0.4 * degree;
        this.elevation = Math.max(-89 * degree, Math.min(89 * degree, this.elevation + dy * 0.4 * degree));
        this.untouched = false;
    }

    /** The place under the pixel stays where it is. */
    zoom(factor: number, x: number, y: number): void {
        const [dx, dy] = [x - this.width / 2, y - this.height / 2];
        this.pan(-dx, -dy);
        this.span *= factor;
        this.pan(dx, dy);
    }

    get triad(): Vec3[] {
        const [right, top, toEye] = this.axes();
        return [0, 1, 2].map((k) => [right[k], top[k], toEye[k]] as Vec3);
    }
}
