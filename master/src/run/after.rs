//! What comes after the run for the rails: further trains, and the time in which they are alone.

use std::io;

use super::checkpoint::{CheckpointError, Checkpoints, Reached};
use super::observe_error::ObserveError;
use super::progress::Progress;
use super::recorder::Recorder;
use super::stop::Stopped;
use crate::system::parallel;
use crate::system::part::Part;
use crate::system::step::System;
use crate::system::times::Timer;
use crate::system::unit::UnitError;
use crate::train::layout::Layout;
use crate::train::tape::Tape;
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
    /// A checkpoint could not be written.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
}

/// The rails, which go on after the run.
#[derive(Default)]
pub struct Rails {
    rails: Vec<Rail>,
    /// What is planned after the run.
    pub traffic: Traffic,
}

/// A rail.
struct Rail {
    /// Number of its part.
    part: usize,
    /// Its name in messages.
    name: String,
    /// What the wheels of the run do, if further trains shall do the same.
    tape: Option<Tape>,
}

impl Rails {
    /// The rails of a train, whose wheels' loads are kept if further trains shall come; `tape` makes an
    /// empty tape for the rail with that number.
    ///
    /// # Errors
    /// When a tape cannot be made.
    pub fn new<E>(
        layout: &Layout,
        system: &System,
        traffic: Traffic,
        tape: impl Fn(usize) -> Result<Tape, E>,
    ) -> Result<Self, E> {
        let mut rails = vec![];
        for holder in &layout.rails {
            let Some(part) = system.number(&holder.component) else { continue };
            let tape = traffic.has_further_trains().then(|| tape(rails.len())).transpose()?;
            rails.push(Rail { part, name: format!("{} rail", holder.side_name()), tape });
        }
        Ok(Self { rails, traffic })
    }

    /// The time to which the rails have come after so many steps, s.
    pub fn time(&self, system: &System, steps: u64) -> f64 {
        let every = self.every(system);
        system.clock.at(steps / every * every)
    }

    /// Whether a part is one of the rails.
    pub fn contain(&self, part: usize) -> bool {
        self.rails.iter().any(|rail| rail.part == part)
    }

    /// Forgets what the wheels do: what follows the run is not asked for.
    pub fn forget_tapes(&mut self) {
        self.rails.iter_mut().for_each(|rail| rail.tape = None);
    }

    /// Keeps what the wheels did in the step to point `k + 1`.
    ///
    /// # Errors
    /// When the tape cannot be written.
    pub fn observe(&mut self, k: u64, system: &System) -> Result<(), UnitError> {
        for Rail { part, name, tape } in &mut self.rails {
            let part = &system.parts[*part];
            if let Some(tape) = tape
                && part.is_due(k)
            {
                tape.add(&part.inputs.reals.values).map_err(|error| tape_error(name, &error))?;
            }
        }
        Ok(())
    }

    /// Leaves the tapes to the system, and gives the number of steps on each, for another run.
    ///
    /// # Errors
    /// When a tape cannot be written.
    pub fn save(&mut self) -> Result<Vec<u64>, UnitError> {
        let save = |Rail { name, tape, .. }: &mut Rail| {
            let steps = tape.as_mut().map_or(Ok(0), Tape::save);
            steps.map_err(|error| tape_error(name, &error))
        };
        self.rails.iter_mut().map(save).collect()
    }

    /// Goes on behind so many steps of each tape that another run has left.
    ///
    /// # Errors
    /// When a tape has fewer.
    pub fn resume(&mut self, saved: &[u64], system: &System) -> Result<(), UnitError> {
        for (Rail { part, name, tape }, steps) in self.rails.iter_mut().zip(saved) {
            let inputs = system.parts[*part].inputs.reals.values.len();
            let resumed = tape.as_mut().map_or(Ok(()), |tape| tape.resume(*steps, inputs));
            resumed.map_err(|error| tape_error(name, &error))?;
        }
        Ok(())
    }

    /// Takes the rails, which came to `time` in the run, through what is planned after it, until somebody
    /// wants it to stop.
    ///
    /// It begins behind what is `reached` already.
    ///
    /// # Errors
    /// When a step fails.
    pub fn continue_after_run(
        &mut self,
        run: &mut Continued<'_>,
        time: f64,
        reached: Reached,
    ) -> Result<Option<Stopped>, FailedStep> {
        let (first, done) = match reached {
            Reached::Run(_) => (0, 0),
            Reached::After(stage, done) => (stage, done),
        };
        for (number, stage) in self.traffic.stages(time).into_iter().enumerate().skip(first) {
            let done = if number == first { done } else { 0 };
            let stopped = match stage {
                Stage::Alone { from, length, steps } => {
                    let steps = Steps { stage: number, done, from, length, steps, per_record: 1 };
                    self.each(run, steps, |_, part| {
                        part.inputs.reals.values.fill(0.0);
                        Ok(())
                    })?
                }
                Stage::Train { from } => self.further_train(run, from, (number, done))?,
            };
            if stopped.is_some() {
                return Ok(stopped);
            }
        }
        Ok(None)
    }

