// Live figures in built books, in Chromium: `node .ci/book.mjs BOOK…`, each the folder of a book that mdBook wrote.
// `.ci/mdbook` builds them and runs this; `.ci/browser --install` installs what it imports.
//
// Pages are opened as files. Every figure of a page becomes live and is the picture that stood there; one is dragged,
// and says what `tracefig solve` says of the scene that it copies; keys move its handle and turn no page; the reader's
// theme recolours it; axe finds nothing in it. On paper, without scripts, where the module may not run and on the page
// that is printed it is the still picture. `TRACEFIG=path` is the binary.

import { execFileSync } from "node:child_process";
import { readFileSync, readdirSync, statSync, writeFileSync } from "node:fs";
import { basename, dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { launched, require, root } from "./chromium.mjs";

const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const tracefig = process.env.TRACEFIG ?? join(root, "target/debug/tracefig");

const FRAMES = 40; // Frames of a drag.
const SAID = 600; // Milliseconds until a figure has said its result: it waits for 400 of rest.
const failures = [];
const fail = (about, message) => failures.push(`${about}: ${message}`);

const browser = await launched();

// A page that tells of everything that it must not do.
async function opened(file, about, options = {}) {
    const page = await browser.newPage({ viewport: { width: 1280, height: 900 }, ...options });
    page.on("request", (request) => request.url().startsWith("file:") || fail(about, `asks for ${request.url()}`));
    page.on("pageerror", (error) => fail(about, error.stack));
    // The page to be printed asks for that at once.
    await page.addInitScript(() => { globalThis.print = () => {}; });
    await page.goto(pathToFileURL(file).href);
    return page;
}

const frame = (page) => page.evaluate(() => new Promise(requestAnimationFrame));
const states = (page) => page.$$eval(".tracefig-live", (all) => all.map((figure) => figure.dataset.live));

// Scrolls to every figure, and waits until it is live or has said why not.
async function allLive(page, about, options = {}) {
    const figures = await page.$$(".tracefig-live");
    const pictures = () => page.$$eval(".tracefig-live figure > svg:not(.knobs)", (all) => all.map((svg) => {
        const copy = svg.cloneNode(true);
        for (const body of copy.querySelectorAll("[data-held]")) delete body.dataset.held;
        return copy.outerHTML;
    }));
    const before = await pictures();
    for (const figure of figures) {
        await figure.scrollIntoViewIfNeeded();
        await page.waitForFunction((it) => it.dataset.live, figure, { timeout: 20000 });
    }
    for (const state of await states(page)) if (state !== "yes") fail(about, `is not live: ${state}`);
    const after = await pictures();
    if (!options.narrow) {
        after.forEach((svg, i) => svg === before[i] || fail(about, `picture ${i + 1} is another one once it is live`));
    }
    return figures;
}

// Drags the figure's first handle along a curve, and compares with what we say of the scene that it copies.
async function drag(page, figure, about) {
    const ring = await (await figure.$(".knob:not(.gone) .ring")).boundingBox();
    const [x, y] = [ring.x + ring.width / 2, ring.y + ring.height / 2];
    await page.evaluate(() => addEventListener("tracefig", ({ detail }) => (globalThis.drawn = detail)));
    await page.mouse.move(x, y);
    await page.mouse.down();
    for (let i = 1; i <= FRAMES; i++) {
        await page.mouse.move(x + 30 * Math.sin(i / 20), y - 20 * Math.sin(i / 12));
        await frame(page);
    }
    await page.mouse.up();
    await judge(page, figure, `${about}, dragged`);
}

// A body can be taken by any of its points: the first that has one under no handle moves with the pointer, to the right
// or, where the drag before left it at the right edge, to the left.
async function dragBody(page, figure, about) {
    const spot = await figure.evaluate((root) => {
        for (const shape of root.querySelectorAll("[data-held] *")) {
            const { left, top, width, height } = shape.getBoundingClientRect();
            for (let i = 1; i < 40; i++) {
                const [x, y] = [left + (width * (i % 8)) / 8, top + (height * Math.floor(i / 8)) / 5];
                if (document.elementFromPoint(x, y)?.closest("[data-held]")) return [x, y];
            }
        }
        return root.querySelector("[data-held]") && [];
    });
    if (!spot) return;
    if (spot.length === 0) return fail(about, "has no body that can be taken by its points");
    const bodies = () => figure.$$eval("[data-held] *", (all) => all.map((shape) => shape.outerHTML).join(""));
    const before = await bodies();
    for (const way of [3, -3]) {
        await page.mouse.move(...spot);
        await page.mouse.down();
        for (let i = 1; i <= 10; i++) await page.mouse.move(spot[0] + way * i, spot[1]);
        await frame(page);
        await frame(page);
        await page.mouse.up();
        if ((await bodies()) !== before) return;
    }
    fail(about, "a body that is held by one of its points does not move");
}

async function judge(page, figure, about) {
    await page.waitForTimeout(SAID);
    await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error("none")); });
    const said = await (await figure.$(".say")).textContent();
    await (await figure.$(".acts button:last-child")).click();
    const copied = await (await figure.$("textarea.text")).inputValue();
    const { answer, sentence } = await page.evaluate(() => globalThis.drawn);
    if (!said.includes(sentence)) fail(about, `says "${said}", expected "${sentence}"`);
    const { result } = JSON.parse(execFileSync(tracefig, ["solve", "-", "--json"], { input: copied }).toString());
    if (JSON.stringify(answer) !== JSON.stringify(result)) {
        fail(about, `answers ${JSON.stringify(answer)}, expected ${JSON.stringify(result)} of\n${copied}`);
    }
}

