//! Checkpoints: from time to time all that a run needs to go on from there, beside its results.
//!
//! ```text
//! results/checkpoint/run.toml          what is run, and of which files it was made
//! results/checkpoint/00000007.state    the state of the run; the last two are kept
//! results/checkpoint/00000008.state
//! results/checkpoint/tape-0            what the wheels did to a rail, for further trains
//! ```
//!
//! A run that comes to its end removes the folder. One that is resumed cuts its tables and fields to where they
//! were at the checkpoint, and writes from there on what it would have written anyway, byte for byte. Tables,
//! fields and tapes are only ever added to, so that a checkpoint needs no copy of them.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | when a checkpoint is written, and which are kept |
//! | `order.rs` | what is run, and whether it can go on as it was |
//! | `state.rs` | the state of a run |
//! | `error.rs` | why it cannot be written or taken |
//! | `file.rs` | a state as a file that is whole or not taken |

mod error;
mod file;
mod order;
mod state;

use std::fs;
use std::path::{Path, PathBuf};

use numerics::seconds;

pub use error::CheckpointError;
pub use file::{from_bytes, to_bytes};
pub use order::{Order, Subject};
pub use state::{Reached, RunState};

use crate::files::file_error::FileError;
use crate::run::folder::contents::CHECKPOINTS;
use crate::run::recorder::Recorder;
use crate::system::step::System;
use crate::system::times::Stopwatch;

/// How many are kept: where the last one is damaged, the one before is taken.
const KEPT: usize = 2;

/// Slack in comparing times, s.
const SAME_TIME: f64 = 1e-9;

/// Writes the checkpoints of a run.
pub struct Checkpoints {
    folder: PathBuf,
    /// Simulated time between two, s.
    interval: f64,
    /// When the next one is due, s.
    due: f64,
    /// Number of the next one.
    number: u64,
    /// The FMUs by their files, with their digests.
    pub fmus: Vec<(String, String)>,
}

/// How a run begins that writes checkpoints, or goes on from one.
#[derive(Default)]
pub struct Beginning {
    /// Where it writes its checkpoints, if it does.
    pub checkpoints: Option<Checkpoints>,
    /// From where it goes on; none: from its start.
    pub state: Option<RunState>,
    /// What the user should know of that.
    pub notes: Vec<String>,
}

impl Beginning {
    /// Refuses to go on with other FMUs than those of the run, as their files and digests say.
    ///
    /// # Errors
    /// When there are others.
    pub fn check_fmus(&self, digests: &[(String, String)]) -> Result<(), CheckpointError> {
        let (Some(state), Some(checkpoints)) = (&self.state, &self.checkpoints) else {
            return Ok(());
        };
        match digests.iter().find(|fmu| !state.fmus.contains(fmu)) {
            None => Ok(()),
            Some((file, _)) => Err(CheckpointError::Changed {
                results: checkpoints.results(),
                what: format!("{file} is packed from other files than when the run began"),
            }),
        }
    }
}

/// The file of the tape of the rail with that number in a folder of results.
pub fn tape_file(results: &Path, number: usize) -> PathBuf {
    results.join(CHECKPOINTS).join(format!("tape-{number}"))
}

/// Begins the checkpoints of a new run as `order` says.
///
/// # Errors
/// When the folder cannot be written.
pub fn begin(order: &Order) -> Result<Beginning, CheckpointError> {
    let folder = order.results.join(CHECKPOINTS);
    let Some(interval) = order.times.checkpoint else { return Ok(Beginning::default()) };
    fs::create_dir_all(&folder).map_err(FileError::at(&folder))?;
    order.write(&folder.join(order::NAME))?;
    let checkpoints = Checkpoints { folder, interval, due: interval, number: 1, fmus: vec![] };
    Ok(Beginning { checkpoints: Some(checkpoints), ..Beginning::default() })
}

/// What the run in a folder of results was ordered to do, if it can go on as it was.
///
/// # Errors
/// When there is no such run, or something is different now.
pub fn order_of(results: &Path) -> Result<Order, CheckpointError> {
    let order = Order::read(&results.join(CHECKPOINTS).join(order::NAME), results)?;
    order.check(results)?;
    Ok(order)
}

