//! What compiles and runs the reader's programs; the library for it is built on first use.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use super::queue::Stop;
use crate::workbook::checking::{Checker, CheckingError, Library};
use crate::workbook::sandbox::Isolation;

/// The compiled library, kept as long as the server runs: after a change of the sources another server takes its place.
#[derive(Debug, Clone)]
pub struct Workbench {
    root: PathBuf,
    library: Arc<Mutex<Option<Library>>>,
}

impl Workbench {
    pub(super) fn new(root: &Path) -> Self {
        Self {
            root: root.to_path_buf(),
            library: Arc::default(),
        }
    }

    /// A checker that ends what it runs when `stop` becomes true.
    ///
    /// The first one takes up to a minute, if no other command has built the library before; the others wait for it.
    ///
    /// # Errors
    ///
    /// The library does not compile.
    pub fn checker(&self, stop: Stop) -> Result<Checker, CheckingError> {
        // A panic has left no library or a whole one.
        let mut known = self.library.lock().unwrap_or_else(PoisonError::into_inner);
        let library = match known.take() {
            // Somebody may have cleaned the target folder.
            Some(library) if library.cagd.is_file() => library,
            _ => Library::build(&self.root)?,
        };
        let library = known.insert(library).clone();
        Ok(Checker::with_library(library, Isolation::best()).until(stop))
    }
}
