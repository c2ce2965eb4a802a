//! A component of a system that runs: its unit, what goes in and out, and when it steps.

use std::time::Duration;

use serde::{Deserialize, Serialize};

use super::checks::{Watch, WatchState};
use super::clock::Clock;
use super::signals::Signals;
use super::structure::Sampling;
use super::times::Stopwatch;
use super::unit::{Unit, UnitError};
use crate::interface::VariableType;

/// A unit of a system with what goes in and out.
pub struct Part {
    /// The unit.
    pub unit: Box<dyn Unit>,
    /// Inputs that are connected, as the unit gets them for its next step.
    pub inputs: Signals,
    /// Outputs that are connected or observed, as they were after its last step.
    pub outputs: Signals,
    /// Inputs that have a start value.
    pub starts: Signals,
    /// It steps at every so many communication points.
    pub every: u64,
    /// Stage in which it steps.
    pub stage: usize,
    /// Checks what the unit gives.
    pub watch: Watch,
    /// Wall time of its steps so far.
    pub wall: Duration,
    /// Whether a step of it goes on elsewhere.
    begun: bool,
    /// The slowest of them.
    pub slowest: SlowestStep,
    /// The last that was taken of its warnings.
    pub last_message: Option<String>,
    /// Sums of the connected inputs since its last step, where it steps less often than the others.
    pub(super) sums: Vec<f64>,
    /// What becomes of the sum of each of them.
    pub(super) samplings: Vec<Sampling>,
}

/// The step of a unit that took longest.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct SlowestStep {
    /// Its wall time.
    pub wall: Duration,
    /// Simulated time at its end, s.
    pub end: f64,
}

/// All that changes of a part while a system runs.
#[derive(Serialize, Deserialize)]
pub struct PartState {
    /// The unit's own.
    #[serde(with = "serde_bytes")]
    unit: Vec<u8>,
    inputs: Signals,
    outputs: Signals,
    watch: WatchState,
    wall: Duration,
    slowest: SlowestStep,
    sums: Vec<f64>,
}

impl Part {
    /// A unit that is not connected yet.
    pub fn new(unit: Box<dyn Unit>, stage: usize, every: u64) -> Self {
        let watch = Watch::of(unit.interface());
        Self {
            unit,
            watch,
            inputs: Signals::default(),
            outputs: Signals::default(),
            starts: Signals::default(),
            every,
            stage,
            wall: Duration::ZERO,
            begun: false,
            slowest: SlowestStep::default(),
            last_message: None,
            sums: vec![],
            samplings: vec![],
        }
    }

    /// Whether point `k + 1` ends one of its steps.
    pub fn is_due(&self, k: u64) -> bool {
        (k + 1).is_multiple_of(self.every)
    }

    /// Steps to point `k + 1` if that ends one of its steps.
    ///
    /// # Errors
    /// When the unit fails.
    pub(super) fn step(&mut self, clock: Clock, k: u64) -> Result<(), UnitError> {
        if !self.is_due(k) {
            return Ok(());
        }
        let (time, length) = self.span(clock, k);
        if std::mem::take(&mut self.begun) {
            return self.complete(time, length);
        }
        self.form_means();
        self.advance(time, length)
    }

    /// Begins that step of a unit that computes elsewhere, so that it goes on while others step.
    ///
    /// # Errors
    /// When the unit fails.
    pub(super) fn begin(&mut self, clock: Clock, k: u64) -> Result<(), UnitError> {
        if !self.unit.is_separate() || !self.is_due(k) {
            return Ok(());
        }
        self.form_means();
        self.inputs.set(self.unit.as_mut())?;
        let (time, length) = self.span(clock, k);
        self.unit.begin_step(time, length)?;
        self.begun = true;
        Ok(())
    }

    /// Where a step to point `k + 1` begins, and how long it is, s.
    fn span(&self, clock: Clock, k: u64) -> (f64, f64) {
        (clock.at(k + 1 - self.every), self.every as f64 * clock.length)
    }

