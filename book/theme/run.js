// Run: every Rust example of a page gets a foot with Run and Edit. The local server compiles the block, as edited,
// against the library; what it prints stands below. Edits stay in this browser until they are reset.
(function () {
    'use strict';

    const HOW = window.workbookServer
        ? 'To run code here, open the link that `cargo run` has printed in the terminal: it ends in `?token=…`.'
        : 'This copy of the book has no server that could run code. Call `cargo run` in the folder of the workbook, and open the link that it prints.';
    const mayRun = window.workbookServer?.mayRun === true;
    // Beyond this the first run is compiling the library.
    const SLOW = 3000;

    const make = (name, className, text = '') => {
        const made = document.createElement(name);
        made.className = className;
        made.textContent = text;
        return made;
    };
    const button = (className, text, title, act) => {
        const made = make('button', className, text);
        made.type = 'button';
        made.title = title;
        made.addEventListener('click', act);
        return made;
    };
    /** Text with `code` in it. */
    const words = text => text.split('`').map((part, index) => index % 2 ? make('code', '', part) : part);

    // ---- What the reader has written, by page and block ----

    /** A name for a block that stays when others come before it, and changes with its text. */
    function nameOf(text, sameBefore) {
        let hash = 0xcbf29ce484222325n;
        for (const byte of new TextEncoder().encode(text)) {
            hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
        }
        return 'workbook-run ' + location.pathname + ' ' + hash.toString(16) + '.' + sameBefore;
    }

    const kept = {
        read(name) {
            try {
                return localStorage.getItem(name);
            } catch {
                return null;
            }
        },
        write(name, text) {
            try {
                if (text === null) {
                    localStorage.removeItem(name);
                } else {
                    localStorage.setItem(name, text);
                }
            } catch {
                // Without a store, or with a full one, the edit lasts as long as the page.
            }
        },
    };

    // ---- What the compiler says, with a little colour ----

    function message(rendered) {
        const lines = rendered.trimEnd().split('\n').map(line => {
            const kind = /^(error|warning)\b/.exec(line)?.[1]
                ?? (/^\s*(= )?(help|note)\b/.test(line) ? 'hint' : null)
                ?? (/^\s*\|[\s|]*[\^_~-]/.test(line) ? 'point' : null)
                ?? (/^\s*(\d+\s*\||\||-->|:::)/.test(line) ? 'place' : 'plain');
            const made = make('span', 'said-' + kind, line);
            return [made, '\n'];
        });
        const said = make('pre', 'run-said');
        said.append(...lines.flat());
        return said;
    }

    // ---- One block ----

    class Example {
        constructor(pre, code, sameBefore) {
            this.pre = pre;
            this.original = code.textContent.replace(/\n$/, '');
            this.name = nameOf(this.original, sameBefore);
            this.expects = ['compile_fail', 'should_panic'].find(name => code.classList.contains(name));
            this.frame = make('div', 'run');
            this.host = make('div', 'run-editor');
            this.host.hidden = true;
            const go = this.expects === 'compile_fail' ? 'Compile' : 'Run';
            this.go = button('run-go', go, go + ' (Ctrl+Enter in the editor)', () => this.run());
            this.go.dataset.name = go;
            this.edit = button('run-edit', 'Edit', 'Change this example', () => this.open(this.text(), true));
            this.back = button('run-back', 'Reset', 'As the book has it', () => this.reset());
            this.back.hidden = true;
            this.say = make('span', 'run-say');
            this.say.setAttribute('role', 'status');
            this.bar = make('div', 'run-bar');
            this.bar.append(this.go, this.edit, this.back, this.say);
            this.result = make('div', 'run-result');
            this.result.hidden = true;
            pre.replaceWith(this.frame);
            this.frame.append(pre, this.host, this.bar, this.result);
            const edited = kept.read(this.name);
            if (edited !== null) {
                this.open(edited, false);
            }
        }

        text() {
            return this.editor ? this.editor.text() : this.original;
        }

        // ---- Editing ----

        /** Puts the editor in the place of the block. */
        open(text, takeFocus) {
            if (!mayRun) {
                this.explain();
                return;
            }
            this.editor = window.workbookEditor(this.host, text, {
                label: 'Example',
                onChange: changed => this.keep(changed),
                onSubmit: () => this.run(),
            });
            this.pre.hidden = true;
            this.host.hidden = false;
            this.edit.hidden = true;
            this.offerBack();
            if (takeFocus) {
                this.editor.focus();
            }
        }

        keep(text) {
            kept.write(this.name, text === this.original ? null : text);
            this.offerBack();
        }

        offerBack() {
            const changed = this.text() !== this.original;
            this.back.hidden = false;
            this.back.textContent = changed ? 'Reset' : 'Close';
            this.frame.classList.toggle('edited', changed);
        }

        /** Back to the block of the book; the edit can be had again until the page is left. */
        reset() {
            if (!this.editor) {
                const text = this.dropped;
                this.open(text, true);
                this.keep(text);
                return;
            }
            const edit = this.text();
            this.editor = null;
            this.host.replaceChildren();
            this.host.hidden = true;
            this.pre.hidden = false;
            this.edit.hidden = false;
            this.result.hidden = true;
            this.say.textContent = '';
            this.keep(this.original);
            this.dropped = edit;
            this.back.hidden = edit === this.original;
            this.back.textContent = 'Undo reset';
            (this.back.hidden ? this.edit : this.back).focus({ preventScroll: true });
        }

        // ---- Running ----

        explain() {
            this.result.replaceChildren(make('p', 'run-head'));
            this.result.firstChild.append(...words(HOW));
            this.result.hidden = false;
        }

        async run() {
            if (!mayRun) {
                this.explain();
                return;
            }
            if (this.running) {
                this.running.abort();
                return;
            }
            this.running = new AbortController();
            this.frame.classList.add('running');
            this.go.textContent = 'Stop';
            this.say.textContent = 'running …';
            this.editor?.markLine();
            const slow = setTimeout(() => {
                this.say.textContent = 'the first run compiles the library, which takes up to a minute; a long program is ended after 10 s';
            }, SLOW);
            try {
                const response = await fetch('/__workbook/run', {
                    method: 'POST',
                    headers: { 'Content-Type': 'application/json' },
                    body: JSON.stringify({ code: this.text() }),
                    signal: this.running.signal,
                });
                if (response.ok) {
                    this.show(await response.json());
                } else {
                    this.complain(await response.text());
                }
            } catch (error) {
                this.complain(error.name === 'AbortError' ? '' : 'The server does not answer. Is `cargo run` still running?');
            }
            clearTimeout(slow);
            this.running = null;
            this.frame.classList.remove('running');
            this.go.textContent = this.go.dataset.name;
        }

        complain(text) {
            this.say.textContent = text === '' ? 'stopped' : '';
            this.result.hidden = text === '';
            const head = make('p', 'run-head wrong');
            head.append(...words(text));
            this.result.replaceChildren(head);
        }

        show(run) {
            const errors = run.diagnostics.filter(diagnostic => diagnostic.level === 'error');
            const [heading, wrong] = this.heading(run, errors);
            const parts = [];
            if (heading !== '') {
                parts.push(make('p', wrong ? 'run-head wrong' : 'run-head', heading));
            }
            if (run.picture !== null) {
                // As a picture, no script in it runs.
                const picture = make('img', 'run-picture');
                picture.alt = 'What the program has drawn';
                picture.src = 'data:image/svg+xml,' + encodeURIComponent(withNamespace(run.picture));
                parts.push(picture);
            }
            if (run.output.trim() !== '') {
                parts.push(make('pre', 'run-output', run.output.trimEnd()));
            }
            if (run.errors.trim() !== '') {
                parts.push(make('pre', 'run-output run-errors', run.errors.trimEnd()));
            }
            parts.push(...run.diagnostics.map(diagnostic => message(diagnostic.rendered)));
            this.result.replaceChildren(...parts);
            this.result.hidden = parts.length === 0;
            this.say.textContent = (run.outcome === 'ran' && parts.length === 0 ? 'It runs; every assertion holds. ' : '')
                + run.seconds.toFixed(1) + ' s';
            const line = errors.find(error => error.line)?.line;
            if (line) {
                this.editor?.markLine(line);
            }
        }

        /** What stands above the result, and whether it is not as it should be. */
        heading(run, errors) {
            const changed = this.text() !== this.original;
            if (run.outcome === 'does_not_compile') {
                const meant = this.expects === 'compile_fail' && !changed;
                return meant ? ['As it should, the compiler refuses this:', false]
                    : [errors.length === 1 ? 'It does not compile.' : 'It does not compile: ' + errors.length + ' errors.', true];
            }
            if (run.outcome === 'failed') {
                const reason = run.reason.charAt(0).toUpperCase() + run.reason.slice(1) + '.';
                const meant = this.expects === 'should_panic' && !changed;
                return meant ? ['As it should, the program panics:', false] : [reason, true];
            }
            return [this.expects === 'compile_fail' ? 'Now it compiles and runs.' : '', false];
        }
    }

    /** A drawing inside a page needs no namespace, one by itself does. */
    const withNamespace = svg => /^<svg[^>]*\sxmlns=/.test(svg)
        ? svg : svg.replace('<svg', '<svg xmlns="http://www.w3.org/2000/svg"');

    const seen = new Map();
    for (const code of document.querySelectorAll('main pre > code.language-rust:not(.noplayground)')) {
        if (code.closest('section.practice')) {
            continue;
        }
        const before = seen.get(code.textContent) ?? 0;
        seen.set(code.textContent, before + 1);
        new Example(code.parentElement, code, before);
    }
})();
