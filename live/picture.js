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
        let left = WARMING;
        const stop = () => { left = 0; };
        for (const act of ["pointerdown", "keydown"]) addEventListener(act, stop, { once: true });
        for (let frame = 0; frame < FRAMES && left > 0; frame++) {
            await new Promise((resolve) => requestIdleCallback(resolve));
            const start = performance.now();
            if (engine.set(edits(frame))) engine.draw();
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

const TAG = /<[^>]*>|[^<]+/g;
const XLINK = "http://www.w3.org/1999/xlink";
const ENTITY = { lt: "<", gt: ">", quot: '"', apos: "'", "#39": "'", amp: "&" };
const unescaped = (s) => s.replace(/&(lt|gt|quot|apos|#39|amp);/g, (_, name) => ENTITY[name]);
const ATTRIBUTE = /([\w:-]+)="([^"]*)"/g;
const attributesOf = (tag) => new Map(Array.from(tag.matchAll(ATTRIBUTE), (m) => [m[1], unescaped(m[2])]));
// The name of an attribute, of what stands before its value.
const nameAt = (before) => /[\w:-]+(?==$)/.exec(before)[0];

// The tag that begins a line of such a text, with its name, its id, and what follows it there.
const HEAD = /^<([\w:-]+)(?: id="([^"]*)")?[^>]*>/;
const ofText = (rest) => /^[^<]*/.exec(rest)[0];

// The tree of a text that tracefig wrote, the element that begins in its line `first`: nodes with tag, name,
// id and kids, their places in `tags`, and their first and last lines. Each tag that opens an element begins
// a line; `lines` has the nodes by those, from `first`.
function treeOf(tags, lines, first) {
    const top = { kids: [] };
    const open = [top];
    let line = 0;
    for (let i = 0; open.length > 0 && i < tags.length; i++) {
        const tag = tags[i];
        const inner = open[open.length - 1];
        if (tag[0] !== "<") inner.kids.push({ tag, name: "#text", kids: null, from: i, to: i });
        else if (tag[1] === "/") Object.assign(open.pop(), { to: i, last: first + line });
        else {
            const [, name, id] = HEAD.exec(tag);
            const node = { tag, name, id, kids: [], from: i, to: i, line: first + line, last: first + line };
            inner.kids.push(node);
            lines[line] = node;
            if (!tag.endsWith("/>")) open.push(node);
        }
        if (tag[0] !== "<" && tag.includes("\n")) line += tag.split("\n").length - 1;
    }
    return top.kids.find((node) => node.kids);
}

