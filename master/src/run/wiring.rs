//! `hotfoot wiring`: the structure of a scenario or a package without running it.

use std::path::Path;

use files::Setting;

use super::error::RunError;
use super::source;
use crate::files::file_error::FileError;
use crate::scenario;
use crate::system::structure::Structure;
use crate::train::fmus::Folders;
use crate::train::structure::of_scenario;

/// The structure of the scenario, with these settings, or of the package at `path`.
///
/// Hotfoot's own FMUs lie in `fmus`.
///
/// # Errors
/// When the scenario or package is wrong, or an FMU is missing or unfit.
pub fn wiring(path: &Path, settings: &[Setting], fmus: &Path) -> Result<Structure, RunError> {
    let folder = tempfile::tempdir().map_err(FileError::at(path))?;
    if source::is_system(path) {
        RunError::check_no_settings(settings)?;
        return Ok(source::read(path, folder.path())?.1);
    }
    let (scenario, file, _) = scenario::load(path, settings)?;
    let folders = Folders { fmus: fmus.to_owned(), results: folder.path().to_owned() };
    let train = of_scenario(&scenario, &folders).map_err(RunError::prepare(&file))?;
    Ok(train.structure)
}
