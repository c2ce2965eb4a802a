//! The state of a run: all that changes while it runs and is not on the disk already.

use serde::{Deserialize, Serialize};

use crate::recording::TableState;
use crate::system::part::PartState;
use crate::system::times::StepTimes;

/// How far a run has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reached {
    /// So many steps of the run are done.
    Run(u64),
    /// The run is over, and of a stage of what comes after it so many steps are done.
    ///
    /// The stages are counted from zero.
    After(usize, u64),
}

/// The state of a run.
#[derive(Serialize, Deserialize)]
pub struct RunState {
    /// How far it has come.
    pub reached: Reached,
    /// To which time, s.
    pub time: f64,
    /// Wall times so far.
    pub times: StepTimes,
    /// The parts of its system.
    pub parts: Vec<PartState>,
    /// Its tables.
    pub tables: Vec<TableState>,
    /// Steps on the tape of each rail.
    pub tapes: Vec<u64>,
    /// The FMUs by their files, with their digests.
    pub fmus: Vec<(String, String)>,
}
