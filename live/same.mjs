// Whether the module draws the bytes that `tracefig render` wrote, but for the metadata of a file, and says
// what the page says before it:
// `node live/same.mjs SCENES FOLDER [MODULE]`.
//
// For each scene of the first folder it draws every STEM.svg and STEM.THEME.svg that lies in the second.
// Notes of a scene are of the binary alone.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { bytes, instance, prefix } from './module.mjs';
import { requests } from './scenes.mjs';

const [scenes, folder, module] = process.argv.slice(2);
const code = bytes(module);
let [same, all] = [0, 0];
for (const [stem, { scene, faces, texts, info }] of requests(scenes)) {
    // A page has one for each figure, as the faces that one brings are those of all that follow.
    const tracefig = await instance(code);
    const is_ours = (name) => name.startsWith(`${stem}.`) && name.endsWith('.svg');
    const said = (words) => JSON.stringify({ ...words, notes: [] });
    const pictures = readdirSync(folder).filter(is_ours);
    for (const name of pictures) {
        const wanted = readFileSync(join(folder, name), 'utf8').replace(/\s*<metadata>.*?<\/metadata>/s, '');
        const theme = name.slice(stem.length + 1, -'.svg'.length) || undefined;
        all += 1;
        const request = { scene, faces, texts, id: prefix(wanted), theme };
        if (!tracefig.open(request) || !tracefig.draw() || tracefig.svg() !== wanted) {
            console.log(`OTHER BYTES: ${name} ${tracefig.info().error ?? ''}`);
        } else if (said(tracefig.info()) !== said(info)) {
            console.log(`OTHER WORDS: ${name}`);
        } else {
            same += 1;
        }
    }
}
console.log(`${same} of ${all} pictures of the module in Node have the bytes of the binary`);
process.exitCode = same === all && all > 0 ? 0 : 1;
