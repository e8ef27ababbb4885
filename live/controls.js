// What a reader takes hold of: a knob on the picture, and the same as numbers beside it.

function make(name, attributes = {}, ...inner) {
    const space = ["svg", "g", "circle"].includes(name) ? "2000/svg" : "1999/xhtml";
    const element = document.createElementNS(`http://www.w3.org/${space}`, name);
    for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
    element.append(...inner);
    return element;
}

function button(words, act, attributes = {}) {
    const made = make("button", { type: "button", ...attributes }, words);
    made.addEventListener("click", act);
    return made;
}

const sign = (shape) => make("span", { "aria-hidden": "true" }, shape);

const NEARLY = 0.999; // Of two axes at the same angle to a key the left and right keys have the first one.
const WAYS = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

// The nearest handle of a figure, or that of the body under a pointer.
function under(figure, { clientX, clientY }) {
    const { left, top } = figure.overlay.getBoundingClientRect();
    const [x, y] = [clientX - left, clientY - top];
    const away = ({ handle: { at } }) => Math.hypot(at[0] * figure.scale - x, at[1] * figure.scale - y);
    const near = [...figure.knobs.values()].filter((knob) => !knob.isGone && away(knob) <= REACH);
    const [nearest] = near.sort((a, b) => away(a) - away(b));
    // Words that can be marked may lie over a body.
    const all = document.elementsFromPoint(clientX, clientY);
    return nearest ?? figure.bodies?.get(all.map((element) => element.closest("[data-held]")).find(Boolean));
}

class Knob {
    constructor(figure, handle) {
        Object.assign(this, { figure, handle, worn: new Map() });
        const hit = make("circle", { class: "hit", r: REACH });
        const ring = make("circle", { class: "ring", r: handle.grip === "position" ? 11 : 7 });
        this.element = make("g", { class: `knob ${handle.grip}` }, hit, ring);
        this.element.addEventListener("keydown", (event) => this.key(event));
        for (const end of ["keyup", "blur"]) this.element.addEventListener(end, () => this.keyUp());
        this.element.addEventListener("pointermove", (event) => this.drag(event));
        for (const end of ["pointerup", "pointercancel", "lostpointercapture"]) {
            this.element.addEventListener(end, () => this.release());
        }
        figure.overlay.append(this.element);
    }

    get isGone() {
        return this.element.classList.contains("gone");
    }

    // Shows where it is; only the first of those that set the same can be reached by keys and heard.
    place(handle, isStop) {
        this.handle = handle;
        const [x, y] = handle.at.map((v) => v * this.figure.scale);
        const { name, value, range: [lo, hi] } = handle;
        const first = (numbers) => [numbers].flat()[0];
        const heard = {
            role: "slider", "aria-label": name, "aria-valuetext": this.figure.inWords(value) + unitOf(handle),
            "aria-valuenow": first(value), "aria-valuemin": first(lo), "aria-valuemax": first(hi),
        };
        this.wear("transform", `translate(${x} ${y})`);
        for (const [key, words] of Object.entries(heard)) this.wear(key, isStop ? words : undefined);
        this.wear("aria-hidden", isStop ? undefined : "true");
        // What listens to keys is a stop of its own in Chromium.
        this.wear("tabindex", isStop ? 0 : -1);
    }

    // Sets an attribute, or takes it away, where that is not done yet.
    wear(name, value) {
        if (this.worn.has(name) && this.worn.get(name) === value) return;
        this.worn.set(name, value);
        if (value === undefined) this.element.removeAttribute(name);
        else this.element.setAttribute(name, value);
    }

    grab(event) {
        const [x, y] = this.figure.pointer(event);
        this.off = [this.handle.at[0] - x, this.handle.at[1] - y];
        this.taken = this.handle;
        this.element.setPointerCapture(event.pointerId);
        this.element.focus({ preventScroll: true });
        this.figure.root.toggleAttribute("data-dragging", true);
        this.element.classList.add("dragged");
    }

