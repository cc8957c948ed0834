//! The mdBook preprocessor: the manuscript goes in, the pages of the site come out.
//!
//! The same code runs in process, when the workbook builds the book, and as the command that stock mdBook calls.

use std::io::{Read, Write};
use std::num::NonZero;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex};

use mdbook_preprocessor::book::{Book, BookItem, Chapter};
use mdbook_preprocessor::errors::Result;
use mdbook_preprocessor::{Preprocessor, PreprocessorContext, parse_input};

use super::catalogue::Catalogue;
use super::data::Data;
use super::error::BookErrors;
use super::evidence::AllEvidence;
use super::exercise::Exercises;
use super::expand::{Expansion, Lines, exercises_of_page};
use super::laws::Laws;
use super::lint;
use super::manuscript::Manuscript;
use super::pages::{Generated, generate};
use super::registry::Registry;
use super::site::{Parts, Site};

/// The name under which `book.toml` lists it.
pub const NAME: &str = "workbook";

/// Expands the directives of the manuscript and adds the generated pages.
#[derive(Clone)]
pub struct Workbook {
    registry: Arc<Registry>,
    with_solutions: bool,
}

impl Default for Workbook {
    fn default() -> Self {
        Self::new(Registry::of_all_chapters())
    }
}

impl Workbook {
    /// The preprocessor with these figures and computed texts.
    pub fn new(registry: Registry) -> Self {
        Self {
            registry: Arc::new(registry),
            with_solutions: true,
        }
    }

    /// The same without the solutions of the exercises, to hand out.
    #[must_use]
    pub fn without_solutions(mut self) -> Self {
        self.with_solutions = false;
        self
    }

    /// Expands a book whose `book.toml` stands in `root/book`.
    ///
    /// # Errors
    ///
    /// Everything that is wrong with the book, at once.
    pub fn expand(&self, root: &Path, book: &mut Book) -> std::result::Result<(), BookErrors> {
        let mut errors = Vec::new();
        let catalogue = Catalogue::load(root).unwrap_or_else(|e| {
            errors.extend(e.iter().cloned());
            Catalogue::default()
        });
        let data = Data::load(root, &mut errors);
        let mut sources: Vec<(PathBuf, String)> = Vec::new();
        for chapter in book.chapters() {
            if let Some(path) = &chapter.source_path {
                let file = Path::new("book/src").join(path);
                sources.push((file, chapter.content.clone()));
            }
        }
        let exercises = Exercises::load(root, &[], &catalogue).unwrap_or_else(|e| {
            errors.extend(e.iter().cloned());
            Exercises::default()
        });
        let manuscript = Manuscript::new(sources, &catalogue, &mut errors);
        for page in &manuscript.pages {
            lint::check(page, &mut errors);
        }
        let laws = Laws::find(root);
        let parts = Parts {
            root,
            catalogue: &catalogue,
            data: &data,
            manuscript: &manuscript,
            registry: &self.registry,
            laws: &laws,
            exercises: &exercises,
            with_solutions: self.with_solutions,
        };
        let site = Site::new(parts, errors);
        let expanded = std::thread::scope(|scope| {
            scope.spawn(|| find_evidence(&site));
            in_parallel(manuscript.pages.len(), |index| {
                let page = &manuscript.pages[index];
                let address = site.address(index);
                let expansion = Expansion {
                    site: &site,
                    page,
                    address: &address,
                    repeated: false,
                    lines: Lines::Same,
                };
                let mut text = expansion.expand(0..page.text.len());
                text.push_str(&exercises_of_page(&site, index));
                text
            })
        });
        let generated = generate(&site);
        BookErrors::none_of(site.into_errors())?;
        let mut contents = expanded.into_iter();
        replace(&mut book.items, &mut contents);
        book.items.push(BookItem::Separator);
        book.items
            .extend(generated.into_iter().map(|page| chapter(page, &[])));
        Ok(())
    }
}

