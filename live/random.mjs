// Random edits of a scene, the same for a seed wherever they are made.

/** Gives a function that draws the next one or two edits of a scene of so many bodies. */
export function edits(seed) {
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
    return (bodies) => Array.from({ length: 1 + below(2) }, () => edit(bodies));
}
