//! Small books in temporary folders, and the book of this package, built once.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use cagd::book::build::build_with;
use cagd::book::error::BookErrors;
use cagd::book::preprocessor::Workbook;
use cagd::book::registry::{Drawing, RegisteredFigure, Registry};
use cagd::book::{BuildReport, build};
use tempfile::TempDir;

/// A book with one page, `book/src/bezier/page.md`.
pub(crate) struct Fixture {
    folder: TempDir,
    registry: Registry,
}

/// The statements that the fixture knows.
const CATALOGUE: &str = r#"[[statement]]
id = "bezier-hull"
kind = "theorem"
title = "Convex hull property"
sources = ["Compendium Theorem 8"]
needs = ["example"]

[[statement]]
id = "bezier-later"
kind = "lemma"
title = "A lemma for later"
sources = []
needs = []
"#;

const BOOK_TOML: &str = "[book]\ntitle = \"Fixture\"\n[build]\ncreate-missing = false\nuse-default-preprocessors = false\n";

impl Fixture {
    /// The book whose page has this text.
    pub(crate) fn new(page: &str) -> Self {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let fixture = Self {
            folder,
            registry: Registry::default()
                .with_figure(figure("bezier-picture", "A picture", "What it shows."))
                .with_computed("bezier", "half", || "$\\frac{1}{2}$".to_owned()),
        };
        fixture
            .with_file("book/book.toml", BOOK_TOML)
            .with_file("book/src/SUMMARY.md", "# Summary\n\n- [Page](bezier/page.md)\n")
            .with_file("book/src/bezier/page.md", page)
            .with_file("book/statements/bezier.toml", CATALOGUE)
            .with_file(
                "book/bibliography.toml",
                "[farin2002]\nshort = \"Farin 2002\"\nauthors = \"G. Farin\"\ntitle = \"Curves\"\npublished = \"MK\"\nyear = 2002\n",
            )
            .with_file(
                "book/glossary.toml",
                "[blossom]\nenglish = \"blossom\"\ngerman = \"Polarform\"\n",
            )
            .with_file("src/lib.rs", "/// Adds one.\n///\n/// More.\npub fn next(n: u8) -> u8 {\n    n + 1\n}\n")
    }

    /// With this file, in the place of one that may be there.
    pub(crate) fn with_file(self, path: &str, text: &str) -> Self {
        let path = self.folder.path().join(path);
        let parent = path.parent().expect("a file has a folder");
        std::fs::create_dir_all(parent).expect("the folder is made");
        std::fs::write(path, text).expect("the file is written");
        self
    }

    /// With this figure.
    pub(crate) fn with_figure(mut self, id: &str, title: &str, description: &str) -> Self {
        self.registry = self.registry.with_figure(figure(id, title, description));
        self
    }

    /// The folder of the package.
    pub(crate) fn root(&self) -> &Path {
        self.folder.path()
    }

    /// Builds the book into `out`, a path below the package.
    pub(crate) fn build_into(self, out: &str) -> (TempDir, Result<BuildReport, BookErrors>) {
        let out = self.folder.path().join(out);
        let report = build_with(self.folder.path(), &out, Workbook::new(self.registry), &[]);
        (self.folder, report)
    }

    /// The page as it is built.
    ///
    /// # Panics
    ///
    /// If the book has errors.
    #[track_caller]
    pub(crate) fn page(self) -> String {
        let (folder, report) = self.build_into("site");
        if let Err(errors) = report {
            panic!("{errors}");
        }
        let page = folder.path().join("site/bezier/page.html");
        std::fs::read_to_string(page).expect("the page is built")
    }

    /// The page of the site to hand out.
    ///
    /// # Panics
    ///
    /// If the book has errors.
    #[track_caller]
    pub(crate) fn page_without_solutions(self) -> String {
        let out = self.folder.path().join("site");
        let workbook = Workbook::new(self.registry).without_solutions();
        if let Err(errors) = build_with(self.folder.path(), &out, workbook, &[]) {
            panic!("{errors}");
        }
        std::fs::read_to_string(out.join("bezier/page.html")).expect("the page is built")
    }

    /// The errors of the book, each as `file:line: message`.
    ///
    /// # Panics
    ///
    /// If the book has none.
    #[track_caller]
    pub(crate) fn errors(self) -> Vec<String> {
        let (_folder, report) = self.build_into("site");
        match report {
            Ok(_) => panic!("the book was built in spite of its error"),
            Err(errors) => errors.iter().map(ToString::to_string).collect(),
        }
    }
}

/// A figure that draws a line.
fn figure(id: &str, title: &str, description: &str) -> RegisteredFigure {
    RegisteredFigure {
        id: id.to_owned(),
        title: title.to_owned(),
        description: description.to_owned(),
        live: None,
        draw: Box::new(|| {
            Ok(Drawing {
                svg: "<svg viewBox=\"0 0 1 1\">\n\n<path d=\"M0 0L1 1\" />\n</svg>\n".to_owned(),
                laws: vec![],
            })
        }),
    }
}

/// The book of this package, built once for all tests.
pub(crate) fn the_book() -> &'static Path {
    static SITE: OnceLock<(TempDir, PathBuf)> = OnceLock::new();
    let (_, out) = SITE.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let out = folder.path().join("site");
        if let Err(errors) = build(Path::new(env!("CARGO_MANIFEST_DIR")), &out) {
            panic!("{errors}");
        }
        (folder, out)
    });
    out
}

/// All files below `folder` with this extension, as paths relative to it, sorted.
pub(crate) fn files_below(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut open = vec![folder.to_owned()];
    while let Some(next) = open.pop() {
        for entry in std::fs::read_dir(&next).expect("the folder is read") {
            let path = entry.expect("the entry is read").path();
            if path.is_dir() {
                open.push(path);
            } else if extension.is_empty() || path.extension().is_some_and(|e| e == extension) {
                found.push(path.strip_prefix(folder).expect("it is below").to_owned());
            }
        }
    }
    found.sort();
    found
}
