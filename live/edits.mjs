// Random edits of every committed figure, in Node: `node live/edits.mjs [EDITS [SEED]]`.
// A trap ends it with status 1.
import { bytes, instance } from './module.mjs';
import { figures } from './drags.mjs';

const [count = 10_000, seed = 18] = process.argv.slice(2).map(Number);
let state = seed >>> 0;
/** A number in [0, 1): mulberry32. */
function random() {
    state = (state + 0x6d2b79f5) >>> 0;
    let t = Math.imul(state ^ (state >>> 15), state | 1);
    t ^= t + Math.imul(t ^ (t >>> 7), t | 61);
    return ((t ^ (t >>> 14)) >>> 0) / 2 ** 32;
}
const below = (n) => Math.floor(random() * n);
const number = () => (random() * 2 - 1) * [5, 5, 5, 1e-300, 1e9, 1e300][below(6)];
const pair = () => [number(), number()];

/** A path of a body's key, with a value that it may or may not hold. */
function edit(bodies) {
    const body = ['shapes', below(bodies)];
    const [key, value] = [
        ['position', pair()],
        ['velocity', pair()],
        ['angle_deg', number() * 60],
        ['angular_velocity_deg', number() * 60],
        ['radius', Math.abs(number())],
        ['half_extents', pair().map(Math.abs)],
        ['vertices', null],
    ][below(7)];
    return key === 'vertices' ? [[...body, key, below(4)], pair()] : [[...body, key], value];
}

const tracefig = await instance(bytes());
const counts = { made: 0, drawn: 0 };
const all = figures();
const each = Math.ceil(count / all.length);
for (const { stem, request, path } of all) {
    for (let i = 0; i < each; i += 1) {
        if (i % 50 === 0 && !tracefig.open(request)) throw new Error(`${stem}: ${tracefig.info().error}`);
        const edits = Array.from({ length: 1 + below(2) }, () => edit(path[1] + 1));
        if (tracefig.set(edits)) {
            counts.made += 1;
            counts.drawn += tracefig.draw();
        }
    }
}
const { made, drawn } = counts;
console.log(`${each * all.length} edits without a trap: ${made} made a scene, ${drawn} were drawn`);
