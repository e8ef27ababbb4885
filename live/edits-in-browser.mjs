// Random edits of every committed figure, in Chromium: `node live/edits-in-browser.mjs [EDITS [SEED]]`.
// Each that is drawn is shown by the patch of the page, and must be what a page has that reads it anew.
// `.ci/browser --install` installs what this needs. A trap or another picture ends it with status 1.
import { readFileSync } from 'node:fs';
import { launched } from '../.ci/chromium.mjs';
import { figures } from './drags.mjs';
import { edits } from './random.mjs';

const [count = 10_000, seed = 18] = process.argv.slice(2).map(Number);
const all = figures();
const each = Math.ceil(count / all.length);
const next = edits(seed);
const runs = all.map(({ stem, request, path }) => ({
    stem, request: JSON.stringify(request), edits: Array.from({ length: each }, () => next(path[1] + 1)),
}));
const here = (name) => readFileSync(new URL(name, import.meta.url));
const browser = await launched();
const page = await browser.newPage();
await page.addScriptTag({ content: here('picture.js').toString() });
const counts = await page.evaluate(async ([module, runs]) => {
    globalThis.tracefigModule = module;
    /** Shows a text in an element of its own. */
    const shown = (text) => {
        document.body.innerHTML = text;
        return document.body.firstElementChild;
    };
    let [made, drawn, stayed] = [0, 0, 0];
    for (const { stem, request, edits } of runs) {
        let [engine, picture, lineEnd] = [];
        const written = () => engine.svg.replaceAll('\n', lineEnd);
        for (const [i, edit] of edits.entries()) {
            if (i % 50 === 0) {
                lineEnd = i % 100 === 0 ? '\n' : ' '; // As it stands in a page, or in a book.
                engine = await Engine.start(request);
                if (!engine.draw()) throw new Error(`${stem}: ${engine.info.error}`);
                picture = new Picture(shown(written()).cloneNode(true));
                if (!picture.begin(written())) throw new Error(`${stem} is not what is written of it`);
            }
            if (!engine.set(edit)) continue;
            made += 1;
            if (!engine.draw()) continue;
            drawn += 1;
            stayed += picture.patch(written());
            const { outerHTML } = shown(written());
            if (picture.svg.outerHTML !== outerHTML) {
                throw new Error(`${stem} shows another picture after edit ${i}: ${JSON.stringify(edit)}`);
            }
        }
    }
    return { made, drawn, stayed };
}, [here('tracefig-live.wasm.gz').toString('base64'), runs]);
await browser.close();
const { made, drawn, stayed } = counts;
const done = `${each * all.length} edits in Chromium without a trap`;
console.log(`${done}: ${made} made a scene, ${drawn} were drawn, ${stayed} of them by the same elements`);
