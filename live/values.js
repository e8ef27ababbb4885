// Values: how they follow a pointer, snap, are said, and are written as TOML. No page and no module here.

// The value of a handle where the pointer is at a point of the page, both in page pixels.
function followed({ value, at: [px, py], pull: { plane, turn, reach, unit } }, [x, y]) {
    if (plane) return value.map((v, i) => v + plane[0][i] * (x - px) + plane[1][i] * (y - py));
    const [cx, cy] = turn ?? reach;
    const far = Math.hypot(px - cx, py - cy);
    if (reach) {
        // Along its own way: past the middle a radius does not grow again.
        const along = ((x - px) * (px - cx) + (y - py) * (py - cy)) / far;
        return value + unit * (far > 0 ? along : Math.hypot(x - cx, y - cy));
    }
    const by = Math.atan2(y - cy, x - cx) - Math.atan2(py - cy, px - cx);
    return value + unit * Math.atan2(Math.sin(by), Math.cos(by));
}

// By how much a page pixel changes a value.
function grainOf({ pull }) {
    if (pull.plane) return Math.hypot(...pull.plane[0]);
    return Math.abs(pull.unit) / (pull.turn ? 60 : 1);
}

// The step that a handle snaps to: what the scene says, for angles 5° or a tenth of a radian, for times a
// hundredth. A quarter of a unit, which nobody asked for, is not taken in a world where it is nothing or
// everything.
function stepOf(handle, snap) {
    if (handle.pull?.turn) return Math.abs(handle.pull.unit) > 2 ? 5 : 0.1;
    if (handle.grip === "angle") return unitOf(handle) === "°" ? 5 : 0.1;
    if (handle.grip === "time") return 0.01;
    if (snap) return snap;
    if (!handle.pull) return 0.25;
    const pixels = 0.25 / grainOf(handle);
    return pixels > 2 && pixels < 80 ? 0.25 : 10 ** Math.round(Math.log10(16 * grainOf(handle)));
}

const each = (value, change) => (Array.isArray(value) ? value.map(change) : change(value));
const snapped = (value, step, round = Math.round) =>
    each(value, (v) => Number((round(v / step) * step).toPrecision(12)));

// Whether a pair is no place: half-extents, which have no number of a vertex behind them.
const isSize = ({ grip, paths: [path] }) => grip === "vertices" && typeof path.at(-1) === "string";

// The unit of a value, as it is written behind it.
const unitOf = ({ paths: [path] }) => ({ angle_deg: "°", angle_rad: " rad" })[path.at(-1)] ?? "";

// The last digit that anyone can see of a value: to a quarter of a pixel.
const grid = (handle) => 10 ** Math.floor(Math.log10(grainOf(handle) / 4));
const tidy = (value, handle) => snapped(value, grid(handle));

// A value on the way to one that can't be, as it is written: what no handle can be pulled by has four digits.
const short = (value, handle) =>
    handle.pull ? tidy(value, handle) : each(value, (v) => Number(v.toPrecision(4)));

// A value where a handle can be; at an end of that it has no more digits than elsewhere, and is one of those
// that it snaps to. A time ends at the first contact, and not short of it.
function within(value, handle, step) {
    let [lo, hi] = handle.range;
    if (handle.grip !== "time") {
        const ends = (by) => [snapped(lo, by, Math.ceil), snapped(hi, by, Math.floor)];
        const steps = step ? ends(step) : [1, 0];
        const hasSome = [steps[0]].flat().every((least, i) => least <= [steps[1]].flat()[i]);
        [lo, hi] = hasSome ? steps : ends(grid(handle));
    }
    return Array.isArray(value)
        ? value.map((v, i) => Math.min(Math.max(v, lo[i]), hi[i]))
        : Math.min(Math.max(value, lo), hi);
}

const between = (a, b, t) => (Array.isArray(a) ? a.map((x, i) => x + (b[i] - x) * t) : a + (b - a) * t);

const digits = (x) => String(Number(x.toPrecision(4))).replace("-", "−");

// A path as a part of a page's address.
const addressOf = (path) => path.map(encodeURIComponent).join("/");

const keyOf = (handle) => JSON.stringify(handle.paths);
const valueAt = (scene, path) => path.reduce((node, step) => node?.[step], scene);

// The scene with values at their paths; the scene itself stays as it is.
function edited(scene, edits) {
    const copy = structuredClone(scene);
    for (const { paths, value } of edits) {
        for (const path of paths) valueAt(copy, path.slice(0, -1))[path.at(-1)] = value;
    }
    return copy;
}

// A scene as TOML, tables in the order of the scene; that of bodies where they are called as numbers, which
// JavaScript sorts.
function toml(scene, bodies) {
    const name = (word) => (/^[\w-]+$/.test(word) ? word : JSON.stringify(word));
    const isTable = (value) => value !== null && typeof value === "object" && !Array.isArray(value);
    const inline = (value) => {
        if (Array.isArray(value)) return `[${value.map(inline).join(", ")}]`;
        if (isTable(value)) return `{ ${lines(value).join(", ")} }`;
        return JSON.stringify(value).replaceAll("\x7f", "\\u007f");
    };
    const keys = (word, value) => (word === "shapes" && bodies) || Object.keys(value);
    const lines = (table) => Object.entries(table).map(([word, value]) => `${name(word)} = ${inline(value)}`);
    const [simple, tables] = [[], []];
    for (const [word, value] of Object.entries(scene)) {
        const listed = Array.isArray(value) && value.length > 0 && value.every(isTable);
        const nested = isTable(value) && Object.values(value).every(isTable);
        const table = (header, item) => tables.push(header, ...lines(item), "");
        if (listed) for (const item of value) table(`[[${name(word)}]]`, item);
        else if (nested) keys(word, value).forEach((k) => table(`[${name(word)}.${name(k)}]`, value[k]));
        else if (isTable(value)) table(`[${name(word)}]`, value);
        else simple.push(`${name(word)} = ${inline(value)}`);
    }
    return [...simple, "", ...tables].join("\n");
}
