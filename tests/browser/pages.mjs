// Every page in a real browser: nothing comes from outside, no script fails, nothing sticks out of a narrow screen,
// and the dark theme is dark. From the server as well as from the disk.
//
//     node pages.mjs CHROMIUM WORKBOOK SITE

import { spawn } from "node:child_process";
import { readdirSync } from "node:fs";
import { join, relative, resolve, sep } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [browserPath, workbook, site] = process.argv.slice(2);
const NARROW = { width: 360, height: 740 };
const WIDE = { width: 1400, height: 900 };

const failures = [];
const fail = message => {
    failures.push(message);
    console.log(`FAILED  ${message}`);
};

/** All pages below the site's folder but the copies of the sources, of which a few stand for all. */
function pagesOf(folder) {
    const all = readdirSync(folder, { recursive: true, withFileTypes: true })
        .filter(entry => entry.isFile() && entry.name.endsWith(".html"))
        .map(entry => relative(folder, join(entry.parentPath ?? entry.path, entry.name)))
        .map(path => path.split(sep).join("/"))
        // Not meant to be opened by themselves: the frame of the contents, and the page of all chapters for printing.
        .filter(path => path !== "toc.html" && path !== "print.html")
        .sort();
    const isSource = path => path.startsWith("source/");
    return [...all.filter(path => !isSource(path)), ...all.filter(isSource).slice(0, 3)];
}

/** The server on a free port; resolves to its address. */
async function serve() {
    const server = spawn(workbook, ["--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
    for await (const line of createInterface({ input: server.stdout })) {
        const address = line.match(/http:\/\/127\.0\.0\.1:\d+/);
        if (address) {
            return { server, address: address[0] };
        }
    }
    throw new Error("the server ended without telling its address");
}

/** Looks at one page and reports what is wrong with it. */
async function visit(page, url, allowed, label) {
    const wrong = [];
    const onConsole = message => {
        if (["error", "warning"].includes(message.type())) {
            wrong.push(`console: ${message.text()}`);
        }
    };
    const onError = error => wrong.push(`script: ${error.message}`);
    const onRequest = request => {
        const target = request.url();
        if (!target.startsWith(allowed) && !target.startsWith("data:") && !target.startsWith("blob:")) {
            wrong.push(`asks for ${target}`);
        }
    };
    const onFailed = request => {
        // A page that is left takes its open question for news with it.
        if (!request.url().includes("/__workbook/state")) {
            wrong.push(`cannot load ${request.url()}: ${request.failure()?.errorText}`);
        }
    };
    page.on("console", onConsole).on("pageerror", onError).on("request", onRequest).on("requestfailed", onFailed);
    await page.goto(url, { waitUntil: "load" });
    await page.evaluate(() => document.fonts.ready);
    const overflow = await page.evaluate(() => {
        // Code, tables and formulas may scroll within their own box; the page and what frames it may not.
        const frames = [document.scrollingElement, document.querySelector("main")];
        for (let frame = frames[1]?.parentElement; frame; frame = frame.parentElement) {
            frames.push(frame);
        }
        const wide = frames.find(frame => frame && frame.scrollWidth > frame.clientWidth);
        if (!wide) {
            return null;
        }
        const limit = wide.getBoundingClientRect().left + wide.clientWidth;
        const culprits = [...wide.querySelectorAll("*")].filter(element =>
            element.getBoundingClientRect().right > limit + 1);
        const excess = wide.scrollWidth - wide.clientWidth;
        return `${excess} px too wide: ${culprits.at(-1)?.outerHTML.slice(0, 120) ?? wide.outerHTML.slice(0, 120)}`;
    });
    if (overflow) {
        wrong.push(overflow);
    }
    page.off("console", onConsole).off("pageerror", onError).off("request", onRequest).off("requestfailed", onFailed);
    wrong.forEach(message => fail(`${label}: ${message}`));
}

/** The brightness of the page's background, 0 black to 255 white. */
const brightness = page => page.evaluate(() => {
    const colour = element => getComputedStyle(element).backgroundColor;
    const canvas = document.createElement("canvas");
    const context = canvas.getContext("2d");
    context.fillStyle = "white";
    context.fillRect(0, 0, 1, 1);
    for (const element of [document.documentElement, document.body]) {
        context.fillStyle = colour(element);
        context.fillRect(0, 0, 1, 1);
    }
    const [red, green, blue] = context.getImageData(0, 0, 1, 1).data;
    return (red + green + blue) / 3;
});

/** Tables whose cells hold sentences, and the filter of the statements, on a screen of this size. */
async function readTables(browser, folder, viewport) {
    const label = path => `${path}, ${viewport.width} px`;
    const context = await browser.newContext({ viewport });
    const page = await context.newPage();
    for (const path of ["notation.html", "exercises.html", "statements.html"]) {
        await page.goto(`${folder}/${path}`, { waitUntil: "load" });
        const excess = await page.$$eval(".table-wrapper", wrappers =>
            Math.max(...wrappers.map(wrapper => wrapper.scrollWidth - wrapper.clientWidth)));
        if (excess > 0) {
            fail(`${label(path)}: a table is ${excess} px too wide to be read without scrolling`);
        }
    }
    await page.fill("#statement-filter [name=words]", "convex hull");
    const [matching, seen] = await page.$$eval("table.statements tbody tr", rows => [
        row => ["convex", "hull"].every(word => row.textContent.toLowerCase().includes(word)),
        row => row.getClientRects().length > 0,
    ].map(test => rows.filter(test).length));
    if (matching === 0 || seen !== matching) {
        fail(`${label("statements.html")}: ${matching} statements match the words, and ${seen} are seen`);
    }
    await context.close();
}

const { server, address } = await serve();
const browser = await chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
try {
    const folder = resolve(site);
    const pages = pagesOf(folder);
    if (pages.length < 2) {
        fail(`${site} holds no pages`);
    }
    for (const colorScheme of ["light", "dark"]) {
        for (const viewport of [NARROW, WIDE]) {
            const context = await browser.newContext({ viewport, colorScheme });
            const page = await context.newPage();
            for (const path of pages) {
                await visit(page, `${address}/${path}`, address, `${path}, ${viewport.width} px, ${colorScheme}`);
            }
            const light = await brightness(page);
            if ((colorScheme === "dark") !== (light < 128)) {
                fail(`the ${colorScheme} theme has a background of brightness ${light.toFixed(0)}`);
            }
            await context.close();
        }
    }
    const context = await browser.newContext({ viewport: WIDE });
    const page = await context.newPage();
    const disk = pathToFileURL(folder).href;
    // A server shows 404.html under every address, so its links begin at the server's root, which a disk has not.
    for (const path of pages.filter(path => path !== "404.html")) {
        await visit(page, `${disk}/${path}`, disk, `${path} from disk`);
    }
    for (const viewport of [NARROW, WIDE]) {
        await readTables(browser, disk, viewport);
    }
    console.log(`${pages.length} pages, from the server at two widths in two themes and from disk, and their long tables`);
} finally {
    await browser.close();
    server.kill("SIGINT");
}
if (failures.length > 0) {
    console.log(`${failures.length} failures`);
    process.exit(1);
}
