//! The steps of a run: those of the whole train, then those of the rails after it.

use crate::run::observe::{ObserveError, Recorder};
use crate::run::progress::Progress;
use crate::system::parallel;
use crate::system::times::Stopwatch;
use crate::system::unit::UnitError;
use crate::train::lockstep::Lockstep;
use crate::train::rail::Rail;
use crate::train::traffic::{Stage, Traffic};

/// A step that failed.
#[derive(Debug)]
pub struct FailedStep {
    /// Time at which it began, s.
    pub time: f64,
    /// Reason.
    pub source: StepFailure,
}

/// Why a step failed.
#[derive(Debug, thiserror::Error)]
pub enum StepFailure {
    /// A unit did not get to its end.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// It could not be recorded.
    #[error(transparent)]
    Observe(#[from] ObserveError),
}

/// Steps and records.
pub struct Stepping<'r> {
    /// The units.
    pub lockstep: &'r mut Lockstep,
    /// Records them.
    pub recorder: &'r mut Recorder,
    /// Tells how far it is.
    pub progress: &'r mut Progress,
}

impl Stepping<'_> {
    /// Takes all units through the steps of the run.
    ///
    /// # Errors
    /// When a step fails.
    pub fn run(&mut self, steps: u64) -> Result<(), FailedStep> {
        for k in 0..steps {
            let time = self.lockstep.clock.at(k);
            self.step(k).map_err(|source| FailedStep { time, source })?;
        }
        Ok(())
    }

    fn step(&mut self, k: u64) -> Result<(), StepFailure> {
        self.lockstep.step(k)?;
        let mut watch = Stopwatch::start();
        self.recorder.observe(k + 1, self.lockstep)?;
        self.progress.show(k + 1, self.lockstep.clock.at(k + 1), self.lockstep);
        self.lockstep.times.recording += watch.lap();
        Ok(())
    }

    /// Takes the rails, which have come to `time`, through what is planned after the run.
    ///
    /// # Errors
    /// When a step fails.
    pub fn go_on(&mut self, traffic: &Traffic, time: f64) -> Result<(), FailedStep> {
        for stage in traffic.stages(time) {
            match stage {
                Stage::Alone { from, length, steps } => {
                    self.each(from, length, steps, 1, Rail::step_alone)?;
                }
                Stage::Train { from } => self.train(from)?,
            }
        }
        Ok(())
    }

    /// A train does again what is on the tapes.
    fn train(&mut self, from: f64) -> Result<(), FailedStep> {
        let mut steps = 0;
        for rail in &mut self.lockstep.rails {
            let rewound = rail.rewind();
            steps = rewound.map_err(|error| FailedStep { time: from, source: error.into() })?;
        }
        let every = self.lockstep.rails.first().map_or(1, |rail| rail.every);
        let length = every as f64 * self.lockstep.clock.length;
        let per_record = (self.recorder.every() / every).max(1);
        self.each(from, length, steps, per_record, Rail::step_again)
    }

    /// Steps the rails, and records them every so many steps and at the last.
    fn each(
        &mut self,
        from: f64,
        length: f64,
        steps: u64,
        per_record: u64,
        step: fn(&mut Rail, f64, f64) -> Result<(), UnitError>,
    ) -> Result<(), FailedStep> {
        for j in 0..steps {
            let time = from + j as f64 * length;
            let failed = |source| FailedStep { time, source };
            let rails = &mut self.lockstep.rails;
            parallel::for_each(rails, |rail| step(rail, time, length))
                .map_err(|error| failed(error.into()))?;
            if (j + 1).is_multiple_of(per_record) || j + 1 == steps {
                let end = from + (j + 1) as f64 * length;
                self.recorder.record_rails(end, rails).map_err(|error| failed(error.into()))?;
                self.progress.show_rails(end);
            }
        }
        Ok(())
    }
}
