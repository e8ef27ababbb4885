// A figure on a page that a reader drags, steps through and asks by numbers. The page says where its handles
// are, so that they are there at once; what is done with them waits for the module, which comes behind them.
// Its first drawing must be the picture of the page: else, and without the module, that stays and they go.

const REACH = 22; // How near a pointer comes to a handle, CSS pixels: with it a finger's 44.
const PAUSE = 400; // Milliseconds of rest before a reader hears the result.
const SLIDE = 120; // Milliseconds in which labels go to their places at rest.
const NARROW = 0.8; // A figure that is shown at less of its width is laid out for the width there is.
const TRIES = 6; // How often the way to what can't be is halved.
const WHOLE = 0xffffffff; // The step that shows the finished figure.
const still = matchMedia("(prefers-reduced-motion: reduce)");
const phone = matchMedia("(max-width: 600px)"); // There one is as wide as the page, whatever a book says.

class Figure extends Edited {
    // Makes a figure of the page live; it stays as it is where that can't be.
    static async start(root, alone) {
        const request = root.querySelector("script[type='application/json']").textContent;
        const figure = new Figure(root, request, alone);
        // What is on the page is seen first; what its address says waits for it.
        figure.begun = new Promise(requestAnimationFrame).then(() => figure.begin(request));
        if (figure.info && globalThis.WebAssembly?.compileStreaming) figure.build();
        try {
            await figure.begun;
        } catch (error) {
            for (const made of figure.around ?? []) made.remove();
            throw error;
        }
        if (figure.around) figure.shown();
        else figure.build();
        root.dataset.drawn = "";
        figure.warm(request);
    }

    // Drags a handle where nobody sees it, by a pixel a frame.
    warm(request) {
        const handle = this.info.handles.find(({ at }) => at);
        if (!handle) return;
        const dragged = (frame) => each(handle.value, (value) => value + frame * grainOf(handle));
        Engine.warm(request, (frame) => handle.paths.map((path) => [path, dragged(frame)]));
    }

    constructor(root, request, alone) {
        const { scene, info, id, bodyNames } = JSON.parse(request);
        super(scene);
        Object.assign(this, { root, alone, info, id, bodyNames });
        this.stage = root.querySelector("figure");
        this.picture = new Picture(this.stage.querySelector("svg"));
        this.knobs = new Map();
        this.rows = new Map();
        this.step = WHOLE;
    }

    // Draws for the first time, which must give the picture of the page.
    async begin(request) {
        const engine = await Engine.start(request);
        if (!engine.draw()) throw new Error(engine.info.error);
        const fits = this.picture.begin(engine.svg);
        if (!fits) throw new Error("the drawing is another one than the picture of the page");
        this.engine = engine;
        this.info = engine.info;
    }

    // ---- The page around the picture

    build() {
        this.overlay = make("svg", { class: "knobs", role: "group", "aria-label": this.word("moved") });
        this.seen = make("p", { class: "seen", "aria-hidden": "true" });
        this.say = make("p", { class: "say", role: "status" });
        this.why = make("p", { class: "why", "aria-hidden": "true" });
        this.bar = make("div", { class: "bar" });
        this.numbers = make("div", { class: "numbers" });
        const summary = make("summary", {}, this.word("numbers"));
        const details = make("details", { class: "numbers-of" }, summary, this.numbers);
        this.stage.append(this.overlay);
        this.stage.after(this.why, this.bar, this.seen, this.say, details);
        this.around = [this.overlay, this.why, this.bar, this.seen, this.say, details];
        this.fill();
        this.stage.addEventListener("pointerdown", (event) => this.grab(event));
        // A finger that holds something drags it; beside it the page scrolls. No style within an SVG says so.
        const keep = (event) => {
            if (event.touches.length === 1 && under(this, event.touches[0])) event.preventDefault();
        };
        this.stage.addEventListener("touchstart", keep, { passive: false });
        this.shown();
        new ResizeObserver(() => this.fit()).observe(this.root);
        if (this.alone) addEventListener("hashchange", () => this.anew());
        this.fromAddress();
        this.speak(0);
        this.root.dataset.live = "yes";
    }

