// Live figures: moves handles and sliders, asks for the picture, shows the answer. What a figure looks like is decided
// in Rust (`src/live/`): compiled to wasm for a site without a server, or asked of the local server.
(function () {
    'use strict';

    const figures = new Map();
    for (const figure of document.querySelectorAll('figure.drawing[data-figure]')) {
        // A figure that a page shows twice answers where it stands first.
        if (!figures.has(figure.dataset.figure)) {
            figures.set(figure.dataset.figure, figure);
        }
    }
    const root = document.currentScript.src.replace(/[^/]*$/, '').replace(/theme\/$/, '');

    // ---- Who answers ----

    /** Answers a question about a part of the figures in the page; the promise fails where there is no wasm build. */
    async function fromWasm(part) {
        await new Promise((resolve, reject) => {
            const script = document.createElement('script');
            script.src = root + 'figures-' + part + '.js';
            script.onload = resolve;
            script.onerror = () => reject(new Error('this site was built without live figures'));
            document.head.append(script);
        });
        const packed = Uint8Array.from(atob(window.cagdFigures[part]), c => c.charCodeAt(0));
        const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
        const module = await WebAssembly.compile(await new Response(stream).arrayBuffer());
        // What the drawing code never calls is imported all the same.
        const imports = {};
        for (const { module: from, name } of WebAssembly.Module.imports(module)) {
            (imports[from] ??= {})[name] = () => { throw new Error(name + ' is not to be called'); };
        }
        const start = async () => (await WebAssembly.instantiate(module, imports)).exports;
        let exports = await start();
        const utf8 = { encode: new TextEncoder(), decode: new TextDecoder() };
        return async question => {
            const bytes = utf8.encode.encode(question);
            try {
                // The memory may grow, and is another one then: it is asked for last.
                const room = exports.question(bytes.length);
                new Uint8Array(exports.memory.buffer, room, bytes.length).set(bytes);
                const length = exports.ask();
                const at = exports.reply();
                return utf8.decode.decode(new Uint8Array(exports.memory.buffer, at, length));
            } catch (error) {
                // After a panic nothing inside is to be trusted.
                exports = await start();
                throw error;
            }
        };
    }

    /** Answers a question by the local server. */
    function fromServer() {
        return async question => {
            const response = await fetch('/__workbook/figure', { method: 'POST', body: question });
            if (!response.ok) {
                throw new Error('the server does not answer');
            }
            return response.text();
        };
    }

    const answering = {};
    /** The one who answers for a part of the figures, found once. */
    function ask(part) {
        answering[part] ??= window.workbookServer ? Promise.resolve(fromServer()) : fromWasm(part);
        return answering[part];
    }

    // For tableaux, which are judged by the same program, and for tests, which compare the two ways and measure them.
    window.workbookAsk = ask;
    if (figures.size === 0) {
        return;
    }
    const alive = new Map();
    window.workbookShow = (id, text) => alive.get(id).show(read(text));

    // ---- What an answer says ----

    /** The facts of an answer by name, and its picture. */
    function read(text) {
        const end = text.indexOf('\n\n');
        const facts = { handle: [], slider: [], stepper: [], law: [], remark: [], svg: text.slice(end + 2) };
        for (const line of text.slice(0, end).split('\n')) {
            const [name, ...fields] = line.split('\t');
            if (Array.isArray(facts[name])) {
                facts[name].push(fields);
            } else {
                facts[name] = fields;
            }
        }
        return facts;
    }

    // ---- One figure ----

    const element = (name, attributes = {}, ...children) => {
        const made = document.createElement(name);
        for (const [key, value] of Object.entries(attributes)) {
            if (key in made && key !== 'style') {
                made[key] = value;
            } else {
                made.setAttribute(key, value);
            }
        }
        made.append(...children);
        return made;
    };

    /** The drawing that a text describes. */
    const parsed = text => {
        const made = document.createElement('template');
        made.innerHTML = text;
        return made.content.querySelector('svg');
    };

    /**
     * Makes an element, which the line `before` describes, the one of the line `after`, if they differ in nothing but
     * values of its own attributes; says whether it did. Most lines of a drag are of this kind and need not be parsed.
     */
    function rewrite(element, before, after) {
        const [head, old] = [after, before].map(line => line.slice(0, line.indexOf('>')));
        const names = text => text.replace(/"[^"]*"/g, '');
        if (after.slice(head.length) !== before.slice(old.length) || names(head) !== names(old) || head.includes('&')) {
            return false;
        }
        for (const [, name, value] of head.matchAll(/ ([\w-]+)="([^"]*)"/g)) {
            if (element.getAttribute(name) !== value) {
                element.setAttribute(name, value);
            }
        }
        return true;
    }

    /**
     * Makes a drawing look like another one and returns it. What is the same stays, so that the browser need not lay
     * it out again: most of a picture does not change from one step of a drag to the next.
     */
    function become(old, fresh) {
        if (old.isEqualNode(fresh)) {
            return old;
        }
        const [before, after] = [[...old.childNodes], [...fresh.childNodes]];
        const names = node => node.nodeName + (node.getAttributeNames?.() ?? '');
        if (names(old) !== names(fresh) || before.length !== after.length) {
            old.replaceWith(fresh);
            return fresh;
        }
        if (old.nodeType !== Node.ELEMENT_NODE) {
            if (old.nodeValue !== fresh.nodeValue) {
                old.nodeValue = fresh.nodeValue;
            }
            return old;
        }
        for (const name of fresh.getAttributeNames()) {
            const value = fresh.getAttribute(name);
            if (old.getAttribute(name) !== value) {
                old.setAttribute(name, value);
            }
        }
        before.forEach((child, i) => become(child, after[i]));
        return old;
    }

    /** Writes a text where another one stands; the same again would be work for the browser. */
    const write = (element, text) => {
        if (element.textContent !== text) {
            element.textContent = text;
        }
    };

    /** How many claims of laws stand beside a figure; the others unfold. */
    const MOST_CLAIMS = 6;

    class Live {
        constructor(figure) {
            this.figure = figure;
            this.id = figure.dataset.figure;
            this.svg = figure.querySelector('svg');
            /** The lines of the picture that is shown, and the element of each. */
            this.lines = [];
            this.elements = [];
            this.values = new URLSearchParams(location.search).get(this.id) ?? '';
            this.handles = new Map();
            this.controls = new Map();
            this.complaint = '';
            this.asking = false;
            /** What the reader has done and no answer knows yet: changes of the values, and where a handle went. */
            this.changes = [];
            this.drag = '';
        }

        async begin(answer) {
            this.answer = answer;
            this.picture = element('div', { className: 'live-picture' });
            // The picture has the size that it is told, not that of its content; until the first answer, that of the book.
            const { width, height } = this.svg.viewBox.baseVal;
            this.picture.style.aspectRatio = width + ' / ' + height;
            this.svg.replaceWith(this.picture);
            this.picture.append(this.svg);
            this.panel = element('div', { className: 'live-controls' });
            this.laws = element('div', { className: 'live-laws-list' });
            // Of a fixed height, so that new numbers do not lay out the page anew; the list says which height.
            this.lawsBox = element('div', { className: 'live-laws', hidden: true }, this.laws);
            new ResizeObserver(() => { this.lawsBox.style.height = this.laws.offsetHeight + 'px'; }).observe(this.laws);
            this.remarks = element('p', { className: 'live-remark', hidden: true });
            // Read out when it appears, not at every step of a drag.
            this.remarks.setAttribute('role', 'status');
            this.say = element('output', { className: 'live-say' });
            const button = (text, title, act) => {
                const made = element('button', { type: 'button', textContent: text, title });
                made.addEventListener('click', act);
                return made;
            };
            this.tools = element('div', { className: 'live-tools' },
                this.say,
                button('Reset', 'As the book shows it', () => this.reset()),
                button('Link', 'Copy a link that shows exactly this', event => this.link(event.target)),
                button('SVG', 'Save the picture', () => this.save()));
            this.picture.after(this.panel, this.tools, this.remarks, this.lawsBox);
            this.figure.classList.add('live');
            await this.draw();
        }

        /** Asks for the picture; what the reader does while one is being drawn waits for the next. */
        async draw() {
            if (this.asking) {
                return;
            }
            this.asking = true;
            this.values = this.changes.reduce((values, change) => change(values), this.values);
            const drag = this.drag;
            [this.changes, this.drag] = [[], ''];
            try {
                const text = await this.answer([this.id, this.values, drag].join('\n'));
                this.show(read(text));
            } catch (error) {
                this.complain(error.message);
            }
            this.asking = false;
            if (this.changes.length > 0 || this.drag !== '') {
                requestAnimationFrame(() => this.draw());
            }
        }

        show(facts) {
            if (facts.values) {
                this.values = facts.values[0];
            }
            if (facts.error) {
                this.complain(facts.error[0]);
                return;
            }
            this.complain('');
            this.showPicture(facts.svg);
            if (this.size?.join() !== facts.size.join()) {
                this.size = facts.size.map(Number);
                this.picture.style.aspectRatio = facts.size.join(' / ');
            }
            facts.handle.forEach(fields => this.placeHandle(fields));
            facts.slider.forEach(fields => this.placeControl(fields, 'any'));
            facts.stepper.forEach(fields => this.placeControl(fields, 1));
            this.showLaws(facts.law);
            this.showRemarks(facts.remark);
        }

        /** Shows a picture. It has one element a line: only the lines that changed are read again. */
        showPicture(text) {
            const lines = text.trimEnd().split('\n');
            const alike = lines.length === this.lines.length && lines[0] === this.lines[0];
            const changed = alike ? lines.flatMap((line, i) => line === this.lines[i] ? [] : [i]) : [];
            // A line outside of the elements, or the style sheet, which is not among them.
            if (!alike || changed.some(i => !this.elements[i])) {
                this.showAll(text, lines);
            } else if (changed.length > 0) {
                const others = changed.filter(i => !rewrite(this.elements[i], this.lines[i], lines[i]));
                const fresh = [...parsed('<svg>' + others.map(i => lines[i]).join('') + '</svg>').children];
                others.forEach((i, k) => { this.elements[i] = become(this.elements[i], fresh[k]); });
            }
            this.lines = lines;
        }

        /** Shows a picture of which nothing is known. */
        showAll(text, lines) {
            const svg = parsed(text);
            const elements = [...svg.children];
            // A style sheet that comes and goes makes the browser look at the whole page again; one stays.
            const style = svg.querySelector('style');
            if (style) {
                this.style ??= this.picture.appendChild(style.cloneNode(true));
                if (style.textContent === this.style.textContent) {
                    style.remove();
                }
            }
            this.svg.replaceWith(svg);
            this.svg = svg;
            // Between the lines that begin and end the picture each is an element, or nothing is known of any.
            const known = elements.length === lines.length - 2;
            this.elements = known ? [null, ...elements.map(e => e === style ? null : e), null] : [];
        }

        complain(message) {
            if (message !== this.complaint) {
                this.complaint = message;
                this.figure.classList.toggle('live-wrong', message !== '');
                this.say.textContent = message;
            }
        }

        placeHandle([name, index, x, y, words]) {
            const key = name + ' ' + index;
            let handle = this.handles.get(key);
            if (!handle) {
                handle = element('button', { type: 'button', className: 'live-handle' });
                handle.dataset.key = key;
                this.listen(handle);
                this.handles.set(key, handle);
                this.picture.append(handle);
            }
            const place = x + ' ' + y + ' ' + this.size;
            if (handle.place !== place) {
                handle.place = place;
                handle.at = [Number(x), Number(y)];
                // In hundredths of the width of the picture: what is translated need not be laid out anew.
                handle.style.translate = handle.at.map(c => 100 * c / this.size[0] + 'cqw').join(' ');
            }
            if (handle.words !== words) {
                handle.words = words;
                handle.setAttribute('aria-label', words + ', move it with the arrow keys');
                handle.title = words;
            }
            if (handle.moving || document.activeElement === handle) {
                this.say.textContent = words;
            }
        }

        /** Moves a handle by mouse, finger and keys. */
        listen(handle) {
            const go = at => {
                const [width, height] = this.size;
                const inside = [Math.min(Math.max(at[0], 0), width), Math.min(Math.max(at[1], 0), height)];
                this.drag = handle.dataset.key + ' ' + inside.map(c => c.toFixed(2)).join(' ');
                this.draw();
            };
            handle.addEventListener('pointerdown', event => {
                if (event.button !== 0) {
                    return;
                }
                handle.setPointerCapture(event.pointerId);
                handle.moving = true;
                handle.focus();
                event.preventDefault();
            });
            handle.addEventListener('pointermove', event => {
                if (handle.moving) {
                    const box = this.picture.getBoundingClientRect();
                    go([
                        (event.clientX - box.left) / box.width * this.size[0],
                        (event.clientY - box.top) / box.height * this.size[1],
                    ]);
                }
            });
            for (const end of ['pointerup', 'pointercancel']) {
                handle.addEventListener(end, () => { handle.moving = false; });
            }
            handle.addEventListener('focus', () => { this.say.textContent = handle.words; });
            handle.addEventListener('keydown', event => {
                const step = event.shiftKey ? 20 : 4;
                const move = { ArrowLeft: [-step, 0], ArrowRight: [step, 0], ArrowUp: [0, -step], ArrowDown: [0, step] }[event.key];
                if (move) {
                    go([handle.at[0] + move[0], handle.at[1] + move[1]]);
                    event.preventDefault();
                    // The book turns its pages by the arrow keys.
                    event.stopPropagation();
                }
            });
        }

        placeControl([name, low, high, value, words], step) {
            let control = this.controls.get(name);
            if (!control) {
                const range = step === 'any' ? (high - low) / 200 : 1;
                const input = element('input', { type: 'range', min: low, max: high, step: range });
                const shown = element('span', { className: 'live-value' });
                input.addEventListener('input', () => {
                    control.at = null;
                    this.set(name, input.value);
                });
                input.addEventListener('keydown', event => event.stopPropagation());
                // `at` is the value that the input was given; none once the reader has moved it.
                control = { input, shown, at: null };
                const row = element('label', { className: 'live-control' }, shown, input);
                this.panel.append(row);
                if (step === 'any') {
                    row.after(this.player(name, input));
                }
                this.controls.set(name, control);
            }
            if (control.words !== words) {
                control.words = words;
                control.shown.textContent = words;
                control.input.setAttribute('aria-valuetext', words);
            }
            const { input } = control;
            // Who moves an input by keys is not disturbed.
            const follows = document.activeElement !== input || input.playing;
            if (follows && control.at !== value) {
                input.value = value;
                control.at = value;
            }
        }

        /** A button that moves a slider from one end to the other. */
        player(name, input) {
            const button = element('button', { type: 'button', className: 'live-play', textContent: '▶', title: 'Play' });
            button.setAttribute('aria-label', 'Play ' + name);
            const stop = () => {
                input.playing = false;
                button.textContent = '▶';
                button.title = 'Play';
            };
            button.addEventListener('click', () => {
                if (input.playing) {
                    stop();
                    return;
                }
                input.playing = true;
                button.textContent = '❚❚';
                button.title = 'Pause';
                const [low, high] = [Number(input.min), Number(input.max)];
                let from = Number(input.value) >= high ? low : Number(input.value);
                let begun = null;
                const frame = now => {
                    // Paused, or the figure was reset.
                    if (!input.playing) {
                        stop();
                        return;
                    }
                    begun ??= now;
                    const at = Math.min(high, from + (high - low) * (now - begun) / 4000);
                    this.set(name, String(at));
                    if (at < high) {
                        requestAnimationFrame(frame);
                    } else {
                        stop();
                    }
                };
                requestAnimationFrame(frame);
            });
            return button;
        }

        /** Another value of a slider or stepper. */
        set(name, value) {
            this.changes.push(values => {
                const others = values.split('&').filter(pair => pair !== '' && !pair.startsWith(name + '='));
                return [...others, name + '=' + value].join('&');
            });
            this.draw();
        }

        /** Both sides of every claim; what is there already is only told the new numbers. */
        showLaws(laws) {
            const shape = laws.map(([statement, claim, , sign]) => [statement, claim, sign].join('\t')).join('\n');
            if (shape !== this.shape) {
                this.shape = shape;
                this.rows = [];
                const [parts, rest] = [[], []];
                let last = null;
                for (const [statement, claim, , sign] of laws) {
                    const place = this.rows.length < MOST_CLAIMS ? parts : rest;
                    if (statement !== last) {
                        last = statement;
                        const name = this.figure.querySelector('[data-law="' + CSS.escape(statement) + '"]');
                        place.push(element('p', { className: 'live-law' }, name ? name.firstChild.cloneNode(true) : statement));
                    }
                    const [left, right] = ['live-left', 'live-right'].map(className => element('span', { className }));
                    const agreement = element('span', { className: 'live-agreement' });
                    const row = element('div', { className: 'live-claim' },
                        element('span', { className: 'live-words', textContent: claim }),
                        element('span', { className: 'live-sides' }, left, ' ' + sign + ' ', right),
                        agreement);
                    place.push(row);
                    this.rows.push({ row, left, right, agreement });
                }
                this.more = null;
                if (rest.length > 0) {
                    this.more = element('summary');
                    const open = this.laws.querySelector('details')?.open ?? false;
                    parts.push(element('details', { className: 'live-more', open }, this.more, ...rest));
                }
                this.laws.replaceChildren(...parts);
                this.lawsBox.hidden = laws.length === 0;
            }
            laws.forEach(([, , left, , right, agreement, holds], i) => {
                const shown = this.rows[i];
                write(shown.left, left);
                write(shown.right, right);
                write(shown.agreement, (holds === 'holds' ? '✓ holds ' : '✗ fails ') + agreement);
                shown.row.classList.toggle('fails', holds !== 'holds');
            });
            if (this.more) {
                const rest = laws.slice(MOST_CLAIMS);
                const failing = rest.filter(law => law[6] !== 'holds').length;
                write(this.more, rest.length + ' more claims: ' + (failing === 0 ? 'all hold' : failing + ' fail'));
            }
        }

        /** What is special about this position. */
        showRemarks(remarks) {
            write(this.remarks, remarks.join(' '));
            this.remarks.hidden = remarks.length === 0;
        }

        reset() {
            for (const { input } of this.controls.values()) {
                input.playing = false;
            }
            [this.changes, this.drag] = [[() => ''], ''];
            this.draw();
        }

        async link(button) {
            const url = new URL(location.href);
            url.searchParams.set(this.id, this.values);
            url.hash = this.figure.id;
            history.replaceState(null, '', url);
            try {
                await navigator.clipboard.writeText(url.href);
                this.say.textContent = 'The link is copied.';
            } catch {
                this.say.textContent = 'The link is in the address bar.';
            }
            button.focus();
        }

        save() {
            const whole = this.svg.cloneNode(true);
            if (this.style && !whole.querySelector('style')) {
                const style = document.createElementNS('http://www.w3.org/2000/svg', 'style');
                style.textContent = this.style.textContent;
                whole.prepend(style);
            }
            const text = new XMLSerializer().serializeToString(whole);
            const url = URL.createObjectURL(new Blob([text], { type: 'image/svg+xml' }));
            element('a', { href: url, download: this.id + '.svg' }).click();
            setTimeout(() => URL.revokeObjectURL(url), 1000);
        }
    }

    // ---- All figures of the page, each when it comes into view ----

    const observer = new IntersectionObserver(entries => {
        for (const entry of entries.filter(entry => entry.isIntersecting)) {
            observer.unobserve(entry.target);
            ask(entry.target.dataset.part).then(
                answer => {
                    const live = new Live(entry.target);
                    alive.set(live.id, live);
                    return live.begin(answer);
                },
                // Without an answer the picture stays what it is: a picture.
                () => document.documentElement.classList.add('still'));
        }
    }, { rootMargin: '600px' });
    figures.forEach(figure => observer.observe(figure));
})();
