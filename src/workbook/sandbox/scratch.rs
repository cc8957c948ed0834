//! How much a scratch folder holds.

use std::fs;
use std::io;
use std::os::unix::fs::MetadataExt;
use std::path::Path;

/// What a file or folder takes at least: its entry and its inode.
const LEAST: u64 = 4096;

/// Whether `folder` holds more than `limit` bytes on the disk.
///
/// Counting stops at the limit, so that a flood of files does not keep the watch busy.
/// A folder that cannot be looked into, because it is nested too deep or closed, counts as too much.
pub(super) fn holds_more_than(folder: &Path, limit: u64) -> bool {
    let mut held = 0;
    let mut open = vec![folder.to_path_buf()];
    while let Some(folder) = open.pop() {
        let entries = match fs::read_dir(&folder) {
            Ok(entries) => entries,
            Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
            Err(_) => return true,
        };
        for entry in entries {
            // Of the entry itself, not of what it may link to.
            let found = entry.and_then(|entry| Ok((entry.path(), entry.metadata()?)));
            let (path, data) = match found {
                Ok(found) => found,
                Err(error) if error.kind() == io::ErrorKind::NotFound => continue,
                Err(_) => return true,
            };
            held += on_disk(&data).max(LEAST);
            if held > limit {
                return true;
            }
            if data.is_dir() {
                open.push(path);
            }
        }
    }
    false
}

/// The bytes that a file takes on the disk, which for a file with holes is less than its length.
pub(super) fn on_disk(data: &fs::Metadata) -> u64 {
    // The field counts in units of 512 bytes on every system.
    data.blocks() * 512
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_below_folders_count_and_links_do_not_lead_out() {
        let folder = tempfile::tempdir().expect("a folder");
        let below = folder.path().join("a/b");
        fs::create_dir_all(&below).expect("folders");
        fs::write(below.join("file"), vec![1; 100_000]).expect("a file");
        std::os::unix::fs::symlink("/", below.join("root")).expect("a link");
        assert!(holds_more_than(folder.path(), 90_000));
        assert!(!holds_more_than(folder.path(), 200_000));
    }

    #[test]
    fn empty_files_count() {
        let folder = tempfile::tempdir().expect("a folder");
        for name in 0..20 {
            fs::write(folder.path().join(name.to_string()), "").expect("a file");
        }
        assert!(holds_more_than(folder.path(), 19 * LEAST));
        assert!(!holds_more_than(folder.path(), 20 * LEAST));
    }
}
