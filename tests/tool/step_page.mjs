// step_page.mjs PAGE CLIPPED WORKSHEET BUG GOURAUD GOLD: drives stepper pages in headless Chromium. playwright-core and axe-core are found
// from the current folder. Prints what fails and ends with 1, or says how many checks passed.
import { createRequire } from "node:module";
import { pathToFileURL } from "node:url";
import path from "node:path";

const require = createRequire(path.join(process.cwd(), "x.js"));
const { chromium } = require("playwright-core");
const axe_source = require("axe-core").source;
const [teapot, clipped, worksheet, bug, gouraud, gold] = process.argv.slice(2).map(name => pathToFileURL(path.resolve(name)).href);

let checks = 0, failures = 0;
function check(ok, what) {
    ++checks;
    if (ok) return;
    ++failures;
    console.log("FAILED " + what);
}

const browser = await chromium.launch({ executablePath: process.env.CHROMIUM || "/usr/bin/chromium", args: ["--no-sandbox"] });
const trouble = [];
let opened = null;
async function open(url, options = {}) {  // one at a time
    if (opened) await opened.close();
    const page = opened = await browser.newPage({ viewport: { width: 1400, height: 900 }, ...options });
    page.setDefaultTimeout(180000);  // a machine may be busy
    page.on("console", message => ["error", "warning"].includes(message.type()) && trouble.push(message.text()));
    page.on("pageerror", error => trouble.push(error.message));
    page.on("request", request => {
        if (!/^(file|data|blob):/.test(request.url())) trouble.push("a request for " + request.url());
    });
    await page.goto(url);
    await page.waitForSelector("#numbers h3, .unreached-box, .sheet", { state: "attached" });
    return page;
}
const place = page => page.evaluate(() => location.hash);
const numbers = page => page.locator("#numbers").innerText();
const data_of = page => page.evaluate(() => JSON.parse(document.getElementById("data").textContent));

