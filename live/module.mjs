// The module as a program in Node holds it: text in, picture and JSON out.
import { readFileSync } from 'node:fs';
import { gunzipSync } from 'node:zlib';

/** The committed module, or the one at a path. */
export function bytes(path = new URL('tracefig-live.wasm.gz', import.meta.url)) {
    const file = readFileSync(path);
    return file[0] === 0x1f ? gunzipSync(file) : file;
}

/** An instance of a module, which asks for nothing. */
export async function instance(module) {
    const { exports } = (await WebAssembly.instantiate(module, {})).instance;
    const decoder = new TextDecoder();
    const put = (text) => {
        const from = Buffer.from(text);
        const at = exports.tf_input(from.length);
        new Uint8Array(exports.memory.buffer, at, from.length).set(from);
    };
    const told = (at, length) => decoder.decode(new Uint8Array(exports.memory.buffer, at, length));
    return {
        /** Opens a figure: `{scene, id, theme}`. */
        open: (request) => (put(JSON.stringify(request)), exports.tf_open() === 1),
        /** Edits the scene: `[[path, value], …]`. */
        set: (edits) => (put(JSON.stringify(edits)), exports.tf_set() === 1),
        /** Shows the figure up to a step, from 1; without one it is finished. */
        step: (step = 0xffffffff) => exports.tf_step(step),
        /** Places labels afresh in the next picture. */
        rest: () => exports.tf_rest(),
        /** Draws the scene as it is now. */
        draw: () => exports.tf_draw() === 1,
        /** The picture as last drawn. */
        svg: () => told(exports.tf_out(), exports.tf_out_len()),
        /** What the last call has to say. */
        info: () => JSON.parse(told(exports.tf_info(), exports.tf_info_len())),
        /** Bytes of its memory. */
        memory: () => exports.memory.buffer.byteLength,
    };
}

/** What every id of an SVG begins with. */
export const prefix = (svg) => /<title id="([^"]+)-title"/.exec(svg)[1];
