//! Hotfoot's own FMUs, packed for the train of a scenario.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::error::PrepareError;
use crate::files::file_error::FileError;
use crate::fmi::pack::{Binary, PackError, pack};
use crate::fmi::{Import, ImportError, Origins};

/// Where FMUs come from and go to.
#[derive(Debug, Clone)]
pub struct Folders {
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Folder of the results.
    pub results: PathBuf,
}

impl Folders {
    /// The files of Hotfoot's own FMUs that are there.
    pub fn own_fmus(&self) -> Vec<PathBuf> {
        let file = |name: &str| self.fmus.join(format!("{name}.fmu"));
        let files = ["longitudinal", "vehicle", "railheat", "synchronisation"].map(file);
        files.into_iter().filter(|file| file.exists()).collect()
    }

    /// Packs one of Hotfoot's own FMUs with the resources that `write` makes, and imports it.
    pub(super) fn packed(
        &self,
        base: &str,
        name: &str,
        write: impl FnOnce(&Path) -> Result<Origins, PackError>,
    ) -> Result<Arc<Import>, PrepareError> {
        let base = self.fmus.join(format!("{base}.fmu"));
        check_fmu(&base)?;
        let folder = self.results.join("fmus");
        std::fs::create_dir_all(&folder).map_err(FileError::at(&folder))?;
        let resources = tempfile::tempdir().map_err(FileError::at(&folder))?;
        let origins = write(resources.path())?;
        let target = folder.join(format!("{name}.fmu"));
        pack(Binary::Fmu(&base), resources.path(), &target).map_err(|error| match error {
            PackError::Import(ImportError::Describe { message, .. }) => {
                let message = origins.rename(&message, resources.path());
                PrepareError::Refused { file: target.display().to_string(), message }
            }
            other => other.into(),
        })?;
        Ok(Import::unpack(&target, origins)?)
    }
}

/// Refuses to go on without one of Hotfoot's own FMUs.
pub(super) fn check_fmu(path: &Path) -> Result<(), PrepareError> {
    match path.exists() {
        true => Ok(()),
        false => Err(PrepareError::NoFmu { path: path.display().to_string() }),
    }
}
