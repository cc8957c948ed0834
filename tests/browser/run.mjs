// Run in a real browser: examples run, say what is wrong, keep what the reader writes, and nothing but the book's own
// scripts gets a word in. With the link of the server, without it, and from the disk.
//
//     node run.mjs CHROMIUM WORKBOOK SITE

import { spawn } from "node:child_process";
import { resolve } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [browserPath, workbook, site] = process.argv.slice(2);
const PAGE = "bezier/de-casteljau.html";
// The first run compiles the library.
const PATIENCE = 300_000;

const failures = [];
const check = (holds, message) => {
    if (!holds) {
        failures.push(message);
        console.log(`FAILED  ${message}`);
    }
};

async function serve() {
    const server = spawn(workbook, ["--port", "0"], { stdio: ["ignore", "pipe", "inherit"] });
    for await (const line of createInterface({ input: server.stdout })) {
        const link = line.match(/http:\/\/127\.0\.0\.1:\d+\/\?token=\w+/);
        if (link) {
            return { server, link: link[0] };
        }
    }
    throw new Error("the server ended without printing its link");
}

/** A page on which each error of the console counts; what the policy forbids is one. */
async function open(browser, address, options = {}) {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 }, ...options });
    const page = await context.newPage();
    const own = new URL(address).origin;
    page.on("console", message => check(message.type() !== "error", `console: ${message.text()}`));
    page.on("pageerror", error => check(false, `script: ${error.message}`));
    page.on("request", request => {
        const isOwn = request.url().startsWith(own === "null" ? "file:" : own) || request.url().startsWith("data:");
        check(isOwn, `asks for ${request.url()}`);
    });
    await page.goto(address, { waitUntil: "load" });
    return page;
}

const example = page => page.locator(".run").first();

/** Presses Run and waits for what comes. */
async function run(block) {
    await block.locator(".run-go").click();
    await block.and(block.page().locator(".run:not(.running)")).waitFor({ timeout: PATIENCE });
    return (await block.locator(".run-say").textContent()) + "\n" + (await block.locator(".run-result").innerText());
}

/** Puts a program into the editor, which is open already. */
const write = (block, text) => block.locator("textarea").fill(text);

async function examplesRun(page) {
    const block = example(page);
    const said = await run(block);
    check(said.includes("every assertion holds"), `an example of the book runs: ${said}`);
    check(await block.locator(".run-result").isHidden(), "without output there is nothing to show");
    const seconds = [];
    for (let turn = 0; turn < 5; turn++) {
        seconds.push(parseFloat((await run(block)).match(/([\d.]+) s/)[1]));
    }
    console.log(`warm, as the server measures it: ${seconds.join(", ")} s`);

    const refused = page.locator(".run:has(code.compile_fail)").first();
    if (await refused.count()) {
        const message = await run(refused);
        check(message.includes("As it should") && /error\[E\d+\]/.test(message), `the compiler refuses: ${message}`);
    }
}

async function editing(page) {
    const block = example(page);
    const original = await block.locator("pre > code").textContent();
    await block.locator(".run-edit").click();
    check(await page.evaluate(() => document.activeElement.tagName) === "TEXTAREA", "Edit leads to the editor");
    check(await block.locator("textarea").inputValue() === original.replace(/\n$/, ""), "all lines are there, hidden ones too");

    await write(block, "let x = 1;\nlet y: u8 = \"a\";\n");
    const wrong = await run(block);
    check(wrong.includes("does not compile") && wrong.includes("example.rs:2:13"), `a compile error: ${wrong}`);
    check(await block.locator(".code-editor-mark").isVisible(), "the line with the error is marked");

    await write(block, "panic!(\"no luck\");");
    const panicked = await run(block);
    check(panicked.includes("panicked") && panicked.includes("no luck"), `a panic: ${panicked}`);

    await write(block, "println!(\"{}\", 6 * 7);\nprintln!(\"<svg viewBox='0 0 9 9'><circle r='4'/><script>document.title = 1</script></svg>\");");
    const drawn = await run(block);
    check(drawn.includes("42"), `the output: ${drawn}`);
    const picture = await block.locator("img.run-picture").evaluate(image => image.decode().then(() => image.naturalWidth, () => 0));
    check(picture > 0, "a program that prints an SVG shows the picture");

    // As text, whatever it looks like.
    await write(block, "println!(\"<img src=x onerror=alert(1)>\");");
    const quoted = await run(block);
    check(quoted.includes("<img src=x onerror=alert(1)>"), `output is text: ${quoted}`);

    await write(block, "loop {}");
    await block.locator(".run-go").click();
    await page.waitForTimeout(1500);
    check(await block.locator(".run-go").textContent() === "Stop", "while it runs, it can be stopped");
    await block.locator(".run-go").click();
    await block.and(page.locator(".run:not(.running)")).waitFor({ timeout: 5000 });
    check((await block.locator(".run-say").textContent()) === "stopped", "Stop ends an endless program");
}

