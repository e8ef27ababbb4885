// Drags over a figure, as scripts that measure want them.
import { requests } from './scenes.mjs';

/** The committed figures: the name, what the module opens, and the last body with its place. */
export function figures(folder = new URL('../figures', import.meta.url).pathname) {
    return Array.from(requests(folder), ([stem, request]) => {
        const bodies = Object.values(request.scene.shapes);
        const place = bodies.at(-1).position ?? [0, 0];
        return { stem, request, path: ['shapes', bodies.length - 1, 'position'], place };
    });
}

/** Where a place on the page lies in the space of a panel. */
function world({ zero, x, y }, [px, py]) {
    const [dx, dy] = [px - zero[0], py - zero[1]];
    const det = x[0] * y[1] - x[1] * y[0];
    return [(dx * y[1] - dy * y[0]) / det, (x[0] * dy - x[1] * dx) / det];
}

/** Places in the space of a panel that are a grid of so many rows and columns over it. */
export function grid(panel, places) {
    const [x0, y0, x1, y1] = panel.rect;
    const at = (k, from, to) => from + ((to - from) * k) / (places - 1);
    const all = Array.from({ length: places * places }, (_, k) => [k % places, Math.floor(k / places)]);
    return all.map(([i, j]) => world(panel, [at(i, x0, x1), at(j, y0, y1)]));
}

/** A way from a place and back, a page pixel a frame, in six directions. */
export function ways(panel, [x, y], frames) {
    const unit = Math.hypot(...panel.x);
    const angles = Array.from({ length: 6 }, (_, k) => (k * Math.PI) / 3);
    return angles.map((a) => [Math.cos(a), Math.sin(a)]).map(([dx, dy]) =>
        Array.from({ length: 2 * frames }, (_, k) => {
            const far = (k < frames ? k + 1 : 2 * frames - 1 - k) / unit;
            return [x + dx * far, y + dy * far];
        }),
    );
}
