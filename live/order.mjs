// Functions of a module in an order in which what packs it finds them alike: gzip looks back by 32 kB, and a
// function packs best behind those that share most of its bytes. Of 727 kB packed it is 10.

/** Bytes that are looked for elsewhere, as one word: what gzip finds are three and more. */
const WORD = 6;
/** A word that stands in more functions than this tells nothing of what they do. */
const COMMON = 40;
/** How far back functions count, bytes: three quarters of what gzip looks back by. */
const WINDOW = 24_000;

/** For each body the numbers of its words, without those that are its alone or common; and who has which. */
function words(bodies) {
    const numbers = new Map();
    const owners = [];
    for (const [body, bytes] of bodies.entries()) {
        for (let at = 0; at + WORD <= bytes.length; at += 1) {
            const word = bytes.toString('latin1', at, at + WORD);
            let number = numbers.get(word);
            if (number === undefined) numbers.set(word, (number = owners.push([]) - 1));
            const of = owners[number];
            if (of.length <= COMMON && of.at(-1) !== body) of.push(body);
        }
    }
    const own = bodies.map(() => []);
    for (const [number, of] of owners.entries()) {
        if (of.length > 1 && of.length <= COMMON) for (const body of of) own[body].push(number);
    }
    return { own, owners };
}

/** The numbers of bodies, each behind those with which it shares most, for its length. */
export function alike(bodies) {
    const { own, owners } = words(bodies);
    const shared = new Int32Array(bodies.length);
    const count = (body, by) => {
        for (const number of own[body]) for (const other of owners[number]) shared[other] += by;
    };
    const left = new Set(bodies.keys());
    const [order, near] = [[], []];
    let length = 0;
    for (let next = 0; left.size > 0; ) {
        order.push(next);
        left.delete(next);
        count(next, 1);
        near.push(next);
        length += bodies[next].length;
        while (length > WINDOW && near.length > 1) {
            const gone = near.shift();
            count(gone, -1);
            length -= bodies[gone].length;
        }
        let most = -1;
        for (const body of left) {
            const share = shared[body] / bodies[body].length;
            if (share > most) [next, most] = [body, share];
        }
    }
    return order;
}
