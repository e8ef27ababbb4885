// A scene with what a reader has changed in it: remembered, taken back, copied, kept in the page's address.

class Edited {
    constructor(scene) {
        this.scene = scene;
        this.edits = new Map(); // What differs from the scene, by the keys of its handle.
        this.first = new Map(); // What the scene says there.
    }

    // Words of ours in the language of the scene, with what stands in their places.
    word(key, ...parts) {
        const [language] = (this.scene.lang ?? "en").toLowerCase().split("-");
        const said = (WORDS[language] ?? WORDS.en)[key];
        return parts.reduce((words, part) => words.replace("{}", () => part), said);
    }

    // Digits as the scene's language writes them, and a value in words.
    number(digits) {
        return ["de", "fr", "es"].includes(this.scene.lang?.slice(0, 2)) ? digits.replace(".", ",") : digits;
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
            this.step = WHOLE;
            this.engine.x.tf_step(WHOLE);
            this.why.textContent = "";
            this.settleNow();
        });
    }

    async copy() {
        const written = toml(edited(this.scene, this.edits.values()));
        try {
            await navigator.clipboard.writeText(written);
            this.tell(this.word("copied"), this.scene.lang ?? "en");
        } catch {
            const named = { class: "text", readonly: "", rows: 12, "aria-label": this.word("text") };
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

    takeAddress() {
        const parts = this.alone ? location.hash.slice(1).split("&").filter(Boolean) : [];
        const said = new Map(parts.map((part) => part.split("=")));
        for (const handle of this.info.handles) {
            const numbers = said.get(addressOf(handle.paths[0]))?.split(",").map(Number);
            if (numbers?.length !== [handle.value].flat().length || !numbers.every(Number.isFinite)) continue;
            this.attempt(handle, Array.isArray(handle.value) ? numbers : numbers[0]);
        }
        if (parts.length > 0) this.settleNow();
    }
}
