//! Where the laws stand: `bezier::laws::convex_hull` is a function below `src/bezier/laws`.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use syn::{Item, Visibility};

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
    ///
    /// A file that is no Rust holds no laws; the compiler says what is wrong with it.
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
    fn read(&mut self, root: &Path, chapter: &str, file: &Path) {
        let Ok(source) = std::fs::read_to_string(root.join(file)) else {
            return;
        };
        let Ok(parsed) = syn::parse_file(&source) else {
            return;
        };
        for item in parsed.items {
            if let Item::Fn(function) = item
                && matches!(function.vis, Visibility::Public(_))
            {
                let name = function.sig.ident.to_string();
                let line = function.sig.ident.span().start().line;
                self.places
                    .insert((chapter.to_owned(), name), Place::new(file, line));
            }
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
