// A scene with what a reader has changed in it: remembered, taken back, copied, kept in the page's address.

const STEP = "step"; // What an address calls the step that is shown; paths of a scene begin otherwise.

class Edited {
    constructor(scene) {
        this.scene = scene;
        this.edits = new Map(); // What differs from the scene, by the keys of its handle.
        this.first = new Map(); // What the scene says there.
    }

    // What the module says of its picture. The playhead stays the one that the page began with: once its time
    // is set, no panel follows a clock, and the module would offer another.
    get info() {
        return this.told;
    }

    set info(info) {
        const isOther = (handle) => handle.grip === "time" && keyOf(handle) !== keyOf(this.clock ?? handle);
        this.told = info && { ...info, handles: info.handles.filter((handle) => !isOther(handle)) };
    }

    // The language of our words: the scene's, or English.
    get language() {
        const [language] = (this.scene.lang ?? "en").toLowerCase().split("-");
        return WORDS[language] ? language : "en";
    }

    // The value of a handle by its key as it is now.
    valueOf(key) {
        return this.edits.get(key)?.value ?? this.first.get(key);
    }

    // Words of ours in the language of the scene, with what stands in their places.
    word(key, ...parts) {
        const said = WORDS[this.language][key];
        return parts.reduce((words, part) => words.replace("{}", () => part), said);
    }

    // Digits as the scene's language writes them, and a value in words.
    number(digits) {
        return this.language !== "en" ? digits.replace(".", ",") : digits;
    }