// Every theme of the book has the first body in a colour that is readable there, as its style sheet says.
async function themes(page, about) {
    const color = (name) => page.evaluate((name) => {
        document.documentElement.className = `js ${name} sidebar-hidden`;
        return getComputedStyle(document.querySelector('.tracefig-book [id*="-body-A"] [class*="-s-"]')).stroke;
    }, name);
    const [light, navy, coal] = [await color("light"), await color("navy"), await color("coal")];
    if (light === navy || navy !== coal) fail(about, `its first body is ${light} on white, ${navy} and ${coal} on dark`);
    await color("light");
}

async function dragged(file, about) {
    const page = await opened(file, about);
    const figures = await allLive(page, about);
    const held = await Promise.all(figures.map((figure) => figure.$(".knob:not(.gone)")));
    const figure = figures.find((_, i) => held[i]);
    if (!figure) {
        await page.close();
        return 0;
    }
    await figure.scrollIntoViewIfNeeded();
    await drag(page, figure, about);
    const url = page.url();
    const knob = await figure.$(".knob[role=slider]");
    const value = () => knob.getAttribute("aria-valuetext");
    const from = await value();
    await knob.focus();
    for (const key of ["ArrowRight", "ArrowRight", "ArrowUp"]) await page.keyboard.press(key);
    await frame(page);
    await frame(page);
    if (page.url() !== url) fail(about, "an arrow key turns the page under a handle");
    else if ((await value()) === from) fail(about, `arrow keys leave the value at ${from}`);
    await dragBody(page, figure, about);
    await themes(page, about);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run({ include: [[".tracefig-live"]] }));
    for (const { id, help, nodes } of violations) fail(about, `axe: ${id}, ${help}: ${nodes[0].html.slice(0, 200)}`);
    await page.emulateMedia({ media: "print" });
    for (const part of [".knobs", ".bar", ".hint", ".say", ".numbers-of"]) {
        if (await (await figure.$(part)).isVisible()) fail(about, `prints its ${part}`);
    }
    await page.close();
    return 1;
}

// A page on which figures must stay as they are, without a control.
async function still(file, about, options) {
    const page = await opened(file, about, options);
    await page.waitForTimeout(options?.javaScriptEnabled === false ? 0 : SAID);
    const controls = await page.locator(".tracefig-live :is(button, input, .knob)").count();
    if (controls > 0) fail(about, `has ${controls} controls`);
    if ((await page.locator(".tracefig-live svg").first().boundingBox()).width < 100) fail(about, "shows no picture");
    await page.close();
}

async function phone(file, about) {
    const page = await opened(file, about, { viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
    await allLive(page, about, { narrow: true }).catch((error) => fail(about, error.message));
    const wide = await page.evaluate(() => {
        const parts = document.querySelectorAll(".tracefig-live :is(figure, figure > svg, div, p, button, input)");
        const ends = [...parts].map((part) => part.getBoundingClientRect().right);
        return Math.max(document.documentElement.scrollWidth, ...ends);
    });
    if (wide > 361) fail(about, `is ${wide} pixels wide on a screen of 360`);
    await page.close();
}

for (const book of process.argv.slice(2)) {
    const [version, name] = [basename(dirname(book)), basename(book)];
    const live = (file) => readFileSync(join(book, file), "utf8").split('class="tracefig-live"').length - 1;
    const pages = readdirSync(book).filter((file) => file.endsWith(".html") && live(file) > 0);
    const chapters = pages.filter((file) => !["print.html", "index.html"].includes(file));
    let count = 0;
    for (const file of chapters) count += await dragged(join(book, file), `mdBook ${version}, ${file}`);
    if (count < chapters.length / 2) fail(book, "has few figures that can be dragged");
    const [first] = chapters;
    await still(join(book, "print.html"), `mdBook ${version}, the page to be printed`);
    await still(join(book, first), `mdBook ${version}, without scripts`, { javaScriptEnabled: false });
    const strict = join(book, "strict.html");
    const policy = '<meta http-equiv="Content-Security-Policy" content="script-src \'self\' file: \'unsafe-inline\'">';
    writeFileSync(strict, readFileSync(join(book, first), "utf8").replace("<head>", `<head>${policy}`));
    await still(strict, `mdBook ${version}, where no module may run`);
    await phone(join(book, first), `mdBook ${version}, on a phone`);
    const runtime = readdirSync(book).find((file) => /^tracefig-live.*\.js$/.test(file));
    const html = readFileSync(join(book, first));
    console.log(
        `${name} by mdBook ${version}: a figure dragged on ${count} of ${chapters.length} pages; ${first} ${html.length} bytes, ` +
        `${gzipSync(html).length} with gzip; ${runtime} ${statSync(join(book, runtime)).size} bytes, ` +
        `${gzipSync(readFileSync(join(book, runtime))).length} with gzip`,
    );
}
await browser.close();
for (const failure of failures) console.error(`FAILED ${failure}`);
process.exitCode = failures.length > 0 ? 1 : 0;
