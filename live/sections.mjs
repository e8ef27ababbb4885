// What a module of WebAssembly consists of, as far as `pack.mjs` and `hot.mjs` ask.

/** The number at a place, of seven bits a byte, and the place after it. */
function number(bytes, at) {
    let [value, shift] = [0, 0];
    for (;;) {
        const byte = bytes[at++];
        value += (byte & 127) * 2 ** shift;
        shift += 7;
        if (byte < 128) return [value, at];
    }
}

/** The sections of a module, or of a part of one that has its own: what each is, and where it begins. */
function* sections(bytes, at) {
    while (at < bytes.length) {
        const [length, from] = number(bytes, at + 1);
        yield { kind: bytes[at], from };
        at = from + length;
    }
}

/** The items of the sections of a kind: what `item` gives for each, with the place after it. */
function items(bytes, kind, item, at = 8) {
    const found = [];
    for (const section of sections(bytes, at)) {
        if (section.kind !== kind) continue;
        let [count, from] = number(bytes, section.from);
        for (; count > 0; count -= 1) {
            const [made, next] = item(from);
            found.push(made);
            from = next;
        }
    }
    return found;
}

/** The pieces of memory that a module begins with: where each lies in it, and where in its bytes. */
export function segments(bytes) {
    return items(bytes, 11, (at) => {
        // 0, i32.const ADDRESS, end, LENGTH, bytes.
        if (bytes[at] !== 0 || bytes[at + 1] !== 0x41) throw new Error('data that lies nowhere');
        const [address, end] = number(bytes, at + 2);
        const [length, from] = number(bytes, end + 1);
        return [{ address, from, length }, from + length];
    });
}

/** The functions of a module, as their bytes. */
export function bodies(bytes) {
    return items(bytes, 10, (at) => {
        const [length, from] = number(bytes, at);
        return [bytes.subarray(from, from + length), from + length];
    });
}

/** What the functions of a module without imports are called, where it says that, by their numbers. */
export function names(bytes) {
    const [section] = WebAssembly.Module.customSections(new WebAssembly.Module(bytes), 'name');
    const said = Buffer.from(section ?? []);
    const all = items(said, 1, (at) => {
        const [index, after] = number(said, at);
        const [length, from] = number(said, after);
        return [[index, said.toString('utf8', from, from + length)], from + length];
    }, 0);
    return new Map(all);
}