    /// Steps with the inputs as they are from `time` over `length`, s.
    ///
    /// # Errors
    /// When the unit fails.
    pub fn advance(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.inputs.set(self.unit.as_mut())?;
        self.complete(time, length)
    }

    fn complete(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        // Asking the clock takes longer than the step of a unit that is brief.
        let watch = (!self.unit.is_brief()).then(Stopwatch::start);
        self.unit.step(time, length)?;
        self.take_outputs(time + length)?;
        let wall = watch.map_or(Duration::ZERO, |mut watch| watch.lap());
        self.wall += wall;
        if wall > self.slowest.wall {
            self.slowest = SlowestStep { wall, end: time + length };
        }
        Ok(())
    }

    /// Gets the outputs as they are at `time`, s, and checks them.
    ///
    /// # Errors
    /// When the unit fails, or an output cannot be.
    pub fn take_outputs(&mut self, time: f64) -> Result<(), UnitError> {
        let Self { unit, outputs, watch, .. } = self;
        outputs.get(unit.as_mut())?;
        watch.check(outputs, unit.as_ref(), time)?;
        watch.check_motions(outputs, unit.as_ref(), time)
    }

    /// Gets other variables as they are at `time`, s, and checks them.
    ///
    /// # Errors
    /// When the unit fails, or a value cannot be.
    pub fn take(&mut self, signals: &mut Signals, time: f64) -> Result<(), UnitError> {
        signals.get(self.unit.as_mut())?;
        self.watch.check(signals, self.unit.as_ref(), time)
    }

    /// Takes the warnings of the unit and of the checks, under the unit's name.
    pub fn take_warnings(&mut self) -> Vec<String> {
        let texts = self.unit.take_warnings().into_iter().chain(self.watch.take_warnings());
        let texts: Vec<String> = texts.collect();
        self.last_message = texts.last().cloned().or(self.last_message.take());
        texts.iter().map(|text| format!("{}: {text}", self.unit.name())).collect()
    }

    /// Turns the sums into the inputs of the next step and begins new ones.
    fn form_means(&mut self) {
        let sums = self.sums.iter_mut().zip(&self.samplings);
        for (input, (sum, sampling)) in self.inputs.reals.values.iter_mut().zip(sums) {
            match sampling {
                Sampling::Last => continue,
                Sampling::Mean => *input = *sum / self.every as f64,
                Sampling::Sum => *input = *sum,
            }
            *sum = 0.0;
        }
    }

    /// What another run needs to go on from here.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn save(&mut self) -> Result<PartState, UnitError> {
        Ok(PartState {
            unit: self.unit.save()?,
            inputs: self.inputs.clone(),
            outputs: self.outputs.clone(),
            watch: self.watch.save(),
            wall: self.wall,
            slowest: self.slowest,
            sums: self.sums.clone(),
        })
    }

    /// Goes on from what the same part of another run has saved.
    ///
    /// # Errors
    /// When the unit refuses, or it was saved by another part.
    pub fn restore(&mut self, saved: PartState) -> Result<(), UnitError> {
        let PartState { unit, inputs, outputs, watch, wall, slowest, sums } = saved;
        let same = inputs.has_variables_of(&self.inputs)
            && outputs.has_variables_of(&self.outputs)
            && sums.len() == self.sums.len();
        if !same {
            return Err(self.unit.differs("it is one with other variables"));
        }
        self.unit.restore(&unit)?;
        (self.inputs, self.outputs, self.sums) = (inputs, outputs, sums);
        self.watch.restore(watch);
        (self.wall, self.slowest) = (wall, slowest);
        Ok(())
    }

    /// An input as `component.variable`, for messages.
    pub fn input_name(&self, kind: VariableType, index: usize) -> String {
        let reference = self.inputs.reference(kind, index);
        let variable = self.unit.interface().name_of(kind, reference).unwrap_or("?");
        format!("{}.{variable}", self.unit.name())
    }
}