    fill() {
        const live = this.scene.live ?? {};
        const time = this.info.handles.find((handle) => handle.grip === "time");
        this.clock = time;
        if (time) this.bar.append(this.playhead(time));
        if ((this.info.steps?.length ?? 0) > 1 && live.steps !== false) {
            const go = (to) => () => this.toStep(to());
            const last = () => this.info.steps.length;
            const now = () => Math.min(this.step, last());
            const back = () => Math.max(now() - 1, 1);
            const on = () => (now() + 1 >= last() ? WHOLE : now() + 1);
            this.count = make("span", { class: "count" });
            this.before = button(sign("◀"), go(back), { "aria-label": this.word("before") });
            this.after = button(sign("▶"), go(on), { "aria-label": this.word("after") });
            this.bar.append(make("span", { class: "steps" }, this.before, this.count, this.after));
        }
        this.hint = make("p", { class: "hint" });
        this.bar.before(this.hint);
        this.around.push(this.hint);
        this.invite();
        const parts = [this.scene, ...(this.scene.panels ?? [])];
        if (parts.some(({ headline, caption }) => headline ?? caption)) {
            const written = make("p", { class: "hint written" }, this.word("written"));
            this.bar.before(written);
            this.around.push(written);
        }
        const reset = button(this.word("reset"), () => this.reset(), { class: "reset" });
        const copy = button(this.word("copy"), () => this.copy());
        this.bar.append(make("span", { class: "acts" }, reset, copy));
    }

    playhead(handle) {
        const bounds = { type: "range", min: 0, max: 1, step: 0.01 };
        const range = make("input", { ...bounds, "aria-label": this.word("time") });
        const said = make("output", {});
        const show = (value) => {
            if (document.activeElement !== range) range.value = value;
            said.value = `t = ${this.number(Number(value).toFixed(2))}`;
            range.setAttribute("aria-valuetext", said.value);
        };
        range.addEventListener("input", () => this.want(handle, Number(range.value)));
        range.addEventListener("change", () => this.settle());
        this.showTime = show;
        return make("label", { class: "time" }, this.word("time"), range, said);
    }

    // ---- From values to a picture

    snap(handle) {
        return this.scene.live?.snap === 0 ? 0 : stepOf(handle, this.scene.live?.snap);
    }

    // Sets a value in the next frame; of several the last.
    want(handle, value) {
        this.wanted = { handle, value };
        this.frame ??= requestAnimationFrame(() => this.alive(() => this.frame && this.attemptWanted()));
    }

    attemptWanted() {
        this.frame = undefined;
        this.attempt(this.wanted.handle, this.wanted.value);
    }

    // Does something with the module, as soon as it is there. After a trap it is of no use: another one takes
    // its place and the picture stays.
    alive(act) {
        if (!this.engine) {
            this.begun?.then(() => this.alive(act), () => {});
            return;
        }
        try {
            act();
        } catch (error) {
            if (!(error instanceof WebAssembly.RuntimeError)) throw error;
            this.refuse(this.word("not"));
            this.engine.open().then(() => {
                this.engine.x.tf_step(this.step);
                if (this.engine.set(this.all())) this.draw();
            });
        }
    }

