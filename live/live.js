// A figure on a page that a reader drags, steps through and asks by numbers. What is on the page before stays
// until the module's first drawing is the same; without the module there is nothing but that, and no control
// that does nothing.

const REACH = 22; // How near a pointer comes to a handle, CSS pixels: with it a finger's 44.
const PAUSE = 400; // Milliseconds of rest before a reader hears the result.
const SLIDE = 120; // Milliseconds in which labels go to their places at rest.
const NARROW = 0.8; // A figure that is shown at less of its width is laid out for the width there is.
const TRIES = 6; // How often the way to what can't be is halved.
const WHOLE = 0xffffffff; // The step that shows the finished figure.
const still = matchMedia("(prefers-reduced-motion: reduce)");
const phone = matchMedia("(max-width: 600px)"); // There one is as wide as the page, whatever a book says.

class Figure {
    // Makes a figure of the page live; it stays as it is where that can't be.
    static async start(root, alone) {
        const request = root.querySelector("script[type='application/json']").textContent;
        const figure = new Figure(root, request, await Engine.start(request), alone);
        if (!figure.engine.draw()) throw new Error(figure.engine.info.error);
        const fits = figure.picture.begin(figure.engine.svg);
        if (!fits) throw new Error("the drawing is another one than the picture of the page");
        figure.build();
        root.dataset.live = "yes";
    }

    constructor(root, request, engine, alone) {
        Object.assign(this, { root, engine, alone });
        this.scene = JSON.parse(request).scene;
        this.stage = root.querySelector("figure");
        this.picture = new Picture(this.stage.querySelector("svg"));
        this.edits = new Map(); // What differs from the scene, by the keys of its handle.
        this.first = new Map(); // What the scene says there.
        this.knobs = new Map();
        this.rows = new Map();
        this.step = WHOLE;
    }

    // ---- The page around the picture

    build() {
        this.info = this.engine.info;
        this.overlay = make("svg", { class: "knobs", role: "group", "aria-label": "What can be moved" });
        this.say = make("p", { class: "say", role: "status" });
        this.why = make("p", { class: "why", "aria-hidden": "true" });
        this.bar = make("div", { class: "bar" });
        this.numbers = make("div", { class: "numbers" });
        const summary = make("summary", {}, "By numbers");
        const details = make("details", { class: "numbers-of" }, summary, this.numbers);
        this.stage.append(this.overlay);
        this.stage.after(this.why, this.bar, this.say, details);
        this.fill();
        this.stage.addEventListener("pointerdown", (event) => this.grab(event));
        this.shown();
        new ResizeObserver(() => this.fit()).observe(this.root);
        if (this.alone) addEventListener("hashchange", () => this.forget() ?? this.fromAddress());
        this.fromAddress();
        this.speak(0);
    }

    fill() {
        const live = this.scene.live ?? {};
        const time = this.info.handles.find((handle) => handle.grip === "time");
        if (time) this.bar.append(this.playhead(time));
        if (this.engine.x.tf_step && (this.info.steps?.length ?? 0) > 1 && live.steps !== false) {
            const go = (to) => () => this.toStep(to());
            const last = () => this.info.steps.length;
            const now = () => Math.min(this.step, last() + 1);
            const [back, on] = [() => Math.max(now() - 1, 1), () => (now() >= last() ? WHOLE : now() + 1)];
            this.count = make("span", { class: "count" });
            const before = button(sign("◀"), go(back), { "aria-label": "previous step" });
            const after = button(sign("▶"), go(on), { "aria-label": "next step" });
            this.bar.append(make("span", { class: "steps" }, before, this.count, after));
        }
        const things = [...new Set(this.info.handles.filter(({ at }) => at).map(thing))];
        if (things.length > 0) this.bar.before(make("p", { class: "hint" }, `Drag ${things.join(", ")}.`));
        const reset = button("Reset", () => this.reset(), { class: "reset" });
        const copy = button("Copy as TOML", () => this.copy());
        this.bar.append(make("span", { class: "acts" }, reset, copy));
    }

