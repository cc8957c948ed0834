// What a reader has typed and not saved yet, kept in this browser for all its tabs.
(function () {
    'use strict';

    const keyOf = name => 'workbook-draft:' + name;

    function readDraft(name) {
        try {
            return JSON.parse(localStorage.getItem(keyOf(name)));
        } catch {
            return null;
        }
    }

    /** Keeps a draft; without one it is forgotten. A browser may refuse to keep anything, and nothing else depends on it. */
    function keepDraft(name, draft) {
        try {
            if (draft) {
                localStorage.setItem(keyOf(name), JSON.stringify(draft));
            } else {
                localStorage.removeItem(keyOf(name));
            }
        } catch {
            // The text is still in its field.
        }
    }

    window.workbookDrafts = { readDraft, keepDraft, keyOf };
})();