async function typing(page) {
    const block = example(page);
    await write(block, "");
    await block.locator("textarea").focus();
    await page.keyboard.type("fn main() {\nlet a = 1;\nif a == 1 {\nprintln!(\"a\");\n}\n}");
    const typed = await block.locator("textarea").inputValue();
    check(typed === "fn main() {\n    let a = 1;\n    if a == 1 {\n        println!(\"a\");\n    }\n}", `lines are indented: ${typed}`);
    await page.keyboard.press("Control+Enter");
    await block.locator(".run-output").waitFor({ timeout: PATIENCE });
    check((await block.locator(".run-output").first().textContent()) === "a", "Ctrl+Enter runs");
    await page.keyboard.press("Escape");
    await page.keyboard.press("Tab");
    check(await page.evaluate(() => document.activeElement.tagName) !== "TEXTAREA", "Escape and Tab leave the editor");
    const size = await block.locator(".code-editor").evaluate(editor => {
        const [field, paper] = [editor.querySelector("textarea"), editor.querySelector("pre")].map(e => e.getBoundingClientRect());
        return [Math.abs(field.width - paper.width), Math.abs(field.height - paper.height)];
    });
    check(Math.max(...size) < 1, `the letters lie on each other: ${size}`);
}

async function edits(page) {
    const text = "// mine\nprintln!(\"kept\");";
    await write(example(page), text);
    await page.reload({ waitUntil: "load" });
    check(await example(page).locator("textarea").inputValue() === text, "an edit is there after a reload");
    await page.goto(new URL("../introduction.html", page.url()).href);
    await page.goBack();
    const block = example(page);
    check(await block.locator("textarea").inputValue() === text, "an edit is there after turning pages");
    check(await page.locator(".run textarea").count() === 1, "no other block has it");

    await block.locator(".run-back").click();
    check(await block.locator("textarea").count() === 0 && await block.locator("pre > code").isVisible(), "Reset shows the block of the book");
    await block.locator(".run-back").click();
    check(await block.locator("textarea").inputValue() === text, "a reset can be taken back");
    await block.locator(".run-back").click();
    await page.reload({ waitUntil: "load" });
    check(await page.locator(".run textarea").count() === 0, "after a reset nothing is kept");
}

/** Without a server that lets the reader in, the button says how to get one. */
async function explained(page, label) {
    await example(page).locator(".run-go").click();
    const said = await example(page).locator(".run-result").innerText();
    check(said.includes("cargo run"), `${label}: ${said}`);
}

const { server, link } = await serve();
const address = new URL(link).origin + "/";
const browser = await chromium.launch({
    executablePath: browserPath,
    args: ["--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run",
        "--disable-background-networking", "--disable-component-update", "--disable-sync"],
});
try {
    const page = await open(browser, link);
    check(!page.url().includes("token"), `the token stays in the address: ${page.url()}`);
    check(await page.evaluate(() => document.cookie) === "", "a script reads the cookie");
    await page.goto(address + PAGE);
    check(await page.locator(".read-only").count() === 0, "the reader is told that he may only read");
    await examplesRun(page);
    await editing(page);
    await typing(page);
    await edits(page);

    // What gets into a page in whatever way does not run.
    const injected = await browser.newContext();
    const victim = await injected.newPage();
    await victim.goto(address + PAGE);
    await victim.evaluate(() => {
        const script = document.createElement("script");
        script.textContent = "window.injected = true";
        document.body.append(script);
        const image = document.createElement("img");
        image.setAttribute("onerror", "window.injected = true");
        image.src = "x:";
        document.body.append(image);
    });
    await victim.waitForTimeout(200);
    check(!(await victim.evaluate(() => window.injected)), "an injected script runs");

    const visitor = await open(browser, address + PAGE);
    check(await visitor.locator(".read-only").isVisible(), "without the link the page says how to get it");
    await explained(visitor, "without the link");

    const fromDisk = await open(browser, pathToFileURL(resolve(site, PAGE)).href);
    await explained(fromDisk, "from disk");

    for (const colorScheme of ["light", "dark"]) {
        const narrow = await open(browser, link, { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true, colorScheme });
        await narrow.goto(address + PAGE);
        const block = example(narrow);
        await block.locator(".run-edit").tap();
        await write(block, `println!("{}", "wide ".repeat(60)); // ${"and a long line ".repeat(10)}`);
        await run(block);
        const excess = await narrow.evaluate(() => document.scrollingElement.scrollWidth - document.scrollingElement.clientWidth);
        check(excess <= 0, `360 px, ${colorScheme}: ${excess} px too wide`);
        const size = await block.locator("textarea").evaluate(field => parseFloat(getComputedStyle(field).fontSize));
        check(size >= 16, `a telephone enlarges the page for letters of ${size} px`);
        await narrow.context().close();
    }
    console.log("Run: examples, errors, drawings, stopping, typing, edits, without the link, from disk, narrow");
} finally {
    await browser.close();
    server.kill("SIGINT");
}
if (failures.length > 0) {
    console.log(`${failures.length} failures`);
    process.exit(1);
}
