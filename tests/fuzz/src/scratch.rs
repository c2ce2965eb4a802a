//! The folder in which a reader finds its bytes as a file.

use std::path::{Path, PathBuf};

use tempfile::TempDir;

/// A folder that goes when this goes.
pub struct Scratch(TempDir);

impl Scratch {
    /// An empty folder, in memory where the system has such: a reader takes less time than a disk.
    pub fn new() -> Self {
        let in_memory = Path::new("/dev/shm");
        let folder = match in_memory.is_dir() {
            true => tempfile::tempdir_in(in_memory),
            false => tempfile::tempdir(),
        };
        Self(folder.expect("a temporary folder"))
    }

    /// A folder with this one file.
    pub fn with(name: &str, bytes: &[u8]) -> Self {
        let scratch = Self::new();
        scratch.write(name, bytes);
        scratch
    }

    /// Writes a file, in folders that are made for it.
    pub fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        let path = self.path(name);
        let folder = path.parent().expect("a file has a folder");
        std::fs::create_dir_all(folder).expect("a temporary folder is writable");
        std::fs::write(path, bytes).expect("a temporary folder is writable");
    }

    /// Where a file is, or would be.
    pub fn path(&self, name: &str) -> PathBuf {
        self.folder().join(name)
    }

    /// The folder.
    pub fn folder(&self) -> &Path {
        self.0.path()
    }
}
