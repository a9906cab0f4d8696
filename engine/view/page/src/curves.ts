// Probes as curves over time, with the frame's time as a line; a click goes to that time.
import uPlot from "uplot";
import { cssColor, element, make } from "./dom";
import { short, shownUnit } from "./numbers";

interface Column {
    part: string;
    unit: string;
    values: (number | null)[];
}

interface Table {
    time: number[];
    /** Columns by their probe. */
    probes: Map<string, Column[]>;
}

/** `t [s],gate.x [m],…` */
export const parseTable = (csv: string): Table => {
    const rows = csv
        .split("\n")
        .filter((row) => row && !row.startsWith("#"))
        .map((row) => row.split(","));
    const table: Table = { time: [], probes: new Map() };
    if (rows.length < 2) return table;
    const columns = rows[0].map((heading, k) => {
        const [, name, unit] = /^(.*?)(?: \[(.*)\])?$/.exec(heading)!;
        const dot = name.indexOf(".");
        const column: Column = { part: name.slice(dot + 1), unit: unit ?? "", values: [] };
        if (k > 0) {
            const probe = dot < 0 ? name : name.slice(0, dot);
            table.probes.set(probe, [...(table.probes.get(probe) ?? []), column]);
        }
        return column;
    });
    for (const row of rows.slice(1)) {
        if (row.length !== columns.length) continue; // being written
        table.time.push(Number(row[0]));
        row.forEach((cell, k) => columns[k].values.push(cell === "" || cell === "nan" ? null : Number(cell)));
    }
    return table;
};

/** Okabe and Ito's colours, told apart by all eyes; the first two are dark enough for both backgrounds. */
const strokes = ["#0b7fc4", "#d55e00", "#009e73", "#cc79a7", "#b08c00", "#56b4e9", "#8a6bbf"];
const height = 168;

export class Curves {
    private table: Table = { time: [], probes: new Map() };
    private readonly shown = new Set<string>();
    private plots: uPlot[] = [];
    private time = 0;

    constructor(private readonly goTo: (time: number) => void) {
        new ResizeObserver(() => this.resize()).observe(element("curves"));
    }

    set(csv: string): void {
        const first = this.table.probes.size === 0;
        this.table = parseTable(csv);
        if (first && this.table.probes.size > 0) {
            this.shown.add([...this.table.probes.keys()][0]);
            this.list();
        }
        if (!first && this.plots.length === this.shown.size) {
            let k = 0;
            for (const probe of this.shown) this.plots[k++].setData(this.data(probe));
        } else this.build();
    }

    setTime(time: number): void {
        this.time = time;
        for (const plot of this.plots) {
            this.placeTime(plot);
            this.showValues(plot);
        }
    }

    private list(): void {
        const holder = element("probe-list");
        element("probe-card").hidden = this.table.probes.size === 0;
        holder.replaceChildren(
            ...[...this.table.probes.keys()].map((probe) => {
                const chip = make("button", { textContent: probe, ariaPressed: String(this.shown.has(probe)) });
                chip.onclick = () => {
                    if (!this.shown.delete(probe)) this.shown.add(probe);
                    this.list();
                    this.build();
                };
                return chip;
            }),
        );
    }

    private scale(probe: string): { unit: string; factor: number } {
        const columns = this.table.probes.get(probe)!;
        let size = 0;
        for (const { values } of columns) for (const value of values) size = Math.max(size, Math.abs(value ?? 0));
        return shownUnit(columns[0].unit, size);
    }

    private data(probe: string): uPlot.AlignedData {
        const { factor } = this.scale(probe);
        const columns = this.table.probes.get(probe)!;
        return [
            this.table.time,
            ...columns.map((c) => (factor === 1 ? c.values : c.values.map((v) => v && v * factor))),
        ];
    }

    /** All anew: after a change of what is shown, or of the page's colours. */
    build(): void {
        for (const plot of this.plots) plot.destroy();
        const holder = element("curves");
        holder.replaceChildren();
        this.plots = [];
        for (const probe of this.shown) {
            const box = make("div");
            holder.append(box);
            this.plots.push(this.plot(probe, box));
        }
        this.resize();
        this.setTime(this.time);
    }

    private plot(probe: string, box: HTMLElement): uPlot {
        const { unit, factor } = this.scale(probe);
        const columns = this.table.probes.get(probe)!;
        const axis = {
            stroke: cssColor("--muted"),
            grid: { stroke: cssColor("--line"), width: 1 },
            ticks: { show: false },
        };
        const text = '11px system-ui, "Segoe UI", Helvetica, Arial, "Liberation Sans", sans-serif';
        const options: uPlot.Options = {
            width: 400,
            height: height,
            padding: [10, 22, 0, 0],
            scales: { x: { time: false } },
            axes: [
                { ...axis, font: text, size: 24, values: (_, ticks) => ticks.map((t) => `${short(t, 4)} s`) },
                { ...axis, font: text, size: 52, values: (_, ticks) => ticks.map((t) => short(t, 4)) },
            ],
            series: [
                {},
                ...columns.map(({ part, unit: own }, k) => ({
                    label: `${probe}.${part}${own ? ` [${factor === 1 ? own : unit}]` : ""}`,
                    stroke: strokes[k % strokes.length],
                    width: 1.4,
                    points: { show: false },
                    value: (_: uPlot, v: number | null) => (v === null ? "–" : short(v, 4)),
                })),
            ],
            cursor: { drag: { x: false, y: false }, points: { size: 6 }, y: false },
            hooks: { draw: [(plot) => this.placeTime(plot)], setCursor: [(plot) => this.showValues(plot)] },
        };
        const plot = new uPlot(options, this.data(probe), box);
        plot.over.append(make("div", { className: "time" }));
        this.placeTime(plot);
        const jump = (event: MouseEvent) =>
            this.goTo(plot.posToVal(event.clientX - plot.over.getBoundingClientRect().left, "x"));
        plot.over.addEventListener("pointerdown", jump);
        plot.over.addEventListener("pointermove", (event) => event.buttons & 1 && jump(event));
        return plot;
    }

    /** At the frame's time, unless the mouse asks for those of another. */
    private showValues(plot: uPlot): void {
        if ((plot.cursor.left ?? -1) >= 0 || this.table.time.length === 0) return;
        let after = this.table.time.findIndex((t) => t >= this.time);
        if (after < 0) after = this.table.time.length - 1;
        plot.setLegend({ idx: after });
    }

    /** An element of its own: drawing the curves anew for every frame would cost more than the particles. */
    private placeTime(plot: uPlot): void {
        const line = plot.over.querySelector<HTMLElement>(".time");
        const x = plot.valToPos(this.time, "x");
        if (line) line.style.transform = `translateX(${x.toFixed(1)}px)`;
    }

    private resize(): void {
        const holder = element("curves");
        [...holder.children].forEach((box, k) => {
            const width = box.clientWidth;
            if (width > 0 && this.plots[k]?.width !== width) this.plots[k]?.setSize({ width, height });
        });
    }
}
