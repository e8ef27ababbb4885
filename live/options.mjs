// Scenes of each layer with each of its options, which no figure has: `node live/options.mjs FOLDER`.
//
// For each of some questions and both spaces it writes a scene of every layer that `tracefig list layers`
// names, of that with every value of every option, and with all its flags. Those that the layer does not fit
// are refused by `tracefig render`.
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';

const [folder] = process.argv.slice(2);
const tracefig = process.env.TRACEFIG ?? new URL('../target/release/tracefig', import.meta.url).pathname;
const QUESTIONS = {
    apart: ['separation', 'gjk', '', '', [5, 2]],
    overlapping: ['separation', 'minkowski', '', '', [1.2, 2]],
    axes: ['separation', 'separating-axes', '', '', [5, 2]],
    merged: ['separation', 'merge', '', '', [5, 2]],
    contact: ['contact', 'clip', '', '', [1.7, 2]],
    hit: ['linear-sweep', 'ray-cast', 'velocity = [6, 2]', 'velocity = [-1, -1]', [7, 2]],
    miss: ['linear-sweep', 'ray-cast', 'velocity = [1, -6]', 'velocity = [-1, 1]', [7, 2]],
    turning: [
        'time-of-impact', 'conservative-advancement', 'velocity = [6, 2]\nangular_velocity_deg = 90',
        'velocity = [-1, -1]\nangular_velocity_deg = -30', [7, 2],
    ],
};
const scene = ([kind, algorithm, a, b, [x, y]]) => `
[shapes.A]
kind = "polygon"
vertices = [[-2, -1], [1, -2], [2, 1], [-1, 2]]
${a}
[shapes.B]
kind = "regular-polygon"
edges = 5
circumradius = 1.5
radius = 0.2
position = [${x}, ${y}]
angle_deg = 10
${b}
[query]
kind = "${kind}"
of = ["A", "B"]
algorithm = "${algorithm}"
`;

/** Values of an option, by what it takes. */
function values(takes) {
    const words = takes.replace(/^some of |^an? .*? \| /, '').split(/ \| |, /);
    if (takes === 'true or false') return ['true', 'false'];
    if (/a number/.test(takes)) return [0.25, 0.5, 1, 3];
    if (/whole number/.test(takes)) return [1];
    if (/names|text|role|\[x, y\]/.test(takes)) return [];
    return words.map((word) => `"${word.trim()}"`);
}

/** The layers, each with its options and what they take. */
function layers() {
    const all = new Map();
    let options;
    for (const line of execFileSync(tracefig, ['list', 'layers'], { encoding: 'utf8' }).split('\n')) {
        const option = /^ {2}(\S+) +(.*?): /.exec(line);
        if (option) options?.push([option[1], option[2]]);
        else if (/^[a-z]/.test(line)) all.set(line.split(' ')[0], (options = []));
    }
    return all;
}

mkdirSync(folder, { recursive: true });
for (const [name, question] of Object.entries(QUESTIONS)) {
    for (const [layer, options] of layers()) {
        const given = ([key, takes]) => values(takes).map((value) => `${key} = ${value}`);
        const [asked, are_flags] = [options.flatMap(given), ([, takes]) => takes === 'true or false'];
        const flags = options.filter(are_flags).map(([key]) => `${key} = true`);
        for (const [i, said] of ['', ...asked, flags.join(', ')].entries()) {
            for (const [space, below] of [['world', 'shapes'], ['configuration', 'difference']]) {
                const own = `{ layer = "${layer}"${said && `, ${said}`} }`;
                const panel = `[[panels]]\nspace = "${space}"\nlayers = ["${below}", ${own}]\n`;
                writeFileSync(join(folder, `${name}-${space}-${layer}-${i}.toml`), scene(question) + panel);
            }
        }
    }
}
