// Every live figure, and pages of other scenes, in Chromium, dragged; `.ci/browser` installs what this imports, and
// runs it.
//
// The pages are drawn into a folder and opened as files. Each shows the committed SVG byte for byte and draws the same;
// asks for nothing and breaks no policy; says while dragged, by a pointer and by keys, what `tracefig solve` says of the
// scene that it copies; shows the same where its address is opened again; is again what it was after a reset; and axe
// finds nothing. Edges are those of `edges.mjs`. Frame times are printed: on the clock, and the processor time of
// scripts, in which what else the machine does is not; of all frames, and of those that drew, as a pointer that
// moves by less than a step changes nothing.
// `TRACEFIG=path` is the binary; names of figures may follow.

import { execFileSync } from "node:child_process";
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { gzipSync } from "node:zlib";
import { basename, dirname, join } from "node:path";
import { pathToFileURL } from "node:url";
import { launched, require, root, wordsNotFound } from "./chromium.mjs";
import { edges } from "./edges.mjs";

const figures = join(root, "figures");
// Scenes that leave their panels to us, and say what no figure does.
const others = join(root, ".ci/pages");
const work = join(root, "target/browser");
const site = join(work, "site");
const axe = readFileSync(require.resolve("axe-core/axe.min.js"), "utf8");
const tracefig = process.env.TRACEFIG ?? join(root, "target/debug/tracefig");

const FRAMES = 40; // Frames of a drag.
const SAID = 600; // Milliseconds until a page has said the result: it waits for 400 of rest.

const failures = [];
const fail = (about, message) => failures.push(`${about}: ${message}`);
const run = (args, input) => execFileSync(tracefig, args, { input, stdio: ["pipe", "pipe", "inherit"] }).toString();

rmSync(site, { recursive: true, force: true });
mkdirSync(site, { recursive: true });
run(["render", figures, others, "--format", "html", "--live=shared", "-o", site]);
run(["render", others, "--format", "svg", "-o", work]);
const alone = join(work, "alone.html");
const asked = process.argv.slice(2);
const pages = readdirSync(site).filter((file) => file.endsWith(".html") && file !== "index.html");
const stems = pages.map((file) => basename(file, ".html")).filter((stem) => asked.length === 0 || asked.includes(stem));
const folderOf = (stem) => (existsSync(join(figures, `${stem}.toml`)) ? figures : others);
run(["render", join(folderOf(stems[0]), `${stems[0]}.toml`), "--live", "-o", alone]);

const browser = await launched();

// A page that tells of everything that it must not do.
async function opened(file, about, options = {}, hash = "") {
    const page = await browser.newPage({ viewport: { width: 1100, height: 900 }, ...options });
    const own = pathToFileURL(dirname(file)).href;
    page.on("request", (request) => request.url().startsWith(`${own}/`) || fail(about, `asks for ${request.url()}`));
    page.on("console", (message) => fail(about, message.text()));
    page.on("pageerror", (error) => fail(about, error.stack));
    const start = performance.now();
    await page.goto(pathToFileURL(file).href + hash);
    if (options.javaScriptEnabled === false) return { page };
    await page.waitForFunction(() => document.querySelector(".tracefig-live").dataset.live);
    const ready = performance.now() - start;
    await page.waitForFunction(() => {
        const { live, drawn } = document.querySelector(".tracefig-live").dataset;
        return drawn !== undefined || live.startsWith("no");
    });
    const drawn = performance.now() - start;
    const live = await page.evaluate(() => document.querySelector(".tracefig-live").dataset.live);
    if (live !== "yes") fail(about, `is not live: ${live}`);
    await page.evaluate(() => {
        const drawn = (globalThis.drawn = { ms: [] });
        document.addEventListener("tracefig", ({ detail }) => {
            drawn.ms.push(detail.ms.all);
            const { answer, sentence, handles } = detail;
            Object.assign(drawn, { answer, sentence, handles });
        });
    });
    return { page, ready, drawn };
}

// The picture as it is now, as text.
const shown = (page) => page.evaluate(() => {
    const now = document.querySelector("figure > svg").cloneNode(true);
    for (const body of now.querySelectorAll("[data-held]")) delete body.dataset.held;
    return now.outerHTML;
});

// Keeps the picture, or says whether it is as it was kept.
async function picture(page) {
    const now = await shown(page);
    page.kept ??= now;
    return now === page.kept;
}
const frame = (page) => page.evaluate(() => new Promise(requestAnimationFrame));

