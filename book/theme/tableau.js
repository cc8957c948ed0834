// A tableau as a table of fields. What an entry is worth is decided in Rust (`tableaux::answer`): by the local server, or
// in the page where there is none.
(function () {
    'use strict';

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
    const same = (a, b) => JSON.stringify(a) === JSON.stringify(b);

    /** The answer of the server; the error says why there is none. */
    async function answered(request) {
        let response;
        try {
            response = await request;
        } catch (error) {
            throw error.name === 'AbortError'
                ? error
                : new Error('The server does not answer. What you have written is kept in this browser.');
        }
        if (!response.ok) {
            throw new Error(await response.text());
        }
        return response;
    }

    /** Judges a table: by the local server, or in the page. */
    async function askForTable(question) {
        if (window.workbookServer) {
            return (await answered(fetch('/__workbook/figure', { method: 'POST', body: question }))).text();
        }
        const ask = await window.workbookAsk('tableaux');
        return ask(question);
    }

    /** The facts of a table (`tableaux::answer`): its task, its cells, and how it stands. */
    function readFacts(text) {
        const facts = { task: '', round: 0, cells: [], say: ['open', ''], error: null };
        for (const line of text.split('\n')) {
            const [name, ...fields] = line.split('\t');
            if (name === 'cell') {
                const [row, column, label, state, text, words] = fields;
                facts.cells.push({ row: Number(row), column: Number(column), label, state, text, words });
            } else if (name === 'say') {
                facts.say = fields;
            } else if (name === 'round') {
                facts.round = Number(fields[0]);
            } else if (name in facts) {
                facts[name] = fields[0];
            }
        }
        return facts;
    }

    class TableView {
        constructor(host, practice) {
            this.host = host;
            this.practice = practice;
            this.fields = new Map();
            this.host.className = 'tableau-host';
        }

        static valueOf(standing) {
            const facts = readFacts(standing.tableau);
            const rows = [];
            for (const cell of facts.cells) {
                (rows[cell.row] ??= [])[cell.column] = cell.text;
            }
            return { fields: rows, round: facts.round };
        }

        /** Lays out the table of these facts. */
        build(facts) {
            this.facts = facts;
            this.fields.clear();
            const table = element('table', { className: 'tableau' });
            const size = 1 + Math.max(...facts.cells.map(cell => cell.row));
            const rows = Array.from({ length: size }, () => table.insertRow());
            for (const cell of facts.cells) {
                const at = rows[cell.row].insertCell();
                const name = element('span', { className: 'tableau-name', textContent: cell.label });
                if (cell.column === 0) {
                    at.append(name, element('span', { className: 'tableau-given', textContent: cell.text }));
                    continue;
                }
                const field = element('input', {
                    type: 'text', autocomplete: 'off', spellcheck: false, size: 9, placeholder: '?',
                });
                field.autocapitalize = 'off';
                field.setAttribute('aria-label', cell.label + ', row ' + cell.row + ', column ' + cell.column);
                field.addEventListener('input', () => {
                    this.mark(field, '', '');
                    this.practice.changed();
                });
                field.addEventListener('keydown', event => {
                    // The book turns its pages by keys.
                    event.stopPropagation();
                    if (event.key === 'Enter') {
                        this.practice.check();
                    }
                });
                at.append(element('label', {}, name, field));
                this.fields.set(cell.row + ' ' + cell.column, field);
            }
            this.host.replaceChildren(
                element('p', { className: 'tableau-task', textContent: 'To compute: ' + facts.task + '.' }),
                element('div', { className: 'table-wrapper' }, table));
        }

        mark(field, state, words) {
            field.closest('td').dataset.state = state;
            field.title = words;
            field.setAttribute('aria-invalid', state === 'wrong' || state === 'unreadable');
        }

        /** Shows what each cell is worth. */
        judge(facts) {
            for (const cell of facts.cells) {
                const field = this.fields.get(cell.row + ' ' + cell.column);
                if (field) {
                    this.mark(field, cell.state, cell.words);
                }
            }
        }

        value() {
            const rows = [];
            for (const cell of this.facts.cells) {
                const field = this.fields.get(cell.row + ' ' + cell.column);
                (rows[cell.row] ??= [])[cell.column] = field ? field.value.trim() : cell.text;
            }
            return { fields: rows, round: this.facts.round };
        }

        set(value) {
            if (!Array.isArray(value.fields) || same(value, this.value())) {
                return;
            }
            for (const [key, field] of this.fields) {
                const [row, column] = key.split(' ');
                field.value = value.fields[row]?.[column] ?? '';
                this.mark(field, '', '');
            }
        }

        question() {
            const { fields, round } = this.value();
            return ['tableau ' + this.practice.tableau + ' ' + round, ...fields.map(row => row.join('\t'))].join('\n');
        }

        shown(value) {
            return (value.fields ?? []).map(row => row.map(text => text || '?').join('   ')).join('\n');
        }
    }

    window.workbookTable = { answered, readFacts, TableView, askForTable };
})();