// Every level, there and back again.
let page = await open(teapot);
check((await page.title()).includes("step by step"), "the title");
for (const level of ["draw", "triangle", "stage", "pixel"]) {
    await page.click(`#scrubber .level:nth-child(${["draw", "triangle", "stage", "pixel"].indexOf(level) + 1}) .name`);
    const start = await place(page), seen = [start];
    for (let i = 0; i < 4; ++i) {
        await page.keyboard.press("ArrowRight");
        seen.push(await place(page));
    }
    if (level !== "draw") check(new Set(seen).size === 5, `${level}: four steps are four places`);
    for (let i = 0; i < 4; ++i) {
        await page.keyboard.press("ArrowLeft");
        if (level !== "draw" && level !== "triangle") check(await place(page) === seen[3 - i], `${level}: step ${i} back`);
    }
}
// All stages of the first triangle tell something, and none shows a number that is none.
await page.click("#scrubber .level:nth-child(3) .name");
const names = [];
for (let i = 0; i < 14; ++i) {
    names.push((await page.locator("#h-numbers").innerText()).replace(/\s+/g, " ").trim());
    const text = await numbers(page);
    check(text.length > 80, names.at(-1) + " tells something");
    check(!/NaN|undefined|\[object/.test(text), names.at(-1) + " has no number that is none");
    await page.keyboard.press("ArrowRight");
}
for (const [i, name] of ["vertex", "assemble", "clip", "project", "cull", "setup", "coverage", "depth", "interpolate", "fragment", "blend"].entries())
    check(names.includes(`${i + 1} ${name}`), `stage ${name} is reached by stepping`);
// Shift goes a level up and down.
await page.keyboard.press("Shift+ArrowDown");
check(await page.locator(".level.current .name").innerText() === "pixel", "shift and down: a finer level");
await page.keyboard.press("Shift+ArrowUp");
await page.keyboard.press("Shift+ArrowUp");
check(await page.locator(".level.current .name").innerText() === "triangle", "shift and up: a coarser level");
await page.keyboard.press("?");
check(await page.locator("#help-dialog").isVisible(), "? opens the help");
await page.click("#close-help");

// A permalink leads to the same step, and shows the recorded values.
const data = await data_of(page);
const fragment = data.fragments.filter(f => f.detailed && f.passed && data.triangles.some(t => t.number === f.triangle)).at(-1);
const link = `#draw=0&triangle=${fragment.triangle}&stage=depth&pixel=${fragment.x},${fragment.y}`;
page = await open(teapot + link);
check(await place(page) === link, "a permalink is restored");
await page.keyboard.press("d");
check((await numbers(page)).replace(/[\u202f\u2009 ]/g, "").includes(String(fragment.incoming)), "the depth that was recorded is shown");
check((await page.locator("#grid-text").innerText()).includes(`Pixel ${fragment.x},${fragment.y}`), "the grid says where it is");
await page.evaluate(hash => { location.hash = hash; }, link.replace("depth", "coverage"));
await page.waitForFunction(() => document.getElementById("h-numbers").innerText.includes("coverage"));
check(true, "a link inside the page is followed");
// A pixel that is not in the page is said, with the command that gets it.
await page.evaluate(() => { location.hash = "#triangle=99999999"; });
await page.waitForFunction(() => /not in this page/.test(document.getElementById("where").textContent));

// Predict: right and wrong.
const answer_of = f => (f.passed ? "passes" : "fails");
page = await open(teapot + link);
await page.keyboard.press("p");
check(await page.locator("#numbers .secret").count() > 0, "predict hides values");
check(!(await numbers(page)).includes("passes; stored"), "the answer is hidden");
await page.click(`#question button[value=${answer_of(fragment)}]`);
check(await page.locator(".verdict.right").count() === 1, "a right answer is right");
check(await page.locator("#numbers .secret").count() === 0, "then the values are shown");
await page.keyboard.press("p");
await page.keyboard.press("p");
await page.click(`#question button[value=${fragment.passed ? "fails" : "passes"}]`);
check(await page.locator(".verdict.wrong").count() === 1, "a wrong answer is wrong");
check((await page.locator(".verdict").innerText()).includes(fragment.passed ? "passes" : "fails"), "and the page says what is right");
await page.keyboard.press("Shift+ArrowLeft");

// What clipping did.
page = await open(clipped);
const cut = (await data_of(page)).triangles.find(t => t.clip === "clipped" && t.pieces.length);
check(cut !== undefined, "the clipped model has a clipped triangle");
await page.evaluate(hash => { location.hash = hash; }, `#triangle=${cut.number}&stage=clip&plane=${cut.planes[0].plane}`);
await page.waitForFunction(() => document.getElementById("h-numbers").innerText.includes("clip"));
check((await numbers(page)).includes(`Plane ${cut.planes[0].plane}`), "the plane that cuts is named");
check(cut.planes.every(p => p.after.every(c => c.t === undefined || (c.t >= 0 && c.t <= 1))), "t lies on the edge");
const vertex = `#triangle=${cut.number}&stage=vertex`;
await page.evaluate(hash => { location.hash = hash; }, vertex);
await page.waitForFunction(() => document.getElementById("h-numbers").innerText.includes("vertex"));
check((await numbers(page)).includes("not reached"), "what was not computed says so");

// The worksheet.
page = await open(worksheet);
check(await page.locator(".sheet:not(.key) li").count() === 6, "six questions");
check(await page.locator(".sheet.key li").count() === 6, "six answers");
check(await page.locator("#worksheet").getByText("undefined").count() === 0, "the worksheet has no holes");
await page.click(".key a >> nth=0");
await page.waitForSelector("#stepper:not([hidden])");
check(await page.locator("#numbers").isVisible(), "an answer leads to its step");

// A bug: it is named, opens where the runs part, with both numbers, and can be sought in predict mode.
page = await open(bug);
const wrong = await data_of(page);
check((await place(page)).includes(`triangle=${wrong.bug.first.triangle}&stage=${wrong.bug.first.stage}`), "the page opens at the first wrong step");
check((await numbers(page)).includes("Bug affine") && (await numbers(page)).includes("oow"), "the bug is named, with the number that is wrong");
check(await page.locator(".bug-box img").count() === 3, "right, wrong and difference");
check(wrong.pictures.differing > 0, "pixels differ");
await page.keyboard.press("ArrowRight");
await page.click(".bug-box a");
check((await place(page)).includes("stage=" + wrong.bug.first.stage), "the link leads back to the first wrong step");
await page.keyboard.press("p");
check(!(await numbers(page)).includes("affine"), "predict hides the bug");
await page.click("#question button[value=cull]");
check(await page.locator(".verdict.wrong").count() === 1 && (await page.locator(".verdict").innerText()).includes("affine"), "and tells it after the answer");
for (const layer of ["wrong", "right", "orders", "painter", "weights", "depth"]) await page.selectOption("#layer", layer);

// Gouraud shading: the corners' light.
page = await open(gouraud + "#stage=fragment");
check(/Gouraud: lit at the corners/.test(await numbers(page)) && /Corner v2: its light/.test(await numbers(page)), "the corners' light is told");
check(await page.locator("#numbers .bad", { hasText: "differ from the shader" }).count() === 0, "with the shader's bits");

// Light for an sRGB screen: the byte that the page tells is the picture's.
page = await open(gold + "#stage=blend");
const shiny = await data_of(page), here = (await place(page)).match(/pixel=(\d+),(\d+)/).slice(1).map(Number);
const seen = shiny.fragments.filter(f => f.passed && f.x === here[0] && f.y === here[1]).at(-1);
await page.waitForFunction(() => document.getElementById("grid-text").innerText.includes("#"));
const shown = "#" + seen.shown.map(b => b.toString(16).padStart(2, "0")).join("");
check((await page.locator("#grid-text").innerText()).includes(shown), "the picture has the byte that blend tells");
check((await numbers(page)).includes(shown), "and so has the numbers pane");

// Accessibility, light and dark, wide and narrow.
const at_stage = stage => teapot + link.replace("depth", stage);
const looks = [...["vertex", "clip", "coverage", "depth", "fragment"].flatMap(stage => [[at_stage(stage), "light", 1400], [at_stage(stage), "dark", 1400]]),
    [at_stage("vertex"), "light", 420], [at_stage("depth"), "dark", 420], [bug, "light", 1400], [bug, "dark", 420],
    [gouraud + "#stage=fragment", "dark", 1400], [gold + "#stage=blend", "light", 1400]];
for (const [url, colorScheme, width] of looks) {
    page = await open(url, { colorScheme, viewport: { width, height: 900 }, bypassCSP: true });
    await page.evaluate(axe_source);
    const found = await page.evaluate(() => axe.run());
    const name = `axe ${url.split("/").at(-1)} ${colorScheme} ${width}`;
    for (const v of found.violations) check(false, `${name}: ${v.id}: ${v.nodes.slice(0, 2).map(n => n.html.slice(0, 120)).join(" | ")}`);
    check(found.violations.length === 0, name);
}

check(trouble.length === 0, "no request and no message in the console: " + trouble.slice(0, 3).join("; "));
await browser.close();
console.log(failures ? `${failures} of ${checks} checks failed` : `${checks} checks passed`);
process.exit(failures ? 1 : 0);