    inWords(value) {
        const numbers = [value].flat().map((x) => this.number(digits(x)));
        const between = this.number(".") === "," ? "; " : ", ";
        return numbers.length > 1 ? `(${numbers.join(between)})` : numbers[0];
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

    remember(handle, value) {
        const key = keyOf(handle);
        if (String(value) === String(this.first.get(key))) this.edits.delete(key);
        else this.edits.set(key, { paths: handle.paths, value });
        this.root.toggleAttribute("data-changed", this.edits.size > 0);
    }

    // Takes all edits back, without drawing.
    forget() {
        const paths = [...this.edits.values()].flatMap((edit) => edit.paths);
        this.engine.set(paths.map((path) => [path, valueAt(this.scene, path) ?? null]));
        this.edits.clear();
        this.root.removeAttribute("data-changed");
    }

    reset() {
        this.alive(() => {
            this.forget();
            this.showStep(WHOLE, false);
            this.why.textContent = "";
            this.settleNow();
            // The button is gone now, and what is next to it has its place.
            this.bar.querySelector(".acts button:last-child").focus({ preventScroll: true });
        });
    }

    // Has the next drawing show a step.
    showStep(step, stepping) {
        [this.step, this.stepping] = [step, stepping];
        this.engine.x.tf_step(step);
    }

    // Whether an earlier step than the last is shown.
    get isAtStep() {
        return this.step < (this.info.steps?.length ?? 0);
    }

    async copy() {
        const written = toml(edited(this.scene, this.edits.values()), this.bodyNames);
        try {
            await navigator.clipboard.writeText(written);
            clearTimeout(this.voice); // What it would say is said along.
            const copied = this.word("copied");
            this.tell(`${copied} ${this.words()}`, `${copied} ${this.said()}`);
        } catch {
            const named = { class: "text", readonly: "", rows: 12, "aria-label": this.word("text") };
            this.text ??= make("textarea", named);
            this.bar.after(this.text);
            this.text.value = written;
            this.text.select();
        }
    }

    // What stands below the picture follows it; nobody hears it.
    see(words) {
        this.seen.lang = this.language;
        if (this.seen.textContent !== words) this.seen.textContent = words;
    }

    // The result, or what the step says that is shown.
    said() {
        // Whoever has gone through the steps reads the last one as it is, with the result at its end.
        const steps = this.stepping ? this.info.steps : undefined;
        const step = steps?.[Math.min(this.step, steps.length) - 1];
        if (!step || this.why.textContent) return this.info.sentence;
        const colon = this.language === "fr" ? "\u00a0:" : ":";
        const end = step.title.includes(":") ? "." : colon; // One colon is enough.
        return `${step.title}${end} ${step.sentences.join(" ")}`;
    }

    // What a reader hears: why not all was done, and what is seen below the picture.
    words() {
        const whole = this.why.textContent.replace(/[^.!?]$/, "$&.");
        return [whole, this.said()].filter(Boolean).join(" ");
    }

    // Says what is to be heard, after a rest.
    speak(pause = PAUSE) {
        clearTimeout(this.voice);
        this.voice = setTimeout(() => this.tell(this.words(), this.said()), pause);
    }

    tell(words, seen) {
        this.see(seen);
        this.say.lang = this.language;
        this.say.textContent = words;
        this.entitle();
        this.invite();
    }

    // What a reader drags, in the words of a hint: a body alone is its place.
    thing({ name, grip, paths: [[, body]] }) {
        return { position: body, vertices: this.word("vertices", body) }[grip] ?? this.word("the", name);
    }

    // Says what can be dragged in the picture as it is.
    invite() {
        const things = [...new Set(this.info.handles.filter(({ at }) => at).map(this.thing, this))];
        this.hint.textContent = this.word("drag", things.join(", "));
        this.hint.hidden = things.length === 0;
    }

    // The title of a page that says the result, and the long text below it: those of the picture as it is.
    entitle() {
        const of = (name) => this.picture.svg.querySelector(name)?.textContent;
        const long = this.root.querySelector("details.words p");
        this.long ??= [...(long?.childNodes ?? [])]; // As it came: powers of ten are raised.
        const now = this.edits.size > 0 && of("desc");
        long?.replaceChildren(...(now ? [now] : this.long));
        if (this.alone) document.title = of("title") ?? document.title;
    }

    toAddress() {
        if (!this.alone) return;
        const part = ({ paths: [path], value }) => `${addressOf(path)}=${[value].flat().join(",")}`;
        const parts = [...this.edits.values()].map(part);
        if (this.isAtStep) parts.push(`${STEP}=${this.step}`);
        history.replaceState(null, "", `#${parts.join("&")}`);
    }

    // Takes over what the address says of things that can be moved here.
    fromAddress() {
        if (this.alone && location.hash.length > 1) this.alive(() => this.takeAddress());
    }

    // Goes where another address says, which may be the scene as it is: back and forward of the browser.
    anew() {
        this.alive(() => {
            this.forget();
            this.takeAddress();
            this.settleNow();
        });
    }

    // Sets several values of a scene without edits together; whether they can be.
    takeAll(asked) {
        if (asked.length < 2 || !this.engine.set(asked.flatMap((one) => this.pairs(...one)))) return false;
        for (const [handle, value] of asked) this.remember(handle, value);
        if (this.draw()) return true;
        for (const [handle] of asked) this.remember(handle, this.first.get(keyOf(handle)));
        return false;
    }

    takeAddress() {
        const parts = this.alone ? location.hash.slice(1).split("&").filter(Boolean) : [];
        const said = new Map(parts.map((part) => part.split("=")));
        const isKnown = this.info.handles.some(({ grip }) => grip === "time");
        const clock = isKnown || !this.clock ? [] : [this.clock];
        const asked = [];
        for (const handle of [...this.info.handles, ...clock]) {
            const texts = said.get(addressOf(handle.paths[0]))?.split(",");
            const numbers = texts?.map((text) => (text ? Number(text) : Number.NaN));
            if (numbers?.length !== [handle.value].flat().length || !numbers.every(Number.isFinite)) continue;
            asked.push([handle, Array.isArray(handle.value) ? numbers : numbers[0]]);
        }
        // A vertex alone may not be where it is with another one.
        if (!this.takeAll(asked)) {
            // What an address says is set or not, as what is typed.
            for (const [handle, value] of asked) this.attempt(handle, value, 0);
        }
        // How many steps there are depends on what was moved.
        const step = Math.trunc(said.get(STEP));
        const isShown = Boolean(this.count) && step > 0 && step < this.info.steps.length;
        if (isShown || this.step !== WHOLE) this.showStep(isShown ? step : WHOLE, isShown);
        if (parts.length > 0) this.settleNow();
    }
}

// Makes a figure of the page live. Where it can't be the picture stays, and the author finds the reason.
function enliven(root, alone) {
    Figure.start(root, alone).catch((error) => {
        root.dataset.live = `no: ${error.message}`;
        console.warn(`tracefig: this figure does not move: ${error.message}`);
    });
}
