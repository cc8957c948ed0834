// The index of statements: shows the rows that match words, chapter and kind.
(function () {
    'use strict';
    const form = document.getElementById('statement-filter');
    if (!form) {
        return;
    }
    const chapters = Array.from(document.querySelectorAll('.index-chapter'));

    function filter() {
        const words = form.elements.words.value.toLowerCase().split(/\s+/).filter(Boolean);
        const chapter = form.elements.chapter.value;
        const kind = form.elements.kind.value;
        let count = 0;
        for (const section of chapters) {
            let shown = 0;
            for (const row of section.querySelectorAll('tbody tr')) {
                const text = row.textContent.toLowerCase();
                const matches = (!chapter || section.dataset.chapter === chapter)
                    && (!kind || row.dataset.kind === kind)
                    && words.every(word => text.includes(word));
                row.hidden = !matches;
                shown += matches ? 1 : 0;
            }
            section.hidden = shown === 0;
            count += shown;
        }
        form.elements.count.value = count === 1 ? '1 statement' : count + ' statements';
    }

    form.hidden = false;
    form.addEventListener('input', filter);
    form.addEventListener('submit', event => event.preventDefault());
    filter();
})();
