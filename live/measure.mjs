// What live figures cost, in Node: `node live/measure.mjs [MODULE]`.
//
// Bytes of the module; for each committed figure the time of a frame (edit, draw, read) as its last body is
// dragged by a pixel a frame; how many places of a grid over its first panel are refused; memory in the end.
// Times are processor time: what else the machine does is not in it, the threads that compile the module are.
import { brotliCompressSync, constants, gzipSync } from 'node:zlib';
import { bytes, instance } from './module.mjs';
import { figures, grid, ways } from './drags.mjs';

const FRAMES = 25;
const PLACES = 13;

/** Milliseconds of processor time so far. */
const now = () => process.cpuUsage().user / 1000;
const module = bytes(process.argv[2]);
const brotli = brotliCompressSync(module, {
    params: { [constants.BROTLI_PARAM_QUALITY]: 11, [constants.BROTLI_PARAM_LGWIN]: 24 },
});
const gzip = gzipSync(module, { level: 9 });
console.log(`module: ${module.length} bytes, ${gzip.length} with gzip, ${brotli.length} with brotli`);
let start = now();
let tracefig = await instance(module);
console.log(`compiled in ${(now() - start).toFixed(0)} ms\n`);

/** The value below which a share of all lies. */
const quantile = (values, share) => values[Math.min(values.length - 1, Math.floor(values.length * share))];
const ms = (value) => value.toFixed(2).padStart(7);
const reasons = new Map();
const all = { times: [], places: 0, refused: 0 };
console.log(`${'figure'.padEnd(24)}   first  median     p95   worst  refused of ${PLACES * PLACES}`);
for (const { stem, request, path, place } of figures()) {
    // The glyphs that a page brings are those of all that follow in an instance.
    tracefig = await instance(module);
    start = now();
    if (!tracefig.open(request) || !tracefig.draw()) throw new Error(`${stem}: ${tracefig.info().error}`);
    const first = now() - start;
    const [panel] = tracefig.info().panels;
    const times = [];
    for (const to of ways(panel, place, FRAMES).flat()) {
        start = now();
        if (tracefig.set([[path, to]]) && tracefig.draw()) {
            tracefig.svg();
            tracefig.info();
            times.push(now() - start);
        }
    }
    times.sort((a, b) => a - b);
    all.times.push(...times);
    let refused = 0;
    for (const to of grid(panel, PLACES)) {
        all.places += 1;
        if (tracefig.set([[path, to]]) && tracefig.draw()) continue;
        refused += 1;
        const why = `${stem}: ${tracefig.info().error}`;
        reasons.set(why, (reasons.get(why) ?? 0) + 1);
    }
    all.refused += refused;
    const [median, most] = [quantile(times, 0.5), quantile(times, 0.95)];
    const row = [first, median, most, times.at(-1)].map(ms).join(' ');
    console.log(`${stem.padEnd(24)} ${row}  ${String(refused).padStart(7)}`);
}
all.times.sort((a, b) => a - b);
const share = ((100 * all.refused) / all.places).toFixed(2);
const [median, most] = [quantile(all.times, 0.5), quantile(all.times, 0.95)];
console.log(`\nall: median ${ms(median)}, p95 ${ms(most)} ms of ${all.times.length} frames`);
console.log(`refused: ${all.refused} of ${all.places} places (${share} %)`);
for (const [why, count] of reasons) console.log(`  ${count} × ${why}`);
console.log(`memory: ${(tracefig.memory() / 2 ** 20).toFixed(1)} MiB`);