/// Looks up the evidence, for which the expansions wait.
fn find_evidence(site: &Site<'_>) {
    let find = || {
        AllEvidence::find(
            site.root,
            site.catalogue,
            site.manuscript,
            site.exercises,
            site.registry,
        )
    };
    let found = std::panic::catch_unwind(std::panic::AssertUnwindSafe(find));
    let (evidence, panic) = match found {
        Ok(Ok(evidence)) => (evidence, None),
        Ok(Err(errors)) => {
            for error in errors.iter() {
                site.report(error.clone());
            }
            (AllEvidence::default(), None)
        }
        Err(panic) => (AllEvidence::default(), Some(panic)),
    };
    // Whatever happens, nobody waits for ever.
    site.evidence.get_or_init(|| evidence);
    if let Some(panic) = panic {
        std::panic::resume_unwind(panic);
    }
}

/// The values of `work` at `0..count`, computed by as many threads as the machine runs at once.
fn in_parallel<T: Send>(count: usize, work: impl Fn(usize) -> T + Sync) -> Vec<T> {
    let next = AtomicUsize::new(0);
    let done = Mutex::new(Vec::with_capacity(count));
    let threads = std::thread::available_parallelism().map_or(1, NonZero::get);
    std::thread::scope(|scope| {
        for _ in 0..threads.min(count) {
            scope.spawn(|| {
                loop {
                    let index = next.fetch_add(1, Ordering::Relaxed);
                    if index >= count {
                        break;
                    }
                    let value = work(index);
                    let mut done = done.lock().unwrap_or_else(|e| e.into_inner());
                    done.push((index, value));
                }
            });
        }
    });
    let mut done = done.into_inner().unwrap_or_else(|e| e.into_inner());
    done.sort_by_key(|(index, _)| *index);
    done.into_iter().map(|(_, value)| value).collect()
}

/// Puts the expanded contents in the place of the written ones, in the same order.
fn replace(items: &mut [BookItem], contents: &mut impl Iterator<Item = String>) {
    for item in items {
        if let BookItem::Chapter(chapter) = item {
            if !chapter.is_draft_chapter()
                && chapter.source_path.is_some()
                && let Some(content) = contents.next()
            {
                chapter.content = content;
            }
            replace(&mut chapter.sub_items, contents);
        }
    }
}

/// A generated page as a chapter of mdBook.
fn chapter(page: Generated, parents: &[String]) -> BookItem {
    let mut chapter = Chapter::new(&page.name, page.content, page.path, parents.to_vec());
    chapter.source_path = None;
    let mut parents = parents.to_vec();
    parents.push(page.name);
    chapter.sub_items = page
        .below
        .into_iter()
        .map(|below| self::chapter(below, &parents))
        .collect();
    BookItem::Chapter(chapter)
}

impl Preprocessor for Workbook {
    fn name(&self) -> &str {
        NAME
    }

    fn run(&self, context: &PreprocessorContext, mut book: Book) -> Result<Book> {
        let root = package_root(&context.root);
        self.expand(&root, &mut book)?;
        Ok(book)
    }

    fn supports_renderer(&self, renderer: &str) -> Result<bool> {
        Ok(supports(renderer))
    }
}

/// Whether the pages can be rendered by this renderer of mdBook: they are HTML.
pub fn supports(renderer: &str) -> bool {
    renderer == "html"
}

/// The root of the package whose book stands in `book_root`.
fn package_root(book_root: &Path) -> PathBuf {
    let absolute = std::path::absolute(book_root).unwrap_or_else(|_| book_root.to_owned());
    match absolute.parent() {
        Some(parent) => parent.to_owned(),
        None => absolute,
    }
}

/// What stock mdBook calls: reads a book as JSON from `input`, writes the expanded one to `output`.
///
/// # Errors
///
/// Input that is not mdBook's, output that cannot be written, and [`BookErrors`] for a book with errors.
pub fn run_as_command(input: impl Read, output: impl Write) -> Result<()> {
    let (context, book) = parse_input(input)?;
    let book = Workbook::default().run(&context, book)?;
    serde_json::to_writer(output, &book)?;
    Ok(())
}
