// Makes the module that `cargo` built smaller, with what Binaryen knows and the compiler can't:
// `node pack.mjs BINARYEN FROM TO`, where BINARYEN is that package's folder. The names of functions must
// still be in it; they are cut too.
//
// - A panic ends the module, and no page reads its message: the functions that write one trap at once, and
//   what is only theirs goes.
// - Faces are ours, and nothing reads a variable one, or a decimal number in one.
// - The root of a number is one instruction.
// - What does alike is called alike, and stands side by side, where it packs better.
// - The names of source files, and the lines in them where a panic may be, are zeros, and what only lists
//   say.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { ofLists } from './lists.mjs';

/** Functions that only end in a trap, by parts of their mangled names. */
const PANICS = [
    /4core9panicking/,
    /3std9panicking/,
    /(slice_error|slice_index|len_mismatch|unwrap|expect|assert)_fail(ed)?/,
    /4core4cell\d+panic_already/,
    /thread5local18panic_access_error/,
    /panic_on_ord_violation/,
    /raw_vec12handle_error|capacity_overflow|handle_alloc_error/,
];
/** Functions that our faces do not come to: outlines that vary, and letters made of two. */
const OTHER_FACES = [
    /10ttf_parser6tables(4gvar|4avar|4hvar|4vvar|4mvar|3cff4cff2)/,
    /10ttf_parser9var_store/,
    /10ttf_parser4Face(20glyph_phantom_points|23apply_metrics_variation)/,
    /10ttf_parser6tables3cff4cff121seac_code_to_glyph_id/,
];
/** What reads a decimal number, with tables of 10 kB that do not pack. */
const READER = /3num7dec2flt.*FromStr8from_str/;
/** The root of a double: here an instruction, which rounds as it does. A library has no name for that. */
const ROOT = /^_ZN4libm4math4sqrt4sqrt17h/;
/** How that table begins, 5⁻³⁴² as two words, and its length: to 5³⁰⁸, each of two words. */
const POWERS = { first: Buffer.from('5ad63b92d653f4ee3f3ba10629aa3f11', 'hex'), length: 651 * 16 };
/** Who may seem to: the tables of a face may have such numbers, and those of ours have none. */
const FACES = /10ttf_parser6tables3cff4dict/;
/** What a source file is called. */
const SOURCES = /(?:\/|crates\/)[\w./+-]+\.rs(?=\0)/g;

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
function segments(bytes) {
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

/**
 * Zeros in the place of the names of sources, and of the places in them: the address of a name, its length,
 * a line, a column.
 */
function without_sources(bytes) {
    const lengths = new Map();
    const all = segments(bytes);
    for (const { address, from, length } of all) {
        const text = bytes.subarray(from, from + length).toString('latin1');
        for (const { index, 0: name } of text.matchAll(SOURCES)) {
            lengths.set(address + index, name.length);
            bytes.fill(0, from + index, from + index + name.length);
        }
    }
    for (const { address, from, length } of all) {
        for (let at = from + ((4 - (address % 4)) % 4); at + 16 <= from + length; at += 4) {
            const name = lengths.get(bytes.readUInt32LE(at));
            if (name !== undefined && name === bytes.readUInt32LE(at + 4)) bytes.fill(0, at, at + 16);
        }
    }
    return bytes;
}

/** Zeros in the place of the table of what reads decimal numbers. */
function without_powers(bytes) {
    const at = bytes.indexOf(POWERS.first);
    if (at < 0 || bytes.indexOf(POWERS.first, at + 1) >= 0) throw new Error('not one table of powers');
    return bytes.fill(0, at, at + POWERS.length);
}

/** Zeros in the place of what only lists say, where a piece of memory has it once. */
function without_lists(bytes) {
    const pieces = segments(bytes).map(({ from, length }) => bytes.subarray(from, from + length));
    let count = 0;
    for (const words of ofLists().map((words) => Buffer.from(words))) {
        const places = pieces.flatMap((piece) => {
            const at = piece.indexOf(words);
            return at < 0 ? [] : [[piece, at], ...(piece.indexOf(words, at + 1) < 0 ? [] : [[]])];
        });
        if (places.length !== 1) continue;
        const [[piece, at]] = places;
        piece.fill(0, at, at + words.length);
        count += 1;
    }
    // As with the functions below.
    if (count < 100) throw new Error(`the module has ${count} texts of lists`);
    return bytes;
}

/** Throws where a function that only these may call, which never come to it, has another caller. */
function held(module, part, callers) {
    let caller;
    for (const line of module.emitText().split('\n')) {
        caller = /^ \(func \$(\S+)/.exec(line)?.[1] ?? caller;
        const called = /\((?:return_)?call \$(\S+?)[\s)]/.exec(line)?.[1] ?? '';
        if (part.test(called) && !callers.test(caller)) throw new Error(`${caller} calls ${called}`);
    }
}

const [folder, from, to] = process.argv.slice(2);
const { default: binaryen } = await import(pathToFileURL(`${folder}/index.js`));
const module = binaryen.readBinary(without_lists(without_powers(without_sources(readFileSync(from)))));
held(module, READER, FACES);
const root = module.f64.sqrt(module.local.get(0, binaryen.f64));
for (const part of [...PANICS, ...OTHER_FACES, READER, ROOT]) {
    let count = 0;
    for (let index = 0; index < module.getNumFunctions(); index += 1) {
        const { name, module: imported, base } = binaryen.getFunctionInfo(module.getFunctionByIndex(index));
        if (base || imported || !part.test(name)) continue;
        count += 1;
        binaryen.Function.setBody(module.getFunction(name), part === ROOT ? root : module.unreachable());
    }
    // A name that is gone would leave the module larger, and no one would see it.
    if (count === 0) throw new Error(`no function is called ${part}`);
}
// Small as compiled, fast as optimized: at `-Oz` it packs 1 kB smaller and a frame takes a seventh longer.
binaryen.setOptimizeLevel(3);
binaryen.setShrinkLevel(0);
binaryen.setDebugInfo(false);
// Zeros between the pieces of memory pack to nothing; more pieces don't.
binaryen.addPassToSkip('memory-packing');
module.optimize();
// What does alike is called alike, and packs better side by side: 12 kB as gzip.
module.runPasses(['reorder-functions-by-name', 'strip-debug', 'strip-producers', 'strip-target-features']);
writeFileSync(to, module.emitBinary());
