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

/** The pieces of memory that a module begins with: where each lies in it, and where in its bytes. */
export function segments(bytes) {
    const found = [];
    for (let at = 8; at < bytes.length; ) {
        const kind = bytes[at];
        let [length, from] = number(bytes, at + 1);
        at = from + length;
        if (kind !== 11) continue;
        let count;
        [count, from] = number(bytes, from);
        for (; count > 0; count -= 1) {
            // 0, i32.const ADDRESS, end, LENGTH, bytes.
            if (bytes[from] !== 0 || bytes[from + 1] !== 0x41) throw new Error('data that lies nowhere');
            const [address, end] = number(bytes, from + 2);
            [length, from] = number(bytes, end + 1);
            found.push({ address, from, length });
            from += length;
        }
    }
    return found;
}

/** The functions of a module, as their bytes. */
export function bodies(bytes) {
    for (let at = 8; at < bytes.length; ) {
        const kind = bytes[at];
        let [length, from] = number(bytes, at + 1);
        at = from + length;
        if (kind !== 10) continue;
        const found = [];
        let count;
        [count, from] = number(bytes, from);
        for (; count > 0; count -= 1) {
            [length, from] = number(bytes, from);
            found.push(bytes.subarray(from, from + length));
            from += length;
        }
        return found;
    }
    throw new Error('no functions');
}

/** What the functions of a module without imports are called, where it says that. */
export function names(bytes) {
    const [section] = WebAssembly.Module.customSections(new WebAssembly.Module(bytes), 'name');
    const said = Buffer.from(section ?? []);
    const found = [];
    for (let at = 0; at < said.length; ) {
        const kind = said[at];
        let [length, from] = number(said, at + 1);
        at = from + length;
        // Of functions.
        if (kind !== 1) continue;
        let [count, index] = [0, 0];
        [count, from] = number(said, from);
        for (; count > 0; count -= 1) {
            [index, from] = number(said, from);
            [length, from] = number(said, from);
            found[index] = said.toString('utf8', from, from + length);
            from += length;
        }
    }
    return found;
}
