//! `hotfoot check`: a scenario up to its first step.

use std::path::Path;

use files::Setting;

use super::error::RunError;
use super::scenario::setup;
use crate::files::file_error::FileError;
use crate::scenario;
use crate::system::substitute::Substitutes;
use crate::system::unit::terminate;
use crate::train::fmus::Folders;

/// Sets a scenario up with these settings and initialises its units as its run does.
///
/// Hotfoot's own FMUs lie in `fmus`. Gives what the run will say before its first step, in sentences.
///
/// # Errors
/// When something is wrong for which the run would not begin.
pub fn check_until_start(
    path: &Path,
    settings: &[Setting],
    fmus: &Path,
) -> Result<Vec<String>, RunError> {
    let folder = tempfile::tempdir().map_err(FileError::at(path))?;
    let (mut scenario, file, text) = scenario::load(path, settings)?;
    // Its folder is not made here.
    scenario.record.checkpoint_s = None;
    let folders = Folders { fmus: fmus.to_owned(), results: folder.path().to_owned() };
    let mut setup = setup(scenario, (&file, text), &folders, 1, &mut Substitutes::new())?;
    setup.initialize()?;
    setup.recorder(&folder.path().join("series"))?;
    setup.describe()?;
    terminate(setup.system.units_mut()).map_err(RunError::End)?;
    let notes = setup.manifest.run.map(|run| run.notes).unwrap_or_default();
    Ok([setup.manifest.warnings, notes].concat())
}
