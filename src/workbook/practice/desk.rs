//! What a reader works with: the exercises, the answers, the progress.

use std::path::{Path, PathBuf};

use super::PracticeError;
use crate::book::catalogue::Catalogue;
use crate::book::error::most_similar;
use crate::book::exercise::{Exercise, ExerciseName, Exercises, Mistakes};
use crate::workbook::answers::Answers;
use crate::workbook::progress::{Entry, Progress, Store, digest};

/// Everything that a reader works with.
#[derive(Debug)]
pub struct Desk {
    /// The root of the workbook.
    pub root: PathBuf,
    /// All statements.
    pub catalogue: Catalogue,
    /// All exercises.
    pub exercises: Exercises,
    /// What is wrong with exercises that were left out.
    pub mistakes: Mistakes,
    /// The reader's answers.
    pub answers: Answers,
    /// The file of the progress.
    pub store: Store,
}

impl Desk {
    /// The desk of the workbook at `root`, with the exercises of these packs, and the answers in `folder`.
    ///
    /// # Errors
    ///
    /// The statements have errors; exercises with mistakes are left out, and `mistakes` tells them.
    pub fn open(root: &Path, packs: &[PathBuf], folder: &Path) -> Result<Self, PracticeError> {
        let catalogue = Catalogue::load(root)?;
        let (exercises, mistakes) = Exercises::load_sound(root, packs, &catalogue);
        Ok(Self {
            answers: Answers::new(root, folder),
            store: Store::new(folder),
            root: root.to_path_buf(),
            catalogue,
            exercises,
            mistakes,
        })
    }

    /// The exercise of this name; the chapter may be left out where the rest says which one is meant.
    ///
    /// # Errors
    ///
    /// There is none, with the most similar name.
    pub fn exercise(&self, name: &str) -> Result<&Exercise, PracticeError> {
        let parsed = name.parse::<ExerciseName>().ok();
        if let Some(exercise) = parsed.as_ref().and_then(|name| self.exercises.get(name)) {
            return Ok(exercise);
        }
        let mut short = self
            .exercises
            .iter()
            .filter(|exercise| exercise.name.name() == name);
        if let (Some(exercise), None) = (short.next(), short.next()) {
            return Ok(exercise);
        }
        let mut broken = self.mistakes.exercises.iter();
        let is_meant = |broken: &ExerciseName| broken.to_string() == name || broken.name() == name;
        if let Some((name, mistakes)) = broken.find(|(name, _)| is_meant(name)) {
            return Err(PracticeError::HasMistakes {
                name: name.clone(),
                mistakes: mistakes.clone(),
            });
        }
        if let Some(file) = parsed.and_then(|name| self.answers.any_file(&name)) {
            return Err(PracticeError::LeftTheBook {
                name: name.to_owned(),
                file: shown(&file),
            });
        }
        let similar = self.exercises.similar(name).or_else(|| {
            let names = self.exercises.iter().map(|exercise| exercise.name.name());
            let short = most_similar(name, names)?;
            let whole = self.exercises.iter().find(|e| e.name.name() == short)?;
            Some(whole.name.to_string())
        });
        Err(PracticeError::UnknownExercise {
            name: name.to_owned(),
            similar,
        })
    }

    /// The exercise of this name, or without a name the one begun last.
    ///
    /// # Errors
    ///
    /// There is none.
    pub fn exercise_or_last(
        &self,
        name: Option<&str>,
        progress: &Progress,
    ) -> Result<&Exercise, PracticeError> {
        match (name, &progress.begun_last) {
            (Some(name), _) => self.exercise(name),
            (None, Some(last)) => self.exercise(&last.to_string()),
            (None, None) => Err(PracticeError::NothingBegun),
        }
    }

    /// The progress; what is to be told about a file that cannot be used goes to standard error.
    ///
    /// # Errors
    ///
    /// The file cannot be read.
    pub fn progress(&self) -> Result<Progress, PracticeError> {
        let (progress, notice) = self.store.read()?;
        tell(notice);
        Ok(progress)
    }

    /// Changes the progress.
    ///
    /// # Errors
    ///
    /// The file cannot be read or written.
    pub fn update<T>(&self, change: impl FnOnce(&mut Progress) -> T) -> Result<T, PracticeError> {
        let (value, notice) = self.store.update(change)?;
        tell(notice);
        Ok(value)
    }

    /// Whether the starter is another than the one with which the reader began.
    pub fn starter_changed(&self, exercise: &Exercise, entry: &Entry) -> bool {
        match (&entry.starter, &exercise.tested, entry.seed) {
            (Some(known), Some(tested), None) => *known != digest(&tested.answer.starter),
            _ => false,
        }
    }

    /// Whether there is an answer, finished or not.
    pub fn is_begun(&self, exercise: &Exercise) -> bool {
        self.answers.file(exercise).is_file()
    }
}

fn tell(notice: Option<String>) {
    if let Some(notice) = notice {
        anstream::eprintln!("{notice}\n");
    }
}

/// The words behind `cargo run --`, with the pack without which the exercise would not be found.
pub fn typed(words: &str, exercise: &Exercise) -> String {
    let Some(pack) = exercise.pack() else {
        return words.to_owned();
    };
    let pack = shown(pack).display().to_string();
    format!("{words} --pack {}", quoted(&pack))
}

/// A word as a shell takes it for itself.
fn quoted(word: &str) -> String {
    let is_plain = |letter: char| letter.is_alphanumeric() || "/._-+@%,:=".contains(letter);
    if word.chars().all(is_plain) {
        word.to_owned()
    } else {
        format!("'{}'", word.replace('\'', r"'\''"))
    }
}

/// A path as the reader would type it: from where he stands, if it is below.
pub fn shown(path: &Path) -> PathBuf {
    let here = std::env::current_dir().unwrap_or_default();
    match path.strip_prefix(&here) {
        Ok(below) if below.as_os_str().is_empty() => PathBuf::from("."),
        Ok(below) => below.to_path_buf(),
        Err(_) => path.to_path_buf(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_folder_is_typed_as_a_shell_takes_it() {
        let typed = ["../exam", "my exam", "it's", "$HOME", "Prüfung-1"].map(quoted);
        let expected = ["../exam", "'my exam'", r"'it'\''s'", "'$HOME'", "Prüfung-1"];
        assert_eq!(typed, expected);
    }

    #[test]
    fn a_path_is_shown_from_where_the_reader_stands() {
        let here = std::env::current_dir().expect("a folder");
        assert_eq!(shown(&here.join("a/b")), Path::new("a/b"));
        assert_eq!(shown(&here), Path::new("."));
        assert_eq!(shown(Path::new("/elsewhere")), Path::new("/elsewhere"));
    }
}
