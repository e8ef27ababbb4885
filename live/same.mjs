// Whether the module draws the bytes that `tracefig render` wrote:
// `node live/same.mjs SCENES FOLDER [MODULE]`.
//
// For each scene of the first folder it draws every STEM.svg and STEM.THEME.svg that lies in the second.
import { readFileSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { bytes, instance, prefix } from './module.mjs';
import { requests } from './scenes.mjs';

const [scenes, folder, module] = process.argv.slice(2);
const tracefig = await instance(bytes(module));
let [same, all] = [0, 0];
for (const [stem, { scene, faces }] of requests(scenes)) {
    const is_ours = (name) => name.startsWith(`${stem}.`) && name.endsWith('.svg');
    const pictures = readdirSync(folder).filter(is_ours);
    for (const name of pictures) {
        const wanted = readFileSync(join(folder, name), 'utf8');
        const theme = name.slice(stem.length + 1, -'.svg'.length) || undefined;
        all += 1;
        const request = { scene, faces, id: prefix(wanted), theme };
        if (tracefig.open(request) && tracefig.draw() && tracefig.svg() === wanted) {
            same += 1;
        } else {
            console.log(`OTHER BYTES: ${name} ${tracefig.info().error ?? ''}`);
        }
    }
}
console.log(`${same} of ${all} pictures of the module in Node have the bytes of the binary`);
process.exitCode = same === all && all > 0 ? 0 : 1;
