// Every committed SVG in Chromium; `.ci/browser` installs what this imports, and runs it.
//
// Alone, a figure must look as our own PNG of it does, hold nothing that runs, and load nothing. In a page with all the
// others it must keep every byte of its picture, so no id and no class reaches from one to another. The auto theme and
// the custom properties are held against PNGs that we draw in the colours in question. In a page axe finds nothing, and
// words are found.

import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { launched, require, root, wordsNotFound } from "./chromium.mjs";

const figures = join(root, "figures");
const work = join(root, "target/browser");
const { PNG } = require("pngjs");

// Limits. Measured with Chromium 156 and 19 figures: the mean is 0.119 to 0.206, 0.244 in dark (all along edges: we count
// sixteen levels of coverage, Chromium more), and at most 4 pixels differ strongly.
//
// Mean difference over all pixels and channels, in levels of 255: two fills in dark at 0.14 for 0.20 make it 2.5.
// Pages end where their drawing ends, and a grid has a soft edge on every row: 0.40 at most of our figures, but 0.47 where
// tinted areas lie over each other on a small page (contact-clipping).
const MEAN_LIMIT = 0.5;
// Levels by which a channel differs strongly. What is lost but a thin grey line differs by more; at half of it, hundreds
// of pixels along edges and letters do.
const STRONG = 64;
// How far, in image pixels, a strong difference may find its colour in the other picture. Chromium measures arcs short: on
// a dotted circle of radius 45 its dots run ahead by 0.55 page pixels in a round, where ours are within 0.09 of the truth.
const REACH = 2;
// Pixels that may differ strongly: 4 in most figures, 9 where dotted outlines cross (advancement-steps). A caption without its full
// stop has 10, a lost marker 115.
const STRONG_LIMIT = 9;

// The scene whose colours are tried, and a colour for its shape A that no theme has.
const TRIED = "01-penetration";
const OTHER_A = "#6b3d00";
// And an opacity of fills that none has.
const OTHER_OPACITY = 0.3;

const failures = [];
const fail = (about, message) => failures.push(`${about}: ${message}`);
const read = (file) => PNG.sync.read(readFileSync(file));

// Largest difference of a channel, of pixel `i` of `a` and pixel `j` of `b`.
function between(a, i, b, j) {
    let most = 0;
    for (let channel = 0; channel < 3; channel++) {
        most = Math.max(most, Math.abs(a.data[4 * i + channel] - b.data[4 * j + channel]));
    }
    return most;
}

// Whether pixel `i` of `a` differs strongly from all pixels within reach of it in `b`: what `b` lacks does.
function missing(a, i, b) {
    for (let y = -REACH; y <= REACH; y++) {
        for (let x = -REACH; x <= REACH; x++) {
            const j = i + y * b.width + x;
            if (j >= 0 && j < b.width * b.height && between(a, i, b, j) <= STRONG) return false;
        }
    }
    return true;
}

// The mean difference, the pixels that differ strongly, and a picture that is black where both agree.
function compare(actual, expected) {
    const { width, height } = expected;
    if (actual.width !== width || actual.height !== height) {
        throw new Error(`expected ${width} × ${height} pixels, got ${actual.width} × ${actual.height}`);
    }
    const difference = new PNG({ width, height });
    let sum = 0;
    let strong = 0;
    for (let i = 0; i < width * height; i++) {
        for (let channel = 4 * i; channel < 4 * i + 3; channel++) {
            difference.data[channel] = Math.abs(actual.data[channel] - expected.data[channel]);
            sum += difference.data[channel];
        }
        difference.data[4 * i + 3] = 255;
        const differs = between(actual, i, expected, i) > STRONG;
        strong += differs && (missing(actual, i, expected) || missing(expected, i, actual)) ? 1 : 0;
    }
    return { mean: sum / (3 * width * height), strong, difference };
}

// A row of the table; both pictures and their difference are kept where it fails.
function judge(about, screenshot, expected) {
    const actual = PNG.sync.read(screenshot);
    const { mean, strong, difference } = compare(actual, expected);
    const failed = mean > MEAN_LIMIT || strong > STRONG_LIMIT;
    const numbers = `${mean.toFixed(3).padStart(8)} ${String(strong).padStart(8)}`;
    console.log(`${about.padEnd(32)} ${numbers}${failed ? "  FAILED" : ""}`);
    if (failed) {
        for (const [kind, image] of Object.entries({ expected, actual, difference })) {
            writeFileSync(join(work, "failed", `${about.replaceAll(" ", "-")}.${kind}.png`), PNG.sync.write(image));
        }
        fail(about, `mean difference ${mean.toFixed(3)}, ${strong} strong pixels`);
    }
}

// In the page: what could run or load, ids that stand twice, and references to none.
function faultsOfDocument() {
    const faults = [];
    const ids = new Set();
    const refer = (id) => document.getElementById(id) || faults.push(`no element has the id "${id}"`);
    for (const element of document.querySelectorAll("*")) {
        if (["script", "foreignObject", "image", "iframe"].includes(element.localName)) faults.push(`a ${element.localName}`);
        if (element.localName === "style" && /url\(|@import/.test(element.textContent)) faults.push("a style sheet that loads");
        if (element.id && ids.has(element.id)) faults.push(`the id "${element.id}" stands twice`);
        ids.add(element.id);
        for (const { localName, value } of element.attributes) {
            if (localName.startsWith("on")) faults.push(`an attribute ${localName}`);
            const targets = localName === "href" || localName === "src" ? [value] : [];
            targets.push(...Array.from(value.matchAll(/url\(([^)]*)\)/g), (found) => found[1]));
            for (const target of targets) {
                if (target.startsWith("#")) refer(target.slice(1));
                else faults.push(`a reference to ${target}`);
            }
            if (localName === "aria-labelledby") value.split(" ").forEach(refer);
        }
    }
    return faults;
}

