//! The steps of a run, recorded one by one.

use super::after::{FailedStep, StepFailure};
use super::checkpoint::{Checkpoints, Reached};
use super::live::LiveFigures;
use super::progress::Progress;
use super::recorder::Recorder;
use super::setup::Setup;
use super::stop::{Early, stopped};
use crate::system::times::{Stopwatch, Timer};

/// Steps and records.
pub struct Stepping<'r> {
    pub setup: &'r mut Setup,
    pub recorder: &'r mut Recorder,
    pub progress: &'r mut Progress,
    pub live: &'r LiveFigures,
    pub checkpoints: Option<&'r mut Checkpoints>,
    pub timer: Timer,
}

impl Stepping<'_> {
    /// Takes all units on from the `done` steps, which it counts, to so many.
    ///
    /// It says if somebody wants the run to end before.
    ///
    /// # Errors
    /// When a unit fails, or nothing can be written, with the time of the last point before.
    pub fn run(&mut self, done: &mut u64, until: u64) -> Result<Option<Early>, FailedStep> {
        while *done < until {
            let k = *done;
            let time = self.setup.system.clock.at(k);
            let failed = |source| FailedStep { time, source };
            if let Some(stopped) = stopped(k, time) {
                self.write_checkpoint(k).map_err(failed)?;
                return Ok(Some(Early::Stopped(stopped)));
            }
            let Err(source) = self.step(k) else {
                *done += 1;
                continue;
            };
            let system = &mut self.setup.system;
            let wish = match &source {
                StepFailure::Unit(error) => system.wish_to_end(error),
                StepFailure::Observe(_) | StepFailure::Checkpoint(_) => None,
            };
            let wish = wish.ok_or_else(|| failed(source))?;
            self.recorder.record_end(k, &wish, system).map_err(|error| failed(error.into()))?;
            return Ok(Some(Early::Wished(wish)));
        }
        Ok(None)
    }

    fn step(&mut self, k: u64) -> Result<(), StepFailure> {
        let Setup { system, rails, .. } = &mut *self.setup;
        system.step(k)?;
        let mut watch = Stopwatch::start();
        rails.observe(k, system)?;
        self.recorder.observe(k + 1, system)?;
        self.progress.show(k + 1, system.clock.at(k + 1), || self.live.text(system));
        system.times.recording += watch.lap();
        let end = system.clock.at(k + 1);
        match self.checkpoints.as_ref().is_some_and(|checkpoints| checkpoints.is_due(end)) {
            true => self.write_checkpoint(k + 1),
            false => Ok(()),
        }
    }

    /// Writes a checkpoint at point `k`, if the run writes any.
    fn write_checkpoint(&mut self, k: u64) -> Result<(), StepFailure> {
        let Some(checkpoints) = &mut self.checkpoints else { return Ok(()) };
        let Setup { system, rails, .. } = &mut *self.setup;
        system.times.run = self.timer.elapsed();
        let reached = (Reached::Run(k), system.clock.at(k));
        Ok(checkpoints.write(reached, rails.save()?, system, self.recorder)?)
    }
}
