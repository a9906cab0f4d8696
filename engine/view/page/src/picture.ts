// Particles as points, drawn by WebGL: discs in 2D, lit balls in 3D.
import * as twgl from "twgl.js";
import type { Camera } from "./camera";
import type { Run } from "./run";
import type { Frame } from "./unpack";

const vertexShader = `#version 300 es
precision highp float;
in float sx, sy, sz;   // place between low and low + span
in float value, group;
uniform vec3 low, span;
uniform mat4 clip;
uniform float pixels;  // of one metre, at distance 1 in 3D
uniform float size;
uniform sampler2D looks;  // per group: (shown, spacing, map's row, -), (low, 1 / range, -, -), colour of no value
uniform sampler2D maps;
out vec4 color;
out float radius;
void main() {
    int g = int(group);
    vec4 look = texelFetch(looks, ivec2(g, 0), 0);
    vec4 scale = texelFetch(looks, ivec2(g, 1), 0);
    if (look.x < 0.5) {
        gl_Position = vec4(2.0, 2.0, 2.0, 1.0);
        gl_PointSize = 1.0;
        return;
    }
    gl_Position = clip * vec4(low + span * vec3(sx, sy, sz), 1.0);
    radius = max(0.9, 0.5 * size * look.y * pixels / gl_Position.w);
    gl_PointSize = 2.0 * radius + 1.0;
    float part = clamp((value - scale.x) * scale.y, 0.0, 1.0);
    vec2 at = vec2((part * 255.0 + 0.5) / 256.0, look.z);
    color = look.z < 0.0 || isnan(value) ? texelFetch(looks, ivec2(g, 2), 0) : texture(maps, at);
}`;

const flatShader = `#version 300 es
precision highp float;
in vec4 color;
in float radius;
out vec4 pixel;
void main() {
    float distance = length(gl_PointCoord - 0.5) * (2.0 * radius + 1.0);
    float cover = clamp(radius + 0.5 - distance, 0.0, 1.0);
    if (cover <= 0.0) discard;
    pixel = vec4(color.rgb, 1.0) * cover;
}`;

const ballShader = `#version 300 es
precision highp float;
in vec4 color;
in float radius;
out vec4 pixel;
void main() {
    vec2 p = (2.0 * gl_PointCoord - 1.0) * vec2(1.0, -1.0);
    float rest = 1.0 - dot(p, p);
    if (rest <= 0.0) discard;
    vec3 normal = vec3(p, sqrt(rest));
    float light = 0.62 + 0.42 * max(0.0, dot(normal, vec3(-0.36, 0.55, 0.75)));
    pixel = vec4(min(color.rgb * light, 1.0), 1.0);
}`;

/** Diameters over spacings; engine/view/frame_picture.cpp says why. */
const overlap = { 2: 1.42, 3: 1.1 };

/** How a group is drawn; `map` is a row, -1: all of one colour. */
export interface Look {
    shown: boolean;
    map: number;
    low: number;
    high: number;
    plain: [number, number, number];
}

const mapColors = 256;

const mapTable = (maps: Run["maps"]): Uint8Array => {
    const rows = Object.values(maps);
    const table = new Uint8Array(rows.length * mapColors * 4);
    rows.forEach((colors, row) => {
        for (let i = 0; i < mapColors; ++i) {
            const place = (i / (mapColors - 1)) * (colors.length - 1);
            const k = Math.min(Math.floor(place), colors.length - 2);
            for (let c = 0; c < 3; ++c) {
                const [a, b] = [colors[k], colors[k + 1]].map((color) => (color >> (16 - 8 * c)) & 255);
                table[(row * mapColors + i) * 4 + c] = Math.round(a + (place - k) * (b - a));
            }
            table[(row * mapColors + i) * 4 + 3] = 255;
        }
    });
    return table;
};

export class Picture {
    private readonly gl: WebGL2RenderingContext;
    private readonly program: twgl.ProgramInfo;
    private readonly maps: WebGLTexture;
    private readonly looks: WebGLTexture;
    private buffers: twgl.BufferInfo | null = null;
    private room = 0;
    private count = 0;
    private box: Record<"low" | "span", number[]> = { low: [0, 0, 0], span: [1, 1, 1] };

    constructor(
        private readonly canvas: HTMLCanvasElement,
        private readonly run: Run,
    ) {
        const gl = canvas.getContext("webgl2", { antialias: false, alpha: true, preserveDrawingBuffer: true });
        if (!gl) throw new Error("This browser draws no WebGL 2, which the picture needs.");
        this.gl = gl;
        this.program = twgl.createProgramInfo(gl, [vertexShader, run.dimension === 2 ? flatShader : ballShader]);
        const rows = Object.keys(run.maps).length;
        this.maps = twgl.createTexture(gl, {
            width: mapColors,
            height: rows,
            src: mapTable(run.maps),
            format: gl.RGBA,
            minMag: gl.LINEAR,
            wrap: gl.CLAMP_TO_EDGE,
            auto: false,
        });
        this.looks = gl.createTexture()!;
    }

