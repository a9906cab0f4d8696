// Cards that say what colours mean, one per medium, and let it be chosen.
import { make, element } from "./dom";
import { fieldLabel, short, shownUnit, withUnit } from "./numbers";
import { media, type Field, type Run } from "./run";

/** What one medium's colours show. */
export interface Choice {
    field: string | null;
    map: string;
    low: number;
    high: number;
    /** The range follows the run until someone sets it. */
    automatic: boolean;
}

const titles = ["Fluid", "Solid", "Walls"];

/** As engine/view/color_map.cpp has it. */
const isSigned = (low: number, high: number) =>
    low < 0 && high > 0 && Math.min(-low, high) > 0.2 * Math.max(-low, high);

export class Colors {
    readonly choices: (Choice | null)[];
    private readonly holder = element("colors");

    constructor(
        private run: Run,
        private readonly changed: () => void,
    ) {
        const starts = [["speed", "pressure"], ["von_mises", "speed"], []];
        this.choices = media.map((_, m) => {
            if (!run.groups.some((group) => group.medium === m)) return null;
            const field =
                starts[m].find((name) => this.offered(m).some((f) => f.name === name)) ??
                (m < 2 ? this.offered(m)[0]?.name : null) ??
                null;
            const choice = { field, map: "viridis", low: 0, high: 1, automatic: true };
            this.spread(choice, m);
            return choice;
        });
        this.show();
    }

    /** A run that goes on has new ranges. */
    update(run: Run): void {
        this.run = run;
        this.choices.forEach((choice, m) => {
            if (!choice?.automatic) return;
            const map = choice.map;
            this.spread(choice, m);
            choice.map = map;
        });
        if (!this.holder.contains(document.activeElement)) this.show();
    }

    private offered(medium: number): Field[] {
        return this.run.fields.filter(({ ranges }) => {
            const range = ranges[medium];
            return range && range[3] > range[2];
        });
    }

    private fieldOf(choice: Choice): Field | undefined {
        return this.run.fields.find((field) => field.name === choice.field);
    }

    /** The range of a field in a medium, and the map that suits it. */
    private spread(choice: Choice, medium: number): void {
        const range = this.fieldOf(choice)?.ranges[medium];
        if (!range) return;
        let [low, high] = range;
        if (!(high > low)) [low, high] = [range[2], range[3]];
        const signed = isSigned(low, high);
        if (signed) [low, high] = [-Math.max(-low, high), Math.max(-low, high)];
        else if (low > 0 && low < 0.1 * high) low = 0; // a speed starts at rest
        Object.assign(choice, {
            low,
            high,
            automatic: true,
            map: signed ? "coolwarm" : medium === 1 ? "plasma" : "viridis",
        });
    }

    private show(): void {
        this.holder.replaceChildren(
            ...this.choices.flatMap((choice, m) =>
                choice && (m < 2 || this.offered(m).length) ? [this.card(choice, m)] : [],
            ),
        );
    }

    private card(choice: Choice, medium: number): HTMLElement {
        const fields = make("select", { ariaLabel: `${titles[medium]}: field` });
        for (const field of this.offered(medium))
            fields.append(
                make("option", { value: field.name, selected: field.name === choice.field }, fieldLabel(field.name)),
            );
        fields.append(make("option", { value: "", selected: !choice.field }, "one colour"));
        fields.onchange = () => {
            choice.field = fields.value || null;
            this.spread(choice, medium);
            this.show();
            this.changed();
        };
        const card = make(
            "section",
            { className: "card" },
            make("div", { className: "head" }, make("h2", {}, titles[medium])),
        );
        const line = make("div", { className: "line" }, fields);
        card.append(line);
        if (!choice.field) return card;
        line.append(this.mapSelect(choice));
        card.append(...this.scale(choice, medium));
        return card;
    }

    private mapSelect(choice: Choice): HTMLElement {
        const maps = make("select", { ariaLabel: "colour map" });
        for (const name of Object.keys(this.run.maps))
            maps.append(make("option", { value: name, selected: name === choice.map }, name));
        maps.onchange = () => {
            choice.map = maps.value;
            this.show();
            this.changed();
        };
        return maps;
    }

    private scale(choice: Choice, medium: number): HTMLElement[] {
        const field = this.fieldOf(choice);
        const shown = shownUnit(field?.unit ?? "", Math.max(Math.abs(choice.low), Math.abs(choice.high)));
        const stops = this.run.maps[choice.map].map((color) => `#${color.toString(16).padStart(6, "0")}`);
        const bar = make("div", { className: "bar" });
        bar.style.background = `linear-gradient(to right, ${stops.join(",")})`;
        const ticks = make("div", { className: "ticks" });
        for (const part of [0, 0.25, 0.5, 0.75, 1])
            ticks.append(make("span", {}, short((choice.low + part * (choice.high - choice.low)) * shown.factor)));
        const label = make("div", { className: "muted" }, withUnit(fieldLabel(choice.field ?? ""), shown.unit));
        return [bar, ticks, label, this.limits(choice, medium, shown.factor)];
    }

    private limits(choice: Choice, medium: number, factor: number): HTMLElement {
        const set = (low: number, high: number) => {
            if (!(high > low)) return this.show();
            Object.assign(choice, { low, high, automatic: false });
            this.show();
            this.changed();
        };
        const input = (value: number, label: string) =>
            make("input", {
                type: "number",
                step: "any",
                value: String(Number((value * factor).toPrecision(4))),
                ariaLabel: label,
            });
        const [low, high] = [input(choice.low, "lower end"), input(choice.high, "upper end")];
        low.onchange = () => set(Number(low.value) / factor, choice.high);
        high.onchange = () => set(choice.low, Number(high.value) / factor);
        const button = (text: string, title: string, deed: () => void) =>
            make("button", { title, onclick: deed }, text);
        const all = this.fieldOf(choice)?.ranges[medium];
        const line = make("div", { className: "line" }, low, high);
        line.style.marginTop = "6px";
        line.append(
            button("auto", "What nearly all particles lie between in nearly all frames", () => {
                this.spread(choice, medium);
                this.show();
                this.changed();
            }),
            button("all", "From the least value of the run to the greatest", () => all && set(all[2], all[3])),
        );
        return line;
    }
}
