//! Writes `report.html` into the folder of a run.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::collect::collect;
use super::data::MainFigure;
use super::error::ReportError;
use super::page::render;
use super::provenance::Provenance;
use super::rail_figures::listed;
use super::system::{self, SystemFacts};
use crate::files::file_error::{read_toml, write_whole};

/// The parts of a manifest that the page of a system shows, which only its run has.
#[derive(Deserialize)]
struct Manifest {
    system: Option<SystemFacts>,
    #[serde(flatten)]
    provenance: Provenance,
}

/// Reads the results in `folder`, writes their report beside them, and gives its path and the
/// figures.
///
/// # Errors
/// When the results cannot be read or the report cannot be written.
pub fn write(folder: &Path) -> Result<(PathBuf, Vec<MainFigure>), ReportError> {
    let Manifest { system, provenance } = read_toml(&folder.join("manifest.toml"))?;
    let (page, figures) = match system {
        Some(facts) => (system::render(&facts, &provenance, folder)?, vec![]),
        None => {
            let data = collect(folder)?;
            let of_rails = data.rails.iter().flat_map(listed);
            (render(&data)?, data.main_figures.iter().cloned().chain(of_rails).collect())
        }
    };
    let file = folder.join("report.html");
    write_whole(&file, &page)?;
    Ok((file, figures))
}
