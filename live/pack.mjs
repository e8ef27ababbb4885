// Makes the module that `cargo` built smaller, with what Binaryen knows and the compiler can't:
// `node pack.mjs BINARYEN FROM TO`, where BINARYEN is that package's folder. The names of functions must
// still be in it; they are cut too.
//
// - A panic ends the module, and no page reads its message: the functions that write one trap at once, and
//   what is only theirs goes.
// - So does what no formula comes to that a page has, and what writes for programmers writes nothing.
// - The root of a number is one instruction, and so are the whole number below it, the lesser and the greater
//   of two.
// - What is alike stands side by side, where it packs better.
// - The names of source files, and the lines in them where a panic may be, are zeros, and what panics and
//   lists say.
// - The tables of `latex-rust` are without what only people read, and without colours, which no
//   formula of ours has.
import { readFileSync, writeFileSync } from 'node:fs';
import { pathToFileURL } from 'node:url';
import { ofLists } from './lists.mjs';
import { alike } from './order.mjs';
import { bodies, names, segments } from './sections.mjs';

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
/** What no formula comes to for which a page was made: in colours, crossed out, written down as a tree. */
const REFUSED = [
    /^_ZN10latex_rust5color16parse_color_spec/,
    /^_ZN10latex_rust6parser5parse6Parser20parse_color_from_cmd/,
    /^_ZN10latex_rust6layout6engine15back_color_wrap/,
    /^_ZN10latex_rust6layout6engine6Engine12cancel_lines/,
    /^_ZN10latex_rust6parser3ast8MathNode4gold/,
];
/** Functions that write what nobody reads: what libraries say of errors, and values in full. */
const SILENT = [
    /^_ZN\d+_\$LT\$(latex_rust|serde_json\.\.error|serde_core).*core\.\.fmt\.\.(Display|Debug)\$GT\$3fmt17h/,
    /^_ZN4core5array.*core\.\.fmt\.\.Debug\$.*3fmt17h/,
    /^_RNvX.*(5range|5alloc6layout).*5Debug3fmt$/,
];
/**
 * Functions that are an instruction here, with its type, its name and how many numbers it takes. A library
 * has no name for a root, which rounds as it does there. The lesser and the greater of two differ where one
 * is no number: that is so of lengths of 10¹⁵⁰ and more, of which no page has any.
 */
const INSTRUCTIONS = [
    [/^_ZN4libm4math4sqrt4sqrt17h/, 'f64', 'sqrt', 1],
    [/^_ZN4libm4math5floor5floor17h/, 'f64', 'floor', 1],
    [/^fmin$/, 'f64', 'min', 2],
    [/^fmax$/, 'f64', 'max', 2],
    [/^fminf$/, 'f32', 'min', 2],
    [/^fmaxf$/, 'f32', 'max', 2],
];
/**
 * How tables begin that nothing comes to, and their bytes: of what reads numbers in JSON 5²⁰⁴⁸, 5⁴⁰⁹⁶ and
 * 5⁸¹⁹², where a double asks for 5¹⁰⁹³ at most, of the 769 digits that decide and 324 zeros.
 */
const POWERS = [
    { first: '01e03313656809e33f4d7db2cf8de249', length: 149 * 4 },
    { first: '01c0672a8d4e72d4e77afe8e901e9af8', length: 298 * 4 },
    { first: '0180cf642652349fe563496453508d7b', length: 595 * 4 },
];
/**
 * What panics of the standard library say, and what it calls errors of files, of which a page has none: from
 * the first words of a run of texts to its last.
 */
