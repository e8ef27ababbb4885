// In which functions of the module drags spend their time: `node live/hot.mjs MODULE` writes their names,
// where MODULE is what the compiler gave, with names. `build --profile` keeps them in `hot.txt`.
//
// Every committed figure is dragged while Node samples which function runs. Of those with the most time for
// their size so many are taken that they have `BYTES` together: there optimizing for speed is worth most.
import { readFileSync } from 'node:fs';
import { Session } from 'node:inspector/promises';
import { figures, ways } from './drags.mjs';
import { instance } from './module.mjs';
import { bodies, names } from './sections.mjs';

/** Bytes of all functions that are taken, before they are optimized for speed. */
const BYTES = 66_000;
/** Pixels of each way of a drag, and how often all ways are gone. */
const [FRAMES, ROUNDS] = [25, 2];
/** Microseconds between two samples. */
const INTERVAL = 150;
/** Samples without which nothing is said of a function. */
const LEAST = 20;

const module = readFileSync(process.argv[2]);
const session = new Session();
session.connect();
await session.post('Profiler.enable');
await session.post('Profiler.setSamplingInterval', { interval: INTERVAL });
const samples = new Map();
for (const { stem, request, path, place } of figures()) {
    const tracefig = await instance(module);
    if (!tracefig.open(request) || !tracefig.draw()) throw new Error(`${stem}: ${tracefig.info().error}`);
    const [panel] = tracefig.info().panels;
    await session.post('Profiler.start');
    for (let round = 0; round < ROUNDS; round += 1) {
        for (const to of ways(panel, place, FRAMES).flat()) {
            if (tracefig.set([[path, to]])) tracefig.draw();
        }
    }
    const { profile } = await session.post('Profiler.stop');
    for (const { callFrame, hitCount } of profile.nodes) {
        samples.set(callFrame.functionName, (samples.get(callFrame.functionName) ?? 0) + hitCount);
    }
}

const called = names(module);
const all = bodies(module).map(({ length }, index) => {
    const name = called.get(index);
    return { name, length, time: samples.get(name) ?? 0 };
});
// What the standard library brings was compiled for speed.
const ours = all.filter(({ name, time }) => name?.startsWith('_ZN') && time >= LEAST);
ours.sort((a, b) => b.time / b.length - a.time / a.length);
let left = BYTES;
const hot = ours.filter(({ length }) => {
    const fits = length <= left;
    if (fits) left -= length;
    return fits;
});
// A name that a linker has numbered is that of the compiler without the number.
const written = new Set(hot.map(({ name }) => name.replace(/\.\d+$/, '')));
console.log([...written].sort().join('\n'));
