//! What the files in an FMU's resources are copies of. Messages of an FMU name the copies; the user reads
//! the names of the files that he wrote.

use std::path::{Path, PathBuf};

/// Names in a resources folder, and the files or folders that they are copies of.
#[derive(Debug, Clone, Default)]
pub struct Origins(Vec<(String, PathBuf)>);

impl Origins {
    /// Copies with their originals.
    pub fn of<const N: usize>(copies: [(String, PathBuf); N]) -> Self {
        Self(copies.into())
    }

    /// Adds a copy with its original.
    pub fn add(&mut self, copy: String, original: PathBuf) {
        self.0.push((copy, original));
    }

    /// The message with the names of the originals in place of the copies in `folder`.
    pub fn rename(&self, message: &str, folder: &Path) -> String {
        let copy = |name: &str| folder.join(name).display().to_string();
        self.0.iter().fold(message.to_owned(), |text, (name, original)| {
            text.replace(&copy(name), &original.display().to_string())
        })
    }
}
