//! What is run without a scenario: an SSP package, packed or as a folder, or a single FMU.

use std::fs;
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

/// The folder with the files of the system at `path`, and its structure. A package is unpacked into the
/// folder `target`.
///
/// # Errors
/// When a file cannot be read or is wrong.
pub fn read(path: &Path, target: &Path) -> Result<(PathBuf, Structure), RunError> {
    match extension(path).as_str() {
        "fmu" => Ok((folder_of(path), single(path))),
        "ssd" => {
            let name = path.file_name().unwrap_or_default().to_string_lossy();
            let structure = ssp::read(&folder_of(path), &name)?;
            Ok((folder_of(path), structure))
        }
        _ if path.is_dir() => Ok((path.to_owned(), ssp::read(path, STRUCTURE_FILE)?)),
        _ => {
            archive::unpack(path, target).map_err(SspError::from)?;
            Ok((target.to_owned(), ssp::read(target, STRUCTURE_FILE)?))
        }
    }
}

/// The files that the system at `path` is made of, besides its FMUs if it is not packed.
///
/// # Errors
/// When a folder cannot be read.
pub fn inputs(path: &Path) -> Result<Vec<PathBuf>, FileError> {
    let folder = match extension(path).as_str() {
        "fmu" | "ssp" => return Ok(vec![path.to_owned()]),
        "ssd" => folder_of(path),
        _ => path.to_owned(),
    };
    let mut files = vec![];
    for folder in [folder.join("resources"), folder].iter().filter(|folder| folder.is_dir()) {
        for entry in fs::read_dir(folder).map_err(FileError::at(folder))? {
            files.push(entry.map_err(FileError::at(folder))?.path());
        }
    }
    files.retain(|file| matches!(extension(file).as_str(), "ssd" | "ssv" | "ssm" | "ssb"));
    files.sort();
    Ok(files)
}

/// An FMU as the only component of a system.
fn single(fmu: &Path) -> Structure {
    let text =
        |part: Option<&std::ffi::OsStr>| part.unwrap_or_default().to_string_lossy().into_owned();
    let (name, source) = (text(fmu.file_stem()), text(fmu.file_name()));
    let component = Component { name: name.clone(), source, ..Component::default() };
    Structure { name, components: vec![component], ..Structure::default() }
}

fn folder_of(file: &Path) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).to_owned()
}

fn extension(path: &Path) -> String {
    path.extension().unwrap_or_default().to_string_lossy().to_lowercase()
}
