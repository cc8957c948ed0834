//! The package that makes an editor complete in the answers.
//!
//! Each answer is a target of its own, an example, so that one that does not compile leaves the others alone.

use std::fs;
use std::path::{Path, PathBuf};

use sha2::{Digest, Sha256};

use super::AnswersError;
use crate::workbook::checking::library::{core_profile, hex};
use crate::workbook::durable;

/// Writes `Cargo.toml` and `Cargo.lock` of the answers in `folder`, for the workbook at `house`.
pub(super) fn update(house: &Path, folder: &Path) -> Result<(), AnswersError> {
    let lock_file = house.join("Cargo.lock");
    let lock = fs::read(&lock_file).map_err(AnswersError::file(&lock_file))?;
    let manifest = manifest(house, folder, &hex(&Sha256::digest(&lock)))?;
    let file = folder.join("Cargo.toml");
    let old = fs::read_to_string(&file).unwrap_or_default();
    let own_lock = folder.join("Cargo.lock");
    // Cargo takes out of the copy what the answers do not need, so it is copied anew only when the original changes.
    if old.lines().nth(1) != manifest.lines().nth(1) || !own_lock.is_file() {
        durable::replace(&own_lock, &lock).map_err(AnswersError::file(&own_lock))?;
    }
    if old != manifest {
        durable::replace(&file, manifest.as_bytes()).map_err(AnswersError::file(&file))?;
    }
    Ok(())
}

/// The text of the manifest.
fn manifest(house: &Path, folder: &Path, lock: &str) -> Result<String, AnswersError> {
    let file = house.join("Cargo.toml");
    let refused = |reason: String| AnswersError::Manifest {
        path: file.clone(),
        reason,
    };
    let text = fs::read_to_string(&file).map_err(AnswersError::file(&file))?;
    let own: toml::Table = toml::from_str(&text).map_err(|e| refused(e.to_string()))?;
    let library = if folder.parent() == Some(house) {
        "..".to_owned()
    } else {
        house.display().to_string()
    };
    let examples: Vec<toml::Table> = answers(folder)
        .into_iter()
        .map(|(chapter, name)| {
            toml::toml! {
                crate-type = ["lib"]
            }
            .into_iter()
            .chain([
                ("name".to_owned(), format!("{chapter}-{name}").into()),
                ("path".to_owned(), format!("{chapter}/{name}.rs").into()),
            ])
            .collect()
        })
        .collect();
    let mut whole = toml::toml! {
        [package]
        name = "answers"
        edition = "2024"
        publish = false
        autoexamples = false

        [workspace]

        [profile.dev]
        debug = 0
    };
    let cagd: toml::Table = [
        ("path".to_owned(), library.into()),
        ("default-features".to_owned(), false.into()),
    ]
    .into_iter()
    .collect();
    let mut dependencies = toml::Table::new();
    dependencies.insert("cagd".into(), cagd.into());
    whole.insert("dependencies".into(), dependencies.into());
    if let Some(dev) = whole
        .get_mut("profile")
        .and_then(|profile| profile.get_mut("dev"))
        .and_then(toml::Value::as_table_mut)
    {
        dev.insert("package".into(), core_profile(&own).into());
    }
    if !examples.is_empty() {
        whole.insert("example".into(), examples.into());
    }
    let body = toml::to_string(&whole).map_err(|e| refused(e.to_string()))?;
    Ok(format!(
        "# Written by the workbook whenever an answer is added; what you change here is lost. Your answers are not touched.\n\
         # Cargo.lock comes from the workbook's, with the digest {lock}.\n\n{body}"
    ))
}

/// The answers that are programs: chapter and name, sorted.
fn answers(folder: &Path) -> Vec<(String, String)> {
    let entries = |folder: PathBuf| {
        let entries = fs::read_dir(folder).into_iter().flatten().flatten();
        entries.filter_map(|entry| entry.file_name().into_string().ok())
    };
    let mut found = Vec::new();
    for chapter in crate::book::catalogue::CHAPTERS {
        for file in entries(folder.join(chapter)) {
            if let Some(name) = file.strip_suffix(".rs")
                && !name.starts_with('.')
            {
                found.push((chapter.to_owned(), name.to_owned()));
            }
        }
    }
    found.sort();
    found
}
