//! How a scenario or a package is run.

use std::path::PathBuf;

use files::Setting;

use crate::scenario::Times;
use crate::system::checks::Checks;
use crate::system::structure::Home;

/// How a scenario or a package is run.
#[derive(Debug, Clone, Default)]
pub struct Options {
    /// Threads for the units; none: all cores.
    pub threads: Option<usize>,
    /// Folder of Hotfoot's own FMUs.
    pub fmus: PathBuf,
    /// Values of the scenario's keys instead of those in its file.
    pub settings: Vec<Setting>,
    /// Times instead of the scenario's or the package's.
    pub times: Times,
    /// Relative tolerance that the FMUs are told instead of their own.
    pub tolerance: Option<f64>,
    /// What becomes of values that cannot be, in place of what the scenario says.
    pub checks: Option<Checks>,
    /// Whether every FMU of a package, and every one that a scenario names, has a thread of its own.
    pub same_thread: bool,
    /// Names of components whose FMUs run in processes of their own; `all` stands for all.
    pub isolate: Vec<String>,
    /// Outputs that are recorded, by patterns: of a package `component.output`, of a scenario's recorded
    /// vehicles `output`, in place of its `record.outputs`.
    pub record: Vec<String>,
    /// No progress bar.
    pub quiet: bool,
}

impl Options {
    /// Where FMUs are called at least.
    pub(super) fn home(&self) -> Home {
        if self.same_thread { Home::OwnThread } else { Home::AnyThread }
    }
}
