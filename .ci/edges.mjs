// What live figures do at their edges: two on one page, what a voice says of a drag, a handle that is dragged away, and
// a page as narrow as a phone. `live.mjs` opens the browser and runs this.

import { readFileSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { pathToFileURL } from "node:url";

const SAID = 600; // Milliseconds until a page has said the result: it waits for 400 of rest.
const AWAY = 1e6; // Page pixels, and units of the world, from where no figure is seen.
const PHONE = 380; // CSS pixels.
const DIGITS = 9; // More than a hand can set.

const frame = (page) => page.evaluate(() => new Promise(requestAnimationFrame));
const isLive = () =>
    [...document.querySelectorAll(".tracefig-live")].every(({ dataset }) => dataset.drawn !== undefined);

// What a reader has of the figures of a page: the picture, what is said, whether that was changed.
const state = (page) => page.$$eval(".tracefig-live", (all) => all.map((root) => {
    const picture = root.querySelector("figure > svg:not(.knobs)").cloneNode(true);
    for (const body of picture.querySelectorAll("[data-held]")) delete body.dataset.held;
    return {
        live: root.dataset.live,
        picture: picture.outerHTML,
        said: root.querySelector(".say").textContent,
        why: root.querySelector(".why").textContent,
        changed: root.hasAttribute("data-changed"),
        values: Array.from(root.querySelectorAll(".numbers input"), (field) => field.value).join(),
    };
}));

async function opened(browser, file, fail, about, options = {}) {
    const page = await browser.newPage({ viewport: { width: 1100, height: 900 }, ...options });
    page.on("console", (message) => fail(about, message.text()));
    page.on("pageerror", (error) => fail(about, error.stack));
    await page.goto(pathToFileURL(file).href);
    await page.waitForFunction(isLive);
    return page;
}

// Takes hold of a handle and goes somewhere in some frames; the mouse stays down.
async function pull(page, knob, [dx, dy], frames = 8) {
    await knob.scrollIntoViewIfNeeded();
    const box = await (await knob.$(".ring")).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= frames; i++) {
        await page.mouse.move(x + (dx * i) / frames, y + (dy * i) / frames);
        await frame(page);
    }
}

// A page that has the figure of another one behind its own.
function together(first, second, file) {
    const [one, other] = [first, second].map((path) => readFileSync(path, "utf8"));
    const from = other.indexOf('<div class="tracefig-live"');
    const root = other.slice(from, other.indexOf("</main>", from));
    writeFileSync(file, one.replace("</main>", () => `${root}</main>`));
}

// Two figures: what is done with one leaves the other, and the address of the page, alone.
async function two(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.waitForTimeout(SAID);
    const before = await state(page);
    if (before.some(({ live }) => live !== "yes")) fail(about, `is not live: ${before.map(({ live }) => live)}`);
    const ids = await page.$$eval("[id]", (all) => all.map(({ id }) => id));
    const twice = ids.filter((id, i) => ids.indexOf(id) < i);
    if (twice.length > 0) fail(about, `has twice the id ${twice[0]}`);
    for (const moved of [1, 0]) {
        const known = await state(page);
        const knob = await page.locator(".tracefig-live").nth(moved).locator(".knob[role=slider]:not(.gone)").first();
        await pull(page, await knob.elementHandle(), [24, -16]);
        await page.mouse.up();
        await page.waitForTimeout(SAID);
        const now = await state(page);
        const other = 1 - moved;
        if (now[moved].picture === known[moved].picture) fail(about, `figure ${moved + 1} stays as it is when dragged`);
        for (const key of Object.keys(now[other])) {
            if (now[other][key] === known[other][key]) continue;
            fail(about, `a drag of figure ${moved + 1} changes ${key} of the other`);
        }
        if (new URL(page.url()).hash.length > 1) fail(about, `its address says ${page.url()}, and not of which figure`);
    }
    for (const reset of await page.$$(".reset")) await reset.click();
    await page.waitForTimeout(SAID);
    const after = await state(page);
    for (const [i, { picture }] of after.entries()) {
        if (picture !== before[i].picture) fail(about, `figure ${i + 1} is another one after a reset`);
    }
    await page.close();
}

