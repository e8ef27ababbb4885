// Random edits of every committed figure, in Node: `node live/edits.mjs [EDITS [SEED]]`.
// A trap ends it with status 1.
import { bytes, instance } from './module.mjs';
import { figures } from './drags.mjs';
import { edits } from './random.mjs';

const [count = 10_000, seed = 18] = process.argv.slice(2).map(Number);
const next = edits(seed);
const counts = { made: 0, drawn: 0 };
const all = figures();
const each = Math.ceil(count / all.length);
for (const { stem, request, path } of all) {
    // The glyphs that a page brings are those of all that follow in an instance.
    const tracefig = await instance(bytes());
    for (let i = 0; i < each; i += 1) {
        // What was drawn is what a scene that can't be drawn falls back to.
        if (i % 50 === 0 && !(tracefig.open(request) && tracefig.draw())) {
            throw new Error(`${stem}: ${tracefig.info().error}`);
        }
        if (tracefig.set(next(path[1] + 1))) {
            counts.made += 1;
            counts.drawn += tracefig.draw();
        }
    }
}
const { made, drawn } = counts;
console.log(`${each * all.length} edits without a trap: ${made} made a scene, ${drawn} were drawn`);
