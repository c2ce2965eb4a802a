//! What is compared with a run: another run, or a measurement.

use std::path::Path;

use super::about::About;
use super::error::CompareError;
use super::fields::Fields;
use super::inputs::{self, InputDifference};
use super::measurement::{Measurement, MeasurementOptions};
use super::run::{Curves, Run};

/// Another run, or a measurement.
pub(super) enum Subject {
    /// A run.
    Run(Box<Run>),
    /// A measurement.
    Measurement(Measurement),
}

impl Subject {
    /// Opens a folder of results, or a file of a measurement whose columns are signals of the run `first`.
    pub fn open(
        path: &Path,
        first: &Run,
        options: &MeasurementOptions,
    ) -> Result<Self, CompareError> {
        match path.is_dir() {
            true => Ok(Self::Run(Run::open(path)?.into())),
            false => Ok(Self::Measurement(Measurement::read(path, first, options)?)),
        }
    }

    /// The run, if it is one.
    pub fn run(&self) -> Option<&Run> {
        match self {
            Self::Run(run) => Some(run),
            Self::Measurement(_) => None,
        }
    }

    pub fn about(&self) -> About {
        match self {
            Self::Run(run) => run.about.clone(),
            Self::Measurement(measurement) => measurement.about.clone(),
        }
    }

    /// Inputs that differ from those of a run; a measurement has none.
    pub fn input_differences(&self, first: &Run) -> Result<Vec<InputDifference>, CompareError> {
        match self {
            Self::Run(run) => inputs::differences(first, run),
            Self::Measurement(_) => Ok(vec![]),
        }
    }

    /// How its fields are from those of a run; a measurement has none.
    pub fn fields(&self, first: &Run) -> Result<Fields, CompareError> {
        match self {
            Self::Run(run) => Fields::of(first, run),
            Self::Measurement(_) => Ok(Fields::default()),
        }
    }

    /// Its columns that a run has not.
    pub fn without_home(&self, first: &Run) -> Vec<String> {
        match self {
            Self::Run(run) => run.columns_beyond(first),
            Self::Measurement(measurement) => measurement.without_home.clone(),
        }
    }

    /// The curves of a column of a table; none where it has no such column.
    pub fn curves(&self, table: &str, column: &str) -> Result<Option<Curves>, CompareError> {
        match self {
            Self::Run(run) => run.curves(table, column),
            Self::Measurement(measurement) => Ok(measurement.curves(table, column)),
        }
    }
}
