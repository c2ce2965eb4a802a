//! The results of a run, opened.

use std::path::Path;

use serde::Deserialize;

use super::error::ReportError;
use super::facts::RunFacts;
use crate::files::file_error::read_toml;
use crate::recording::SeriesReader;

/// The part of the manifest that the report needs; the others are for people.
#[derive(Deserialize)]
struct Manifest {
    run: RunFacts,
}

/// The results of a run, opened.
pub(super) struct Results {
    /// Facts of the run.
    pub facts: RunFacts,
    /// What train and rail say of themselves.
    pub train: SeriesReader,
    /// The vehicles.
    pub vehicles: SeriesReader,
    /// Further outputs of vehicles, if any are recorded.
    pub outputs: Option<SeriesReader>,
}

impl Results {
    /// Opens `manifest.toml` and `series/` in `folder`.
    pub fn open(folder: &Path) -> Result<Self, ReportError> {
        let series = folder.join("series");
        let facts = read_toml::<Manifest>(&folder.join("manifest.toml"))?.run;
        let outputs = match facts.outputs.is_empty() || facts.train_alone {
            true => None,
            false => Some(SeriesReader::open(&series, "outputs")?),
        };
        Ok(Self {
            facts,
            outputs,
            train: SeriesReader::open(&series, "train")?,
            vehicles: SeriesReader::open(&series, "vehicles")?,
        })
    }
}
