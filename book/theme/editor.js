// The editor for code: a text field over the same text with colours. The field is the browser's own, so touch, screen
// readers, undo and every way of typing work; the colours come from the book's own highlighter.
//
//     const editor = workbookEditor(host, text, { language, label, onChange, onSubmit });
//     editor.text()        what stands there now
//     editor.set(text)     puts another text there; `onChange` is not called
//     editor.focus()
//     editor.markLine(n)   marks a line, counted from 1; without a number, none
//
// `host` is an element that the editor fills. `label` names the field for screen readers. `onChange` hears the text after
// every change by the reader; `onSubmit` hears Ctrl+Enter. Tab indents; Escape, then Tab leaves the field.
(function () {
    'use strict';

    const INDENT = '    ';

    window.workbookEditor = function (host, text, { language = 'rust', label = 'Code', onChange, onSubmit } = {}) {
        const make = (name, className) => {
            const made = document.createElement(name);
            made.className = className;
            return made;
        };
        const frame = make('div', 'code-editor');
        const sheet = make('div', 'code-editor-sheet');
        const mark = make('div', 'code-editor-mark');
        const paper = make('pre', 'code-editor-paper');
        const colours = make('code', 'hljs');
        const field = make('textarea', 'code-editor-field');
        mark.hidden = true;
        paper.setAttribute('aria-hidden', 'true');
        field.setAttribute('aria-label', label + '; Tab indents, Escape then Tab leaves');
        field.value = text;
        field.wrap = 'off';
        field.spellcheck = false;
        field.autocapitalize = 'off';
        field.autocomplete = 'off';
        field.setAttribute('autocorrect', 'off');
        paper.append(colours);
        sheet.append(mark, paper, field);
        frame.append(sheet);
        host.replaceChildren(frame);

        function colour() {
            const known = window.hljs?.getLanguage(language);
            // An empty last line has a height only if something stands on it.
            const shown = field.value + '\n';
            if (known) {
                colours.innerHTML = window.hljs.highlight(language, shown, true).value;
            } else {
                colours.textContent = shown;
            }
        }

        /** Types at the cursor, as the reader would, so that undo takes it back. */
        function type(text) {
            const done = text === '' ? document.execCommand('delete') : document.execCommand('insertText', false, text);
            if (!done) {
                field.setRangeText(text, field.selectionStart, field.selectionEnd, 'end');
                field.dispatchEvent(new Event('input'));
            }
        }

        const lineStart = at => field.value.lastIndexOf('\n', at - 1) + 1;
        const indentAt = start => field.value.slice(start).match(/^ */)[0];

        /** Changes every line of the selection; the lines stay selected. */
        function changeLines(change) {
            const from = lineStart(field.selectionStart);
            const newline = field.value.indexOf('\n', field.selectionEnd);
            const to = newline < 0 ? field.value.length : newline;
            const lines = field.value.slice(from, to).split('\n');
            const changed = change(lines).join('\n');
            field.setSelectionRange(from, to);
            type(changed);
            field.setSelectionRange(from, from + changed.length);
        }

        const outdented = line => line.replace(/^ {1,4}/, '');

        function comment(lines) {
            const full = lines.filter(line => line.trim() !== '');
            const all = full.every(line => line.trimStart().startsWith('//'));
            return lines.map(line => {
                if (line.trim() === '') {
                    return line;
                }
                return all ? line.replace(/^( *)\/\/ ?/, '$1') : line.replace(/^( *)/, '$1// ');
            });
        }

        let leaving = false;
        field.addEventListener('keydown', event => {
            // The book turns its pages and opens its search by keys.
            event.stopPropagation();
            const command = event.ctrlKey || event.metaKey;
            const left = leaving;
            leaving = event.key === 'Escape' || (leaving && event.key === 'Shift');
            const selected = field.value.slice(field.selectionStart, field.selectionEnd);
            if (event.isComposing || event.altKey) {
                return;
            }
            if (event.key === 'Enter' && command) {
                onSubmit?.();
            } else if (event.key === 'Tab' && !command && !left) {
                if (event.shiftKey) {
                    changeLines(lines => lines.map(outdented));
                } else if (selected.includes('\n')) {
                    changeLines(lines => lines.map(line => line && INDENT + line));
                } else {
                    const column = field.selectionStart - lineStart(field.selectionStart);
                    type(INDENT.slice(column % INDENT.length));
                }
            } else if (event.key === 'Enter' && !event.shiftKey) {
                const start = lineStart(field.selectionStart);
                const before = field.value.slice(start, field.selectionStart);
                const indent = indentAt(start).slice(0, before.length);
                const opens = /[{([]\s*$/.test(before);
                const closes = opens && /^[})\]]/.test(field.value.slice(field.selectionEnd));
                type('\n' + indent + (opens ? INDENT : ''));
                if (closes) {
                    const at = field.selectionStart;
                    type('\n' + indent);
                    field.setSelectionRange(at, at);
                }
            } else if (event.key === '}' && selected === '') {
                const start = lineStart(field.selectionStart);
                const before = field.value.slice(start, field.selectionStart);
                if (before === '' || before.trim() !== '') {
                    return;
                }
                field.setSelectionRange(start, field.selectionStart);
                type(outdented(before) + '}');
            } else if (event.key === '/' && command) {
                changeLines(comment);
            } else {
                return;
            }
            event.preventDefault();
        });
        field.addEventListener('input', () => {
            mark.hidden = true;
            colour();
            onChange?.(field.value);
        });
        colour();

        return {
            text: () => field.value,
            set(text) {
                field.value = text;
                mark.hidden = true;
                colour();
            },
            focus: () => field.focus({ preventScroll: true }),
            markLine(line) {
                mark.hidden = !line;
                mark.style.setProperty('--line-number', line || 1);
            },
        };
    };
})();
