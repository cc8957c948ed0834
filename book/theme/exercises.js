// Exercises on the page: the reader's answer in an editor or in the table of a tableau, Check, Hint, Solution, Reset.
// The rules are those of the terminal and live in Rust (`src/workbook/practice/`); here they get buttons. What is typed
// and not saved yet is kept in this browser, for all its tabs.
(function () {
    'use strict';

    const root = document.currentScript.src.replace(/[^/]*$/, '').replace(/theme\/$/, '');
    const mayRun = window.workbookServer?.mayRun === true;

    const element = (name, attributes = {}, ...children) => {
        const made = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) {
            if (key in made) {
                made[key] = value;
            } else {
                made.setAttribute(key, value);
            }
        }
        made.append(...children);
        return made;
    };
    const button = (text, title, act) => {
        const made = element('button', { type: 'button', textContent: text, title });
        made.addEventListener('click', act);
        return made;
    };
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

    const { readDraft, keepDraft, keyOf } = window.workbookDrafts;

    // ---- The answer as text ----

    class TextView {
        constructor(host, practice) {
            this.editor = window.workbookEditor(host, '', {
                language: practice.kind === 'explain' ? 'markdown' : 'rust',
                label: 'Your answer to “' + practice.title + '”',
                onChange: () => practice.changed(),
                onSubmit: () => practice.check(),
            });
        }

        static valueOf(standing) {
            return { text: standing.text };
        }

        value() {
            return { text: this.editor.text() };
        }

        set(value) {
            if (typeof value.text === 'string' && value.text !== this.editor.text()) {
                this.editor.set(value.text);
            }
        }

        shown(value) {
            return value.text;
        }
    }

    const { answered, readFacts, TableView, askForTable } = window.workbookTable;

    // ---- One exercise ----

    class Practice {
        constructor(section) {
            this.section = section;
            this.name = section.dataset.exercise;
            this.kind = section.dataset.kind;
            this.tableau = section.dataset.tableau;
            this.title = section.querySelector('.practice-head').textContent.trim();
            const fold = kind => section.querySelector(':scope > details.' + kind);
            this.starter = fold('starter');
            this.hints = Array.from(section.querySelectorAll(':scope > details.hint'));
            this.solution = fold('solution:not(.afterwards)');
            this.afterwards = fold('afterwards');
            this.checklist = fold('checklist');
            this.standing = null;
            this.base = null;
            this.saved = null;
            this.busy = null;
            this.conflicting = null;
            this.view = null;
        }

        // -- What it looks like --

        lay() {
            this.state = element('span', { className: 'practice-state' });
            this.section.querySelector('.practice-head').append(' ', this.state);
            this.host = element('div');
            this.say = element('output', { className: 'practice-say' });
            this.checkButton = button('', 'Ctrl+Enter', () => this.check());
            this.checkButton.className = 'practice-check';
            this.tools = element('div', { className: 'practice-tools' }, this.checkButton);
            this.conflict = element('div', { className: 'practice-conflict', role: 'alert', hidden: true });
            this.verdict = element('div', { className: 'verdict', hidden: true });
            this.summary = element('summary', { textContent: 'Your answer' });
            this.fold = element('details', { className: 'fold answer' },
                this.summary, this.host, this.conflict, this.tools, this.say, this.verdict);
            const before = this.section.querySelector(':scope > details');
            this.section.insertBefore(this.fold, before);
            this.fold.addEventListener('keydown', event => {
                if ((event.ctrlKey || event.metaKey) && event.key === 's') {
                    event.preventDefault();
                    event.stopPropagation();
                    this.save();
                }
            }, true);
        }

        tell(words, isWrong = false) {
            this.say.replaceChildren(...[words].flat());
            this.say.classList.toggle('wrong', isWrong);
        }

        // -- With a server --

        begin() {
            this.lay();
            this.section.classList.add('served');
            this.checkButton.textContent = this.checkWord();
            this.hintButton = button('Hint', 'One more hint', () => this.hint());
            this.solutionButton = button('Solution', 'Ask for the solution', () => this.ask());
            this.resetButton = button('Reset', 'Begin anew; your answer is kept as a backup', () => this.reset());
            this.saveButton = button('Save', 'Ctrl+S', () => this.save());
            this.tools.append(this.saveButton, this.hintButton, this.solutionButton, this.resetButton);
            if (this.kind === 'explain') {
                this.doneButton = button('Mine says all of it', 'Mark it as done', () => this.done());
                this.doneButton.hidden = true;
                this.checkButton.after(this.doneButton);
            }
            if (this.tableau) {
                this.resetButton.after(button('Fresh numbers', 'Deal other numbers; your answer is kept as a backup', () => this.fresh()));
            }
            this.starter?.remove();
            window.addEventListener('storage', event => event.key === keyOf(this.name) && this.fromOtherTab(event.newValue));
        }

        checkWord() {
            return this.kind === 'explain' ? 'Compare' : 'Check';
        }

        post(what, body = {}) {
            const address = '/__workbook/exercise/' + this.name + '/' + what;
            const headers = { 'Content-Type': 'application/json' };
            const signal = this.busy?.signal;
            return answered(fetch(address, { method: 'POST', headers, body: JSON.stringify(body), signal }))
                .then(response => response.json());
        }

        isDirty() {
            return this.view !== null && !same(this.view.value(), this.saved);
        }

        /** The reader has typed. */
        changed() {
            if (!this.standing) {
                keepDraft(this.name, { value: this.view.value() });
                return;
            }
            keepDraft(this.name, this.isDirty() ? { value: this.view.value(), base: this.base } : null);
            this.tell(this.isDirty() ? 'Not saved yet; Check saves it, and so does Ctrl+S.' : '');
        }

        /** Another tab of this browser has typed, or has saved. */
        fromOtherTab(text) {
            if (!this.standing) {
                return;
            }
            if (text === null) {
                // Whatever it did with the text, the file has it now, and the news of that follow.
                this.saved = this.view.value();
                this.tell('');
                return;
            }
            const draft = JSON.parse(text);
            if (draft.value.round !== this.view.value().round) {
                return;
            }
            this.view.set(draft.value);
            this.base = draft.base;
            this.tell('You are writing this in another tab.');
        }

        /** Makes the view that fits the answer: a table as long as the file holds one. */
        viewFor(standing) {
            const View = standing.tableau ? TableView : TextView;
            if (View === TableView) {
                const facts = readFacts(standing.tableau);
                if (!(this.view instanceof TableView) || this.view.facts.round !== facts.round) {
                    this.view = new TableView(this.host, this);
                    this.view.build(facts);
                }
            } else if (!(this.view instanceof TextView)) {
                this.host.className = '';
                this.view = new TextView(this.host, this);
            }
            return View.valueOf(standing);
        }

        /** Hears how the reader stands: at first, and whenever the file or the progress has changed. */
        take(standing) {
            this.recover(standing);
            const isFirst = this.standing === null;
            const wasDirty = this.isDirty();
            const before = this.view?.value();
            this.standing = standing;
            this.facts();
            if (isFirst) {
                const theirs = this.viewFor(standing);
                this.view.set(theirs);
                this.base = standing.digest;
                this.saved = this.view.value();
                const draft = readDraft(this.name);
                // What was typed for other numbers fits no table of these.
                if (draft?.value && draft.value.round === theirs.round && !same(draft.value, theirs)) {
                    this.view.set(draft.value);
                    if (this.isDirty()) {
                        this.base = draft.base ?? null;
                        this.fold.open = true;
                        this.tell('Not saved yet; this is what you have written here last.');
                        this.base === standing.digest || this.clash();
                    }
                } else {
                    keepDraft(this.name, null);
                }
                this.fold.open ||= standing.digest !== null && !standing.solved;
                return;
            }
            if (standing.digest === this.base) {
                return;
            }
            const theirs = (standing.tableau ? TableView : TextView).valueOf(standing);
            if (wasDirty && !same(before, theirs)) {
                this.clash();
                return;
            }
            this.viewFor(standing);
            this.view.set(theirs);
            this.base = standing.digest;
            this.saved = this.view.value();
            keepDraft(this.name, null);
            this.settle();
            if (!same(before, theirs)) {
                this.tell('Taken over from ' + standing.file + ', which has changed.');
            }
        }

        /** A check that broke off may have saved the answer before: then the file holds what was sent. */
        recover(standing) {
            const View = standing.tableau ? TableView : TextView;
            if (!this.lost || !same(this.lost, View.valueOf(standing))) {
                return false;
            }
            this.saved = this.lost;
            this.base = standing.digest;
            this.lost = null;
            return true;
        }

        /** Between the saving and the reply somebody else may have written: then the reply holds his text. */
        overtaken(sent) {
            const theirs = (this.standing.tableau ? TableView : TextView).valueOf(this.standing);
            // A table comes back with other blanks.
            const plain = value => JSON.stringify(value.fields ?? value).replace(value.fields ? /\s/g : '', '');
            if (plain(theirs) === plain(sent)) {
                return;
            }
            if (this.isDirty()) {
                this.base = 'overtaken';
                this.clash();
                return;
            }
            this.viewFor(this.standing);
            this.view.set(theirs);
            this.saved = this.view.value();
            this.tell('Taken over from ' + this.standing.file + ', which has changed.');
        }

        /** Shows the facts that depend on no text. */
        facts() {
            const { solved, digest, hints, starter_changed: changed, file } = this.standing;
            this.state.textContent = solved ? '✓ solved' : digest !== null ? 'begun' : '';
            this.state.classList.toggle('solved', solved);
            this.summary.textContent = digest === null ? 'Write your answer' : 'Your answer';
            this.summary.title = file;
            this.hints.forEach((hint, index) => { hint.hidden = index >= hints; });
            this.hintButton.hidden = this.hints.length === 0;
            this.hintButton.disabled = hints >= this.hints.length;
            this.hintButton.textContent = 'Hint ' + Math.min(hints + 1, this.hints.length) + ' of ' + this.hints.length;
            if (hints >= this.hints.length) {
                this.hintButton.textContent = 'No more hints';
            }
            this.resetButton.disabled = digest === null;
            for (const fold of [this.solution, this.afterwards]) {
                if (fold) {
                    // What a reader has seen he may see again; the numbers of a tableau may be others now.
                    fold.hidden = !solved && !this.solutionShown;
                }
            }
            if (this.solution && this.tableau) {
                this.solution.hidden = true;
            }
            if (this.checklist) {
                const isOpen = solved || this.compared || this.solutionShown;
                this.checklist.hidden = !isOpen;
                this.solution.hidden = !isOpen;
                this.doneButton.hidden = !isOpen || solved;
            }
            this.note ??= this.section.insertBefore(element('p', { className: 'practice-note', hidden: true }), this.fold);
            this.note.hidden = !changed;
            this.note.textContent = 'The starter has changed since you began. Your answer is left alone. Reset gives you the new starter and keeps your answer as a backup.';
        }

        // -- Two texts --

        /** The file holds something that the reader has not seen, while he has written something else. */
        clash() {
            const standing = this.standing;
            const View = standing.tableau ? TableView : TextView;
            const theirs = View.prototype.shown(View.valueOf(standing));
            this.conflicting = standing;
            this.fold.open = true;
            this.conflict.replaceChildren(
                element('p', {}, element('strong', { textContent: 'The file has changed meanwhile.' }),
                    ' Above is what you have written here; ' + standing.file + ' holds this:'),
                element('pre', { textContent: theirs }),
                element('div', { className: 'practice-tools' },
                    button('Keep mine', 'Write it into the file; what is there is kept as a backup', () => this.keepMine()),
                    button('Take the file', 'Go on with what the file holds', () => this.takeTheirs())));
            this.conflict.hidden = false;
            this.tell('');
        }

        settle() {
            this.conflicting = null;
            this.conflict.hidden = true;
        }

        keepMine() {
            this.save(true);
        }

        takeTheirs() {
            const mine = this.view.value();
            const standing = this.conflicting;
            this.settle();
            const theirs = this.viewFor(standing);
            this.view.set(theirs);
            this.base = standing.digest;
            this.saved = this.view.value();
            keepDraft(this.name, null);
            const back = button('Back to mine', 'What you had written here', () => {
                this.view.set(mine);
                this.changed();
            });
            if (mine.round === theirs.round) {
                this.tell(['Your own text is put aside until you leave the page. ', back]);
            }
        }

        // -- What the buttons do --

        /** Sends the answer; the reply belongs to the text as it was sent. */
        async send(what, { replace = false, words = '' } = {}) {
            if (this.busy) {
                this.busy.abort();
                return null;
            }
            const sent = this.view.value();
            const stop = new AbortController();
            this.busy = stop;
            this.checkButton.textContent = 'Stop';
            this.tell(words);
            try {
                let reply = await this.post(what, { ...sent, base: this.base, replace });
                if (reply.conflict && this.recover(reply.standing)) {
                    reply = await this.post(what, { ...sent, base: this.base, replace });
                }
                this.lost = null;
                const isUnread = reply.tableau && !reply.verdict && what === 'check';
                if (!reply.conflict && !isUnread) {
                    this.saved = sent;
                    this.base = reply.standing.digest;
                    this.settle();
                    this.tell(reply.backup ? 'What was in the file is kept as ' + reply.backup + '.' : '');
                }
                this.standing = reply.standing;
                this.facts();
                if (reply.conflict) {
                    this.clash();
                } else if (!isUnread) {
                    this.overtaken(sent);
                    keepDraft(this.name, this.isDirty() ? { value: this.view.value(), base: this.base } : null);
                }
                return reply;
            } catch (error) {
                this.lost = sent;
                this.tell(error.name === 'AbortError' ? 'Stopped.' : error.message, error.name !== 'AbortError');
                return null;
            } finally {
                this.busy = null;
                this.checkButton.textContent = this.checkWord();
            }
        }

        async save(replace = false) {
            if (!mayRun || !this.view || this.busy) {
                return;
            }
            const reply = await this.send('save', { replace });
            if (reply && !reply.conflict && !reply.tableau && !reply.backup) {
                this.tell('Saved as ' + reply.standing.file + '.');
            }
            this.judgeUnread(reply);
        }

        judgeUnread(reply) {
            if (reply?.tableau && !reply.verdict) {
                const facts = readFacts(reply.tableau);
                this.view.judge(facts);
                this.tell(facts.say[1] + ' Nothing was saved yet.', true);
            }
        }

        async check() {
            if (!mayRun) {
                return this.checkHere();
            }
            if (!this.view) {
                return;
            }
            if (!this.fold.open) {
                this.fold.open = true;
            }
            const words = this.kind === 'explain' ? '' : 'Your answer is compiled and tested …';
            const reply = await this.send('check', { words });
            if (!reply || reply.conflict) {
                return;
            }
            if (this.kind === 'explain') {
                this.compared = true;
                this.facts();
                this.checklist.open = true;
                this.tell('Compare yours with what a good answer says, below.');
                return;
            }
            this.judgeUnread(reply);
            if (reply.tableau) {
                this.view.judge?.(readFacts(reply.tableau));
            }
            if (reply.verdict) {
                this.show(reply);
            }
        }

        show(reply) {
            const passed = reply.verdict.outcome === 'passed';
            this.verdict.className = 'verdict ' + (passed ? 'passed' : 'failed');
            this.verdict.innerHTML = reply.html;
            this.verdict.hidden = false;
            for (const said of this.verdict.querySelectorAll('[data-line]')) {
                const go = () => {
                    this.view.editor?.markLine(Number(said.dataset.line));
                    this.view.editor?.focus();
                };
                said.title = 'Show the line';
                said.addEventListener('click', go);
            }
            const line = reply.verdict.diagnostics.find(said => said.level === 'error' && said.line)?.line;
            this.view.editor?.markLine(line);
            if (passed) {
                this.next(reply.next);
            }
            this.say.dataset.checks = reply.standing.checks;
        }

        next(next) {
            if (this.afterwards) {
                this.afterwards.hidden = false;
                this.afterwards.open = true;
            }
            if (next) {
                const link = next.address
                    ? element('a', { href: root + next.address, textContent: next.title })
                    : element('span', { textContent: next.title });
                this.verdict.append(element('p', { className: 'verdict-next' },
                    'Next is ', link, ', about ' + next.minutes + ' minutes.'));
                this.verdict.hidden = false;
            }
        }

        async done() {
            const reply = await this.send('done');
            if (reply && !reply.conflict) {
                this.verdict.className = 'verdict passed';
                this.verdict.replaceChildren(element('p', { className: 'verdict-summary', textContent: 'Done.' }));
                this.next(reply.next);
            }
        }

        /** Does something that changes no text. */
        async quietly(what, then) {
            try {
                const reply = await this.post(what);
                then(reply);
            } catch (error) {
                this.fold.open = true;
                this.tell(error.message, true);
            }
        }

        hint() {
            return this.quietly('hint', reply => {
                this.standing = { ...this.standing, hints: reply.standing.hints };
                this.facts();
                const last = this.hints[reply.standing.hints - 1];
                if (last) {
                    last.open = true;
                    last.scrollIntoView({ block: 'nearest' });
                }
            });
        }

        ask() {
            return this.quietly('solution', reply => {
                const { source, hints_left: left } = reply.solution;
                if (source === null) {
                    const hints = left === 0 ? '' : left === 1 ? ' One hint is left.' : ' ' + left + ' hints are left.';
                    this.tell('You have not solved it yet.' + hints + ' If you want to see the solution all the same, ask once more.');
                    return;
                }
                this.solutionShown = true;
                this.tell('');
                if (this.solution && !this.tableau) {
                    this.facts();
                    this.solution.hidden = false;
                    this.solution.open = true;
                    this.solution.scrollIntoView({ block: 'nearest' });
                } else {
                    this.dealt?.remove();
                    const code = element('code', { className: 'language-rust hljs', textContent: source });
                    this.dealt = element('details', { className: 'fold solution', open: true },
                        element('summary', { textContent: 'Solution' }), element('pre', {}, code));
                    this.section.append(this.dealt);
                    this.facts();
                }
            });
        }

        /** Begins anew; the server keeps the file, and a text that was not saved is saved before. */
        async anew(what, words) {
            if (this.isDirty()) {
                const reply = await this.send('save');
                if (!reply || reply.conflict || reply.tableau) {
                    this.judgeUnread(reply);
                    return;
                }
            }
            await this.quietly(what, reply => {
                this.solutionShown = false;
                this.compared = false;
                this.dealt?.remove();
                this.verdict.hidden = true;
                this.saved = this.view.value();
                this.base = undefined;
                this.take(reply.standing);
                this.fold.open = true;
                this.tell(words + (reply.backup ? ' Your answer is kept as ' + reply.backup + '.' : ''));
            });
        }

        reset() {
            return this.anew('reset', 'This is the starter again.');
        }

        fresh() {
            return mayRun ? this.anew('fresh', 'These are fresh numbers.') : this.dealHere();
        }

        // -- Without a server, or read-only --

        /** A table is judged by the library itself, wherever the page is opened. */
        async beginHere() {
            this.lay();
            this.checkButton.textContent = 'Check';
            this.tools.append(button('Fresh numbers', 'Deal other numbers', () => this.dealHere()));
            const draft = readDraft(this.name);
            await this.dealHere(draft?.value?.round ?? 0);
            if (draft?.value && this.view) {
                this.view.set(draft.value);
                this.fold.open = true;
            }
        }

        async dealHere(round = 1 + Math.floor(Math.random() * 9999)) {
            try {
                const facts = readFacts(await askForTable('tableau ' + this.tableau + ' ' + round));
                if (facts.error) {
                    throw new Error(facts.error);
                }
                this.view = new TableView(this.host, this);
                this.view.build(facts);
                this.starter.hidden = true;
                this.tell('');
            } catch {
                // The starter below still shows the table.
                this.fold.remove();
                explain(this);
            }
        }

        async checkHere() {
            const facts = readFacts(await askForTable(this.view.question()));
            this.view.judge(facts);
            this.verdict.hidden = false;
            this.verdict.className = 'verdict ' + (facts.say[0] === 'right' ? 'passed' : facts.say[0] === 'wrong' ? 'failed' : '');
            this.verdict.replaceChildren(element('p', { className: 'verdict-summary', textContent: facts.say[1] }));
        }
    }

    /** Says how to get Check where there is no server, or no permission. */
    function explain(practice) {
        const how = element('p', { className: 'practice-how', hidden: true });
        const code = text => element('code', { textContent: text });
        if (window.workbookServer) {
            how.append('This page is open for reading. Open the link that ', code('cargo run'),
                ' has printed in the terminal, and your answer is checked here.');
        } else {
            how.append('A page without a server cannot run programs. In the folder of the workbook, ', code('cargo run'),
                ' opens the same page with an editor and Check; in a terminal, ', code('cargo run -- start ' + practice.name),
                ' and ', code('cargo run -- check'), ' do the same.');
        }
        const open = button(practice.kind === 'explain' ? 'Compare' : 'Check', 'How to check an answer', () => { how.hidden = !how.hidden; });
        open.className = 'practice-check';
        const before = practice.section.querySelector(':scope > details');
        practice.section.insertBefore(element('div', { className: 'practice-tools' }, open), before);
        practice.section.insertBefore(how, before);
    }

    // ---- All exercises of the page ----

    const practices = Array.from(document.querySelectorAll('section.practice[data-exercise]'), section => new Practice(section));
    // On the page of all exercises, a mark before each that was begun.
    const rows = new Map();
    for (const link of document.querySelectorAll('table.exercises a[href*="#exercise--"]')) {
        rows.set(link.hash.replace('#exercise--', '').replace('--', '/'), link);
    }

    if (!mayRun) {
        for (const practice of practices) {
            if (practice.tableau) {
                practice.beginHere();
            } else {
                explain(practice);
            }
        }
        return;
    }

    practices.forEach(practice => practice.begin());

    async function look() {
        const names = new Set([...practices.map(practice => practice.name), ...rows.keys()]);
        if (names.size === 0) {
            return;
        }
        const asked = fetch('/__workbook/exercises?' + new URLSearchParams({ names: Array.from(names).join(',') }));
        try {
            const standings = await (await answered(asked)).json();
            for (const standing of standings) {
                const practice = practices.find(practice => practice.name === standing.exercise);
                if (standing.problem) {
                    practice?.tell(standing.problem, true);
                    continue;
                }
                // While an answer is under way, its reply says how things stand.
                if (practice && !practice.busy) {
                    practice.take(standing);
                }
                const link = rows.get(standing.exercise);
                if (link) {
                    link.dataset.state = standing.solved ? 'solved' : standing.digest !== null ? 'begun' : '';
                }
            }
        } catch (error) {
            practices.forEach(practice => practice.tell(error.message, true));
        }
    }

    // The script of the server waits for news, and tells of the first at once.
    document.addEventListener('workbook-answers', look);
})();