    playhead(handle) {
        const range = make("input", { type: "range", min: 0, max: 1, step: 0.01, "aria-label": "time" });
        const said = make("output", {});
        const show = (value) => {
            if (document.activeElement !== range) range.value = value;
            said.value = `t = ${Number(value).toFixed(2)}`;
            range.setAttribute("aria-valuetext", said.value);
        };
        range.addEventListener("input", () => this.want(handle, Number(range.value)));
        range.addEventListener("change", () => this.settle());
        this.showTime = show;
        return make("label", { class: "time" }, "time", range, said);
    }

    // ---- From values to a picture

    snap(handle) {
        return this.scene.live?.snap === 0 ? 0 : stepOf(handle, this.scene.live?.snap);
    }

    // Sets a value in the next frame; of several the last.
    want(handle, value) {
        this.wanted = { handle, value };
        this.frame ??= requestAnimationFrame(() => {
            this.frame = undefined;
            this.alive(() => this.attempt(this.wanted.handle, this.wanted.value));
        });
    }

    // After a trap the module is of no use: another one takes its place and the picture stays.
    alive(act) {
        try {
            act();
        } catch (error) {
            if (!(error instanceof WebAssembly.RuntimeError)) throw error;
            this.refuse("That can’t be drawn.");
            this.engine.open().then(() => this.engine.set(this.all()) && this.draw());
        }
    }

    // What is to be set where; what the scene says already, as it says it.
    pairs(handle, value) {
        const own = String(value) === String(this.first.get(keyOf(handle)));
        return handle.paths.map((path) => [path, own ? (valueAt(this.scene, path) ?? null) : value]);
    }

    // Every edit, with the width that the page has.
    all() {
        const edits = [...this.edits.values()].flatMap(({ paths, value }) => this.pairs({ paths }, value));
        return this.width ? [...edits, [["canvas"], this.canvas()]] : edits;
    }

    // Sets a value, or of the way there as much as can be, and says why not all.
    attempt(handle, value) {
        const key = keyOf(handle);
        const before = this.edits.get(key)?.value ?? this.first.get(key) ?? handle.value;
        let reached = value;
        let why = "";
        if (!this.engine.set(this.pairs(handle, value))) {
            why = this.engine.info.error;
            let [good, bad] = [0, 1];
            for (let i = 0; i < TRIES; i++) {
                const middle = (good + bad) / 2;
                if (this.engine.set(this.pairs(handle, between(before, value, middle)))) good = middle;
                else bad = middle;
            }
            reached = between(before, value, good);
        }
        if (!this.draw()) return;
        this.remember(handle, reached);
        this.refuse(why);
    }

    remember(handle, value) {
        const key = keyOf(handle);
        if (String(value) === String(this.first.get(key))) this.edits.delete(key);
        else this.edits.set(key, { paths: handle.paths, value });
        this.root.toggleAttribute("data-changed", this.edits.size > 0);
    }

    refuse(why) {
        this.why.textContent = why;
        this.root.toggleAttribute("data-refused", why !== "");
        if (why) this.speak();
    }

    // Draws the scene as it is; where it can't be drawn the module is again as it was.
    draw() {
        const start = performance.now();
        if (!this.engine.draw()) {
            this.refuse(this.engine.info.error);
            return false;
        }
        const drawn = performance.now();
        const stays = this.picture.patch(this.engine.svg);
        this.info = this.engine.info;
        this.shown(stays);
        const ms = { module: drawn - start, all: performance.now() - start };
        this.root.dispatchEvent(new CustomEvent("tracefig", { bubbles: true, detail: { ...this.info, ms } }));
        return true;
    }

    // Asks how large the picture is shown: not in a frame, which would have to be laid out twice for that.
    measure() {
        this.wide = this.picture.size[0];
        this.scale = this.stage.clientWidth / this.wide;
    }

