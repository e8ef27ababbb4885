// What only lists and the schema say of layers, options, labels, values and keys: a module of pages has
// neither, and the compiler can't know, as those words stand in the tables beside what it needs.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';

const sources = new URL('../src', import.meta.url).pathname;
/** The fields that a list shows, and the file whose rows have them without a name. */
const FIELDS = /\b(?:about|default|needs): "((?:[^"\\]|\\.)*)"/gs;
/** Rows of values that are told: the name, and what a list says of it. */
const TOLD = /\btold!\(\s*"[^"]*",\s*"((?:[^"\\]|\\.)*)"/gs;
const ROWS = join('scene', 'fields.rs');
const LITERAL = /"((?:[^"\\]|\\.)*)"/gs;
/** What would help against an error: a page says what is wrong, and its reader has no file to mend. */
const HELPS = /\blet help = "((?:[^"\\]|\\.)*)"/gs;
/** Bytes of the shortest that is worth it, and of the shortest in a row, where words of scenes stand too. */
const LEAST = 12;
const LEAST_OF_ROWS = 20;
const TESTS = /#\[cfg\(test\)\]\nmod tests \{/;

/** What a literal says. */
const said = (literal) => literal.replace(/\\\n\s*/g, '').replaceAll('\\"', '"').replaceAll('\\\\', '\\');

/** The words of lists that nothing else in the sources says. */
export function ofLists() {
    const found = new Set();
    const take = (whole, literal) => (found.add(said(literal)), '');
    const takeLong = (whole, literal) =>
        literal.includes(' ') && literal.length >= LEAST_OF_ROWS ? take(whole, literal) : whole;
    let rest = '';
    for (const name of readdirSync(sources, { recursive: true }).filter((name) => name.endsWith('.rs'))) {
        const [text] = readFileSync(join(sources, name), 'utf8').split(TESTS);
        const bare = text.replace(/^\s*\/\/.*$/gm, '');
        const code = [FIELDS, TOLD, HELPS].reduce((code, words) => code.replace(words, take), bare);
        rest += (name === ROWS ? code.replace(LITERAL, takeLong) : code).replace(/\\\n\s*/g, '');
    }
    return [...found].filter((words) => words.length >= LEAST && !rest.includes(words));
}