// While a handle is held nothing is said; at rest the result is, once.
async function voice(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.waitForTimeout(SAID);
    await page.evaluate(() => {
        globalThis.said = [];
        const say = document.querySelector(".say");
        new MutationObserver(() => globalThis.said.push(say.textContent)).observe(say, { childList: true });
        document.addEventListener("tracefig", ({ detail }) => { globalThis.sentence = detail.sentence; });
    });
    const region = await page.$eval(".say", (say) => [say.getAttribute("role"), say.getAttribute("aria-live")].join());
    const isPolite = ["status,", "status,polite", ",polite"].includes(region);
    if (!isPolite) fail(about, `says results in a region that is ${region}`);
    await pull(page, await page.$(".knob[role=slider]:not(.gone)"), [30, -20]);
    const during = await page.evaluate(() => globalThis.said.length);
    if (during > 0) fail(about, `speaks ${during} times while a handle is held`);
    const [seen, now] = await page.evaluate(() => [document.querySelector(".seen").textContent, globalThis.sentence]);
    if (!seen.includes(now)) fail(about, `shows "${seen}" while a handle is held, expected "${now}"`);
    await page.mouse.up();
    await page.waitForTimeout(2 * SAID);
    const { said, sentence } = await page.evaluate(() => ({ said: globalThis.said, sentence: globalThis.sentence }));
    if (said.length !== 1 || !said[0].includes(sentence)) fail(about, `says ${JSON.stringify(said)} of "${sentence}"`);
    await page.close();
}

// A handle that goes far away stops where it can, by a pointer and by numbers, and the figure lives on.
async function away(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.waitForTimeout(SAID);
    const [before] = await state(page);
    await pull(page, await page.$(".knob[role=slider]:not(.gone)"), [AWAY, -AWAY], 4);
    await page.mouse.up();
    await page.waitForTimeout(SAID);
    const check = async (how, asked) => {
        const [{ picture, said, why, values }] = await state(page);
        if (/NaN|Infinity/.test(picture)) fail(about, `${how}, draws what is no number`);
        if (!said) fail(about, `${how}, says nothing`);
        const stopped = !values.split(",").includes(String(asked));
        if (asked !== undefined && stopped && !why) fail(about, `${how}, stops at ${values} and does not say why`);
        if (why && !said.includes(why)) fail(about, `${how}, shows "${why}" and says "${said}"`);
        const given = before.values.split(",");
        const long = values.split(",").find((v) => !given.includes(v) && v.replaceAll(/\D/g, "").length > DIGITS);
        if (long) fail(about, `${how}, has ${long} in a field`);
    };
    await check("dragged away");
    await page.click(".numbers-of summary");
    const field = page.locator(".numbers input").first();
    for (const far of [AWAY, 1e308]) {
        if ((await field.count()) === 0) break;
        await field.fill(String(far));
        await field.press("Enter");
        await page.waitForTimeout(SAID);
        await check(`set to ${far}`, far);
    }
    await page.click(".reset");
    await page.waitForTimeout(SAID);
    const [after] = await state(page);
    if (after.picture !== before.picture) fail(about, "is another one after it was away and taken back");
    await page.close();
}

// An address with vertices that only together make an outline, and a time: all are taken, and the playhead stays the one
// that there is.
async function addressed(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    const at = (time) => `shapes/Sheet/vertices/1=20,0&shapes/Sheet/vertices/0=5,-1&panels/1/time=${time}`;
    for (const time of [0.25, 0.5]) {
        await page.evaluate((hash) => (location.hash = hash), at(time));
        await page.waitForTimeout(SAID);
        const [{ values, why }] = await state(page);
        const asked = `5,-1,20,0,4,4,0,4,${time}`;
        if (values !== asked || why) fail(about, `has ${values} at an address of ${asked}, and says "${why}"`);
        const hash = await page.evaluate(() => location.hash.slice(1));
        if (hash.split("&").sort().join() !== at(time).split("&").sort().join()) fail(about, `goes on to ${hash}`);
    }
    await page.close();
}