// Compares what the page says with what we say of the scene that it copies.
async function judge(page, about) {
    await page.waitForTimeout(SAID);
    await page.evaluate(() => { navigator.clipboard.writeText = () => Promise.reject(new Error("none")); });
    const said = await page.textContent(".say");
    await page.click(".acts button:last-child");
    const copied = await page.inputValue("textarea.text");
    const { answer, sentence } = await page.evaluate(() => globalThis.drawn);
    if (!said.includes(sentence)) fail(about, `says "${said}", expected "${sentence}"`);
    const [seen, ...words] = await page.evaluate(() => {
        const text = (part) => document.querySelector(part)?.textContent;
        const [title, desc] = ["title", "desc"].map((name) => text(`figure > svg > ${name}`));
        return [text(".seen"), text("details.words p"), desc, document.title, title];
    });
    if (!seen.includes(sentence)) fail(about, `shows "${seen}", expected "${sentence}"`);
    if (words[0] !== words[1]) fail(about, `describes "${words[0]}", expected "${words[1]}"`);
    if (words[2] !== words[3]) fail(about, `is called "${words[2]}", expected "${words[3]}"`);
    const { result } = JSON.parse(run(["solve", "-", "--json"], copied));
    if (JSON.stringify(answer) !== JSON.stringify(result)) {
        fail(about, `answers ${JSON.stringify(answer)}, expected ${JSON.stringify(result)} of\n${copied}`);
    }
}

// Milliseconds of processor time that the scripts of a page have taken so far.
async function scripted(page) {
    page.session ??= await page.context().newCDPSession(page);
    await page.session.send("Performance.enable", { timeDomain: "threadTicks" });
    const { metrics } = await page.session.send("Performance.getMetrics");
    return 1000 * metrics.find(({ name }) => name === "ScriptDuration").value;
}

// Drags a handle along a curve, a pixel or so a frame; the processor time of each, and whether it drew.
async function drag(page, knob) {
    const box = await (await knob.$(".ring")).boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await frame(page);
    const frames = [];
    const pictures = () => page.evaluate(() => globalThis.drawn.ms.length);
    let [before, count] = [await scripted(page), await pictures()];
    for (let i = 1; i <= FRAMES; i++) {
        await page.mouse.move(x + 30 * Math.sin(i / 20), y - 20 * Math.sin(i / 12));
        await frame(page);
        const [now, all] = [await scripted(page), await pictures()];
        frames.push({ ms: now - before, drew: all > count });
        [before, count] = [await scripted(page), all];
    }
    await page.mouse.up();
    return frames;
}

const quantile = (values, share) => {
    const sorted = [...values].sort((a, b) => a - b);
    return sorted.length > 0 ? sorted[Math.floor(share * (sorted.length - 1))] : Number.NaN;
};

// The times of those frames that drew.
const drawing = (frames) => frames.filter(({ drew }) => drew).map(({ ms }) => ms);

