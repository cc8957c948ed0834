//! Where the laws stand: `bezier::laws::convex_hull` is a function below `src/bezier/laws`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::catalogue::{CHAPTERS, Statement};
use super::directive::Options;
use super::error::Place;

/// The laws of all chapters, by chapter and name.
#[derive(Debug, Clone, Default)]
pub struct Laws {
    places: BTreeMap<(String, String), Place>,
}

impl Laws {
    /// Reads `src/<chapter>/laws.rs` and the files below `src/<chapter>/laws/`.
    pub fn find(root: &Path) -> Self {
        let mut laws = Self::default();
        for chapter in CHAPTERS {
            let mut files = vec![PathBuf::from(format!("src/{chapter}/laws.rs"))];
            rust_files(root, Path::new(&format!("src/{chapter}/laws")), &mut files);
            for file in files {
                laws.read(root, chapter, &file);
            }
        }
        laws
    }

    /// Adds the public functions of a file.
    ///
    /// They are the lines that begin with `pub fn`: the sources are formatted, so nothing else begins so. Parsing every
    /// law of the library would take longer than the rest of the preprocessor.
    fn read(&mut self, root: &Path, chapter: &str, file: &Path) {
        let Ok(source) = std::fs::read_to_string(root.join(file)) else {
            return;
        };
        for (index, line) in source.lines().enumerate() {
            let Some(rest) = line.strip_prefix("pub fn ") else {
                continue;
            };
            let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
            let name = &rest[..end.unwrap_or(rest.len())];
            self.places.insert(
                (chapter.to_owned(), name.to_owned()),
                Place::new(file, index + 1),
            );
        }
    }

    /// The laws of a statement: those its directive names, else the one of its own name, if there is one.
    pub fn of(&self, statement: &Statement, options: &Options) -> Vec<(String, Place)> {
        let names = match options.get("law") {
            Some(names) => names.clone(),
            None => vec![statement.code_name()],
        };
        names
            .into_iter()
            .filter_map(|name| {
                let key = (statement.chapter.to_owned(), name);
                let place = self.places.get(&key)?.clone();
                Some((format!("{}::laws::{}", key.0, key.1), place))
            })
            .collect()
    }
}

/// Adds the Rust files below `folder`, in the order of their names.
fn rust_files(root: &Path, folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = std::fs::read_dir(root.join(folder)) else {
        return;
    };
    let mut names: Vec<_> = entries.flatten().map(|entry| entry.file_name()).collect();
    names.sort();
    for name in names {
        let path = folder.join(name);
        if root.join(&path).is_dir() {
            rust_files(root, &path, files);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_law_is_found_with_its_line() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        std::fs::create_dir_all(folder.path().join("src/bezier/laws")).expect("it is made");
        let source = "//! Laws.\n\n/// One.\npub fn one<T>(t: T) {}\n\nfn helper() {}\n";
        let file = "src/bezier/laws/a.rs";
        std::fs::write(folder.path().join(file), source).expect("it is written");
        let laws = Laws::find(folder.path());
        let key = ("bezier".to_owned(), "one".to_owned());
        assert_eq!(laws.places.get(&key), Some(&Place::new(file, 4)));
        assert_eq!(laws.places.len(), 1);
    }
}
