//! Checks of what units give: numbers are finite, inside of the range that the variable declares or its
//! role has, and change no faster than they can.
//!
//! One comparison of an array with its bounds tells all but the last; only if it fails are the values
//! looked at one by one.

use std::collections::HashSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::clock;
use super::motion::Motion;
use super::signals::{Ranges, Signals};
use super::unit::{Unit, UnitError};
use crate::interface::range::Range;
use crate::interface::{Interface, VariableType};

/// What becomes of values of units that cannot be.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Checks {
    /// A value that is not finite ends the run; one out of its range is a warning.
    #[default]
    #[serde(skip)]
    Finite,
    /// Both end the run.
    Error,
    /// Both are warnings, the first time for each variable.
    Warn,
    /// They are not looked for.
    Off,
}

/// Most warnings of a unit that are told in full.
const MOST_WARNINGS: usize = 20;

/// Checks what a unit gives.
#[derive(Default)]
pub struct Watch {
    /// What becomes of values that cannot be.
    pub checks: Checks,
    /// The ranges of the variables that have one.
    ranges: Ranges,
    /// Variables that cannot change faster than so much.
    motions: Vec<Motion>,
    warned: HashSet<(VariableType, u32)>,
    warnings: Vec<String>,
    more: usize,
}

impl Watch {
    /// A watch over the ranges that the variables of an interface declare.
    pub fn of(interface: &Interface) -> Self {
        let mut watch = Self::default();
        for variable in interface.variables() {
            let range = match variable.kind {
                VariableType::Boolean => Range { min: 0.0, max: 1.0 },
                _ => variable.range,
            };
            if range != Range::FINITE {
                watch.narrow((variable.kind, variable.reference), range);
            }
        }
        watch
    }

    /// Lets a Real be in a range only, and change by so much a second at most.
    pub fn limit(&mut self, reference: u32, range: Range, most_per_second: Option<f64>) {
        self.narrow((VariableType::Real, reference), range);
        self.motions.extend(most_per_second.map(|most| Motion::new(reference, most)));
    }

    fn narrow(&mut self, variable: (VariableType, u32), range: Range) {
        let own = self.ranges.entry(variable).or_insert(Range::FINITE);
        *own = own.and(range);
    }

    /// Checks what a unit has given at `time`, s.
    ///
    /// # Errors
    /// When a value cannot be, if that ends the run.
    pub fn check(
        &mut self,
        signals: &mut Signals,
        unit: &dyn Unit,
        time: f64,
    ) -> Result<(), UnitError> {
        if self.checks == Checks::Off || signals.are_within(&self.ranges) {
            return Ok(());
        }
        for (variable, value, range) in signals.outside() {
            let problem = if !value.is_finite() {
                "is not a finite number".to_owned()
            } else if value < range.min {
                format!("is less than {:?}, the least that it can be", range.min)
            } else {
                format!("is more than {:?}, the most that it can be", range.max)
            };
            self.found(unit, variable, (value, time), &problem)?;
        }
        Ok(())
    }

    /// Checks how fast the outputs of a unit have changed until `time`, s.
    ///
    /// # Errors
    /// When one was too fast, if that ends the run.
    pub fn check_motions(
        &mut self,
        outputs: &Signals,
        unit: &dyn Unit,
        time: f64,
    ) -> Result<(), UnitError> {
        if self.checks == Checks::Off {
            return Ok(());
        }
        let jumps: Vec<_> = self
            .motions
            .iter_mut()
            .filter_map(|motion| Some((motion.reference, motion.jump(outputs, time)?)))
            .collect();
        for (reference, jump) in jumps {
            let variable = (VariableType::Real, reference);
            self.found(unit, variable, (jump.value, time), &jump.to_string())?;
        }
        Ok(())
    }

    /// Deals with a value that cannot be.
    fn found(
        &mut self,
        unit: &dyn Unit,
        variable: (VariableType, u32),
        (value, time): (f64, f64),
        problem: &str,
    ) -> Result<(), UnitError> {
        let is_error = match self.checks {
            Checks::Error => true,
            Checks::Finite => !value.is_finite(),
            Checks::Warn | Checks::Off => false,
        };
        let what =
            || format!("{} at {} s", shown(unit.interface(), variable, value), clock::shown(time));
        if is_error {
            return Err(UnitError {
                instance: unit.name().into(),
                source_file: unit.source_file().into(),
                action: format!("the check of {}", what()).into(),
                status: None,
                last_message: Some(format!("the value {problem}").into()),
            });
        }
        if self.warned.insert(variable) {
            match self.warnings.len() < MOST_WARNINGS {
                true => self.warnings.push(format!("{} {problem}", what())),
                false => self.more += 1,
            }
        }
        Ok(())
    }

    /// Takes out the warnings.
    pub fn take_warnings(&mut self) -> Vec<String> {
        let more = match std::mem::take(&mut self.more) {
            0 => None,
            more => Some(format!("{more} more variables have values that cannot be")),
        };
        std::mem::take(&mut self.warnings).into_iter().chain(more).collect()
    }
}

/// A variable with its value and unit.
fn shown(interface: &Interface, (kind, reference): (VariableType, u32), value: f64) -> String {
    let Some(name) = interface.name_of(kind, reference) else {
        return format!("value reference {reference} = {value:?}");
    };
    let unit = interface.variable(name).and_then(|variable| variable.unit.as_deref());
    match unit {
        None | Some("1" | "") => format!("{name} = {value:?}"),
        Some(unit) => format!("{name} = {value:?} {unit}"),
    }
}
