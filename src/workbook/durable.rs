//! Files that are written whole or not at all.

use std::fs::{self, File};
use std::io::{self, Write};
use std::os::unix::fs::PermissionsExt;
use std::path::Path;

/// Puts `bytes` into the place of a file, so that whoever reads it, even after a crash, finds the old or the new text.
///
/// The new text is on the disk before the name points to it.
///
/// # Errors
///
/// What the operating system says; the old file is still there then.
pub(crate) fn replace(file: &Path, bytes: &[u8]) -> io::Result<()> {
    let folder = match file.parent() {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => return Err(io::ErrorKind::InvalidInput.into()),
    };
    fs::create_dir_all(folder)?;
    let mut new = tempfile::Builder::new()
        .prefix(".new-")
        .tempfile_in(folder)?;
    new.write_all(bytes)?;
    new.as_file().sync_all()?;
    new.persist(file)?;
    keep_name(folder);
    Ok(())
}

/// Writes a file of the reader's: whole or not at all, and with the rights that other programs give to new files.
///
/// If there is a file of this name it is replaced if `force` says so, and is an error of the kind
/// [`AlreadyExists`](io::ErrorKind::AlreadyExists) otherwise.
///
/// # Errors
///
/// What the operating system or `write` says; an old file is still there then.
pub(crate) fn write_new(
    file: &Path,
    force: bool,
    write: impl FnOnce(&mut io::BufWriter<&mut File>) -> io::Result<()>,
) -> io::Result<()> {
    let folder = match file.parent() {
        Some(folder) if folder.as_os_str().is_empty() => Path::new("."),
        Some(folder) => folder,
        None => return Err(io::ErrorKind::InvalidInput.into()),
    };
    let mut new = tempfile::Builder::new()
        .prefix(".new-")
        .permissions(fs::Permissions::from_mode(0o666))
        .tempfile_in(folder)?;
    let mut buffered = io::BufWriter::new(new.as_file_mut());
    write(&mut buffered)?;
    buffered.flush()?;
    drop(buffered);
    new.as_file().sync_all()?;
    if force {
        new.persist(file)?;
    } else {
        new.persist_noclobber(file)?;
    }
    keep_name(folder);
    Ok(())
}

/// As [`replace`], by way of the file `new` in the same folder, which nobody else may write.
///
/// What a killed program has left there is written over, so that nothing piles up.
///
/// # Errors
///
/// What the operating system says; the old file is still there then.
pub(crate) fn replace_by(new: &Path, file: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut text = File::create(new)?;
    text.write_all(bytes)?;
    text.sync_all()?;
    fs::rename(new, file)?;
    if let Some(folder) = file.parent() {
        keep_name(folder);
    }
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
