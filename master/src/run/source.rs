//! What is run without a scenario: an SSP package, packed or as a folder, or a single FMU.

use std::path::{Path, PathBuf};

use super::error::RunError;
use crate::files::archive;
use crate::files::file_error::FileError;
use crate::ssp::{self, STRUCTURE_FILE, SspError};
use crate::system::structure::{Component, Structure};

/// Whether a file or folder is a system of FMUs; otherwise it is a scenario.
pub fn is_system(path: &Path) -> bool {
    let is_unpacked =
        || path.join(STRUCTURE_FILE).is_file() && !path.join("scenario.toml").exists();
    matches!(extension(path).as_str(), "ssp" | "ssd" | "fmu") || is_unpacked()
}

/// The folder with the files of the system at `path`, and its structure. What is packed is unpacked into
/// the folder `place`.
///
/// # Errors
/// When a file cannot be read or is wrong.
pub fn read(path: &Path, place: &Path) -> Result<(PathBuf, Structure), RunError> {
    match extension(path).as_str() {
        "fmu" => single(path, place),
        "ssd" => {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let folder = path.parent().unwrap_or(Path::new("")).to_owned();
            let structure = ssp::read(&folder, &name)?;
            Ok((folder, structure))
        }
        _ if path.is_dir() => Ok((path.to_owned(), ssp::read(path, STRUCTURE_FILE)?)),
        _ => {
            archive::unpack(path, place).map_err(SspError::from)?;
            Ok((place.to_owned(), ssp::read(place, STRUCTURE_FILE)?))
        }
    }
}

/// An FMU as the only component of a system, copied into the folder `place`.
fn single(fmu: &Path, place: &Path) -> Result<(PathBuf, Structure), RunError> {
    let name = fmu.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    std::fs::create_dir_all(place).map_err(FileError::at(place))?;
    let source = fmu.file_name().unwrap_or_default().to_string_lossy().into_owned();
    std::fs::copy(fmu, place.join(&source)).map_err(FileError::at(fmu))?;
    let component = Component { name: name.clone(), source, ..Component::default() };
    Ok((place.to_owned(), Structure { name, components: vec![component], ..Structure::default() }))
}

fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}
