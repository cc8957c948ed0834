// Live figures in a real browser: moved by mouse, finger and keys, played, turned and saved, from the server as well as
// from disk; the wasm build answers with the same bytes as the native one; a drag keeps up with the screen.
//
//     node live.mjs CHROMIUM WORKBOOK SITE

import { spawn } from "node:child_process";
import { readFileSync, readdirSync } from "node:fs";
import { mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { dirname, join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { fileURLToPath, pathToFileURL } from "node:url";
import { gzipSync } from "node:zlib";
import { chromium } from "playwright-core";

const [browserPath, workbook, site] = process.argv.slice(2);
const PAGE = "bezier/de-casteljau.html";
const FIGURE = "bezier-figure-de-casteljau";

const failures = [];
const check = (holds, message) => {
    console.log(`${holds ? "ok    " : "FAILED"}  ${message}`);
    if (!holds) {
        failures.push(message);
    }
};

/** The server on a free port; resolves to its address. */
async function serve() {
    const server = spawn(workbook, ["--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
    for await (const line of createInterface({ input: server.stdout })) {
        const address = line.match(/http:\/\/127\.0\.0\.1:\d+\S*/);
        if (address) {
            return { server, address: address[0] };
        }
    }
    throw new Error("the server ended without telling its address");
}

/** The figure of the page, alive and in view. */
async function alive(page, id = FIGURE) {
    const figure = page.locator(`figure[data-figure="${id}"]`);
    await figure.scrollIntoViewIfNeeded();
    await page.locator(`figure.live[data-figure="${id}"] .live-handle`).first().waitFor();
    return figure;
}

const words = handle => handle.getAttribute("aria-label");

/** Waits until a handle says something else than `before`. */
async function moved(handle, before) {
    for (let i = 0; i < 100; i++) {
        const now = await words(handle);
        if (now !== before) {
            return now;
        }
        await new Promise(resolve => setTimeout(resolve, 20));
    }
    return before;
}

/** What the browser complains of in a page, and requests to elsewhere than `url`; it grows while the page is used. */
function complaints(page, url) {
    const wrong = [];
    page.on("console", message => ["error", "warning"].includes(message.type()) && wrong.push(message.text()));
    page.on("pageerror", error => wrong.push(error.message));
    page.on("request", request => {
        const target = request.url();
        if (!target.startsWith(new URL(url).origin === "null" ? "file:" : new URL(url).origin)
            && !target.startsWith("data:") && !target.startsWith("blob:")) {
            wrong.push(`asks for ${target}`);
        }
    });
    return wrong;
}

/** Drags from the middle of an element by the mouse. */
async function drag(page, element, [dx, dy]) {
    await element.scrollIntoViewIfNeeded();
    const box = await element.boundingBox();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + dx, y + dy, { steps: 5 });
    await page.mouse.up();
    // The last position is drawn after those on the way.
    await page.waitForTimeout(200);
}

async function everyWay(context, url, label) {
    const page = await context.newPage();
    const wrong = complaints(page, url);
    await page.goto(url);
    const figure = await alive(page);
    const handle = figure.locator(".live-handle").nth(4);
    const before = await words(handle);
    const still = await figure.locator("svg").innerHTML();

    const box = await handle.boundingBox();
    check(box.width >= 44 && box.height >= 44, `${label}: a handle is large enough for a thumb`);
    await drag(page, handle, [30, 20]);
    const byMouse = await moved(handle, before);
    check(byMouse !== before, `${label}: the mouse moves a handle (${before} → ${byMouse})`);
    check(await figure.locator("svg").innerHTML() !== still, `${label}: the picture is another one`);

    await handle.focus();
    await page.keyboard.press("ArrowLeft");
    const byKey = await moved(handle, byMouse);
    check(byKey !== byMouse, `${label}: an arrow key moves it`);
    check(page.url() === url || page.url().split("#")[0] === url, `${label}: the arrow key turns no page`);

    const slider = figure.locator("input[type=range]").first();
    await slider.focus();
    const value = figure.locator(".live-value").first();
    const at = await value.textContent();
    await page.keyboard.press("ArrowRight");
    await page.waitForFunction(([element, old]) => element.textContent !== old, [await value.elementHandle(), at]);
    check(true, `${label}: an arrow key moves the slider`);

    await figure.getByRole("button", { name: "Link" }).click();
    await page.waitForTimeout(100);
    const link = page.url();
    const dragged = await figure.locator("svg").innerHTML();
    await figure.getByRole("button", { name: "Reset" }).click();
    await moved(handle, byKey);
    check(await words(handle) === before, `${label}: reset shows it as the book does`);
    const again = await context.newPage();
    await again.goto(link);
    const restored = await alive(again);
    await again.waitForTimeout(300);
    check(await restored.locator("svg").innerHTML() === dragged, `${label}: a link restores exactly this state`);
    await again.close();
    check(wrong.length === 0, `${label}: no complaint of the browser, no outside request ${wrong.join("; ")}`);
    await page.close();
}

/** The laws stand beside the figure with the numbers of the dragged points, and a degenerate position is explained. */
async function laws(context, url, label) {
    const page = await context.newPage();
    await page.goto(new URL("shape.html", url).href);
    const figure = await alive(page, "bezier-figure-convex-hull");
    const readout = figure.locator(".live-laws");
    check((await readout.locator(".live-law a").getAttribute("href")).includes("bezier-convex-hull"),
        `${label}: a law is named by a link to its statement`);
    const before = await readout.locator(".live-right").first().textContent();
    const handle = figure.locator(".live-handle").nth(4);
    const name = await words(handle);
    await drag(page, handle, [-20, -20]);
    await moved(handle, name);
    await page.waitForTimeout(200);
    const after = await readout.locator(".live-right").first().textContent();
    const corner = (await words(handle)).match(/\((-?[\d.]+), (-?[\d.]+)\)/);
    check(before !== after && after.startsWith(corner[1].slice(0, 3)), `${label}: the law reads the dragged point (${before} → ${after})`);
    const agreement = readout.locator(".live-agreement").first();
    check(/✓ holds/.test(await agreement.textContent()), `${label}: it holds (${await agreement.textContent()})`);
    check(await figure.locator(".live-remark").isHidden(), `${label}: a general position needs no remark`);
    await page.goto(new URL("de-casteljau.html", url).href);
    const range = await alive(page, "bezier-parameter-range");
    const slider = range.locator("input[type=range]");
    await slider.focus();
    await page.keyboard.press("Home");
    await range.locator(".live-remark", { hasText: "negative" }).waitFor();
    check(true, `${label}: a parameter outside the interval says what the interval is for`);
    await page.close();
}

/** The play button moves the slider until it is pressed again. */
async function plays(context, url, label) {
    const page = await context.newPage();
    await page.goto(url);
    const figure = await alive(page);
    const value = figure.locator(".live-value").first();
    const button = figure.locator(".live-play").first();
    const slider = figure.locator("input[type=range]").first();
    const [first, at] = [await value.textContent(), await slider.inputValue()];
    const seen = new Set([first]);
    const drawn = new Set([await figure.locator("svg").innerHTML()]);
    await button.click();
    for (let i = 0; i < 100 && (seen.size < 4 || drawn.size < 4); i++) {
        await page.waitForTimeout(50);
        seen.add(await value.textContent());
        drawn.add(await figure.locator("svg").innerHTML());
    }
    check(seen.size >= 4 && drawn.size >= 4, `${label}: play moves the slider and the picture (${[...seen].join(", ")})`);
    await button.click();
    await page.waitForTimeout(300);
    const paused = await value.textContent();
    await page.waitForTimeout(300);
    check(await value.textContent() === paused, `${label}: pressed again, it stands still (${paused})`);
    await button.click();
    await figure.getByRole("button", { name: "Reset" }).click();
    await page.waitForTimeout(300);
    check(await value.textContent() === first, `${label}: reset while it plays, it shows the first value (${first})`);
    check(await slider.inputValue() === at, `${label}: the slider stands there, too`);
    check(await button.getAttribute("title") === "Play", `${label}: the button plays again`);
    await page.close();
}

/** Keys that come faster than answers are all heeded. */
async function heeds(context, url, label) {
    const page = await context.newPage();
    await page.route("**/__workbook/figure", async route => {
        await new Promise(resolve => setTimeout(resolve, 200));
        await route.continue();
    });
    await page.goto(url);
    const figure = await alive(page);
    const slider = figure.locator("input[type=range]").first();
    const value = figure.locator(".live-value").first();
    const read = async () => [Number((await value.textContent()).match(/[-\d.]+$/)[0]), Number(await slider.inputValue())];
    const step = Number(await slider.getAttribute("step"));
    const [begin] = await read();
    const wanted = begin + 6 * step;
    await slider.focus();
    for (let i = 0; i < 6; i++) {
        await page.keyboard.press("ArrowRight");
    }
    const near = x => Math.abs(x - wanted) < step / 2;
    let [shown, stands] = [begin, begin];
    for (let i = 0; i < 100 && !(near(shown) && near(stands)); i++) {
        await page.waitForTimeout(100);
        [shown, stands] = await read();
    }
    check(near(shown) && near(stands),
        `${label}: the figure shows what the slider says after fast keys (${shown}, ${stands}, wanted ${wanted.toFixed(4)})`);
    await page.close();
}

/** The picture that is saved is the one that is shown, and a browser opens it by itself. */
async function saves(context, url, label) {
    const page = await context.newPage();
    await page.goto(url);
    const figure = await alive(page);
    const handle = figure.locator(".live-handle").nth(4);
    const before = await words(handle);
    await drag(page, handle, [25, 15]);
    await moved(handle, before);
    const [download] = await Promise.all([
        page.waitForEvent("download"),
        figure.getByRole("button", { name: "SVG" }).click(),
    ]);
    const file = join(await mkdtemp(join(tmpdir(), "figure-")), download.suggestedFilename());
    await download.saveAs(file);
    // The style sheet of the shown picture stands beside it.
    const elements = svg => [...svg.children].filter(e => e.localName !== "style")
        .map(e => [e.localName, ...[...e.attributes].map(a => `${a.name}=${a.value}`).sort(), e.textContent].join("|"));
    const shown = await figure.locator("svg").evaluate(elements);
    const alone = await context.newPage();
    await alone.goto(pathToFileURL(file).href);
    const root = alone.locator("svg");
    const saved = await root.evaluate(elements);
    check(file.endsWith(`${FIGURE}.svg`) && saved.length > 20 && saved.join("\n") === shown.join("\n"),
        `${label}: the saved picture is the shown one (${saved.length} elements)`);
    const color = await alone.locator("path.curve").first().evaluate(e => getComputedStyle(e).stroke);
    check(await root.isVisible() && color !== "none", `${label}: it opens by itself, with its colours (${color})`);
    await alone.close();
    await page.close();
    await rm(dirname(file), { recursive: true });
}

/** A surface is turned by its handle, and refined by its slider. */
async function surface(context, url, label) {
    const page = await context.newPage();
    await page.goto(url);
    const figure = await alive(page, "subdivision-loop-limit");
    const faces = () => figure.locator("svg path").evaluateAll(all => all.map(e => e.getAttribute("d")).join(""));
    const handle = figure.locator(".live-handle");
    const [before, first] = [await faces(), await words(handle)];
    await drag(page, handle, [60, 0]);
    const second = await moved(handle, first);
    const turned = await faces();
    check(turned !== before && second !== first, `${label}: dragged sideways, a surface turns (${first} → ${second})`);
    await drag(page, handle, [0, -40]);
    const third = await moved(handle, second);
    const tilted = await faces();
    check(tilted !== turned && third !== second, `${label}: dragged upwards, it is tilted (→ ${third})`);
    const value = figure.locator(".live-value");
    await figure.locator("input[type=range]").focus();
    await page.keyboard.press("Home");
    await figure.locator(".live-value", { hasText: "= 0" }).waitFor();
    await page.waitForTimeout(100);
    const coarse = await faces();
    await page.keyboard.press("ArrowRight");
    await figure.locator(".live-value", { hasText: "= 1" }).waitFor();
    await page.waitForTimeout(100);
    const fine = await faces();
    check(fine.length > 1.5 * coarse.length,
        `${label}: a step more has more faces (${coarse.length} and ${fine.length} letters, ${await value.textContent()})`);
    await page.close();
}

/** Every figure of every page comes alive without a complaint. */
async function everyPage(context, base, label) {
    const page = await context.newPage();
    const wrong = complaints(page, base);
    let [pages, figures] = [0, 0];
    const failing = [];
    const folders = readdirSync(site, { withFileTypes: true }).filter(entry => entry.isDirectory());
    for (const { name: folder } of folders) {
        for (const name of readdirSync(join(site, folder)).filter(name => name.endsWith(".html"))) {
            await page.goto(new URL(`${folder}/${name}`, base).href);
            const live = await page.locator("figure.drawing[data-part]").evaluateAll(
                all => [...new Set(all.map(figure => figure.dataset.figure))]);
            for (const id of live) {
                await page.locator(`figure[data-figure="${id}"]`).first().scrollIntoViewIfNeeded();
                const drawn = page.locator(`figure.live[data-figure="${id}"]`).locator(".live-handle, .live-control");
                await drawn.first().waitFor({ state: "attached" });
            }
            failing.push(...await page.locator(".live-claim.fails, .live-wrong").evaluateAll(
                all => all.map(element => `${element.closest("figure").dataset.figure}: ${element.textContent}`)));
            [pages, figures] = [pages + 1, figures + live.length];
        }
    }
    check(failing.length === 0, `${label}: all live figures draw, and their laws hold ${failing.join("; ")}`);
    check(wrong.length === 0 && pages > 25 && figures > 60,
        `${label}: ${figures} live figures on ${pages} pages, no complaint, no outside request ${wrong.join("; ")}`);
    await page.close();
}

/** In the dark theme the live picture is dark; on paper there are no controls and the picture is as it was left. */
async function darkAndPrinted() {
    const context = await browser.newContext({ viewport: { width: 1300, height: 900 }, colorScheme: "dark" });
    const page = await context.newPage();
    await page.goto(fromDisk);
    const figure = await alive(page);
    const light = color => color.match(/[\d.]+/g).slice(0, 3).reduce((sum, part) => sum + Number(part), 0) / 3;
    const paper = await page.evaluate(() => getComputedStyle(document.documentElement).backgroundColor);
    const text = await figure.locator(".live-sides").first().evaluate(element => getComputedStyle(element).color);
    check(light(text) > 120 && light(paper) < 80, `dark: the numbers of the laws are light (${text}) on dark paper (${paper})`);
    const handle = figure.locator(".live-handle").nth(4);
    const before = await words(handle);
    await handle.focus();
    await page.keyboard.press("Shift+ArrowUp");
    await moved(handle, before);
    const left = await figure.locator("svg").innerHTML();
    await page.emulateMedia({ media: "print" });
    const shown = await figure.locator("button, input, .live-laws, .live-say").evaluateAll(
        all => all.filter(element => element.getClientRects().length > 0).length);
    check(shown === 0, `print: no controls (${shown})`);
    const printed = figure.locator("svg");
    check(await printed.isVisible() && await printed.innerHTML() === left, "print: the picture as the reader left it");
    const size = await figure.locator(".live-picture").boundingBox();
    const drawn = await printed.boundingBox();
    check(Math.abs(size.height - drawn.height) < 2, `print: no gap below the picture (${size.height} and ${drawn.height})`);
    await context.close();
}

const browser = await chromium.launch({ executablePath: browserPath, args: ["--no-sandbox", "--disable-gpu"] });
const { server, address } = await serve();
const served = new URL(PAGE, address).href;
const fromDisk = pathToFileURL(resolve(site, PAGE)).href;
try {
    const context = await browser.newContext({ viewport: { width: 1300, height: 900 } });
    await everyWay(context, served, "server");
    await everyWay(context, fromDisk, "disk");

    for (const [url, label] of [[served, "server"], [fromDisk, "disk"]]) {
        await laws(context, url, label);
        await plays(context, url, label);
        await heeds(context, url, label);
        await surface(context, new URL("../subdivision/loop.html", url).href, label);
        await everyPage(context, new URL("../", url).href, label);
    }
    await saves(context, fromDisk, "disk");
    await darkAndPrinted();

    // ---- By finger, on a narrow screen ----
    const phone = await browser.newContext({ viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true });
    const page = await phone.newPage();
    await page.goto(fromDisk);
    const figure = await alive(page);
    const handle = figure.locator(".live-handle").nth(4);
    await handle.scrollIntoViewIfNeeded();
    const before = await words(handle);
    const box = await handle.boundingBox();
    const session = await phone.newCDPSession(page);
    const touch = (type, x, y) => session.send("Input.dispatchTouchEvent", { type, touchPoints: type === "touchEnd" ? [] : [{ x, y }] });
    await touch("touchStart", box.x + 22, box.y + 22);
    for (let i = 1; i <= 5; i++) {
        await touch("touchMove", box.x + 22 + 4 * i, box.y + 22 + 3 * i);
    }
    await touch("touchEnd");
    check(await moved(handle, before) !== before, "phone: a finger moves a handle");
    // One finger drags a point onto the other, where the line through both is none.
    await page.goto(pathToFileURL(resolve(site, "affine/barycentric.html")).href);
    const line = await alive(page, "affine-barycentric-on-line");
    const remark = line.locator(".live-remark");
    check(await remark.isHidden(), "phone: two points make a line");
    await line.locator(".live-handle").first().scrollIntoViewIfNeeded();
    const [to, from] = await line.locator(".live-handle").evaluateAll(all => all.slice(0, 2).map(handle => {
        const box = handle.getBoundingClientRect();
        return [box.x + box.width / 2, box.y + box.height / 2];
    }));
    await touch("touchStart", ...from);
    for (let i = 1; i <= 8; i++) {
        await touch("touchMove", ...[0, 1].map(k => from[k] + (to[k] - from[k]) * i / 8));
    }
    await touch("touchEnd");
    await remark.waitFor();
    check(/A ≠ B/.test(await remark.textContent()), `phone: a degenerate position is explained (${await remark.textContent()})`);
    const wide = await page.evaluate(() => document.documentElement.scrollWidth);
    check(wide <= 360, `phone: nothing sticks out (${wide})`);
    await phone.close();

    // ---- The same bytes, and in time ----
    const still = await context.newPage();
    await still.goto(fromDisk);
    await alive(still);
    const ids = readdirSync(resolve(site, "..", "..", "snapshots"), { recursive: true })
        .filter(name => name.endsWith(".snap.svg"))
        .map(name => name.replace(/^.*[\\/]/, "").replace(".snap.svg", ""));
    const parts = readdirSync(site).filter(name => /^figures-.*\.js$/.test(name)).map(name => name.slice(8, -3));
    const partOf = id => still.evaluate(async ([parts, id]) => {
        for (const part of parts) {
            if (!(await (await window.workbookAsk(part))(id + "\n\n")).startsWith("error\tthere is no figure")) {
                return part;
            }
        }
    }, [parts, id]);
    const inPage = (part, question) => still.evaluate(
        async ([part, question]) => (await window.workbookAsk(part))(question), [part, question]);
    const ofServer = await context.newPage();
    await ofServer.goto(served);
    const native = question => ofServer.evaluate(async question => (await window.workbookAsk(""))(question), question);
    const different = [];
    for (const id of ids) {
        const part = await partOf(id);
        const question = `${id}\n\n`;
        const answer = await native(question);
        const values = (answer.match(/^values\t(.*)$/m) ?? [])[1] ?? "";
        const handle = answer.match(/^handle\t([^\t]*)\t([^\t]*)\t([^\t]*)\t([^\t]*)/m);
        const questions = [question];
        if (handle) {
            const [, name, index, x, y] = handle;
            questions.push(`${id}\n${values}\n${name} ${index} ${Number(x) + 11.37} ${Number(y) - 7.77}`);
        }
        for (const asked of questions) {
            if (await native(asked) !== await inPage(part, asked)) {
                different.push(asked);
            }
        }
    }
    check(ids.length > 20 && different.length === 0, `wasm and native answer alike for ${ids.length} figures ${different.join(" | ")}`);

    await ofServer.close();
    await still.bringToFront();
    const times = await still.evaluate(async id => {
        const figureOf = document.querySelector(`figure[data-figure="${id}"]`);
        const answer = await window.workbookAsk(figureOf.dataset.part);
        const values = (await answer(id + "\n\n")).match(/^values\t(.*)$/m)[1];
        const figure = document.querySelector(`figure[data-figure="${id}"] .live-picture`);
        const draws = [];
        /** How many frames come late in a time, in which each does some work. */
        const lateFrames = async (milliseconds, work) => {
            let late = 0;
            let last = null;
            const begin = performance.now();
            while (performance.now() - begin < milliseconds) {
                const now = await new Promise(requestAnimationFrame);
                if (last !== null && now - last > 1000 / 60 * 1.5) {
                    late++;
                }
                last = now;
                await work();
            }
            return late;
        };
        const redraw = async () => {
            const start = performance.now();
            const k = draws.length % 100;
            const text = await answer(`${id}\n${values}\nb 1 ${260 + k} ${80 + k / 2}`);
            window.workbookShow(id, text);
            figure.getBoundingClientRect();
            draws.push(performance.now() - start);
        };
        // The bound is for a machine that leaves three quarters of its time to a page: others are late whatever is drawn.
        const busy = () => {
            const end = performance.now() + 12;
            while (performance.now() < end) { /* no drawing */ }
        };
        /** The quickest of many runs of a fixed calculation, in milliseconds. */
        const calculation = () => Math.min(...Array.from({ length: 30 }, () => {
            const start = performance.now();
            let sum = 0;
            for (let i = 1; i < 2e6; i++) {
                sum += Math.sqrt(i) / (i % 7 + 1);
            }
            return sum > 0 ? performance.now() - start : Infinity;
        }));
        const tries = [];
        do {
            const before = await lateFrames(2000, busy);
            const dragging = await lateFrames(3000, redraw);
            tries.push({ dragging, busy: before + await lateFrames(2000, busy) });
        } while (tries.length < 4 && !tries.some(({ busy, dragging }) => busy === 0 && dragging === 0));
        draws.sort((a, b) => a - b);
        return {
            quick: draws[Math.floor(draws.length / 20)],
            median: draws[draws.length >> 1],
            worst: draws[draws.length - 1],
            frames: draws.length,
            calculation: calculation(),
            tries,
        };
    }, FIGURE);
    // What else the machine does makes a redraw slower and never quicker: the quickest twentieth tells what the page needs.
    const quiet = times.tries.filter(({ busy }) => busy === 0);
    /** Says whether a time is kept; a machine that is late without any drawing can keep one, but not miss it. */
    const inTime = (holds, message) => holds || quiet.length > 0 ? check(holds, message)
        : console.log(`        not judged: ${message}; late in 4 s with 12 ms of other work a frame: `
            + times.tries.map(({ busy }) => busy).join(", "));
    // The 4 ms are meant for a machine that does the fixed calculation in 9 ms; a slower one may take longer in proportion.
    const bound = 4 * Math.max(1, times.calculation / 9);
    inTime(times.quick < bound, `a redraw takes ${times.quick.toFixed(2)} ms where nothing disturbs it (at most ${bound.toFixed(2)}, median `
        + `${times.median.toFixed(2)}, worst ${times.worst.toFixed(2)})`);
    inTime(times.tries.some(({ dragging }) => dragging === 0),
        `late frames in 3 s of dragging: ${times.tries.map(({ dragging }) => dragging).join(", ")}`);

    // ---- How much a reader loads ----
    for (const part of parts) {
        const script = readFileSync(join(site, `figures-${part}.js`), "utf8");
        const packed = Buffer.from(script.split('"')[3], "base64").length;
        check(packed < 150_000, `the wasm code of ${part} takes ${packed} bytes gzipped`);
    }
    for (const path of ["bezier/de-casteljau.html", "bezier/shape.html", "bezier/bounds.html", "affine/maps.html", "subdivision/four-point.html"]) {
        const fresh = await browser.newContext({ viewport: { width: 1300, height: 900 } });
        const visitor = await fresh.newPage();
        const loaded = new Set();
        visitor.on("request", request => request.url().startsWith("file:") && loaded.add(request.url().replace(/[?#].*/, "")));
        await visitor.goto(pathToFileURL(resolve(site, path)).href);
        for (const figure of await visitor.locator("figure[data-figure]").all()) {
            await figure.scrollIntoViewIfNeeded();
        }
        await visitor.locator("figure.live").first().waitFor();
        await visitor.waitForTimeout(300);
        // As a web server sends them: what is text is compressed.
        const sent = [...loaded].reduce((sum, url) => sum + gzipSync(readFileSync(fileURLToPath(url))).length, 0);
        check(sent < 1_000_000, `a first visit of ${path} loads ${sent} bytes in ${loaded.size} files`);
        await fresh.close();
    }
} finally {
    server.kill("SIGINT");
    await browser.close();
}
console.log(failures.length === 0 ? "live figures: all well" : `${failures.length} failures`);
process.exit(failures.length === 0 ? 0 : 1);