// Goes to the page's own address without numbers, back and forward.
async function wander(page, stem) {
    const [moved, plain] = [await shown(page), page.url().replace(/#.*/, "#")];
    await page.goto(plain);
    await page.waitForTimeout(SAID);
    if (!(await picture(page))) fail(stem, "an address without numbers shows another picture than at rest");
    await page.goBack();
    await page.waitForTimeout(SAID);
    if ((await shown(page)) !== moved) fail(stem, "one step back the picture is another one");
}

// Goes a step back and to the address that the page has then: another page shows the same there.
async function atStep(page, stem) {
    const before = page.locator(".steps button").first();
    if ((await before.count()) === 0) return;
    await before.click();
    await page.waitForTimeout(SAID);
    const { hash } = new URL(page.url());
    if (!/[#&]step=\d+$/.test(hash)) fail(stem, `a step back the address ends in "${hash}"`);
    const { page: again } = await opened(join(site, `${stem}.html`), stem, {}, hash);
    await again.waitForTimeout(SAID);
    if ((await shown(again)) !== (await shown(page))) fail(stem, `shows something else at the step of ${hash}`);
    const [here, there] = await Promise.all([page, again].map((one) => one.textContent(".seen")));
    if (here !== there) fail(stem, `says "${there}" at ${hash}, expected "${here}"`);
    await again.close();
    // A step that what is moved does not have is the whole.
    const field = page.locator(".numbers input").first();
    const was = await field.inputValue();
    await field.fill(String(Number(was) + 8));
    await field.press("Enter");
    await page.waitForTimeout(SAID);
    const [step, count] = (await page.textContent(".count")).match(/\d+/g).map(Number);
    const { hash: moved } = new URL(page.url());
    const expected = step < count ? `step=${step}` : undefined;
    if (/step=\d+/.exec(moved)?.[0] !== expected) fail(stem, `at step ${step} of ${count} the address is ${moved}`);
}

async function figure(stem) {
    const file = join(site, `${stem}.html`);
    const html = readFileSync(file, "utf8");
    const committed = readFileSync(join(folderOf(stem) === figures ? figures : work, `${stem}.svg`), "utf8").trimEnd();
    if (!html.includes(`<figure>${committed}</figure>`)) fail(stem, "does not hold the committed picture");
    const { page, ready, drawn } = await opened(file, stem);
    const described = () => page.innerHTML("details.words p");
    const description = await described();
    if ((await page.locator(".knobs").count()) === 0) {
        await page.close();
        return { ms: [], cpu: [] };
    }
    await picture(page);
    const knobs = await page.$$(".knob:not(.gone)");
    const cpu = [];
    for (const knob of knobs.slice(0, 2)) cpu.push(...(await drag(page, knob)));
    const { ms } = await page.evaluate(() => globalThis.drawn);
    if (knobs.length > 0) {
        await judge(page, `${stem}, dragged`);
        const value = () => page.evaluate(() => document.activeElement.getAttribute("aria-valuetext"));
        await page.focus(".knob[role=slider]");
        const from = await value();
        await page.keyboard.press("ArrowRight");
        await frame(page);
        await frame(page);
        if ((await value()) === from) fail(stem, `the arrow key leaves the value at ${from}`);
        await judge(page, `${stem}, by keys`);
    }
    await page.click(".numbers-of summary");
    const field = page.locator(".numbers input").first();
    if ((await field.count()) > 0) {
        await field.fill(String(Number(await field.inputValue()) + 0.25));
        await field.press("Enter");
        await judge(page, `${stem}, by numbers`);
        const { page: again } = await opened(file, stem, {}, new URL(page.url()).hash);
        await again.waitForTimeout(SAID);
        if ((await shown(again)) !== (await shown(page))) fail(stem, `shows something else at ${page.url()}`);
        await again.close();
        await wander(page, stem);
        await atStep(page, stem);
    }
    const time = page.locator(".numbers input").last();
    if ((await page.locator(".time").count()) > 0) {
        await time.fill("0.25");
        await time.press("Enter");
        await page.waitForTimeout(SAID);
        const at = Number(await time.inputValue()).toFixed(2);
        const readout = await page.textContent(".time output");
        if (readout.replace(",", ".") !== `t = ${at}`) fail(stem, `the playhead says "${readout}" at ${at}`);
        await time.fill("-1.2");
        await time.press("Enter");
        await frame(page);
        const told = [await time.inputValue(), await page.textContent(".why")];
        if (told.join() !== "0,") fail(stem, `a time before the first gives ${told}`);
        await page.waitForTimeout(SAID);
    }
    const reach = await page.evaluate(() => {
        const drawn = (globalThis.drawn.handles ?? []).filter(({ at }) => at);
        const values = new Set(drawn.map(({ paths }) => JSON.stringify(paths))).size;
        const knobs = [...document.querySelectorAll(".knob:not(.gone)")];
        const stops = (some) => some.filter(({ tabIndex }) => tabIndex >= 0).length;
        const unnamed = stops(knobs.filter((knob) => knob.ariaHidden));
        return { handles: drawn.length, knobs: knobs.length, values, stops: stops(knobs), unnamed };
    });
    if (reach.unnamed > 0) fail(stem, `${reach.unnamed} handles without a name are stops of the keyboard`);
    if (reach.knobs !== reach.handles) fail(stem, `has ${reach.knobs} knobs of ${reach.handles} handles`);
    if (reach.stops !== reach.values) fail(stem, `the keyboard reaches ${reach.stops} of ${reach.values} values`);
    const heard = await page.evaluate(() => [document.querySelector(".say").lang, document.documentElement.lang]);
    const told = ["de", "fr", "es"].includes(heard[1]) ? heard[1] : "en";
    if (heard[0] !== told) fail(stem, `a page in ${heard[1]} is heard in ${heard[0]}`);
    await page.evaluate(axe);
    const { violations } = await page.evaluate(() => globalThis.axe.run());
    for (const { id, help, nodes } of violations) fail(stem, `axe: ${id}, ${help}: ${nodes[0].html.slice(0, 200)}`);
    if (await page.isVisible(".reset")) await page.click(".reset");
    await page.waitForTimeout(200);
    const lost = await page.evaluate(wordsNotFound);
    for (const line of lost) fail(stem, `a search does not find "${line}"`);
    if (!(await picture(page))) fail(stem, "after a reset the picture is another one");
    await page.waitForTimeout(SAID);
    if ((await described()) !== description) fail(stem, "after a reset the description is another one");
    await page.close();
    const times = [ms, cpu.map(({ ms }) => ms), drawing(cpu)];
    const shares = times.flatMap((values) => [quantile(values, 0.5), quantile(values, 0.95)]);
    const numbers = [ready, drawn, ...shares].map((x) => x.toFixed(1).padStart(7));
    const sizes = [html.length, gzipSync(html).length].map((x) => String(x).padStart(8));
    console.log(`${stem.padEnd(26)}${sizes.join("")}${numbers.join(" ")}  ${String(knobs.length).padStart(2)} handles`);
    return { ms, cpu };
}

const head = "   bytes      gz  ready   drawn" + "  median     p95".repeat(3) + " ms: on the clock, of the processor, where it drew";
console.log(`${"figure".padEnd(26)}${head}`);
const all = { ms: [], cpu: [] };
for (const stem of stems) {
    const { ms, cpu } = await figure(stem);
    all.ms.push(...ms);
    all.cpu.push(...cpu);
}
for (const [about, values] of Object.entries({
    "on the clock": all.ms,
    "processor time": all.cpu.map(({ ms }) => ms),
    "processor time where it was drawn": drawing(all.cpu),
})) {
    const [median, most] = [0.5, 0.95].map((share) => quantile(values, share).toFixed(1));
    console.log(`all, ${about}: median ${median}, p95 ${most} ms of ${values.length} frames`);
}

// One page with all it needs, and what is left of it without scripts and without a module.
const bytes = readFileSync(alone);
const { page, ready, drawn } = await opened(alone, "alone");
console.log(`alone: ${bytes.length} bytes, ${gzipSync(bytes, { level: 9 }).length} with gzip, ready in ${ready.toFixed(0)} ms, drawn in ${drawn.toFixed(0)}`);
await page.close();
const { page: bare } = await opened(alone, "without scripts", { javaScriptEnabled: false });
const controls = await bare.locator("button, input, .knob").count();
if (controls > 0) fail("without scripts", `has ${controls} controls that do nothing`);
await bare.close();
const broken = join(work, "broken.html");
writeFileSync(broken, bytes.toString().replace(" 'wasm-unsafe-eval'", ""));
const torn = await browser.newPage();
await torn.goto(pathToFileURL(broken).href);
await torn.waitForFunction(() => document.querySelector(".tracefig-live").dataset.live?.startsWith("no"));
if ((await torn.locator("button, input, .knob").count()) > 0) fail("without the module", "has controls that do nothing");
await torn.close();

// The list, and a page, on a phone.
for (const [file, about] of [[join(site, "index.html"), "index"], [join(site, `${stems[0]}.html`), "phone"]]) {
    const phone = await browser.newPage({ viewport: { width: 360, height: 740 }, isMobile: true, hasTouch: true });
    await phone.goto(pathToFileURL(file).href);
    await phone.waitForTimeout(500);
    const wide = await phone.evaluate(() => document.documentElement.scrollWidth);
    if (wide > 360) fail(about, `is ${wide} pixels wide on a screen of 360`);
    await phone.close();
}

// Two on one page, a voice, a handle that goes far away, columns on a phone.
const two = asked.length > 1 ? stems.slice(0, 2) : ["circle-circle", "gjk-steps"];
const complete = two.map((stem) => join(work, `${stem}.html`));
const sceneOf = (stem) => join(folderOf(stem), `${stem}.toml`);
for (const [i, stem] of two.entries()) run(["render", sceneOf(stem), "--live", "-o", complete[i]]);
const inColumns = (stem) => readFileSync(sceneOf(stem), "utf8").includes("columns = ");
const columns = stems.filter(inColumns);
const numbers = join(work, "numbers.html"); // None of the pages, whose scenes other scripts read in JavaScript's order.
run(["render", join(root, ".ci/names-that-are-numbers.toml"), "--live", "-o", numbers]);
const pagesOfEdges = { stems: two, columns, alone: complete, numbers };
if (asked.length !== 1) await edges({ browser, site, work, fail, ...pagesOfEdges });

await browser.close();
for (const failure of failures) console.error(`FAILED ${failure}`);
process.exitCode = failures.length > 0 ? 1 : 0;
