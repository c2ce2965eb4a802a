//! Writes `report.html` into the folder of a run.

use std::path::{Path, PathBuf};

use super::data::MainFigure;
use super::rail_figures::listed;
use super::{ReportError, collect, render};

/// Reads the results in `folder`, writes their report beside them, and gives its path and the
/// figures.
///
/// # Errors
/// When the results cannot be read or the report cannot be written.
pub fn write(folder: &Path) -> Result<(PathBuf, Vec<MainFigure>), ReportError> {
    let data = collect(folder)?;
    let file = folder.join("report.html");
    std::fs::write(&file, render(&data)?)
        .map_err(|source| ReportError::File { file: file.clone(), source })?;
    let of_rails = data.rails.iter().flat_map(listed);
    Ok((file, data.main_figures.iter().cloned().chain(of_rails).collect()))
}
