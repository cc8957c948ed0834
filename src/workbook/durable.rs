//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::PermissionsExt;
use std::path::{Path, PathBuf};

/// Puts `bytes` into the place of a file, so that whoever reads it, even after a crash, finds the old or the new text.
///
/// The new text is on the disk before the name points to it. Where the name is a link, the file behind it gets the
/// text, and the link stays.
///
/// # Errors
///
/// What the operating system says; the old file is still there then.
pub(crate) fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let file = behind_links(file)?;
    let folder = folder_of(&file);
    fs::create_dir_all(folder)?;
    let mut new = beside().tempfile_in(folder)?;
    new.write_all(bytes)?;
    new.as_file().sync_all()?;
    new.persist(&file)?;
    keep_name(folder);
    Ok(())
}

/// Writes a file of the reader's: whole or not at all, and with the rights that other programs give to new files.
///
/// If there is a file of this name it is replaced if `force` says so, and is an error of the kind
/// [`AlreadyExists`](io::ErrorKind::AlreadyExists) otherwise. Where the name is a link, the file behind it is meant.
///
/// # Errors
///
/// What the operating system or `write` says; an old file is still there then.
pub(crate) fn write_new(
    file: &Path,
    force: bool,
    write: impl FnOnce(&mut io::BufWriter<&mut File>) -> io::Result<()>,
) -> io::Result<()> {
    let file = behind_links(file)?;
    let folder = folder_of(&file);
    let mut new = beside()
        .permissions(fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)?;
    let mut buffered = io::BufWriter::new(new.as_file_mut());
    write(&mut buffered)?;
    buffered.flush()?;
    drop(buffered);
    new.as_file().sync_all()?;
    if force {
        new.persist(&file)?;
    } else {
        new.persist_noclobber(&file)?;
    }
    keep_name(folder);
    Ok(())
}

/// Tries whether [`write_new`] can write a file, before anybody waits for what it will hold.
///
/// # Errors
///
/// What the operating system says.
pub(crate) fn try_new(file: &Path) -> io::Result<()> {
    let file = behind_links(file)?;
    beside().tempfile_in(folder_of(&file)).map(drop)
}

/// The file that a name stands for: the one behind all links, whether or not it is there.
fn behind_links(name: &Path) -> io::Result<PathBuf> {
    /// As many links as Linux follows.
    const MOST: usize = 40;
    let mut file = name.to_path_buf();
    for _ in 0..=MOST {
        let Ok(target) = fs::read_link(&file) else {
            return Ok(file);
        };
        // A relative one is meant from the folder of the link.
        file.pop();
        file.push(target);
    }
    Err(io::Error::other("it is a link that leads to no file"))
}

/// The folder of a file.
fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// How the new file is made that takes the place of the old one.
fn beside() -> tempfile::Builder<'static, 'static> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".new-");
    builder
}

/// As [`replace`], by way of a file of the name `new` in the same folder, which nobody else may write.
///
/// What a killed program has left there is written over, so that nothing piles up.
///
/// # Errors
///
/// What the operating system says; the old file is still there then.
pub(crate) fn replace_by(new: &str, file: &Path, bytes: &[u8]) -> io::Result<()> {
    let file = behind_links(file)?;
    let new = file.with_file_name(new);
    let mut text = File::create(&new)?;
    text.write_all(bytes)?;
    text.sync_all()?;
    fs::rename(new, &file)?;
    keep_name(folder_of(&file));
    Ok(())
}

/// Brings a new name in a folder to the disk.
///
/// Some file systems cannot be asked for that; after a crash the old text may then be back, and it is whole.
fn keep_name(folder: &Path) {
    if let Ok(folder) = File::open(folder) {
        let _ = folder.sync_all();
    }
}

#[cfg(test)]
mod tests {
    use std::os::unix::fs::symlink;

    use super::*;

    #[test]
    fn a_link_stays_and_its_file_is_written() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::create_dir(path("elsewhere")).expect("a folder");
        symlink("elsewhere/file", path("near")).expect("a link");
        symlink(path("near"), path("far")).expect("a link");
        type Write = fn(&Path) -> io::Result<()>;
        let all: [(&str, Write); 4] = [
            ("replace", |file| replace(file, b"replace")),
            ("replace by", |file| replace_by(".new", file, b"replace by")),
            ("force", |file| {
                write_new(file, true, |out| out.write_all(b"force"))
            }),
            ("new", |file| {
                fs::remove_file(file.with_file_name("elsewhere/file"))?;
                write_new(file, false, |out| out.write_all(b"new"))
            }),
        ];
        for (text, write) in all {
            write(&path("far")).unwrap_or_else(|error| panic!("{text}: {error}"));
            assert!(path("far").is_symlink() && path("near").is_symlink());
            let written = fs::read_to_string(path("elsewhere/file")).expect("a file");
            assert_eq!(written, text);
        }
        let left = fs::read_dir(path("elsewhere")).expect("a folder").count();
        assert_eq!(left, 1, "what was on the way is gone");

        let refused = write_new(&path("far"), false, |_| Ok(()));
        let refused = refused.map_err(|error| error.kind());
        assert_eq!(refused, Err(io::ErrorKind::AlreadyExists));
        symlink("circle", path("circle")).expect("a link");
        assert!(replace(&path("circle"), b"").is_err());
        assert!(path("circle").is_symlink());
    }
}
