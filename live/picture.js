// The module that draws, and the picture on the page: of each new text of it only what differs is changed.

let compiled; // The module, of all figures of a page.
let isWarm = false;
const FRAMES = 32; // Frames that nobody sees,
const WARMING = 500; // and the milliseconds that they may take together.
const [DECODER, ENCODER] = [new TextDecoder(), new TextEncoder()];
function compile() {
    const inline = () => document.getElementById("tracefig-module").textContent.trim();
    const bytes = unpacked(globalThis.tracefigModule ?? inline());
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
    // It is compiled while it is inflated.
    const headers = { "Content-Type": "application/wasm" };
    return WebAssembly.compileStreaming(new Response(stream, { headers }));
}

function unpacked(base64) {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(base64);
    const packed = atob(base64);
    const bytes = new Uint8Array(packed.length);
    for (let i = 0; i < bytes.length; i++) bytes[i] = packed.charCodeAt(i);
    return bytes;
}

// One figure in the module. Its calls take and leave texts in the module's memory.
class Engine {
    static async start(request) {
        const engine = new Engine();
        engine.request = request;
        await engine.open();
        return engine;
    }

    async open() {
        this.x = (await WebAssembly.instantiate(await (compiled ??= compile()), {})).exports;
        if (!this.tell("tf_open", this.request)) throw new Error(this.info.error);
    }

    // Draws frames of a drag that nobody sees, while the page rests: what runs often the browser compiles
    // better, and the first frames that someone sees are as fast as the later ones. `edits` gives those of
    // each frame. One figure of a page does it for all.
    static async warm(request, edits) {
        if (isWarm || !globalThis.requestIdleCallback) return;
        isWarm = true;
        const engine = await Engine.start(request);
        if (!engine.draw()) return;
        const unseen = document.createElement("div");
        unseen.innerHTML = engine.svg;
        const picture = new Picture(unseen.firstElementChild);
        picture.begin(engine.svg);
        let left = WARMING;
        const stop = () => { left = 0; };
        for (const act of ["pointerdown", "keydown"]) addEventListener(act, stop, { once: true });
        for (let frame = 0; frame < FRAMES && left > 0; frame++) {
            await new Promise((resolve) => requestIdleCallback(resolve));
            const start = performance.now();
            if (engine.set(edits(frame)) && engine.draw()) picture.patch(engine.svg);
            left -= performance.now() - start;
        }
    }

    // What the last call had to say.
    get info() {
        return JSON.parse(this.read(this.x.tf_info(), this.x.tf_info_len()));
    }

    // The picture as last drawn.
    get svg() {
        return this.read(this.x.tf_out(), this.x.tf_out_len());
    }

    read(start, length) {
        return DECODER.decode(new Uint8Array(this.x.memory.buffer, start, length));
    }

    // Hands a text to a call; whether it was taken.
    tell(call, said) {
        const bytes = ENCODER.encode(said);
        const room = this.x.tf_input(bytes.length);
        new Uint8Array(this.x.memory.buffer, room, bytes.length).set(bytes);
        return this.x[call]() === 1;
    }

    // Edits the scene, all of them or none; whether it still is one.
    set(edits) {
        return this.tell("tf_set", JSON.stringify(edits));
    }

    // Draws it; whether it could be drawn.
    draw() {
        return this.x.tf_draw() === 1;
    }
}

const XLINK = "http://www.w3.org/1999/xlink";
const ENTITY = { lt: "<", gt: ">", quot: '"', apos: "'", "#39": "'", amp: "&" };
const entity = (_, name) => ENTITY[name];
const unescaped = (s) => (s.includes("&") ? s.replace(/&(lt|gt|quot|apos|#39|amp);/g, entity) : s);
const ATTRIBUTE = /([\w:-]+)="([^"]*)"/g;
const attributesOf = (tag) => Array.from(tag.matchAll(ATTRIBUTE), (m) => [m[1], unescaped(m[2])]);
// The name of an attribute, of what stands before its value.
const nameAt = (before) => before.slice(before.lastIndexOf(" ") + 1, -1);

// The tag that begins a line of such a text, with its name, its id, and what follows it there.
const HEAD = /^<([\w:-]+)(?: id="([^"]*)")?[^>]*>/;
const tagOf = (line) => line.slice(0, line.indexOf(">") + 1);
const ofText = (rest) => /^[^<]*/.exec(rest)[0];