    /** Room for so many particles, in buffers that are filled anew for each frame. */
    private reserve(count: number): void {
        if (count <= this.room) return;
        this.room = Math.ceil(1.1 * count);
        const steps = {
            numComponents: 1,
            data: new Uint16Array(this.room),
            normalize: true,
            drawType: this.gl.DYNAMIC_DRAW,
        };
        const floats = { numComponents: 1, data: new Float32Array(this.room), drawType: this.gl.DYNAMIC_DRAW };
        this.buffers = twgl.createBufferInfoFromArrays(this.gl, {
            sx: steps,
            sy: steps,
            sz: { ...steps },
            value: floats,
            group: floats,
        });
    }

    private put(name: string, data: Uint16Array | Float32Array): void {
        const attribute = this.buffers!.attribs![name];
        this.gl.bindBuffer(this.gl.ARRAY_BUFFER, attribute.buffer);
        this.gl.bufferSubData(this.gl.ARRAY_BUFFER, 0, data);
    }

    /** Unpacks what load() will ask for. */
    async prepare(frame: Frame, fields: (string | null)[]): Promise<void> {
        const axes = this.run.dimension === 2 ? ["x", "y"] : ["x", "y", "z"];
        await Promise.all([
            ...axes.map((axis) => frame.steps(axis)),
            frame.numbersOf("group"),
            ...fields.map((field) => (field && frame.has(field) ? frame.values(field) : null)),
        ]);
    }

    /** `fields`: shown of each medium, null: none. */
    async load(frame: Frame, fields: (string | null)[]): Promise<() => void> {
        const axes = this.run.dimension === 2 ? ["x", "y"] : ["x", "y", "z"];
        const places = await Promise.all(axes.map((axis) => frame.steps(axis)));
        const groups = new Float32Array(await frame.numbersOf("group"));
        const columns = await Promise.all(
            fields.map((field) => (field && frame.has(field) ? frame.values(field) : undefined)),
        );
        const first = columns.find((column) => column);
        const values = first && columns.every((c) => !c || c === first) ? first : this.mixed(columns, groups);
        return () => {
            this.reserve(frame.count);
            this.count = frame.count;
            places.forEach((steps, k) => this.put(["sx", "sy", "sz"][k], steps));
            this.put("value", values);
            this.put("group", groups);
            const ranges = axes.map((axis) => frame.range(axis));
            while (ranges.length < 3) ranges.push([0, 0]);
            this.box.low = ranges.map(([low]) => low);
            this.box.span = ranges.map(([low, high]) => ((high - low) * 65535) / 65534);
        };
    }

    private mixed(columns: (Float32Array | undefined)[], groups: Float32Array): Float32Array {
        const medium = this.run.groups.map((group) => group.medium);
        const values = new Float32Array(groups.length);
        for (let i = 0; i < values.length; ++i) values[i] = columns[medium[groups[i]]]?.[i] ?? NaN;
        return values;
    }

    /** How each group is drawn from now on. */
    setLooks(looks: Look[]): void {
        const { gl } = this;
        const n = looks.length;
        const table = new Float32Array(3 * 4 * n);
        const rows = Object.keys(this.run.maps).length;
        looks.forEach((look, g) => {
            const row = look.map < 0 ? -1 : (look.map + 0.5) / rows;
            table.set([look.shown ? 1 : 0, this.run.groups[g].spacing, row, 0], 4 * g);
            table.set([look.low, look.high > look.low ? 1 / (look.high - look.low) : 0, 0, 0], 4 * (n + g));
            table.set([...look.plain, 1], 4 * (2 * n + g));
        });
        gl.bindTexture(gl.TEXTURE_2D, this.looks);
        gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, n, 3, 0, gl.RGBA, gl.FLOAT, table);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
        gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
    }

    draw(camera: Camera, size: number): number {
        const { gl, canvas } = this;
        const ratio = window.devicePixelRatio || 1;
        const [w, h] = [Math.round(camera.width * ratio), Math.round(camera.height * ratio)];
        if (canvas.width !== w || canvas.height !== h) [canvas.width, canvas.height] = [w, h];
        gl.viewport(0, 0, w, h);
        gl.clearColor(0, 0, 0, 0);
        gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
        if (!this.buffers || this.count === 0) return 0;
        const flat = this.run.dimension === 2;
        (flat ? gl.disable : gl.enable).call(gl, gl.DEPTH_TEST);
        (flat ? gl.enable : gl.disable).call(gl, gl.BLEND);
        gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gl.useProgram(this.program.program);
        twgl.setBuffersAndAttributes(gl, this.program, this.buffers);
        if (flat) {
            const sz = this.program.attribLocations?.["sz"] ?? -1;
            if (sz >= 0) (gl.disableVertexAttribArray(sz), gl.vertexAttrib1f(sz, 0));
        }
        twgl.setUniforms(this.program, {
            low: this.box.low,
            span: this.box.span,
            clip: camera.clip(),
            size: overlap[this.run.dimension] * size,
            pixels: ratio * camera.pixelsPerMetre * camera.eyeDistance,
            looks: this.looks,
            maps: this.maps,
        });
        gl.drawArrays(gl.POINTS, 0, this.count);
        return this.count;
    }
}