const UNREAD = [
    ['entity not found', 'uncategorized error'],
    ['attempt to divide by zero', 'with a divisor of zero'],
    ['attempt to join into collection', 'usize::MAX'],
    ['start of range should be a character boundary', 'end of range should be a character boundary'],
    ['Hash table capacity overflow', ''],
    ['Formatting argument out of range', ''],
    ['cannot access a Thread Local Storage value during or after destruction', ''],
    ['already mutably borrowed', ''],
    ['RefCell already borrowed', ''],
    ['user-provided comparison function', 'implement a total order'],
    ['a formatting trait implementation', 'underlying stream did not'],
    ...[
        'ndigits > 0',
        'buf.len() >= ndigits || buf.len() >= maxlen',
        'buf.len() >= maxlen',
        'other > 0',
        'noborrow',
        'digits < 40',
        '!buf.is_empty()',
        "buf[0] > b'0'",
        'd.mant > 0',
        'd.minus > 0',
        'd.plus > 0',
        'd.mant + d.plus < (1 << 61)',
        'd.mant.checked_sub(d.minus).is_some()',
        'd.mant.checked_add(d.plus).is_some()',
        'self.is_char_boundary(idx)',
        'self.is_char_boundary(new_len)',
        'self.peeked.is_none()',
        'len > 0',
        'idx < CAPACITY',
        'edge.height == self.height - 1',
        'edge.height == self.node.height - 1',
        'src.len() == dst.len()',
        'old_left_len >= count',
    ].map((claim) => [`assertion failed: ${claim}`, '']),
    // Of libraries, whose errors write nothing here.
    ['EOF while parsing a list', 'recursion limit exceeded'],
    ['unmatched \\begin (missing \\end)', ''],
    ['double superscript', 'double subscript'],
    ['invalid OpenType face', 'unmatched delimiter'],
    ...[
        "unmatched '{'",
        "expected ']' after x-arrow optional argument",
        "expected ']' after color model",
        "expected '{' after \\substack",
        'empty \\substack',
        'unexpected math shift',
        'unmatched math delimiter',
        'empty array preamble',
        'hline in this environment',
        'intertext in this environment',
        'em_size_pt must be positive',
        'OpenType MATH table',
        'color component NaN',
        'RGB component out of 0..255',
        'RGB component NaN',
        'dvipsnames must be the full 68-color set',
        'any valid JSON value',
        'serialize_value called before serialize_key',
        'failed to write whole buffer',
        'a Display implementation returned an error unexpectedly',
        'Attempted to initialize thread-local while it is being dropped',
        'one-time initialization may not be performed recursively',
    ].map((words) => [words, '']),
    ['internal error: entered unreachable code', ''],
    ['called `Option::unwrap()` on a `None` value', ''],
    ['called `Result::unwrap()` on an `Err` value', ''],
];
/** Bytes of the longest such run. */
const LONGEST_RUN = 1000;
/**
 * The tables of `latex-rust`, which reads them line by line and skips empty ones: the first line, how the
 * last begins, and what a row of it is for us. Of a symbol nothing asks for the category and the
 * description; a colour in a formula is an error before a page is made, and 68 of them must be there.
 * The notice before a table of which no row is left goes with it.
 */
const TABLES = [
    {
        header: 'glyph\tcategory\tkind\tlatex\tdescription\n',
        last: '\\backepsilon\tBack epsilon',
        row: ([glyph, , kind, latex]) => [glyph, '', kind, latex],
    },
    {
        header: 'name\tc\tm\ty\tk\n',
        notice: '# THIS FILE HAS BEEN MODIFIED. It is not the original dvipsnam.def',
        last: 'YellowOrange\t0\t0.42\t1\t0',
        row: () => ['', 0, 0, 0, 0],
    },
];
/** What a source file is called. */
const SOURCES = /(?:\/|crates\/)[\w./+-]+\.rs(?=\0)/g;

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

/** Zeros in the place of the tables of what reads decimal numbers. */
function without_powers(bytes) {
    for (const { first, length } of POWERS) {
        const begin = Buffer.from(first, 'hex');
        const at = bytes.indexOf(begin);
        if (at < 0 || bytes.indexOf(begin, at + 1) >= 0) throw new Error(`not one table of ${first}`);
        bytes.fill(0, at, at + length);
    }
    return bytes;
}

/** Tables of texts as short as what reads them allows, and empty lines in the rest of their places. */
function without_notes(bytes) {
    for (const { header, last, row, notice } of TABLES) {
        const from = bytes.indexOf(header);
        const start = notice === undefined ? from : bytes.lastIndexOf(notice, from);
        if (start < 0) throw new Error(`no notice before ${header}`);
        const to = bytes.indexOf(last, from) + last.length;
        if (from < 0 || to < from + last.length) throw new Error(`no table of ${header}`);
        const rows = bytes.toString('utf8', from + header.length, to).split('\n').filter(Boolean);
        const short = header + rows.map((line) => row(line.split('\t')).join('\t')).join('\n');
        bytes.fill('\n', start, to);
        bytes.write(short, from);
    }
    return bytes;
}