    // Sets a value, or of the way there as much as can be, and says why not all; what is typed is set or not.
    attempt(handle, value, tries = TRIES) {
        const key = keyOf(handle);
        const before = this.valueOf(key) ?? handle.value;
        // A pointer that moves by less than a step changes nothing, once its value is reached.
        if (String(value) === String(before) && !this.why.textContent) return;
        let reached = value;
        let why = "";
        if (!this.engine.set(this.pairs(handle, value))) {
            why = this.engine.info.error;
            let [good, bad] = [0, 1];
            reached = before;
            for (let i = 0; i < tries; i++) {
                const middle = (good + bad) / 2;
                const there = short(between(before, value, middle), handle);
                if (this.engine.set(this.pairs(handle, there))) [good, reached] = [middle, there];
                else bad = middle;
            }
        }
        this.remember(handle, reached);
        if (!this.draw()) return this.remember(handle, before);
        this.refuse(why);
        this.see(this.said()); // A reader hears it at rest.
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
            if (!handle.at) continue;
            const knob = this.knob(handle);
            seen.add(knob);
            knob.place(handle, !stops.has(key));
            stops.add(key);
        }
        // A panel that was given a time has no playhead that the module knows of.
        if (this.clock) this.showTime(this.valueOf(keyOf(this.clock)));
        for (const knob of this.knobs.values()) knob.element.classList.toggle("gone", !seen.has(knob));
        // What has left its panel has no handle, and numbers still.
        const keys = new Set(this.info.handles.map(keyOf));
        for (const [key, row] of this.rows) {
            if (!keys.has(key)) row.show(this.valueOf(key));
        }
        const held = this.info.handles.map(({ panel, name }) => `${panel} ${name}`).join();
        // The module's first picture is compared with that of the page as it came.
        if (this.engine && (!stays || held !== this.heldBy)) this.hold();
        this.heldBy = held;
        if (this.count) {
            const last = this.info.steps.length;
            const now = Math.min(this.step, last);
            this.count.textContent = this.word("step", now, last);
            this.before.setAttribute("aria-disabled", now <= 1);
            this.after.setAttribute("aria-disabled", now >= last);
            this.root.toggleAttribute("data-at-step", this.isAtStep); // On paper it has its words.
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
            const panel = this.picture.svg.getElementById(`${this.id}-panel-${handle.panel + 1}`);
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
        // What is held has lost its place in the layout.
        if (room !== this.had) for (const knob of this.knobs.values()) knob.release();
        this.had = room;
        this.own ??= this.picture.size[0];
        const asAsked = this.stage.style.width && !phone.matches;
        const width = room < NARROW * this.own && !asAsked ? Math.max(Math.floor(room), 240) : undefined;
        this.measure();
        if (width === this.room) return this.shown();
        this.room = width;
        this.alive(() => this.refit(width));
    }

    refit(width) {
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
        this.engine.x.tf_rest();
        if (!this.engine.set([[["canvas"], this.canvas()]]) || !this.draw()) this.width = before;
    }

    canvas() {
        if (!this.width) return this.scene.canvas ?? null;
        const { columns, height, ...canvas } = this.scene.canvas ?? {};
        return { ...canvas, width: this.width };
    }

    // ---- Handles

    // The vertices of a box share the name of what they set.
    knob(handle) {
        const key = `${handle.panel} ${handle.vertex} ${handle.name}`;
        if (!this.knobs.has(key)) this.knobs.set(key, new Knob(this, handle));
        return this.knobs.get(key);
    }

    // Takes hold of what is under the pointer.
    grab(event) {
        const knob = event.button === 0 && under(this, event);
        // A second finger takes nothing away from the first.
        if (!knob || "dragging" in this.root.dataset) return;
        event.preventDefault();
        knob.grab(event);
    }

    pointer(event) {
        const { left, top } = this.overlay.getBoundingClientRect();
        return [(event.clientX - left) / this.scale, (event.clientY - top) / this.scale];
    }

    // After a change: labels go to where a still picture has them, the address says it, and a voice.
    settle() {
        this.alive(() => this.settleNow());
    }

    settleNow() {
        if (this.frame) {
            cancelAnimationFrame(this.frame);
            this.attemptWanted();
        }
        const labels = () => [...this.picture.svg.querySelectorAll('[id*="-label-"]')];
        const places = () => labels().map((label) => [label, label.getBoundingClientRect()]);
        const before = new Map(places());
        const why = this.why.textContent;
        this.engine.x.tf_rest();
        this.draw();
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

    toStep(step) {
        [this.step, this.stepping] = [step, true];
        this.alive(() => {
            this.refuse("");
            this.showStep(step, true);
            this.draw();
            this.toAddress();
            this.speak(0);
        });
    }

    row(handle) {
        const key = keyOf(handle);
        if (!this.rows.has(key)) this.rows.set(key, new Row(this, handle));
        return this.rows.get(key);
    }
}
