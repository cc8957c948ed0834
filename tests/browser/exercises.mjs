// Exercises in a real browser: answered, checked, saved and never lost, by the server as well as from disk.
//
//     node exercises.mjs CHROMIUM WORKBOOK SITE

import { spawn } from "node:child_process";
import { existsSync, mkdtempSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { createInterface } from "node:readline";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";

const [browserPath, workbook, site] = process.argv.slice(2);
const CODE = "bezier/parabola-point";
const TABLE = "bezier/cubic-tableau";
const EXPLAIN = "bezier/blossom-uniqueness";
const anchor = name => "exercise--" + name.replace("/", "--");

const failures = [];
const check = (holds, message) => {
    console.log(`${holds ? "ok    " : "FAILED"}  ${message}`);
    if (!holds) {
        failures.push(message);
    }
};

/** The server on a free port with answers of its own; resolves to its link. */
async function serve(answers) {
    const arguments_ = ["--port", "0", "--answers", answers];
    const server = spawn(workbook, arguments_, { stdio: ["ignore", "pipe", "inherit"] });
    for await (const line of createInterface({ input: server.stdout })) {
        const link = line.match(/http:\/\/127\.0\.0\.1:\d+\S*/);
        if (link) {
            return { server, link: link[0] };
        }
    }
    throw new Error("the server ended without telling its address");
}

/** The page of the site that shows an exercise. */
function pageOf(name) {
    const pages = readdirSync(site, { recursive: true }).filter(path => path.endsWith(".html") && !path.startsWith("source"));
    const found = pages.find(path => readFileSync(join(site, path), "utf8").includes(`id="${anchor(name)}"`));
    return found.split("\\").join("/");
}

/** The text between the marks of an exercise: its solution. */
function solutionOf(name) {
    const lines = readFileSync(resolve(site, "..", "..", "book/exercises", name, "answer.rs"), "utf8").split("\n");
    return lines.filter(line => !/^\s*\/\/[@|]/.test(line)).join("\n");
}

const answers = mkdtempSync(join(tmpdir(), "answers-"));
const { server, link } = await serve(answers);
const address = new URL(link).origin;
const file = path => join(answers, path);
const read = path => existsSync(file(path)) ? readFileSync(file(path), "utf8") : null;

const browser = await chromium.launch({ executablePath: browserPath, args: ["--no-sandbox", "--disable-gpu"] });
const wrong = [];

/** A page that remembers every complaint and every request to elsewhere. */
async function open(context, url) {
    const page = await context.newPage();
    page.on("console", message => ["error", "warning"].includes(message.type()) && wrong.push(message.text()));
    page.on("pageerror", error => wrong.push(error.message));
    page.on("request", request => {
        if (!/^(data|blob|file):/.test(request.url()) && !request.url().startsWith(address)) {
            wrong.push("asks for " + request.url());
        }
    });
    await page.goto(url);
    return page;
}

/** The parts of an exercise on a page. */
function parts(page, name) {
    const section = page.locator(`section[data-exercise="${name}"]`);
    return {
        section,
        fold: section.locator("details.answer"),
        field: section.locator(".code-editor-field"),
        button: text => section.getByRole("button", { name: text, exact: true }),
        verdict: section.locator(".verdict"),
        say: section.locator(".practice-say"),
        conflict: section.locator(".practice-conflict"),
        state: section.locator(".practice-state"),
        cell: (row, column) => section.locator(`table.tableau tr:nth-child(${row + 1}) td:nth-child(${column + 1})`),
    };
}

/** Waits until something holds; tells whether it did. */
async function soon(holds, patience = 15000) {
    const end = Date.now() + patience;
    while (Date.now() < end) {
        if (await holds()) {
            return true;
        }
        await new Promise(resolve => setTimeout(resolve, 40));
    }
    return false;
}

/** Presses Check and waits for the verdict; the first one may compile the library. */
async function judged(exercise, outcome) {
    const before = await exercise.verdict.innerHTML();
    await exercise.button("Check").click();
    await soon(async () => await exercise.verdict.innerHTML() !== before && await exercise.button("Check").isVisible(), 240000);
    return (await exercise.verdict.getAttribute("class")).includes(outcome);
}

const begun = async exercise => {
    await exercise.section.scrollIntoViewIfNeeded();
    if (!await exercise.fold.evaluate(fold => fold.open)) {
        await exercise.fold.locator("summary").first().click();
    }
    await exercise.fold.locator("textarea, input").first().waitFor();
};

try {
    const context = await browser.newContext({ viewport: { width: 1280, height: 900 } });
    const entry = await open(context, link);
    await entry.close();
    const codePage = `${address}/${pageOf(CODE)}`;
    const tab = await open(context, codePage);
    const code = parts(tab, CODE);

    // ---- Failing, not compiling, passing ----
    await begun(code);
    check(read("bezier/parabola-point.rs") === null, "looking at an exercise makes no file");
    check(await judged(code, "failed"), "the starter fails");
    check(await code.verdict.locator("svg").count() === 1, "a picture shows the wrong curve beside the right one");
    check(await code.verdict.locator(".verdict-finding dd.right").count() === 1, "the finding says what is expected");
    check(read("bezier/parabola-point.rs") !== null, "a check saves the answer where the terminal looks for it");
    await code.field.fill("pub fn broken() -> u8 { missing }\n");
    check(await judged(code, "failed"), "what does not compile is no answer");
    check((await code.verdict.textContent()).includes("missing"), "the compiler's words are shown");
    check(await code.section.locator(".code-editor-mark").isVisible(), "its line is marked in the editor");
    const solution = solutionOf(CODE);
    await code.field.fill(solution);
    check(await judged(code, "passed"), "the solution passes");
    check((await code.state.textContent()).includes("solved"), "it is marked as solved");
    check(await code.verdict.locator(".verdict-next a").count() === 1, "the next exercise is named with a link");
    const progress = JSON.parse(read("progress.json"));
    check(progress.exercises[CODE].checks === 3 && progress.exercises[CODE].solved > 0, "the progress is that of the terminal");

    // ---- What is typed is kept ----
    await code.field.fill("// not saved\n" + solution);
    check(read("bezier/parabola-point.rs") === solution, "typing alone writes no file");
    await tab.reload();
    await code.fold.waitFor();
    check(await soon(async () => (await code.field.count()) && (await code.field.inputValue()).startsWith("// not saved")), "it is there again after a reload");
    await begun(code);
    await code.field.focus();
    await tab.keyboard.press("Control+s");
    check(await soon(() => read("bezier/parabola-point.rs").startsWith("// not saved")), "Ctrl+S saves it");

    // ---- Two tabs, and an editor ----
    const other = await open(context, codePage);
    const twin = parts(other, CODE);
    await begun(twin);
    await twin.field.fill("// from the other tab\n" + solution);
    check(await soon(async () => (await code.field.inputValue()).startsWith("// from the other tab")), "what one tab types, the other shows");
    await twin.field.focus();
    await other.keyboard.press("Control+s");
    check(await soon(() => read("bezier/parabola-point.rs").startsWith("// from the other tab")), "the other tab saves");
    // A tab that has not heard of the save yet would rightly take the next text for a conflict with its own.
    const known = async tab => !(await tab.say.textContent()).includes("Not saved");
    check(await soon(async () => await known(code) && await known(twin)), "both tabs hear of it");
    writeFileSync(file("bezier/parabola-point.rs"), "// by an editor\n");
    check(await soon(async () => await code.field.inputValue() === "// by an editor\n" && await twin.field.inputValue() === "// by an editor\n"), "both tabs take over what an editor saves");
    await other.close();
    await code.field.fill("// mine\n");
    writeFileSync(file("bezier/parabola-point.rs"), "// theirs\n");
    check(await soon(() => code.conflict.isVisible()), "two texts are shown as a conflict");
    check(await code.field.inputValue() === "// mine\n" && (await code.conflict.textContent()).includes("// theirs"), "it shows both");
    await code.field.focus();
    await tab.keyboard.press("Control+s");
    await tab.waitForTimeout(300);
    check(read("bezier/parabola-point.rs") === "// theirs\n", "until the reader chooses nothing is written");
    await code.button("Keep mine").click();
    check(await soon(() => read("bezier/parabola-point.rs") === "// mine\n"), "the reader's choice is written");
    const backups = readdirSync(file("backups/bezier")).map(name => read("backups/bezier/" + name));
    check(backups.includes("// theirs\n"), "what had to make room is kept");
    await code.field.fill("// mine again\n");
    writeFileSync(file("bezier/parabola-point.rs"), "// theirs again\n");
    await soon(() => code.conflict.isVisible());
    await code.button("Take the file").click();
    check(await code.field.inputValue() === "// theirs again\n", "or the file is taken");
    await code.button("Back to mine").click();
    check(await code.field.inputValue() === "// mine again\n", "and his own text comes back when asked for");

    // ---- Hints, solution, reset ----
    await code.button("Reset").click();
    check(await soon(async () => (await code.say.textContent()).includes("kept as")), "a reset says where the answer is kept");
    check(readdirSync(file("backups/bezier")).some(name => read("backups/bezier/" + name) === "// mine again\n"), "also the text that was not saved");
    const hints = code.section.locator("details.hint");
    check(!await hints.first().isVisible(), "no hint is seen at first");
    await code.section.getByRole("button", { name: /^Hint 1/ }).click();
    check(await soon(() => hints.nth(0).isVisible()) && !await hints.nth(1).isVisible(), "hints come one at a time");
    await code.button("Solution").click();
    check(await soon(async () => (await code.say.textContent()).includes("ask once more")), "the solution is not shown at the first question");
    await code.button("Solution").click();
    check(await soon(() => code.section.locator("details.solution").first().isVisible()), "it is shown at the second");
    await tab.close();

    // ---- A tableau ----
    const tablePage = await open(context, `${address}/${pageOf(TABLE)}`);
    const table = parts(tablePage, TABLE);
    await begun(table);
    const entries = solutionOf(TABLE).split("\n").filter(line => line.startsWith("(")).map(line => line.match(/\([^)]*\)/g));
    const fill = async (exercise, rows) => {
        for (let row = 1; row < 4; row++) {
            for (let column = 1; column <= row; column++) {
                await exercise.cell(row, column).locator("input").fill(rows[row][column]);
            }
        }
    };
    const state = (exercise, row, column) => exercise.cell(row, column).getAttribute("data-state");
    await fill(table, entries);
    await table.cell(2, 1).locator("input").fill("six");
    await table.button("Check").click();
    check(await soon(async () => await state(table, 2, 1) === "unreadable"), "a cell that cannot be read is told");
    check(read("bezier/cubic-tableau.rs") === null, "and nothing is written");
    await table.cell(2, 1).locator("input").fill("(1, 1)");
    check(await judged(table, "failed"), "a wrong entry fails");
    check(await state(table, 2, 1) === "wrong" && await state(table, 1, 1) === "right", "each cell is judged by itself");
    await table.cell(2, 1).locator("input").fill(entries[2][1]);
    check(await judged(table, "passed"), "the filled tableau passes");
    check(read("bezier/cubic-tableau.rs").includes(entries[3][3]), "it stands in the file of the terminal");
    await table.button("Fresh numbers").click();
    check(await soon(async () => await table.cell(1, 1).locator("input").inputValue() === ""), "fresh numbers are dealt");
    await tablePage.close();

    // ---- An explanation ----
    const explainPage = await open(context, `${address}/${pageOf(EXPLAIN)}`);
    const explain = parts(explainPage, EXPLAIN);
    await begun(explain);
    check(!await explain.section.locator("details.checklist").isVisible(), "the checklist waits for an answer");
    await explain.field.fill("Because it is known from its values at 0 and 1.\n");
    await explain.button("Compare").click();
    check(await soon(() => explain.section.locator("details.checklist").isVisible()), "comparing shows what a good answer says");
    check(await explain.section.locator("details.model").isVisible(), "and the model answer");
    await explain.button("Mine says all of it").click();
    check(await soon(async () => (await explain.state.textContent()).includes("solved")), "the reader judges himself");
    check(read("bezier/blossom-uniqueness.md").startsWith("Because"), "the answer is in its file");
    await explainPage.close();
    const list = await open(context, `${address}/exercises.html`);
    const marked = state => list.locator(`table.exercises a[data-state="${state}"]`).count();
    check(await soon(async () => await marked("solved") === 2 && await marked("begun") === 1), "the list marks what is solved and what is begun");
    await list.close();
    await context.close();

    // ---- Read-only, narrow and dark ----
    const visitor = await browser.newContext({ viewport: { width: 360, height: 740 }, colorScheme: "dark" });
    const reading = await open(visitor, codePage);
    const closed = parts(reading, CODE);
    check(await closed.field.count() === 0, "without the link there is no editor");
    await closed.button("Check").click();
    check((await closed.section.locator(".practice-how").textContent()).includes("link"), "and the button says what is missing");
    await visitor.close();
    const phone = await browser.newContext({ viewport: { width: 360, height: 740 }, colorScheme: "dark", hasTouch: true, isMobile: true });
    const small = await open(phone, link);
    for (const [name, ends] of [[CODE, "failed"], [TABLE, "failed"]]) {
        await small.goto(`${address}/${pageOf(name)}`);
        const exercise = parts(small, name);
        await begun(exercise);
        check(await judged(exercise, ends), `phone: ${name} is checked`);
        const wide = await small.evaluate(() => document.documentElement.scrollWidth);
        check(wide <= 360, `phone: nothing sticks out of ${name} (${wide})`);
        const target = await exercise.button("Check").boundingBox();
        check(target.height >= 44, "phone: a button is large enough for a thumb");
    }
    await phone.close();

    // ---- From disk ----
    const disk = await browser.newContext({ viewport: { width: 1280, height: 900 } });
    const still = await open(disk, pathToFileURL(resolve(site, pageOf(CODE))).href);
    const silent = parts(still, CODE);
    check(await silent.section.locator("details.starter").isVisible(), "disk: the page shows what it showed before");
    await silent.button("Check").click();
    check((await silent.section.locator(".practice-how").textContent()).includes("cargo run"), "disk: Check says how to get it");
    await still.goto(pathToFileURL(resolve(site, pageOf(TABLE))).href);
    const alone = parts(still, TABLE);
    await begun(alone);
    await fill(alone, entries);
    await alone.cell(3, 1).locator("input").fill("(0, 0)");
    await alone.button("Check").click();
    check(await soon(async () => await state(alone, 3, 1) === "wrong"), "disk: the tableau is judged by the library");
    await alone.cell(3, 1).locator("input").fill(entries[3][1]);
    await alone.button("Check").click();
    check(await soon(async () => (await alone.verdict.getAttribute("class")).includes("passed")), "disk: and found right");
    const question = `tableau bezier cubic 7\n(0, 0)\n?\t(1, 1)`;
    const inPage = await still.evaluate(async question => (await window.workbookAsk("tableaux"))(question), question);
    const native = await fetch(`${address}/__workbook/figure`, { method: "POST", body: question, headers: { Origin: address } });
    check(inPage === await native.text(), "wasm and native judge alike");
    await disk.close();
    check(wrong.length === 0, `no complaint of the browser, no outside request ${wrong.join("; ")}`);
} finally {
    server.kill("SIGINT");
    await browser.close();
    rmSync(answers, { recursive: true, force: true });
}
console.log(failures.length === 0 ? "exercises: all well" : `${failures.length} failures`);
process.exit(failures.length === 0 ? 0 : 1);