/** Zeros in the place of what nobody reads. */
function without_panics(bytes) {
    let count = 0;
    for (const { from, length } of segments(bytes)) {
        const piece = bytes.subarray(from, from + length);
        for (const [first, last] of UNREAD) {
            for (let at = piece.indexOf(first); at >= 0; at = piece.indexOf(first, at + 1)) {
                const end = piece.indexOf(last, at + first.length) + last.length;
                if (end <= at || end > at + LONGEST_RUN) throw new Error(`no "${last}" after "${first}"`);
                piece.fill(0, at, Math.max(end, at + first.length));
                count += 1;
            }
        }
    }
    // As with the functions below.
    if (count < 20) throw new Error(`the module has ${count} texts of panics`);
    return bytes;
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

/** A number of seven bits a byte, and a text behind its length. */
const small = (value) => (value < 128 ? [value] : [(value & 127) | 128, ...small(Math.floor(value / 128))]);
const told = (bytes) => [...small(bytes.length), ...bytes];

/** A module without imports with names for its functions that are in the order in which they should stand. */
function named(bytes) {
    const place = [];
    for (const [index, body] of alike(bodies(bytes)).entries()) place[body] = String(index).padStart(6, '0');
    const names = place.flatMap((name, index) => [...small(index), ...told(Buffer.from(name))]);
    const section = [...told(Buffer.from('name')), 1, ...told([...small(place.length), ...names])];
    return Buffer.concat([bytes, Buffer.from([0, ...told(section)])]);
}

const [folder, from, to] = process.argv.slice(2);
const compiled = readFileSync(from);
/** What is compiled for speed. Of these functions many stand in their callers, and have no name then. */
const hot = readFileSync(new URL('hot.txt', import.meta.url), 'utf8').trim().split('\n');
const called = new Set(names(compiled).values());
const there = hot.filter((name) => called.has(name)).length;
// As with the functions below: a name that is gone would leave its function slow.
if (there < hot.length / 2) throw new Error(`${there} of ${hot.length} functions of hot.txt are there`);
const { default: binaryen } = await import(pathToFileURL(`${folder}/index.js`));
const cut = [without_sources, without_powers, without_notes, without_panics, without_lists];
let module = binaryen.readBinary(cut.reduce((bytes, without) => without(bytes), compiled));
/** What stands in the place of a function; nothing where it stays. */
function instead(part, results) {
    const instruction = INSTRUCTIONS.find(([one]) => one === part);
    if (instruction) {
        const [, type, name, count] = instruction;
        const numbers = Array.from({ length: count }, (_, at) => module.local.get(at, binaryen[type]));
        return module[type][name](...numbers);
    }
    if (!SILENT.includes(part)) return module.unreachable();
    // 0 says that all was written.
    return results === binaryen.i32 ? module.i32.const(0) : undefined;
}
for (const part of [...PANICS, ...REFUSED, ...SILENT, ...INSTRUCTIONS.map(([part]) => part)]) {
    let count = 0;
    for (let index = 0; index < module.getNumFunctions(); index += 1) {
        const about = binaryen.getFunctionInfo(module.getFunctionByIndex(index));
        const { name, module: imported, base, results } = about;
        if (base || imported || !part.test(name)) continue;
        const body = instead(part, results);
        if (body === undefined) continue;
        count += 1;
        binaryen.Function.setBody(module.getFunction(name), body);
    }
    // A name that is gone would leave the module larger, and no one would see it.
    if (count === 0) throw new Error(`no function is called ${part}`);
}
// Small as compiled, fast as optimized: at `-Oz` it packs 1 kB smaller and a frame takes a seventh longer.
binaryen.setOptimizeLevel(3);
binaryen.setShrinkLevel(0);
// What does little stands in its callers, which is no larger than a call; of eight expressions it would be.
binaryen.setAlwaysInlineMaxSize(6);
binaryen.setDebugInfo(false);
// Zeros between the pieces of memory pack to nothing; more pieces don't.
binaryen.addPassToSkip('memory-packing');
// A second time finds what the first has laid open: 0.4 kB of brotli.
module.optimize();
module.optimize();
module.runPasses(['strip-debug', 'strip-producers', 'strip-target-features']);
module = binaryen.readBinary(named(Buffer.from(module.emitBinary())));
module.runPasses(['reorder-functions-by-name', 'strip-debug']);
writeFileSync(to, module.emitBinary());