    // Brings handles and numbers to where the picture has them; whether its elements stayed as they were.
    shown(stays = false) {
        if (this.picture.size[0] !== this.wide) this.measure();
        const seen = new Set();
        const stops = new Set();
        for (const handle of this.info.handles) {
            const key = keyOf(handle);
            if (!this.first.has(key)) this.first.set(key, this.written(handle) ?? handle.value);
            this.row(handle).show(handle.value);
            if (handle.grip === "time") this.showTime(handle.value);
            if (!handle.at) continue;
            const knob = this.knob(handle);
            seen.add(knob);
            knob.place(handle, !stops.has(key));
            stops.add(key);
        }
        for (const knob of this.knobs.values()) knob.element.classList.toggle("gone", !seen.has(knob));
        const held = this.info.handles.map(({ panel, name }) => `${panel} ${name}`).join();
        if (!stays || held !== this.heldBy) this.hold();
        this.heldBy = held;
        if (this.count) {
            const [now, last] = [this.step, this.info.steps.length];
            this.count.textContent = now >= last ? `${last} steps` : `step ${now} of ${last}`;
        }
    }

    // What the scene says where a handle sets it; a word for a moment is none.
    written({ paths: [path], value }) {
        const said = valueAt(this.scene, path);
        return typeof said === typeof value ? said : undefined;
    }

    // Marks the bodies that can be dragged by any of their points.
    hold() {
        const held = new Map();
        for (const handle of this.info.handles.filter(({ grip }) => grip === "position")) {
            const side = ["A", "B"][this.scene.query.of.indexOf(handle.paths[0][1])];
            const panel = this.picture.svg.querySelector(`[id$="-panel-${handle.panel + 1}"]`);
            const body = side && panel?.querySelector(`[id*="-body-${side}"]`);
            if (body) held.set(body, this.knob(handle));
        }
        for (const body of this.bodies?.keys() ?? []) if (!held.has(body)) delete body.dataset.held;
        for (const body of held.keys()) body.dataset.held = "";
        this.bodies = held;
    }

    // The width of the page where the figure's own would be unreadably small.
    fit() {
        const room = this.root.clientWidth;
        this.own ??= this.picture.size[0];
        const asAsked = this.stage.style.width && !phone.matches;
        const width = room < NARROW * this.own && !asAsked ? Math.max(Math.floor(room), 240) : undefined;
        this.measure();
        if (width === this.room) return this.shown();
        this.room = width;
        this.layOut(width);
        // What can't be folded, as a formula, needs more; then letters are a little smaller.
        const words = this.picture.svg.querySelectorAll('[id$="-caption"],[id$="-headline"]');
        const boxes = Array.from(words, (text) => text.getBBox());
        const most = Math.max(...boxes.map((box) => 2 * box.x + box.width));
        if (width && most > width + 1) this.layOut(Math.ceil(most));
        this.refuse("");
    }

    layOut(width) {
        const before = this.width;
        this.width = width;
        this.engine.x.tf_rest?.();
        if (!this.engine.set([[["canvas"], this.canvas()]]) || !this.draw()) this.width = before;
    }

    canvas() {
        if (!this.width) return this.scene.canvas ?? null;
        const { columns, height, ...canvas } = this.scene.canvas ?? {};
        return { ...canvas, width: this.width };
    }

    // ---- Handles

    knob(handle) {
        const key = `${handle.panel} ${handle.name}`;
        if (!this.knobs.has(key)) this.knobs.set(key, new Knob(this, handle));
        return this.knobs.get(key);
    }

    // Takes hold of the nearest handle, or of the body under the pointer.
    grab(event) {
        if (event.button !== 0) return;
        const { left, top } = this.overlay.getBoundingClientRect();
        const [x, y] = [event.clientX - left, event.clientY - top];
        const away = ({ handle: { at } }) => Math.hypot(at[0] * this.scale - x, at[1] * this.scale - y);
        const near = [...this.knobs.values()].filter((knob) => !knob.isGone && away(knob) <= REACH);
        const [nearest] = near.sort((a, b) => away(a) - away(b));
        // Words that can be marked may lie over a body.
        const under = document.elementsFromPoint(event.clientX, event.clientY);
        const held = under.map((element) => element.closest("[data-held]")).find(Boolean);
        const knob = nearest ?? this.bodies.get(held);
        if (!knob) return;
        event.preventDefault();
        knob.grab(event);
    }