// A page as wide as a phone: the columns that a scene asks for are not what it has, and nothing sticks out.
async function narrow(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.waitForTimeout(SAID);
    const [wide] = await state(page);
    await page.setViewportSize({ width: PHONE, height: 800 });
    await page.waitForTimeout(2 * SAID);
    const { scroll, shown, panels } = await page.evaluate(() => {
        const svg = document.querySelector("figure > svg:not(.knobs)");
        // What is drawn beyond a panel is cut off at its edge.
        const cuts = Array.from(svg.querySelectorAll("clipPath > rect"), ({ x, width }) => [x, width]);
        const ends = cuts.map(([x, width]) => [x.baseVal.value, x.baseVal.value + width.baseVal.value]);
        return {
            scroll: document.documentElement.scrollWidth,
            shown: svg.getBoundingClientRect().width / svg.viewBox.baseVal.width,
            panels: ends.map((at) => at.map((end) => end / svg.viewBox.baseVal.width)),
        };
    });
    if (scroll > PHONE) fail(about, `is ${scroll} wide on a page of ${PHONE}`);
    if (shown < 0.8) fail(about, `shows its letters at ${shown.toFixed(2)} of their size on a page of ${PHONE}`);
    const beyond = panels.length === 0 || panels.some(([left, right]) => left < 0 || right > 1);
    if (beyond) fail(about, `has panels beyond a page of ${PHONE}`);
    await page.setViewportSize({ width: 1100, height: 900 });
    await page.waitForTimeout(2 * SAID);
    const [again] = await state(page);
    if (again.picture !== wide.picture) fail(about, `is another one after it was ${PHONE} wide`);
    await page.close();
}

// Sizes of a small body that has turned: keys to the right and up make them more, a drag through the middle makes a
// radius less and not more again, and a number that can't be leaves all as it was.
async function sizes(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.waitForTimeout(SAID);
    await page.click(".numbers-of summary");
    const values = async () => (await state(page))[0].values.split(",").map(Number);
    const [angle, radius, width, height] = await values();
    const pressed = async (name, key) => {
        await page.focus(`.knob[role=slider][aria-label="${name} of chip"]`);
        await page.keyboard.press(key);
        await frame(page);
        await frame(page);
        return values();
    };
    const same = (a, b) => a.length === b.length && a.every((v, i) => Math.abs(v - b[i]) < 1e-12);
    for (const [key, wanted] of [["ArrowRight", [width + 0.001, height]], ["ArrowUp", [width + 0.001, height + 0.001]]]) {
        const now = await pressed("half-extents", key);
        if (!same(now.slice(2), wanted)) fail(about, `${key} gives half-extents of ${now.slice(2)}`);
    }
    const less = await pressed("radius", "ArrowLeft");
    if (!same(less, [angle, radius - 0.001, width + 0.001, height + 0.001])) fail(about, `ArrowLeft gives ${less}`);
    await pull(page, await page.$('.knob.radius[role=slider]'), [-60, -60]);
    await page.mouse.up();
    await page.waitForTimeout(SAID);
    const through = (await values())[1];
    if (!(through < radius)) fail(about, `dragged through the corner the radius is ${through}`);
    const before = await state(page);
    await page.locator(".numbers input").nth(2).fill("-1");
    await page.keyboard.press("Enter");
    await page.waitForTimeout(SAID);
    const [after] = await state(page);
    if (after.picture !== before[0].picture || !after.why) fail(about, `a width of -1 gives ${after.values}`);
    const heard = await page.getAttribute(".knob.angle", "aria-valuetext");
    if (heard !== `${angle}°`) fail(about, `an angle is heard as ${heard}`);
    await page.close();
}

// A finger drags what it holds, a handle or a body, and beside that the page scrolls.
async function finger(browser, file, fail, about) {
    const phone = { viewport: { width: PHONE, height: 700 }, isMobile: true, hasTouch: true };
    const page = await opened(browser, file, fail, about, phone);
    await page.evaluate(() => { document.body.style.paddingBottom = "2000px"; });
    await page.waitForTimeout(SAID);
    const session = await page.context().newCDPSession(page);
    const touch = (type, ...points) => session.send("Input.dispatchTouchEvent", { type, touchPoints: points });
    const places = await page.evaluate(() => {
        const { x, bottom } = document.querySelector("figure > svg").getBoundingClientRect();
        const held = { handle: ".knob[role=slider]:not(.gone) .ring", body: "figure > svg [data-held]" };
        const there = Object.entries(held).map(([what, css]) => [what, document.querySelector(css)]);
        const boxes = there.filter(([, at]) => at).map(([what, at]) => [what, at.getBoundingClientRect()]);
        const middles = boxes.map(([what, at]) => [what, at.x + at.width / 2, at.y + at.height / 2]);
        return [...middles, ["page", x + 4, bottom - 4]];
    });
    for (const [what, x, y] of places) {
        await touch("touchStart", { x, y });
        for (let i = 1; i <= 10; i++) {
            await touch("touchMove", { x, y: y - 6 * i });
            await frame(page);
        }
        await touch("touchEnd");
        await page.waitForTimeout(SAID);
        const [{ changed }] = await state(page);
        const scrolled = await page.evaluate(() => scrollY);
        const isDragged = what !== "page";
        if (changed !== isDragged || scrolled > 0 === isDragged) {
            fail(about, `a finger on the ${what} scrolls by ${scrolled}, changed: ${changed}`);
        }
        if (changed) await page.click(".reset");
        await page.evaluate(() => scrollTo(0, 0));
    }
    await page.close();
}