// How many lines at the beginning of two texts are the same, and how many after those at their ends.
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
    }

    // Width and height in page pixels.
    get size() {
        return this.svg.getAttribute("viewBox").split(" ").slice(2).map(Number);
    }

    // Takes what the page shows for the picture of this text; whether it is.
    begin(text) {
        this.lines = text.split("\n");
        this.nodes = [];
        this.shown = treeOf(text.match(TAG), this.nodes, 0);
        return this.bind(this.shown, this.svg);
    }

    // Ties a tree to the elements of the page; whether they are the same.
    bind(node, element) {
        node.element = element;
        if (element?.nodeName !== node.name) return false;
        if (!node.kids) return element.data === unescaped(node.tag);
        const own = attributesOf(node.tag);
        let fits = element.attributes.length === own.size && element.childNodes.length === node.kids.length;
        for (const [name, value] of own) fits &&= element.getAttribute(name) === value;
        for (const [i, kid] of node.kids.entries()) fits = this.bind(kid, element.childNodes[i]) && fits;
        return fits;
    }

    // Shows another text; whether all elements stayed.
    patch(text) {
        const lines = text.split("\n");
        if (this.redress(lines)) return true;
        const [begin, end] = alike(this.lines, lines);
        const last = this.lines.length - 1;
        const holds = ({ kids, line, last: close }) => kids && line < begin && close > last - end;
        // Read is what holds all that differs, and nothing around it.
        let [around, inner] = [undefined, this.shown];
        for (let kid = inner; kid; kid = inner.kids.find(holds)) [around, inner] = [inner, kid];
        this.renew(inner, around, lines);
        return false;
    }

    // Makes an element, which lies in another one, that of other lines; all around it is as it was.
    renew(old, around, lines) {
        const { last } = old;
        const more = lines.length - this.lines.length;
        // What lies around it may close in its last line.
        const tags = lines.slice(old.line, last + 1 + more).join("\n").match(TAG);
        const nodes = [];
        const next = treeOf(tags, nodes, old.line);
        this.morph(old, next, tags);
        if (old === this.shown) this.shown = next;
        else around.kids[around.kids.indexOf(old)] = next;
        const after = this.nodes.slice(last + 1);
        after.forEach((node) => { node.line += more; });
        this.nodes.forEach((node) => { if (node.last >= last) node.last += more; });
        this.nodes.length = old.line;
        nodes.length = last + 1 + more - old.line;
        this.nodes = this.nodes.concat(nodes, after);
        this.lines = lines;
    }

    // Sets what differs in a text of the same elements, line by line; whether it is one. Most frames are.
    redress(lines) {
        if (lines.length !== this.lines.length) return false;
        const differ = [];
        for (let i = 0; i < lines.length; i++) {
            if (lines[i] === this.lines[i]) continue;
            const [was, is] = [HEAD.exec(this.lines[i]), HEAD.exec(lines[i])];
            const node = this.nodes[i];
            // Another page size moves all that lies over the picture.
            if (!node || node === this.shown || was?.[1] !== is?.[1] || was[2] !== is[2]) return false;
            const [before, now] = [this.lines[i].slice(was[0].length), lines[i].slice(is[0].length)];
            const [old, text] = [before, now].map(ofText);
            if (before.slice(old.length) !== now.slice(text.length)) return false;
            if (was[0].endsWith("/>") !== is[0].endsWith("/>")) return false;
            const [inner] = node.kids;
            if (before !== now && (inner?.kids !== null || inner.tag !== old)) return false;
            differ.push([node, is[0], before === now ? undefined : text]);
        }
        for (const [node, tag, text] of differ) {
            if (node.tag !== tag) this.dress(node, { tag, kids: node.kids });
            node.tag = tag;
            if (text === undefined) continue;
            this.dress(node.kids[0], { tag: text, kids: null });
            node.kids[0].tag = text;
        }
        this.lines = lines;
        return true;
    }

    // Makes the element of an old node that of the next one.
    morph(old, next, tags) {
        next.element = old.element;
        if (old.tag !== next.tag) this.dress(old, next);
        if (!next.kids) return;
        const alike = old.kids.length === next.kids.length
            && old.kids.every((kid, i) => kid.name === next.kids[i].name && kid.id === next.kids[i].id);
        if (alike) next.kids.forEach((kid, i) => this.morph(old.kids[i], kid, tags));
        else this.arrange(old, next, tags);
    }

    dress({ element, tag }, next) {
        if (!next.kids) {
            element.data = unescaped(next.tag);
            return;
        }
        // Names and values take turns between quotes, as no value has one of its own; what is left closes.
        const [before, now] = [tag, next.tag].map((text) => text.split('"').slice(0, -1));
        const stays = (part, i) => i % 2 > 0 || part === before[i];
        const isSame = before.length === now.length && now.every(stays);
        // Others stand in another order: at rest the element is written as in the file.
        for (let i = 0; !isSame && i < before.length; i += 2) element.removeAttribute(nameAt(before[i]));
        for (let i = 0; i < now.length; i += 2) {
            if (isSame && before[i + 1] === now[i + 1]) continue;
            const [name, value] = [nameAt(now[i]), unescaped(now[i + 1])];
            if (name.startsWith("xlink:")) element.setAttributeNS(XLINK, name, value);
            else element.setAttribute(name, value);
        }
    }

    // Children keep their elements: those with an id wherever they stand now, others take that of the next
    // old one of their name. What is left over goes, what is lacking is written.
    arrange(old, next, tags) {
        const kept = kindred(old.kids, next.kids);
        const stay = new Set(kept.values());
        for (const kid of old.kids) if (!stay.has(kid)) kid.element.remove();
        const lacking = next.kids.filter((kid) => !kept.get(kid));
        const made = this.parsed(lacking, tags);
        let place = next.element.firstChild;
        for (const kid of next.kids) {
            const before = kept.get(kid);
            const element = before?.element ?? made.shift();
            if (element === place) place = place.nextSibling;
            else next.element.insertBefore(element, place);
            if (before) this.morph(before, kid, tags);
            else this.bind(kid, element);
        }
    }

    // New elements and texts of nodes; what is to be read is read at once.
    parsed(nodes, tags) {
        const group = document.createElementNS("http://www.w3.org/2000/svg", "g");
        const written = nodes.filter(({ kids }) => kids);
        const texts = written.map(({ from, to }) => tags.slice(from, to + 1).join(""));
        if (texts.length > 0) group.innerHTML = texts.join("");
        const elements = [...group.childNodes];
        const text = (tag) => document.createTextNode(unescaped(tag));
        return nodes.map(({ kids, tag }) => (kids ? elements.shift() : text(tag)));
    }
}
