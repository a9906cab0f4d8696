// The particle that was clicked on, followed through the frames.
import type { Camera, Vec3 } from "./camera";
import { element, make } from "./dom";
import { fieldLabel, short, shownUnit } from "./numbers";
import { media, type Run } from "./run";
import type { Frame } from "./unpack";

/** So near must a click be, where particles are small [px]. */
const reach = 8;

export interface Picked {
    group: number;
    id: number;
    index: number;
}

export const pickAt = async (
    frame: Frame,
    run: Run,
    camera: Camera,
    shown: boolean[],
    size: number,
    x: number,
    y: number,
): Promise<Picked | null> => {
    const [groups, ids] = await Promise.all([frame.numbersOf("group"), frame.numbersOf("id")]);
    const clip = camera.clip();
    let best = -1;
    let least = Infinity;
    for (let i = 0; i < frame.count; ++i) {
        if (!shown[groups[i]]) continue;
        const [px, py, depth] = camera.project(frame.place(i), clip);
        const off = Math.hypot(px - x, py - y);
        const radius = Math.max(reach, 0.5 * size * run.groups[groups[i]].spacing * camera.pixelsPerMetre);
        // In 3D the foremost ball under the pointer counts, in 2D the nearest centre.
        const rank = run.dimension === 3 ? depth : off;
        if (off <= radius && rank < least) [best, least] = [i, rank];
    }
    return best < 0 ? null : { group: groups[best], id: ids[best], index: best };
};

/** Particles keep their order as long as none comes or goes. */
export const find = async (frame: Frame, picked: Picked): Promise<number> => {
    const [groups, ids] = await Promise.all([frame.numbersOf("group"), frame.numbersOf("id")]);
    const is = (i: number) => groups[i] === picked.group && ids[i] === picked.id;
    if (is(picked.index)) return picked.index;
    for (let i = 0; i < frame.count; ++i) if (is(i)) return i;
    return -1;
};

const row = (name: string, value: string) => make("tr", {}, make("td", {}, name), make("td", {}, value));

export const showPicked = async (frame: Frame | null, run: Run, picked: Picked | null): Promise<Vec3 | null> => {
    const holder = element("pick");
    const hint = make("div", { className: "muted" }, "Click on a particle to see its values.");
    const i = frame && picked ? await find(frame, picked) : -1;
    if (!frame || !picked || i < 0) {
        holder.replaceChildren(picked ? make("div", { className: "muted" }, "Not in this frame.") : hint);
        return null;
    }
    const group = run.groups[picked.group];
    const place = frame.place(i);
    const table = make("table", {}, row(group.name, `${media[group.medium]}, no. ${picked.id}`));
    const axes = ["x", "y", "z"].slice(0, run.dimension);
    axes.forEach((axis, k) => table.append(row(`${axis} [m]`, short(place[k], 4))));
    const fields = run.fields.filter(({ name, ranges }) => {
        const range = ranges[group.medium];
        return frame.has(name) && range && (range[3] > range[2] || range[2] !== 0);
    });
    const values = await Promise.all(fields.map(({ name }) => frame.values(name)));
    fields.forEach(({ name, unit }, k) => {
        const shown = shownUnit(unit, Math.abs(values[k][i]));
        table.append(
            row(`${fieldLabel(name)}${shown.unit ? ` [${shown.unit}]` : ""}`, short(values[k][i] * shown.factor, 4)),
        );
    });
    holder.replaceChildren(table);
    return place;
};
