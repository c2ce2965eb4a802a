//! The step of a system: one loop for trains and for any other system.
//!
//! After each step the outputs of a unit are got once; then everything is computed, set once and
//! stepped, so that no output is read between a set and the next step (FMI 2.0 §4.2.4). Units that compute
//! elsewhere are begun first. Times
//! are t_k = t_0 + k·h from integers. Units share nothing within a stage, and sums are taken in the
//! order of the connections, so that the number of threads cannot change a result.

use std::collections::HashMap;
use std::ops::Range;

use super::checks::Checks;
use super::clock::Clock;
use super::links::Links;
use super::parallel;
use super::part::{Part, PartState};
use super::times::{StepTimes, Stopwatch};
use super::unit::{Unit, UnitError};

/// Units and what flows between them.
pub struct System {
    /// The communication points.
    pub clock: Clock,
    /// The units, in the order of their stages.
    pub parts: Vec<Part>,
    /// The stages of a step, in their order.
    pub(super) stages: Vec<Stage>,
    /// Where the wall time goes.
    pub times: StepTimes,
    /// Number of each part by its name.
    numbers: HashMap<String, usize>,
}

/// A unit wants the run to end.
#[derive(Debug)]
pub struct WishToEnd {
    /// Number of its part.
    pub part: usize,
    /// Its name and file.
    pub of: String,
    /// The time until which it came, s.
    pub time: f64,
}

/// Units that step together, and what they take before.
pub(super) struct Stage {
    /// Numbers of its parts: first those whose steps are too short for a thread of their own.
    pub parts: Range<usize>,
    /// How many of these there are.
    pub brief: usize,
    /// What its parts take.
    pub links: Links,
}

impl System {
    /// A system of parts that are not connected yet.
    pub fn new(clock: Clock, mut parts: Vec<Part>) -> Self {
        parts.sort_by_key(|part| (part.stage, !part.unit.is_brief()));
        let names = parts.iter().map(|part| part.unit.name().to_owned());
        let numbers = names.zip(0..).collect();
        let count = parts.last().map_or(0, |part| part.stage + 1);
        let stage = |stage| {
            let begin = parts.partition_point(|part| part.stage < stage);
            let end = parts.partition_point(|part| part.stage <= stage);
            let brief = parts[begin..end].partition_point(|part| part.unit.is_brief());
            Stage { parts: begin..end, brief, links: Links::default() }
        };
        let stages: Vec<_> = (0..count).map(stage).collect();
        Self { clock, stages, times: StepTimes::of(count), numbers, parts }
    }

    /// Takes all units from point `k` to `k + 1`.
    ///
    /// # Errors
    /// When a unit fails; the others keep what they have.
    pub fn step(&mut self, k: u64) -> Result<(), UnitError> {
        let clock = self.clock;
        for (stage, time) in self.stages.iter().zip(&mut self.times.stages) {
            let mut watch = Stopwatch::start();
            stage.links.pull(&mut self.parts);
            self.times.exchange += watch.lap();
            let parts = &mut self.parts[stage.parts.clone()];
            let (brief, long) = parts.split_at_mut(stage.brief);
            long.iter_mut().try_for_each(|part| part.begin(clock, k))?;
            brief.iter_mut().try_for_each(|part| part.step(clock, k))?;
            parallel::for_each(long, |part| part.step(clock, k))?;
            *time += watch.lap();
        }
        Ok(())
    }

    /// What another system of the same parts needs to go on from here.
    ///
    /// # Errors
    /// When a unit refuses.
    pub fn save(&mut self) -> Result<Vec<PartState>, UnitError> {
        let mut saved: Vec<_> = self.parts.iter_mut().map(|part| (part, None)).collect();
        parallel::for_each(&mut saved, |(part, state)| {
            *state = Some(part.save()?);
            Ok(())
        })?;
        Ok(saved.into_iter().filter_map(|(_, state)| state).collect())
    }

    /// Goes on, when the initialisation has ended, from what another system of the same parts has saved.
    ///
    /// # Errors
    /// When a unit refuses.
    pub fn restore(&mut self, saved: Vec<PartState>) -> Result<(), UnitError> {
        let mut pairs: Vec<_> = self.parts.iter_mut().zip(saved.into_iter().map(Some)).collect();
        parallel::for_each(&mut pairs, |(part, state)| {
            state.take().map_or(Ok(()), |state| part.restore(state))
        })
    }

    /// The wish of the unit whose step failed with this error, if it failed to end the run.
    pub fn wish_to_end(&self, error: &UnitError) -> Option<WishToEnd> {
        let part = self.number(&error.instance)?;
        let unit = self.parts[part].unit.as_ref();
        let of = format!("{} ({})", unit.name(), unit.source_file());
        unit.wish_to_end().map(|time| WishToEnd { part, of, time })
    }

    /// The number of the part of that name.
    pub fn number(&self, name: &str) -> Option<usize> {
        self.numbers.get(name).copied()
    }

    /// All units, in the order of the parts.
    pub fn units(&self) -> impl Iterator<Item = &dyn Unit> {
        self.parts.iter().map(|part| part.unit.as_ref())
    }

    /// Says what becomes of values of its units that cannot be.
    pub fn set_checks(&mut self, checks: Checks) {
        self.parts.iter_mut().for_each(|part| part.watch.checks = checks);
    }

    /// Takes the warnings of all units and of the checks.
    pub fn take_warnings(&mut self) -> Vec<String> {
        self.parts.iter_mut().flat_map(Part::take_warnings).collect()
    }

    /// All units, in the order of the parts.
    pub fn units_mut(&mut self) -> impl Iterator<Item = &mut Box<dyn Unit>> {
        self.parts.iter_mut().map(|part| &mut part.unit)
    }
}