    drag(event) {
        if (!this.off) return;
        if (event.buttons === 0) return this.release(); // Let go where nobody told us.
        const [x, y] = this.figure.pointer(event);
        // A view that fits what is drawn widens as that moves: by its new scale a way out would grow with
        // itself. So a value is that of the pointer's place in the picture where it was taken.
        const from = this.taken;
        const value = followed(from, [x + this.off[0], y + this.off[1]]);
        const step = event.altKey ? 0 : this.figure.snap(from);
        const clean = step ? snapped(value, step) : tidy(value, from);
        this.figure.want(this.handle, within(clean, from, step));
    }

    release() {
        if (!this.off) return;
        this.off = undefined;
        this.element.classList.remove("dragged");
        this.figure.root.toggleAttribute("data-dragging", false);
        this.figure.settle();
    }

    key(event) {
        const way = WAYS[event.key];
        const { figure, handle } = this;
        if (event.key === "Home") figure.want(handle, figure.first.get(keyOf(handle)));
        else if (event.key === "Escape" && this.off) figure.want(handle, this.taken.value);
        else if (way) figure.want(handle, within(this.stepped(way, event.shiftKey ? 0.2 : 1), handle));
        else return;
        event.preventDefault();
        if (event.key === "Escape") this.release();
        else this.pressed = true;
    }

    // A key that is held moves on and on, and comes to rest when it is let go.
    keyUp() {
        if (this.pressed) this.figure.settle();
        this.pressed = false;
    }

    // The value a step away: along the page for what lies in a plane, else more or less.
    stepped([x, y], share) {
        const { value, pull: { plane } } = this.handle;
        const step = (this.figure.snap(this.handle) || stepOf(this.handle)) * share;
        const round = (v) => Number(v.toPrecision(12));
        if (!plane) return round(value + (x - y) * step);
        // Half-extents grow to the right and up, wherever the box has turned. Of a body that has turned the
        // vertices move along that of its own axes which leads there most.
        const way = isSize(this.handle) ? [x, -y] : value.map((_, i) => plane[0][i] * x + plane[1][i] * y);
        const [a, b] = way.map((v) => Math.abs(v));
        const most = (y === 0 ? a >= NEARLY * b : b < NEARLY * a) ? 0 : 1;
        return value.map((v, i) => (i === most ? round(v + Math.sign(way[i]) * step) : v));
    }
}

// The numbers of a handle as fields: for readers who type, hear or switch.
class Row {
    constructor(figure, handle) {
        this.figure = figure;
        const unit = unitOf(handle).trim();
        const plain = handle.grip === "time" ? figure.word("time") : handle.name;
        const name = unit ? `${plain} (${unit})` : plain;
        const words = Array.isArray(handle.value) ? ["x", "y"] : [""];
        const field = (word) => make("input", {
            type: "number", step: figure.snap(handle) || "any", inputmode: "decimal",
            "aria-label": word ? `${name}, ${word}` : name,
        });
        this.fields = words.map(field);
        const change = () => {
            this.typed = undefined;
            const numbers = this.fields.map((field) => field.valueAsNumber);
            if (!numbers.every(Number.isFinite)) {
                figure.refuse("");
                figure.shown();
                return;
            }
            const value = words.length > 1 ? numbers : numbers[0];
            const asked = handle.grip === "time" ? within(value, handle) : value;
            figure.alive(() => figure.attempt(handle, asked, 0));
            figure.settle();
        };
        for (const field of this.fields) {
            field.addEventListener("input", () => (this.typed = field));
            field.addEventListener("change", change);
        }
        const shown = make("span", { "aria-hidden": "true" }, name);
        figure.numbers.append(shown, make("span", {}, ...this.fields));
    }

    // What is typed stays until it is done; then the field says what has become of it.
    show(value) {
        [value].flat().forEach((v, i) => {
            const field = this.fields[i];
            if (this.typed !== field && field.value !== String(v)) field.value = v;
        });
    }
}
