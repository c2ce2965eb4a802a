//! The FMU files of a package.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use super::error::SspError;
use crate::files::file_error::FileError;

/// The FMU files of a package, each once.
pub(super) struct Sources {
    package: PathBuf,
    /// From the file to its name in the package.
    names: BTreeMap<PathBuf, String>,
}

impl Sources {
    /// None yet, for the package in a folder.
    pub(super) fn new(package: &Path) -> Self {
        Self { package: package.to_owned(), names: BTreeMap::new() }
    }

    /// Path of a file in the package.
    pub(super) fn add(&mut self, file: &Path) -> String {
        if let Some(name) = self.names.get(file) {
            return name.clone();
        }
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        let name = |n: usize| match n {
            1 => format!("resources/{stem}.fmu"),
            n => format!("resources/{stem}-{n}.fmu"),
        };
        let taken = |name: &String| self.names.values().any(|other| other == name);
        let name = (1..).map(name).find(|name| !taken(name)).unwrap_or_default();
        self.names.insert(file.to_owned(), name.clone());
        name
    }

    /// Copies all files into the package.
    pub(super) fn copy(&self) -> Result<(), SspError> {
        let folder = self.package.join("resources");
        std::fs::create_dir_all(&folder).map_err(FileError::at(&folder))?;
        for (file, name) in &self.names {
            std::fs::copy(file, self.package.join(name)).map_err(FileError::at(file))?;
        }
        Ok(())
    }
}