// A line without so many tags at its end.
function cut(line, tags) {
    let end = line.length;
    for (let i = 0; i < tags; i++) end = line.lastIndexOf("<", end - 1);
    return line.slice(0, end);
}

// A text that tracefig wrote, in lines of which each tag that opens an element begins one. Between them
// stands a line break, or as in a book a space.
class Written {
    constructor(text) {
        this.lineEnd = text[text.indexOf(">") + 1];
        this.lines = text.split(this.lineEnd === "\n" ? "\n" : / (?=<)/);
    }

    // Has the elements of another text where that has them.
    like({ last, after }) {
        return Object.assign(this, { last, after });
    }

    // Finds its elements. Each is named by the line that it begins: `last` has the line in which it ends, and
    // `after` how many that lie around it end there too.
    outlined() {
        [this.last, this.after] = [[], []];
        const open = [];
        for (const [i, line] of this.lines.entries()) {
            const opens = line[0] === "<" && line[1] !== "/";
            const end = opens ? line.indexOf(">") + 1 : 0;
            if (opens) open.push(i);
            let closing = opens && line[end - 2] === "/" ? 1 : 0;
            for (let at = end; (at = line.indexOf("</", at)) >= 0; at += 2) closing += 1;
            while (closing > 0) {
                const element = open.pop();
                this.last[element] = i;
                this.after[element] = closing -= 1;
            }
        }
        return this;
    }

    // The elements in one.
    kids(element) {
        const kids = [];
        for (let line = element + 1; line <= this.last[element]; line++) {
            if (this.last[line] === undefined) continue;
            const [tag, name, id] = HEAD.exec(this.lines[line]);
            kids.push({ line, tag, name, id });
            line = this.last[line];
        }
        return kids;
    }

    // One as it is written.
    of(element) {
        const [last, after] = [this.last[element], this.after[element]];
        return [...this.lines.slice(element, last), cut(this.lines[last], after)].join(this.lineEnd);
    }

    // What is written in it.
    inner(element) {
        const [text, tag] = [this.of(element), tagOf(this.lines[element])];
        return tag.endsWith("/>") ? "" : text.slice(tag.length, text.lastIndexOf("</"));
    }

    // Whether its end has a line of its own.
    trails(element) {
        return this.lines[this.last[element]].startsWith("</");
    }
}

// Whether two lines begin an element of the same name, and of the same id where that matters.
function isKin(a, b, isStrict) {
    // Most begin with an attribute that is no id.
    const quote = a.indexOf('"') + 1;
    if (quote > 0 && b.startsWith(a.slice(0, quote)) && !a.endsWith(' id="', quote)) return a[0] === "<";
    const [was, is] = [HEAD.exec(a), HEAD.exec(b)];
    return was !== null && was[1] === is?.[1] && (!isStrict || was[2] === is[2]);
}

// What differs between the lines of two elements that have the same ones in them: each line with both its
// tags, and other words. The first may have another id.
function differences(old, from, now, to) {
    const more = now.last[to] - to;
    if (old.last[from] - from !== more) return undefined;
    const differ = [];
    for (let i = 0; i <= more; i++) {
        let [a, b] = [old.lines[from + i], now.lines[to + i]];
        if (i === more) [a, b] = [cut(a, old.after[from]), cut(b, now.after[to])];
        if (a === b) continue;
        if (!isKin(a, b, i > 0)) return undefined;
        const [was, is] = [a, b].map(tagOf);
        if (was.endsWith("/>") !== is.endsWith("/>")) return undefined;
        const [before, after] = [a.slice(was.length), b.slice(is.length)];
        const [words, said] = before === after ? ["", ""] : [before, after].map(ofText);
        // Words that end in their line.
        const isRead = words !== before && before.slice(words.length) === after.slice(said.length);
        if (before !== after && !isRead) return undefined;
        differ.push([i, was, is, words === said ? undefined : said]);
    }
    return differ;
}

