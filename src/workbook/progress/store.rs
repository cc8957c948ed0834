//! The file of the progress: one writer at a time, whole at any moment, never thrown away.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};

use serde::Deserialize;
use thiserror::Error;

use super::{Progress, VERSION};
use crate::workbook::durable;

/// The name of the file in the folder of answers.
pub const FILE: &str = "progress.json";

/// The progress cannot be read or kept.
#[derive(Debug, Error)]
pub enum ProgressError {
    /// A file cannot be read or written.
    #[error("`{}` cannot be read or written ({source})\nnext step: see that the folder exists and is yours", path.display())]
    File {
        /// The file.
        path: PathBuf,
        /// What the operating system says.
        source: io::Error,
    },
    /// A file is no record of progress.
    #[error("`{}` is no record of progress: {reason}\nnext step: name a file that `progress export` has written", path.display())]
    Unreadable {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        reason: String,
    },
    /// A file would be overwritten.
    #[error("`{}` exists already, and it is left alone\nnext step: name a new file", .0.display())]
    Exists(PathBuf),
}

impl ProgressError {
    fn file(path: &Path) -> impl FnOnce(io::Error) -> Self {
        let path = path.to_path_buf();
        move |source| Self::File { path, source }
    }
}

/// The progress of a folder of answers.
#[derive(Debug, Clone)]
pub struct Store {
    folder: PathBuf,
}

/// What a file holds.
enum Held {
    Nothing,
    Progress(Progress),
    /// It cannot be used: the word for the name of the copy, and the reason.
    Unusable(String, String),
}

impl Store {
    /// The progress that is kept in this folder of answers.
    pub fn new(folder: &Path) -> Self {
        Self {
            folder: folder.to_path_buf(),
        }
    }

    /// The file.
    pub fn file(&self) -> PathBuf {
        self.folder.join(FILE)
    }

    /// Reads the progress; a file that cannot be used is put aside, and the text says so.
    ///
    /// # Errors
    ///
    /// A file cannot be read or moved.
    pub fn read(&self) -> Result<(Progress, Option<String>), ProgressError> {
        match held(&self.file())? {
            Held::Nothing => Ok((Progress::default(), None)),
            Held::Progress(progress) => Ok((progress, None)),
            Held::Unusable(..) => {
                let _lock = self.lock()?;
                self.read_locked()
            }
        }
    }

    /// Reads the progress, changes it and writes it, while no other command can.
    ///
    /// Returns what `change` returns, and what is to be told about a file that could not be used.
    ///
    /// # Errors
    ///
    /// A file cannot be read or written; the old progress is still there then.
    pub fn update<T>(
        &self,
        change: impl FnOnce(&mut Progress) -> T,
    ) -> Result<(T, Option<String>), ProgressError> {
        let _lock = self.lock()?;
        let (old, notice) = self.read_locked()?;
        let mut progress = old.clone();
        let value = change(&mut progress);
        if progress != old {
            // Only the one who holds the lock writes, so what a killed command has left is written over.
            let file = self.file();
            bytes(&progress)
                .and_then(|text| durable::replace_by(".progress.new", &file, &text))
                .map_err(ProgressError::file(&file))?;
        }
        Ok((value, notice))
    }

    /// Writes the progress to a new file.
    ///
    /// # Errors
    ///
    /// The file exists, or cannot be written.
    pub fn export(&self, file: &Path) -> Result<Progress, ProgressError> {
        if file.exists() {
            return Err(ProgressError::Exists(file.to_path_buf()));
        }
        let (progress, _) = self.read()?;
        bytes(&progress)
            .and_then(|text| durable::replace(file, &text))
            .map_err(ProgressError::file(file))?;
        Ok(progress)
    }

    /// Takes over what another file knows; nothing that is known is forgotten.
    ///
    /// # Errors
    ///
    /// The file is no record of progress, or the result cannot be written.
    pub fn import(&self, file: &Path) -> Result<Progress, ProgressError> {
        let unreadable = |reason: String| ProgressError::Unreadable {
            path: file.to_path_buf(),
            reason,
        };
        let other = match held(file)? {
            Held::Progress(progress) => progress,
            Held::Nothing => return Err(unreadable("there is no such file".into())),
            Held::Unusable(_, reason) => return Err(unreadable(reason)),
        };
        let (progress, _) = self.update(|progress| {
            progress.join(other);
            progress.clone()
        })?;
        Ok(progress)
    }

    /// Waits until no other command changes the progress; the operating system frees it when this process ends.
    fn lock(&self) -> Result<File, ProgressError> {
        let path = self.folder.join(".progress.lock");
        let lock = || {
            fs::create_dir_all(&self.folder)?;
            let file = File::create(&path)?;
            file.lock()?;
            Ok(file)
        };
        lock().map_err(ProgressError::file(&path))
    }

    fn read_locked(&self) -> Result<(Progress, Option<String>), ProgressError> {
        let file = self.file();
        match held(&file)? {
            Held::Nothing => Ok((Progress::default(), None)),
            Held::Progress(progress) => Ok((progress, None)),
            Held::Unusable(word, reason) => {
                let aside = self.put_aside(&file, &word)?;
                let notice = format!(
                    "`{}` cannot be used: {reason}.\n\
                     It is kept as `{}`, and the progress begins anew; your answers are untouched.\n\
                     next step: mend the copy and `cargo run -- progress import` it, or check your answers again",
                    file.display(),
                    aside.display()
                );
                Ok((Progress::default(), Some(notice)))
            }
        }
    }

    /// Moves a file to the next free name.
    fn put_aside(&self, file: &Path, word: &str) -> Result<PathBuf, ProgressError> {
        let mut number = 1;
        let aside = loop {
            let aside = self.folder.join(format!("progress.{word}-{number}.json"));
            if !aside.exists() {
                break aside;
            }
            number += 1;
        };
        fs::rename(file, &aside).map_err(ProgressError::file(file))?;
        Ok(aside)
    }
}

fn held(file: &Path) -> Result<Held, ProgressError> {
    #[derive(Deserialize)]
    struct Versioned {
        version: u32,
    }
    let bytes = match fs::read(file) {
        Ok(bytes) => bytes,
        Err(e) if e.kind() == io::ErrorKind::NotFound => return Ok(Held::Nothing),
        Err(e) => return Err(ProgressError::file(file)(e)),
    };
    let broken = |e: serde_json::Error| Held::Unusable("broken".into(), in_words(&bytes, &e));
    // The version comes first: a newer format may look quite different.
    Ok(match serde_json::from_slice::<Versioned>(&bytes) {
        Ok(Versioned { version }) if version > VERSION => Held::Unusable(
            format!("version-{version}"),
            format!(
                "a newer workbook has written it (version {version}, this one knows {VERSION})"
            ),
        ),
        Ok(_) => serde_json::from_slice(&bytes).map_or_else(broken, Held::Progress),
        Err(e) => broken(e),
    })
}

/// What is wrong with a file, without the words of the parser.
fn in_words(bytes: &[u8], error: &serde_json::Error) -> String {
    use serde_json::error::Category;
    let line = error.line();
    if bytes.trim_ascii().is_empty() {
        return "it is empty".into();
    }
    match error.classify() {
        Category::Eof => format!("it breaks off in line {line}"),
        Category::Syntax => format!("line {line} is no JSON"),
        Category::Data | Category::Io => {
            format!("line {line} does not fit a record of progress")
        }
    }
}

/// The text of the file.
fn bytes(progress: &Progress) -> io::Result<Vec<u8>> {
    let mut text = serde_json::to_vec_pretty(progress)?;
    text.push(b'\n');
    Ok(text)
}
