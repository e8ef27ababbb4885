// Random edits of every committed figure, in Chromium: `node live/edits-in-browser.mjs [EDITS [SEED]]`.
// `.ci/browser --install` installs what this needs. A trap ends it with status 1.
import { launched } from '../.ci/chromium.mjs';
import { bytes } from './module.mjs';
import { figures } from './drags.mjs';
import { edits } from './random.mjs';

const [count = 10_000, seed = 18] = process.argv.slice(2).map(Number);
const all = figures();
const each = Math.ceil(count / all.length);
const next = edits(seed);
const runs = all.map(({ stem, request, path }) => ({
    stem, request, edits: Array.from({ length: each }, () => next(path[1] + 1)),
}));
const browser = await launched();
const page = await browser.newPage();
const counts = await page.evaluate(async ([packed, runs]) => {
    const module = Uint8Array.from(atob(packed), (c) => c.charCodeAt(0));
    const { exports } = (await WebAssembly.instantiate(module, {})).instance;
    const tell = (call, said) => {
        const text = new TextEncoder().encode(JSON.stringify(said));
        const at = exports.tf_input(text.length);
        new Uint8Array(exports.memory.buffer, at, text.length).set(text);
        return exports[call]() === 1;
    };
    let [made, drawn] = [0, 0];
    for (const { stem, request, edits } of runs) {
        for (const [i, edit] of edits.entries()) {
            if (i % 50 === 0 && !tell('tf_open', request)) throw new Error(`${stem} is no figure`);
            if (!tell('tf_set', edit)) continue;
            made += 1;
            drawn += exports.tf_draw();
        }
    }
    return { made, drawn };
}, [Buffer.from(bytes()).toString('base64'), runs]);
await browser.close();
const { made, drawn } = counts;
const done = `${each * all.length} edits in Chromium without a trap`;
console.log(`${done}: ${made} made a scene, ${drawn} were drawn`);