// How many at the beginning of two lists are the same, and how many after those at their ends.
function alike(old, now) {
    const least = Math.min(old.length, now.length);
    let [begin, end] = [0, 0];
    while (begin < least && old[begin] === now[begin]) begin += 1;
    while (begin + end < least && old[old.length - 1 - end] === now[now.length - 1 - end]) end += 1;
    return [begin, end];
}

// Which old child each next one goes on as: that of its id, or else what is written as it is, from either
// end, and between those, in their order, one of its name that none needs.
function kindred(old, next) {
    const goesOn = ({ name, id }, i) => name === next[i].name && id === next[i].id;
    if (old.length === next.length && old.every(goesOn)) return new Map(next.map((kid, i) => [kid, old[i]]));
    const known = new Map(old.filter((kid) => kid.id).map((kid) => [kid.id, kid]));
    const same = (kid) => (known.get(kid.id)?.name === kid.name ? known.get(kid.id) : undefined);
    const pairs = new Map(next.map((kid) => [kid, same(kid)]));
    const taken = new Set(pairs.values());
    const free = old.filter((kid) => !taken.has(kid));
    const rest = next.filter((kid) => !pairs.get(kid));
    const [begin, end] = alike(free.map(({ tag }) => tag), rest.map(({ tag }) => tag));
    for (let i = 0; i < begin; i++) pairs.set(rest[i], free[i]);
    for (let i = 1; i <= end; i++) pairs.set(rest.at(-i), free.at(-i));
    let from = begin;
    const to = free.length - end;
    for (const kid of rest.slice(begin, rest.length - end)) {
        const at = free.findIndex((other, i) => i >= from && i < to && other.name === kid.name);
        if (at < 0) continue;
        pairs.set(kid, free[at]);
        from = at + 1;
    }
    return pairs;
}

class Picture {
    constructor(svg) {
        this.svg = svg;
        // What the file says of itself is of the picture as it came; the module draws none.
        const metadata = svg.querySelector("metadata");
        metadata?.previousSibling.remove(); // The end of the line before it.
        metadata?.remove();
    }

    // Width and height in page pixels.
    get size() {
        return this.svg.getAttribute("viewBox").split(" ").slice(2).map(Number);
    }

    // Takes what the page shows for the picture of this text; whether it is.
    begin(text) {
        this.text = new Written(text).outlined();
        this.elements = []; // By the lines that they begin.
        const isOurs = (element, line) => isOf(this.text, line, element);
        return bind(this.text, this.elements, 0, this.svg) && this.elements.every(isOurs);
    }

    // Shows another text; whether all elements stayed. In most frames they do.
    patch(text) {
        const next = new Written(text);
        const { lines } = this.text;
        // Another page size moves all that lies over the picture.
        const isOfSize = next.lines.length === lines.length && next.lines[0] === lines[0];
        const differ = isOfSize && differences(this.text, 0, next.like(this.text), 0);
        if (differ) {
            this.redress(differ, 0);
            this.text = next;
            return true;
        }
        const drawn = { text: next.outlined(), elements: [] };
        this.morph(0, drawn, 0);
        Object.assign(this, drawn);
        return false;
    }

    // Sets what differs in the lines from one on.
    redress(differ, first) {
        for (const [i, was, is, said] of differ) {
            const element = this.elements[first + i];
            dress(element, was, is);
            if (said !== undefined) element.textContent = unescaped(said);
        }
    }

