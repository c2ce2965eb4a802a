//! The results of a run, opened.

use std::path::Path;

use serde::Deserialize;

use super::error::ReportError;
use super::facts::RunFacts;
use super::provenance::Provenance;
use crate::files::file_error::read_toml;
use crate::recording::{RecordingError, SeriesReader};

/// Columns of the train with the speed of a logger, and the root mean square of the difference from it.
const MEASURED_SPEED: &str = "driver.measured_speed";
const SPEED_RMS: &str = "driver.speed_rms";

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
    /// Speed of the leading vehicle in a logger's file at the records, m/s; empty without one.
    pub fn measured_speed(&self) -> Result<Vec<f64>, RecordingError> {
        let measured = self.of_train(MEASURED_SPEED)?;
        Ok(if measured.iter().any(|speed| *speed != 0.0) { measured } else { vec![] })
    }

    /// Root mean square of the speed less the measured one, over the run, m/s; none without a logger.
    pub fn speed_rms(&self) -> Result<Option<f64>, RecordingError> {
        match self.measured_speed()?.is_empty() {
            true => Ok(None),
            false => Ok(self.of_train(SPEED_RMS)?.last().copied()),
        }
    }

    /// An output of the train at the records; empty where the train has no such output.
    fn of_train(&self, name: &str) -> Result<Vec<f64>, RecordingError> {
        match self.train.columns().any(|column| column.name() == name) {
            true => self.train.read(name, &[]),
            false => Ok(vec![]),
        }
    }

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
