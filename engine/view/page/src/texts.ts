// What is said in words: the run's facts and its effects.
import { element, make } from "./dom";
import { short } from "./numbers";
import type { Run, Summary } from "./run";

const thousands = (n: number) => n.toLocaleString("en").replaceAll(",", " ");

export const showHead = (run: Run): void => {
    element("title").textContent = document.title = run.title;
    document.title += " – sluice";
    const badge = element("status");
    badge.textContent = run.status || "no summary";
    badge.className = `badge ${run.status}`;
    const particles = run.frames.at(-1)?.[2] ?? 0;
    element("facts").textContent =
        `${thousands(particles)} particles, ${run.frames.length} frame${run.frames.length === 1 ? "" : "s"}, ${run.dimension}D`;
};

const number = (value: unknown): string => (typeof value === "number" ? short(value, 4) : String(value));

const facts: [string, string, string][] = [
    ["simulated_time", "simulated", "s"],
    ["end_time", "to reach", "s"],
    ["steps", "steps", ""],
    ["dt", "last step", "s"],
    ["wall_seconds", "wall time", "s"],
    ["cpu_seconds", "CPU time", "s"],
    ["threads", "threads", ""],
    ["precision", "precision", ""],
    ["instruction_set", "instructions", ""],
    ["max_speed", "highest speed", "m/s"],
    ["max_mach", "highest Mach number", ""],
    ["scene_hash", "scene", ""],
    ["version", "sluice", ""],
    ["message", "", ""],
];

export const showSummary = (run: Run, summary: Summary): void => {
    const table = make("table");
    for (const [key, name, unit] of facts) {
        if (summary[key] === undefined) continue;
        const value = key === "scene_hash" ? String(summary[key]) : `${number(summary[key])} ${unit}`;
        table.append(make("tr", {}, make("td", {}, name), make("td", {}, value)));
    }
    table.append(make("tr", {}, make("td", {}, "folder"), make("td", {}, run.directory)));
    element("run-facts").querySelector("div")!.replaceChildren(table);

    const effects = Object.values(summary.effects ?? {});
    const on = effects.filter((effect) => effect.on);
    element("effects").hidden = effects.length === 0;
    element("effects").querySelector("summary")!.textContent =
        `Effects: ${on.length} on, ${effects.length - on.length} off`;
    const paragraph = (effect: (typeof effects)[0]) =>
        make(
            "p",
            { className: effect.on ? "" : "off", title: effect.equation },
            make("b", {}, effect.name),
            ` – ${effect.why}`,
        );
    element("effects")
        .querySelector("div")!
        .replaceChildren(
            ...on.map(paragraph),
            ...(on.length < effects.length ? [make("p", { className: "off" }, "Off:")] : []),
            ...effects.filter((effect) => !effect.on).map(paragraph),
        );
};

const keys: [string, string][] = [
    ["space", "play or pause"],
    ["← →", "one frame back, on; with shift ten"],
    ["Home End", "first, last frame"],
    ["+ −", "play faster, slower"],
    ["wheel", "zoom"],
    ["drag", "move the view; in 3D turn it, with shift move it"],
    ["double click, R", "show everything"],
    ["click", "pick a particle, or a time in a curve"],
    ["P", "panel"],
    ["T", "light or dark"],
];

export const showKeys = (): void => {
    element("keys").replaceChildren(...keys.flatMap(([key, deed]) => [make("dt", {}, key), make("dd", {}, deed)]));
};