    // Makes an element of the picture that of the next one.
    morph(old, next, line) {
        const differ = differences(this.text, old, next.text, line);
        if (differ) {
            this.redress(differ, old);
            for (let i = old; i <= this.text.last[old]; i++) next.elements[line + i - old] = this.elements[i];
            return;
        }
        const element = this.elements[old];
        next.elements[line] = element;
        dress(element, tagOf(this.text.lines[old]), tagOf(next.text.lines[line]));
        const [before, kids] = [this.text.kids(old), next.text.kids(line)];
        const isList = before.length > 0 && kids.length > 0;
        if (isList && this.text.trails(old) === next.text.trails(line)) {
            this.arrange(before, next, kids, element);
            return;
        }
        const [wrote, writes] = [this.text.inner(old), next.text.inner(line)];
        if (writes !== wrote) write(element, writes);
        bind(next.text, next.elements, line, element);
    }

    // Children keep their elements: those with an id wherever they stand now, others take that of the next
    // old one of their name. What is left over goes, what is lacking is written. Each has a line, so that its
    // end stands before it.
    arrange(old, next, kids, element) {
        const { lineEnd } = next.text;
        const kept = kindred(old, kids);
        const stay = new Set(kept.values());
        for (const kid of old) {
            if (stay.has(kid)) continue;
            this.elements[kid.line].previousSibling.remove();
            this.elements[kid.line].remove();
        }
        const lacking = kids.filter((kid) => !kept.get(kid));
        const made = lacking.length > 0 && document.createElementNS(element.namespaceURI, "g");
        if (made) made.innerHTML = lacking.map(({ line }) => lineEnd + next.text.of(line)).join("");
        let [before, most] = [undefined, 0];
        for (const kid of kids) {
            const from = kept.get(kid)?.line;
            const own = from === undefined ? made.firstElementChild : this.elements[from];
            if (from > most) most = from; // It stands after all that are before it.
            else {
                const place = before ? before.nextSibling : element.firstChild;
                element.insertBefore(own.previousSibling, place);
                element.insertBefore(own, place);
            }
            before = own;
            if (from === undefined) bind(next.text, next.elements, kid.line, own);
            else this.morph(from, next, kid.line);
        }
    }
}

// Ties an element of a text, and all in it, to those of the page; whether they are as many.
function bind(text, elements, line, element) {
    const inner = element.getElementsByTagName("*");
    elements[line] = element;
    let at = 0;
    for (let i = line + 1; i <= text.last[line]; i++) {
        if (text.last[i] !== undefined) elements[i] = inner[at++];
    }
    return at === inner.length;
}

// Whether an element is as a text says, but for those in it.
function isOf(text, line, element) {
    const [tag, name] = HEAD.exec(text.lines[line]);
    const own = attributesOf(tag);
    if (element.nodeName !== name || element.attributes.length !== own.length) return false;
    if (own.some(([name, value]) => element.getAttribute(name) !== value)) return false;
    const kids = text.kids(line).length;
    if (kids === 0) return element.textContent === unescaped(text.inner(line));
    // The ends of lines are texts.
    return element.childNodes.length === 2 * kids + text.trails(line);
}

function write(element, inner) {
    if (inner.includes("<")) element.innerHTML = inner;
    else element.textContent = unescaped(inner);
}

// Sets what differs between two tags of an element.
function dress(element, old, next) {
    if (old === next) return;
    // Names and values take turns between quotes, as no value has one of its own; what is left closes.
    const [before, now] = [old.split('"'), next.split('"')];
    let isSame = before.length === now.length;
    for (let i = 0; isSame && i < now.length; i += 2) isSame = before[i] === now[i];
    // Others stand in another order: at rest the element is written as in the file.
    for (let i = 0; !isSame && i < before.length - 1; i += 2) element.removeAttribute(nameAt(before[i]));
    for (let i = 0; i < now.length - 1; i += 2) {
        if (isSame && before[i + 1] === now[i + 1]) continue;
        const [name, value] = [nameAt(now[i]), unescaped(now[i + 1])];
        if (name.startsWith("xlink:")) element.setAttributeNS(XLINK, name, value);
        else element.setAttribute(name, value);
    }
}