// The scene that is tried, drawn by us; the path of its file.
function render(theme, format) {
    const into = join(work, "tried", basename(theme, ".toml"));
    const scene = join(figures, `${TRIED}.toml`);
    const args = ["render", scene, "--theme", theme, "--format", format, "-o", into];
    execFileSync(join(root, "target/debug/tracefig"), args, { stdio: ["ignore", "ignore", "inherit"] });
    return join(into, `${TRIED}.${format}`);
}

function themeFile(name, text) {
    const file = join(work, "tried", `${name}.toml`);
    writeFileSync(file, text);
    return file;
}

for (const folder of ["failed", "tried"]) {
    rmSync(join(work, folder), { recursive: true, force: true });
    mkdirSync(join(work, folder), { recursive: true });
}
const browser = await launched();
const page = await browser.newPage({ viewport: { width: 960, height: 540 }, deviceScaleFactor: 2 });
let opened = "";
page.on("request", (request) => request.url() === opened || fail(basename(opened), `asks for ${request.url()}`));
page.on("console", (message) => fail(basename(opened), message.text()));

async function open(file) {
    opened = pathToFileURL(file).href;
    await page.goto(opened);
    for (const fault of await page.evaluate(faultsOfDocument)) fail(basename(file), fault);
}

// What is shown, of a page as large as a picture at twice its size; figures end where their drawing ends.
async function shot({ width, height }) {
    await page.setViewportSize({ width: width / 2, height: height / 2 });
    return page.screenshot();
}

// Opens an HTML page with figures inlined, all in the same place.
async function inline(files, sheet = "") {
    const html = join(work, "tried/inlined.html");
    const place = "body{margin:0}svg{position:absolute;top:0;left:0}";
    const pictures = files.map((file) => readFileSync(file, "utf8")).join("");
    writeFileSync(html, `<!doctype html><html lang="en"><meta charset="utf-8"><style>${place}${sheet}</style>${pictures}`);
    await open(html);
}

console.log(`${"figure".padEnd(32)} ${"mean".padStart(8)} ${"strong".padStart(8)}`);
const files = readdirSync(figures).filter((file) => file.endsWith(".svg")).sort().map((file) => join(figures, file));
const alone = [];
for (const file of files) {
    await open(file);
    const expected = read(file.replace(/svg$/, "png"));
    alone.push(await shot(expected));
    judge(basename(file, ".svg"), alone.at(-1), expected);
}

await inline(files);
for (const [k, file] of files.entries()) {
    await page.evaluate((shown) => {
        document.querySelectorAll("svg").forEach((svg, k) => (svg.style.visibility = k === shown ? "visible" : "hidden"));
    }, k);
    const together = await shot(read(file.replace(/svg$/, "png")));
    if (!together.equals(alone[k])) {
        judge(`${basename(file, ".svg")} in a page`, together, PNG.sync.read(alone[k]));
        fail(basename(file), "other figures in its page change it");
    }
}

const auto = render("auto", "svg");
for (const colorScheme of ["light", "dark"]) {
    await page.emulateMedia({ colorScheme });
    await open(auto);
    const expected = read(render(colorScheme, "png"));
    judge(`${TRIED} auto, ${colorScheme}`, await shot(expected), expected);
}
await page.emulateMedia({ colorScheme: "light" });

const other = render(themeFile("other-a", `[colors]\na = "${OTHER_A}"\n`), "png");
await inline([join(figures, `${TRIED}.svg`)], `:root{--tracefig-a:${OTHER_A}}`);
judge(`${TRIED} --tracefig-a`, await shot(read(other)), read(other));

const fuller = render(themeFile("fuller", `fill_opacity = ${OTHER_OPACITY}\n`), "png");
await inline([join(figures, `${TRIED}.svg`)], `:root{--tracefig-fill-opacity:${OTHER_OPACITY}}`);
judge(`${TRIED} --tracefig-fill-opacity`, await shot(read(fuller)), read(fuller));

// A figure, alone and inside a page: every line of its words is found there, and what is found is not seen.
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
for (const file of [join(figures, `${TRIED}.svg`), render("light", "html")]) {
    await open(file);
    if (file.endsWith(".html")) {
        await page.evaluate(axe);
        // A page of one picture has its headline in the picture.
        const rules = { "page-has-heading-one": { enabled: false } };
        const { violations } = await page.evaluate((rules) => globalThis.axe.run({ rules }), rules);
        for (const { id, nodes } of violations) fail(basename(file), `axe: ${id}: ${nodes[0].html.slice(0, 200)}`);
    }
    const lost = await page.evaluate(wordsNotFound);
    for (const line of lost) fail(basename(file), `a search does not find "${line}"`);
    const withWords = await page.locator("svg").screenshot();
    await page.evaluate(() => document.querySelectorAll("svg text").forEach((text) => text.remove()));
    if (!withWords.equals(await page.locator("svg").screenshot())) fail(basename(file), "words for a search are seen");
}

await browser.close();
for (const failure of failures) console.error(`FAILED ${failure}`);
process.exitCode = failures.length > 0 ? 1 : 0;
