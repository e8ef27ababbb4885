// Figures in steps in Chromium; `.ci/browser` installs what this imports, and runs it.
//
// Each page is drawn into a folder and opened as a file. It asks for nothing and breaks no policy; buttons, keys, the
// list and an address with #step-2 lead to each step, which shows what came until then and nothing that was taken away;
// all but buttons and keys does so without JavaScript; nothing moves by itself; axe finds nothing.
// `TRACEFIG=path` is the binary; names of figures may follow.

import { execFileSync } from "node:child_process";
import { mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { basename, join } from "node:path";
import { pathToFileURL } from "node:url";
import { launched, require, root } from "./chromium.mjs";

const work = join(root, "target/browser");
const pages = join(work, "steps");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const tracefig = process.env.TRACEFIG ?? join(root, "target/debug/tracefig");

// The last of its simplexes stays and the others go, as the scene names none.
const GOING = `[shapes.A]
kind = "polygon"
vertices = [[-3, 0], [3, -2], [1, 2]]
[shapes.B]
kind = "polygon"
vertices = [[2, 5], [6, 2], [5, 5]]
[query]
kind = "separation"
of = ["A", "B"]
algorithm = "gjk"
`;

const failures = [];
const fail = (about, message) => failures.push(`${about}: ${message}`);
const draw = (scenes) => execFileSync(tracefig, ["render", ...scenes, "--steps", "--format", "html", "-o", pages]);

rmSync(pages, { recursive: true, force: true });
mkdirSync(pages, { recursive: true });
const going = join(work, "going.toml");
writeFileSync(going, GOING);
draw([going, join(root, "figures")]);
const asked = process.argv.slice(2);
const files = readdirSync(pages).filter((file) => file.endsWith(".html"));
const stems = files.map((file) => basename(file, ".steps.html"));
const chosen = stems.filter((stem) => asked.length === 0 || asked.includes(stem));

const browser = await launched();

// A page that tells of everything that it must not do.
async function opened(stem, hash = "", options = {}) {
    const page = await browser.newPage({ viewport: { width: 1100, height: 900 }, ...options });
    const address = pathToFileURL(join(pages, `${stem}.steps.html`)).href;
    page.on("request", (request) => request.url().startsWith(address) || fail(stem, `asks for ${request.url()}`));
    page.on("console", (message) => fail(stem, message.text()));
    page.on("pageerror", (error) => fail(stem, error.stack));
    await page.goto(address + hash);
    return page;
}

// Holds what is seen to what a step has; says how many parts it shows, and how many it has taken away.
async function holds(page, about, step) {
    const parts = await page.$$eval("[data-step]", (all) => all.map(({ dataset, parentElement }, i) => {
        let seen = 1;
        for (let at = all[i]; at.tagName !== "FIGURE"; at = at.parentElement) seen *= getComputedStyle(at).opacity;
        const [since, until] = [Number(dataset.step), Number(dataset.until ?? Infinity)];
        return { since, until, seen, inner: parentElement.closest("[data-step]") !== null };
    }));
    for (const { since, until, seen, inner } of parts) {
        const is = since <= step && step < until;
        // A part of another is seen where both are.
        if ((is && !inner && seen !== 1) || (!is && seen !== 0)) {
            fail(about, `at step ${step}, what comes with ${since} and goes with ${until} has opacity ${seen}`);
        }
    }
    const shown = parts.filter(({ seen }) => seen > 0).length;
    return { shown, gone: parts.filter(({ until }) => until <= step).length };
}

async function sound(page, about) {
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    for (const { id, nodes } of violations) fail(about, `axe: ${id}: ${nodes[0].html}`);
    const moving = await page.evaluate(() => document.getAnimations().length);
    if (moving > 0) fail(about, `${moving} animations`);
}

async function figure(stem) {
    const page = await opened(stem);
    const count = await page.locator("input[name=step]").count();
    const [back, next] = [page.locator("nav button").first(), page.locator("nav button").last()];
    const step = () => page.evaluate(() => Number(document.querySelector("input[name=step]:checked").value));
    const at = async (about, expected) => {
        if ((await step()) !== expected) fail(`${stem}, ${about}`, `is at step ${await step()}, expected ${expected}`);
        const said = await page.textContent("nav output");
        if (!said.startsWith(`${expected} / ${count}: `)) fail(`${stem}, ${about}`, `says "${said}"`);
        if ((await back.isDisabled()) !== (expected === 1)) fail(`${stem}, ${about}`, "the button back is wrong");
        const sign = await next.textContent();
        if (sign !== (expected === count ? "↺" : "▶")) fail(`${stem}, ${about}`, `the button onward is ${sign}`);
        const hash = await page.evaluate(() => location.hash);
        if (about !== "opened" && hash !== `#step-${expected}`) fail(`${stem}, ${about}`, `the address ends in ${hash}`);
        return holds(page, `${stem}, ${about}`, expected);
    };
    const whole = await at("opened", count);
    await sound(page, stem);
    // The buttons stay where they are, whatever is said.
    const stands = async () => Math.round((await back.boundingBox()).y);
    await page.keyboard.press("Home");
    if ((await page.evaluate(() => document.documentElement.scrollHeight > innerHeight + 1))) {
        await at("opened", count);
        await next.click();
    }
    const first = await at("Home, or from the end onward", 1);
    const stood = await stands();
    for (let k = 2; k <= count; k++) {
        if (k % 2 === 0) await next.click();
        else await page.keyboard.press("ArrowRight");
        await at("onward", k);
        if ((await stands()) !== stood) fail(stem, `at step ${k} the buttons moved`);
    }
    await back.click();
    await at("back", Math.max(1, count - 1));
    // On a page that scrolls these keys are the browser's.
    await page.setViewportSize({ width: 1100, height: 12000 });
    await page.keyboard.press("End");
    await at("End", count);
    await page.keyboard.press("Home");
    await at("Home", 1);
    await page.keyboard.press("End");
    // In the list, where the browser has keys of its own, an arrow goes one step too.
    await page.locator("input[name=step]").last().focus();
    await page.keyboard.press("ArrowLeft");
    await at("in the list", Math.max(1, count - 1));
    const held = await page.evaluate(() => document.activeElement.checked);
    if (!held) fail(stem, "an arrow in the list leaves the focus behind");
    await page.close();
    const phone = await opened(stem, "#step-1", { viewport: { width: 390, height: 800 } });
    const isSeen = (all) => all.filter((one) => one.getBoundingClientRect().width > 0).length;
    const seen = await phone.$$eval("figure > svg", isSeen);
    const wide = await phone.evaluate(() => [document.documentElement.scrollWidth, scrollY]);
    if (seen !== 1 || wide[0] > 390 || wide[1] > 0) fail(stem, `on a phone: ${seen} pictures, ${wide}`);
    await holds(phone, `${stem} on a phone`, 1);
    await phone.close();
    const linked = await opened(stem, "#step-1");
    await holds(linked, `${stem}, #step-1`, 1);
    await linked.locator("input[name=step]").last().check();
    await holds(linked, `${stem}, #step-1 and End`, count);
    await linked.close();
    const bare = await opened(stem, "", { javaScriptEnabled: false });
    if (await bare.locator("nav").isVisible()) fail(stem, "shows buttons that do nothing without JavaScript");
    await bare.locator("input[name=step]").first().check();
    await bare.close();
    return { stem, count, first: first.shown, whole: whole.shown, gone: whole.gone };
}

// Without JavaScript the page is looked at by its pixels: evaluate is a script too.
async function without(stem) {
    const shot = async (hash, pick) => {
        const page = await opened(stem, hash, { javaScriptEnabled: false });
        if (pick) await page.locator("input[name=step]").nth(pick - 1).check();
        const image = await page.locator("figure").screenshot();
        await page.close();
        return image.toString("base64");
    };
    const [opens, one, link] = [await shot(""), await shot("", 1), await shot("#step-1")];
    if (one !== link) fail(stem, "without JavaScript, the list and #step-1 show two pictures");
    if (one === opens) fail(stem, "without JavaScript, the list changes nothing");
    if ((await shot("#step-1", 2)) !== (await shot("", 2))) fail(stem, "without JavaScript, #step-1 holds the list");
}

let gone = 0;
for (const stem of chosen) {
    const of = await figure(stem);
    gone += of.gone;
    console.log(`${stem}: ${of.count} steps, of ${of.whole} parts ${of.first} from the start, ${of.gone} taken away`);
}
for (const stem of chosen.filter((name) => name.startsWith("g"))) await without(stem);
if (asked.length === 0 && gone === 0) fail("all", "no step takes anything away");
await browser.close();
for (const failure of failures) console.error(failure);
console.log(`${chosen.length} figures in steps, ${failures.length} faults`);
process.exit(failures.length > 0 ? 1 : 0);