    /// A train does again what is on the tapes; so many steps of this stage it has done.
    fn further_train(
        &mut self,
        run: &mut Continued<'_>,
        from: f64,
        (stage, done): (usize, u64),
    ) -> Result<Option<Stopped>, FailedStep> {
        let mut steps = 0;
        for Rail { part, name, tape } in &mut self.rails {
            let inputs = run.system.parts[*part].inputs.reals.values.len();
            let found = tape.as_mut().map_or(Ok(0), |tape| tape.seek(done, inputs));
            steps = found.map_err(|error| FailedStep {
                time: from,
                source: tape_error(name, &error).into(),
            })?;
        }
        let every = self.every(run.system);
        let length = every as f64 * run.system.clock.length;
        let per_record = (run.recorder.every / every).max(1);
        self.each(run, Steps { stage, done, from, length, steps, per_record }, |rail, part| {
            let Rail { name, tape, .. } = rail;
            let Some(tape) = tape else { return Ok(()) };
            tape.next(&mut part.inputs.reals.values).map_err(|error| tape_error(name, &error))
        })
    }

    /// Steps the rails with what `load` puts on them, and records them every so many steps and at the
    /// last.
    fn each(
        &mut self,
        run: &mut Continued<'_>,
        steps: Steps,
        load: fn(&mut Rail, &mut Part) -> Result<(), UnitError>,
    ) -> Result<Option<Stopped>, FailedStep> {
        let Steps { stage, done, from, length, steps, per_record } = steps;
        for j in done..steps {
            let time = from + j as f64 * length;
            let failed = |source| FailedStep { time, source };
            if let Some(stopped) = (run.stop)(j, time) {
                self.write_checkpoint(run, Reached::After(stage, j), time).map_err(failed)?;
                return Ok(Some(stopped));
            }
            self.step(run.system, time, length, load).map_err(|error| failed(error.into()))?;
            if (j + 1).is_multiple_of(per_record) || j + 1 == steps {
                let end = from + (j + 1) as f64 * length;
                let recorded = run.recorder.record_after(end, run.system);
                recorded.map_err(|error| failed(error.into()))?;
                run.progress.show_rails(end);
            }
            let end = from + (j + 1) as f64 * length;
            if run.checkpoints.as_ref().is_some_and(|checkpoints| checkpoints.is_due(end)) {
                self.write_checkpoint(run, Reached::After(stage, j + 1), end).map_err(failed)?;
            }
        }
        Ok(None)
    }

    /// Writes a checkpoint if the run writes any.
    fn write_checkpoint(
        &mut self,
        run: &mut Continued<'_>,
        reached: Reached,
        time: f64,
    ) -> Result<(), StepFailure> {
        let Some(checkpoints) = &mut run.checkpoints else { return Ok(()) };
        run.system.times.after = run.timer.elapsed();
        Ok(checkpoints.write((reached, time), self.save()?, run.system, run.recorder)?)
    }

    fn step(
        &mut self,
        system: &mut System,
        time: f64,
        length: f64,
        load: fn(&mut Rail, &mut Part) -> Result<(), UnitError>,
    ) -> Result<(), UnitError> {
        let parts = system.parts.iter_mut().enumerate();
        let rail_of = |part| self.rails.iter().position(|rail| rail.part == part);
        let mut parts: Vec<_> =
            parts.filter_map(|(number, part)| Some((rail_of(number)?, part))).collect();
        parts.sort_by_key(|(rail, _)| *rail);
        let mut pairs: Vec<_> =
            self.rails.iter_mut().zip(parts).map(|(rail, (_, part))| (rail, part)).collect();
        parallel::for_each(&mut pairs, |(rail, part)| {
            load(rail, part)?;
            part.advance(time, length)
        })
    }

    /// Exchange steps per step of the rails.
    fn every(&self, system: &System) -> u64 {
        self.rails.first().map_or(1, |rail| system.parts[rail.part].every)
    }
}

/// What goes on of a run.
pub struct Continued<'r> {
    /// The units.
    pub system: &'r mut System,
    /// Records them.
    pub recorder: &'r mut Recorder,
    /// Tells how far it is.
    pub progress: &'r mut Progress,
    /// Writes checkpoints, if they are wanted.
    pub checkpoints: Option<&'r mut Checkpoints>,
    /// Wall time of what comes after the run.
    pub timer: Timer,
    /// Whether it is to stop.
    pub stop: &'r mut Stop<'r>,
}

/// Says before a step with its number, which begins at a time in s, whether the run is to stop.
pub type Stop<'s> = dyn FnMut(u64, f64) -> Option<Stopped> + 's;

/// Equal steps of a stage, so many of them done, and after how many of them the rails are recorded.
#[derive(Clone, Copy)]
struct Steps {
    stage: usize,
    done: u64,
    from: f64,
    length: f64,
    steps: u64,
    per_record: u64,
}

fn tape_error(name: &str, error: &io::Error) -> UnitError {
    UnitError {
        instance: name.into(),
        source_file: "the wheels' loads on disk, for further trains".into(),
        action: "writing or reading".into(),
        status: None,
        last_message: Some(error.to_string().into()),
    }
}
