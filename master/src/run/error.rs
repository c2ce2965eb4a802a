//! Why a run or an export failed.

use std::path::Path;

use files::{Mistake, Setting};
use numerics::seconds;

use crate::files::file_error::FileError;
use crate::report::ReportError;
use crate::run::after::{FailedStep, StepFailure};
use crate::run::checkpoint::CheckpointError;
use crate::run::observe_error::ObserveError;
use crate::scenario::Scenario;
use crate::ssp::SspError;
use crate::system::compile::CompileError;
use crate::system::parallel::ThreadsError;
use crate::system::start::StartError;
use crate::system::unit::UnitError;
use crate::train::error::PrepareError;

/// Why a run of a scenario or of a system, or an export, failed.
#[derive(Debug, thiserror::Error)]
pub enum RunError {
    /// The scenario is wrong.
    #[error(transparent)]
    Scenario(#[from] Mistake),
    /// The scenario's units cannot be set up.
    #[error("scenario {file}: {source}")]
    Prepare {
        /// Scenario.
        file: String,
        /// Reason.
        source: Box<PrepareError>,
    },
    /// A package cannot be read or written, or does not fit its FMUs.
    #[error(transparent)]
    Ssp(#[from] SspError),
    /// A time on the command line makes no sense.
    #[error("{option} {value}: must be a number of seconds greater than zero")]
    Time {
        /// The option.
        option: &'static str,
        /// The time.
        value: f64,
    },
    /// A package has no keys that could be set.
    #[error("{setting}: sets a key of a scenario; a package or an FMU has none")]
    Setting {
        /// The first one.
        setting: Setting,
    },
    /// The system gives no threads.
    #[error(transparent)]
    Threads(#[from] ThreadsError),
    /// The units cannot be initialised.
    #[error(transparent)]
    Start(#[from] StartError),
    /// A unit failed while running; what was recorded before is kept.
    #[error("at {} s: {source}; the results until then are in {results}", seconds(*time))]
    Step {
        /// Time at which the step began, s.
        time: f64,
        /// Reason.
        source: Box<StepFailure>,
        /// Folder of the results.
        results: String,
    },
    /// A unit could not complete what it writes.
    #[error("at the end of the run: {0}")]
    End(UnitError),
    /// Recording failed.
    #[error(transparent)]
    Observe(#[from] ObserveError),
    /// A checkpoint cannot be written, or the run not go on from one.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    /// The report cannot be written.
    #[error(transparent)]
    Report(#[from] ReportError),
    /// A file of the results cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
}

impl RunError {
    /// What `map_err` needs for units of the scenario in this file.
    pub(crate) fn prepare(file: &Path) -> impl FnOnce(PrepareError) -> Self + '_ {
        move |source| match source {
            PrepareError::Value(mistake) => Self::Scenario(mistake),
            source => Self::Prepare { file: file.display().to_string(), source: source.into() },
        }
    }

    /// The same, told at the key of the scenario that a component complains of, if it names one.
    pub(crate) fn at_key(self, scenario: &Scenario) -> Self {
        let unit = match &self {
            Self::Start(StartError::Unit(unit)) => unit,
            Self::Prepare { source, .. } => match &**source {
                PrepareError::Unit(unit) | PrepareError::Compile(CompileError::Unit(unit)) => unit,
                _ => return self,
            },
            _ => return self,
        };
        let message = unit.last_message.as_deref().unwrap_or_default();
        scenario.blamed(&unit.instance, message).map_or(self, Self::Scenario)
    }

    /// Own vehicles that find no balance, at the key of the speed at which they should start.
    ///
    /// Initial values that do not settle tell of a loop where there are FMUs of others.
    pub(crate) fn of_start(self, scenario: &Scenario) -> Self {
        let fmus = &scenario.fmus;
        let is_own =
            fmus.longitudinal.is_none() && fmus.vehicle.is_none() && fmus.vehicle_at.is_empty();
        match self {
            Self::Start(StartError::Loop { .. }) if is_own => {
                let wanted = "the vehicles find no balance to start from on this track: lower the speed, start \
                              on gentler track (train.leading_vehicle_position_m, or radius and cant in the track \
                              file), or with less traction and brake";
                let speed = scenario.train.speed_m_per_s;
                Self::Scenario(scenario.check().error("train.speed_m_per_s", speed, wanted))
            }
            other => other,
        }
    }

    /// A step that failed, in a run whose results are in this folder.
    pub(crate) fn step(failed: FailedStep, results: &Path) -> Self {
        let FailedStep { time, source } = failed;
        Self::Step { time, source: source.into(), results: results.display().to_string() }
    }

    /// Refuses settings of what is no scenario.
    pub(crate) fn check_no_settings(settings: &[Setting]) -> Result<(), Self> {
        match settings.first() {
            None => Ok(()),
            Some(setting) => Err(Self::Setting { setting: setting.clone() }),
        }
    }

    /// Refuses a time that is not greater than zero.
    pub(crate) fn check_time(option: &'static str, value: f64) -> Result<(), Self> {
        match value > 0.0 && value.is_finite() {
            true => Ok(()),
            false => Err(Self::Time { option, value }),
        }
    }
}