    pointer(event) {
        const { left, top } = this.overlay.getBoundingClientRect();
        return [(event.clientX - left) / this.scale, (event.clientY - top) / this.scale];
    }

    // After a change: labels go to where a still picture has them, the address says it, and a voice.
    settle() {
        if (this.frame) {
            cancelAnimationFrame(this.frame);
            this.frame = undefined;
            this.alive(() => this.attempt(this.wanted.handle, this.wanted.value));
        }
        const labels = () => [...this.picture.svg.querySelectorAll('[id*="-label-"]')];
        const places = () => labels().map((label) => [label, label.getBoundingClientRect()]);
        const before = new Map(places());
        const why = this.why.textContent;
        this.engine.x.tf_rest?.();
        this.alive(() => this.draw());
        this.refuse(why);
        for (const [label, { x, y }] of still.matches ? [] : places()) {
            const from = before.get(label);
            if (!from || Math.hypot(from.x - x, from.y - y) < 0.5) continue;
            const by = `translate(${(from.x - x) / this.scale}px, ${(from.y - y) / this.scale}px)`;
            const way = [{ transform: by }, { transform: "none" }];
            label.animate(way, { duration: SLIDE, easing: "ease-out" });
        }
        this.toAddress();
        this.speak();
    }

    // ---- What is said

    speak(pause = PAUSE) {
        clearTimeout(this.voice);
        this.voice = setTimeout(() => (this.say.textContent = this.words()), pause);
    }

    words() {
        const why = this.why.textContent;
        const step = this.info.steps?.[this.step - 1];
        if (!step || why) return [why, this.info.sentence].filter(Boolean).join(" ");
        return `${step.title}: ${step.sentences.join(" ")}`;
    }

    toStep(step) {
        this.step = step;
        this.engine.x.tf_step(step);
        this.alive(() => this.draw());
        this.speak(0);
    }

    row(handle) {
        const key = keyOf(handle);
        if (!this.rows.has(key)) this.rows.set(key, new Row(this, handle));
        return this.rows.get(key);
    }

    // ---- Away from here

    // Takes all edits back, without drawing.
    forget() {
        const paths = [...this.edits.values()].flatMap((edit) => edit.paths);
        this.engine.set(paths.map((path) => [path, valueAt(this.scene, path) ?? null]));
        this.edits.clear();
        this.root.removeAttribute("data-changed");
    }

    reset() {
        this.forget();
        this.step = WHOLE;
        this.engine.x.tf_step?.(WHOLE);
        this.why.textContent = "";
        this.settle();
    }

    async copy() {
        const written = toml(edited(this.scene, this.edits.values()));
        try {
            await navigator.clipboard.writeText(written);
            this.say.textContent = "The scene is on the clipboard.";
        } catch {
            const named = { class: "text", readonly: "", rows: 12, "aria-label": "The scene as TOML" };
            this.text ??= make("textarea", named);
            this.bar.after(this.text);
            this.text.value = written;
            this.text.select();
        }
    }

    toAddress() {
        if (!this.alone) return;
        const part = ({ paths: [path], value }) => `${addressOf(path)}=${[value].flat().join(",")}`;
        history.replaceState(null, "", `#${[...this.edits.values()].map(part).join("&")}`);
    }

    // Takes over what the address says of things that can be moved here.
    fromAddress() {
        const parts = this.alone ? location.hash.slice(1).split("&").filter(Boolean) : [];
        const said = new Map(parts.map((part) => part.split("=")));
        for (const handle of this.info.handles) {
            const numbers = said.get(addressOf(handle.paths[0]))?.split(",").map(Number);
            if (numbers?.length !== [handle.value].flat().length || !numbers.every(Number.isFinite)) continue;
            this.attempt(handle, Array.isArray(handle.value) ? numbers : numbers[0]);
        }
        if (parts.length > 0) this.settle();
    }
}
