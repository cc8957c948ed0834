//! The exercises and answers, kept in memory as long as the sources stay as they are.

use std::collections::BTreeMap;
use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use crate::book::catalogue::CHAPTERS;
use crate::workbook::checking::Checker;
use crate::workbook::practice::{Desk, PracticeError};
use crate::workbook::progress;
use crate::workbook::sandbox::Isolation;

/// How often the answers are looked at while a page waits for news of them.
///
/// It costs a millisecond; a reader who saves in his editor looks at the page no sooner.
const LOOK: Duration = Duration::from_millis(400);

/// What the handlers work at.
#[derive(Debug, Clone)]
pub struct Desks {
    root: Arc<PathBuf>,
    answers: Arc<PathBuf>,
    pages: Arc<PathBuf>,
    open: Arc<Mutex<Option<Arc<Table>>>>,
    checker: Arc<Mutex<Option<Checker>>>,
}

/// A desk, and where the pages show its exercises.
#[derive(Debug)]
pub(super) struct Table {
    /// The build of the book to which it belongs.
    build: String,
    pub(super) desk: Desk,
    /// The addresses of the exercises, by name.
    pub(super) addresses: BTreeMap<String, String>,
}

impl Desks {
    /// The desks of the workbook at `root`, with the reader's answers and the built pages in these folders.
    pub fn new(root: &Path, answers: &Path, pages: &Path) -> Self {
        Self {
            root: Arc::new(root.to_path_buf()),
            answers: Arc::new(answers.to_path_buf()),
            pages: Arc::new(pages.to_path_buf()),
            open: Arc::default(),
            checker: Arc::default(),
        }
    }

    /// The desk for this build of the book; the exercises are read again after each.
    pub(super) fn table(&self, build: &str) -> Result<Arc<Table>, PracticeError> {
        let mut open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(table) = open.as_ref().filter(|table| table.build == build) {
            return Ok(Arc::clone(table));
        }
        let table = Arc::new(Table {
            build: build.to_owned(),
            desk: Desk::open(&self.root, &[], &self.answers)?,
            addresses: addresses(&self.pages),
        });
        *open = Some(Arc::clone(&table));
        Ok(table)
    }

    /// What checks answers; the library is compiled with the first check.
    ///
    /// A change of its sources starts this program anew, and with it the checker.
    pub(super) fn checker(&self) -> Result<Checker, PracticeError> {
        let mut checker = self.checker.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(checker) = checker.as_ref() {
            return Ok(checker.clone());
        }
        let new = Checker::new(&self.root, Isolation::best())?;
        Ok(checker.insert(new).clone())
    }

    /// Something that changes with the answers and the progress.
    pub fn stamp(&self) -> String {
        let mut hasher = DefaultHasher::new();
        let mut look_at = |file: &Path| {
            if let Ok(known) = fs::metadata(file) {
                (file, known.len(), known.modified().ok()).hash(&mut hasher);
            }
        };
        look_at(&self.answers.join(progress::FILE));
        for chapter in CHAPTERS {
            let entries = fs::read_dir(self.answers.join(chapter));
            let mut files: Vec<PathBuf> = entries
                .into_iter()
                .flatten()
                .flatten()
                .map(|entry| entry.path())
                .collect();
            files.sort();
            files.iter().for_each(|file| look_at(file));
        }
        format!("{:x}", hasher.finish())
    }

    /// Waits until the answers or the progress are no longer as they were.
    pub async fn changed_since(&self, stamp: &str) {
        loop {
            let desks = self.clone();
            let now = tokio::task::spawn_blocking(move || desks.stamp()).await;
            if now.is_ok_and(|now| now != stamp) {
                return;
            }
            tokio::time::sleep(LOOK).await;
        }
    }
}

/// Where the built pages show which exercise, from the top of the site.
fn addresses(pages: &Path) -> BTreeMap<String, String> {
    const MARK: &str = "class=\"practice\" id=\"";
    let mut found = BTreeMap::new();
    let mut folders = vec![pages.to_path_buf()];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).into_iter().flatten().flatten() {
            let path = entry.path();
            // The pages with sources are many, and show no exercise.
            if path.is_dir() && !path.ends_with("source") {
                folders.push(path);
                continue;
            }
            let (Ok(below), Ok(text)) = (path.strip_prefix(pages), fs::read_to_string(&path))
            else {
                continue;
            };
            if path.extension().is_none_or(|end| end != "html") {
                continue;
            }
            for rest in text.split(MARK).skip(1) {
                let anchor = rest.split('"').next().unwrap_or_default();
                if let Some(name) = anchor.strip_prefix("exercise--") {
                    let address = format!("{}#{anchor}", below.display());
                    found.insert(name.replacen("--", "/", 1), address);
                }
            }
        }
    }
    found
}