/// Goes on with what was ordered, from the newest checkpoint that is whole.
///
/// # Errors
/// When the folder cannot be read.
pub fn resume(order: &Order) -> Result<Beginning, CheckpointError> {
    let folder = order.results.join(CHECKPOINTS);
    let interval = order.times.checkpoint.unwrap_or(f64::INFINITY);
    let states = states(&folder)?;
    let number = states.last().map_or(1, |(number, _)| number + 1);
    let mut checkpoints = Checkpoints { folder, interval, due: interval, number, fmus: vec![] };
    let mut notes = vec![];
    for (_, path) in states.iter().rev() {
        let state: RunState = match file::read(path) {
            Ok(state) => state,
            Err(reason) => {
                notes.push(format!("{} is not taken: {reason}", path.display()));
                // It must not count as one of those that are kept.
                fs::remove_file(path).map_err(FileError::at(path))?;
                continue;
            }
        };
        notes.push(format!("the run goes on from {} s", seconds(state.time)));
        checkpoints.plan(state.time);
        let state = Some(state);
        return Ok(Beginning { checkpoints: Some(checkpoints), state, notes });
    }
    notes.push("there is no whole checkpoint yet: the run begins anew".to_owned());
    Ok(Beginning { checkpoints: Some(checkpoints), state: None, notes })
}

impl Checkpoints {
    /// Whether one is due when the run has come to a time, s.
    pub fn is_due(&self, time: f64) -> bool {
        time >= self.due - SAME_TIME
    }

    /// The folder of the results, for messages.
    fn results(&self) -> String {
        self.folder.parent().unwrap_or(&self.folder).display().to_string()
    }

    /// The next one is due at the next multiple of the interval after a time, s.
    fn plan(&mut self, time: f64) {
        self.due =
            ((time + SAME_TIME) / self.interval).floor().mul_add(self.interval, self.interval);
    }

    /// Writes one: the run has come to `reached`, at a time in s, and has so many steps on each tape.
    ///
    /// # Errors
    /// When a unit cannot be saved, or the disk is full.
    pub fn write(
        &mut self,
        (reached, time): (Reached, f64),
        tapes: Vec<u64>,
        system: &mut System,
        recorder: &mut Recorder,
    ) -> Result<(), CheckpointError> {
        let mut watch = Stopwatch::start();
        let (parts, tables) = (system.save()?, recorder.save());
        let (times, fmus) = (system.times.clone(), self.fmus.clone());
        let state = RunState { reached, time, tapes, times, parts, tables, fmus };
        file::write(&self.folder.join(format!("{:08}.state", self.number)), &state)?;
        self.number += 1;
        self.plan(time);
        let states = states(&self.folder)?;
        for (_, old) in states.iter().rev().skip(KEPT) {
            fs::remove_file(old).map_err(FileError::at(old))?;
        }
        system.times.checkpoints += watch.lap();
        Ok(())
    }

    /// Removes the folder: the run has come to its end, or writes no checkpoints after all.
    ///
    /// # Errors
    /// When that fails.
    pub fn remove(self) -> Result<(), CheckpointError> {
        // The order first: without it there is nothing to go on with, whatever else may be left.
        let order = self.folder.join(order::NAME);
        fs::remove_file(&order).map_err(FileError::at(&order))?;
        Ok(fs::remove_dir_all(&self.folder).map_err(FileError::at(&self.folder))?)
    }
}

/// The states in the folder by their numbers.
fn states(folder: &Path) -> Result<Vec<(u64, PathBuf)>, FileError> {
    let mut states = vec![];
    for entry in fs::read_dir(folder).map_err(FileError::at(folder))? {
        let path = entry.map_err(FileError::at(folder))?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let number = name.strip_suffix(".state").and_then(|number| number.parse().ok());
        states.extend(number.map(|number| (number, path)));
    }
    states.sort_unstable();
    Ok(states)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every 2 s; a step that passes several multiples makes one checkpoint due.
    #[test]
    fn analytic_a_checkpoint_is_due_at_each_multiple_of_the_interval() {
        let mut checkpoints = Checkpoints {
            folder: PathBuf::new(),
            interval: 2.0,
            due: 2.0,
            number: 1,
            fmus: vec![],
        };
        assert!(!checkpoints.is_due(1.999) && checkpoints.is_due(2.0 - 1e-12));
        for (written, due) in [(2.0 - 1e-12, 4.0), (4.5, 6.0), (60.0, 62.0)] {
            checkpoints.plan(written);
            assert_eq!(checkpoints.due, due, "after {written} s");
        }
    }
}
