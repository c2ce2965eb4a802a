//! The results of a run, opened.

use std::path::Path;

use serde::Deserialize;

use super::error::ReportError;
use super::facts::RunFacts;
use super::provenance::Provenance;
use crate::files::file_error::read_toml;
use crate::recording::SeriesReader;

/// The manifest of a train's run.
#[derive(Deserialize)]
struct Manifest {
    run: RunFacts,
    #[serde(flatten)]
    provenance: Provenance,
}

/// The results of a run, opened.
pub(super) struct Results {
    /// Facts of the run.
    pub facts: RunFacts,
    /// What was run.
    pub provenance: Provenance,
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
        let Manifest { run: facts, provenance } = read_toml(&folder.join("manifest.toml"))?;
        let outputs = match facts.outputs.is_empty() || facts.train_alone {
            true => None,
            false => Some(SeriesReader::open(&series, "outputs")?),
        };
        Ok(Self {
            facts,
            provenance,
            outputs,
            train: SeriesReader::open(&series, "train")?,
            vehicles: SeriesReader::open(&series, "vehicles")?,
        })
    }
}