// What was refused is no longer said at a step; a pointer whose end nobody tells, and one that another finger follows,
// hold what they took alone; and bodies that are called as numbers are copied in the order of the scene.
async function letGo(browser, file, fail, about) {
    const page = await opened(browser, file, fail, about);
    await page.click(".numbers-of summary");
    const field = page.locator(".numbers input[aria-label^='vertex']").first();
    const typed = async (words) => {
        await field.fill(words);
        await field.press("Enter");
        await page.waitForTimeout(SAID);
        return (await state(page))[0];
    };
    const { why } = await typed("1e20");
    if (!why) fail(about, "a vertex at 1e20 is not refused");
    await page.click(".steps button:first-child");
    await page.waitForTimeout(SAID);
    const [stepped, seen] = [(await state(page))[0], await page.textContent(".seen")];
    if (stepped.why) fail(about, `a step back it still says "${stepped.why}"`);
    const again = await browser.newPage();
    await again.goto(page.url());
    await again.waitForFunction(isLive);
    await again.waitForTimeout(SAID);
    const there = await again.textContent(".seen");
    if (there !== seen) fail(about, `says "${seen}" at a step, and "${there}" where its address is opened`);
    await again.close();
    await typed("1e20");
    const after = await typed("");
    if (after.why) fail(about, `says "${after.why}" of a number that nobody typed`);

    const session = await page.context().newCDPSession(page);
    const box = await (await page.$(".knob[role=slider]:not(.gone) .ring")).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    const mouse = (type, by, buttons) => {
        const button = type === "mouseMoved" ? "none" : "left";
        return session.send("Input.dispatchMouseEvent", { type, x: x + by, y, button, buttons, clickCount: 1 });
    };
    await mouse("mousePressed", 0, 1);
    await mouse("mouseMoved", 20, 1);
    await frame(page);
    await mouse("mouseMoved", 21, 0);
    await page.waitForTimeout(SAID);
    const isHeld = await page.evaluate(() => document.querySelector("[data-dragging],.dragged") !== null);
    if (isHeld) fail(about, "holds what no button holds");
    await mouse("mouseReleased", 21, 0);

    await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error("none")); });
    await page.click(".acts button:last-child");
    const copied = await page.inputValue("textarea.text");
    const names = Array.from(copied.matchAll(/^\[shapes\.(.*)\]$/gm), (match) => match[1]).join();
    if (names !== "b,7,3,2") fail(about, `copies the bodies ${names}`);
    await page.close();
}

// Looks at the edges of some pages that share the module in `site`; at `alone` are two pages with all they need, at
// `numbers` is one of bodies that are called as numbers, and `columns` are pages whose scenes ask for columns.
export async function edges({ browser, site, work, fail, stems, columns, alone, numbers }) {
    const shared = (stem) => join(site, `${stem}.html`);
    const [first, second] = stems;
    const pair = join(site, "two.html");
    together(shared(first), shared(second), pair);
    await two(browser, pair, fail, "two that share the module");
    const complete = join(work, "two-alone.html");
    together(...alone, complete);
    await two(browser, complete, fail, "two with all they need");
    for (const stem of stems) {
        await voice(browser, shared(stem), fail, `${stem}, heard`);
        await away(browser, shared(stem), fail, `${stem}, far away`);
        await finger(browser, shared(stem), fail, `${stem}, by a finger`);
    }
    await sizes(browser, shared("small-and-turned"), fail, "sizes of a small body");
    await letGo(browser, numbers, fail, "names that are numbers");
    await addressed(browser, shared("two-vertices"), fail, "two vertices in an address");
    for (const stem of columns) await narrow(browser, shared(stem), fail, `${stem}, narrow`);
}
