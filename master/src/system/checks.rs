//! Checks of what units give: numbers are finite, inside of the range that the variable declares or its
//! role has, and change no faster than they can.
//!
//! One comparison of an array with its bounds tells all but the last; only if it fails are the values
//! looked at one by one.

use std::collections::HashSet;

use numerics::seconds;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

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
    /// What it has found so far.
    found: Found,
}

/// What a watch has found so far.
#[derive(Clone, Default, Serialize, Deserialize)]
struct Found {
    warned: HashSet<(VariableType, u32)>,
    warnings: Vec<String>,
    more: usize,
}

/// All that changes of a watch while a system runs.
#[derive(Serialize, Deserialize)]
pub struct WatchState {
    found: Found,
    /// Time, s, and value of each variable whose changes are watched, at its last step.
    last: Vec<Option<(f64, f64)>>,
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
            self.deal_with(unit, variable, (value, time), &problem)?;
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
            self.deal_with(unit, variable, (jump.value, time), &jump.to_string())?;
        }
        Ok(())
    }

    /// Deals with a value that cannot be.
    fn deal_with(
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
            || format!("{} at {} s", shown(unit.interface(), variable, value), seconds(time));
        if is_error {
            return Err(UnitError {
                instance: unit.name().into(),
                source_file: unit.source_file().into(),
                action: format!("the check of {}", what()).into(),
                status: None,
                last_message: Some(format!("the value {problem}").into()),
            });
        }
        let Found { warned, warnings, more } = &mut self.found;
        if warned.insert(variable) {
            match warnings.len() < MOST_WARNINGS {
                true => warnings.push(format!("{} {problem}", what())),
                false => *more += 1,
            }
        }
        Ok(())
    }

    /// What another watch over the same variables needs to go on from here.
    pub fn save(&self) -> WatchState {
        let last = self.motions.iter().map(|motion| motion.last).collect();
        WatchState { found: self.found.clone(), last }
    }

    /// Goes on from what another watch over the same variables has saved.
    pub fn restore(&mut self, saved: WatchState) {
        self.found = saved.found;
        for (motion, last) in self.motions.iter_mut().zip(saved.last) {
            motion.last = last;
        }
    }

    /// Takes out the warnings.
    pub fn take_warnings(&mut self) -> Vec<String> {
        let more = match std::mem::take(&mut self.found.more) {
            0 => None,
            more => Some(format!("{more} more variables have values that cannot be")),
        };
        std::mem::take(&mut self.found.warnings).into_iter().chain(more).collect()
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::mock::Mock;
    use crate::system::part::Part;

    /// A unit with outputs y0, y1, … that become the given values in its first step.
    fn part(checks: Checks, values: &[f64]) -> Part {
        let names: Vec<_> = (0..values.len()).map(|i| (format!("y{i}"), "output")).collect();
        let given = values.to_vec();
        let step = move |own: &mut [f64], _: f64, _: f64| own.copy_from_slice(&given);
        let mock = Mock::new("m", &names, &Default::default(), step);
        let mut part = Part::new(Box::new(mock), 0, 1);
        for reference in 0..values.len() {
            part.outputs.index(VariableType::Real, reference as u32);
        }
        part.watch.checks = checks;
        part
    }

    #[test]
    fn what_is_not_finite_is_an_error_a_warning_or_nothing() {
        for value in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            for checks in [Checks::Finite, Checks::Error] {
                let error = part(checks, &[0.0, value]).advance(2.0, 0.5).unwrap_err().to_string();
                let wanted = format!(
                    "m: the value is not a finite number (a mock: the check of y1 = {value:?} at \
                     2.5 s failed)"
                );
                assert_eq!(error, wanted);
            }
            let mut warned = part(Checks::Warn, &[0.0, value]);
            warned.advance(2.0, 0.5).unwrap();
            warned.advance(2.5, 0.5).unwrap();
            let wanted = format!("m: y1 = {value:?} at 2.5 s is not a finite number");
            assert_eq!(warned.take_warnings(), [wanted]);
            let mut off = part(Checks::Off, &[0.0, value]);
            off.advance(2.0, 0.5).unwrap();
            assert!(off.take_warnings().is_empty());
        }
    }

    /// Friction power of -1 MW and of 1e300 W, and 1 kW.
    #[test]
    fn what_is_out_of_its_range_is_a_warning_or_an_error() {
        let powers = [-1e6, 1e300, 1e3];
        let limited = |checks| {
            let mut part = part(checks, &powers);
            for reference in 0..3 {
                part.watch.limit(reference, Range { min: 0.0, max: 1e8 }, None);
            }
            part
        };
        let mut warned = limited(Checks::Finite);
        warned.advance(0.0, 1.0).unwrap();
        let wanted = [
            "m: y0 = -1000000.0 at 1 s is less than 0.0, the least that it can be",
            "m: y1 = 1e300 at 1 s is more than 100000000.0, the most that it can be",
        ];
        assert_eq!(warned.take_warnings(), wanted);
        let error = limited(Checks::Error).advance(0.0, 1.0).unwrap_err().to_string();
        assert!(error.contains("y0 = -1000000.0 at 1 s"), "{error}");
    }

    #[test]
    fn a_value_that_changes_faster_than_it_can_is_told() {
        let mut speed = part(Checks::Finite, &[-16.0]);
        speed.watch.limit(0, Range::FINITE, Some(200.0));
        speed.take_outputs(0.0).unwrap();
        speed.advance(0.0, 0.1).unwrap();
        assert!(speed.take_warnings().is_empty(), "16 m/s in 0.1 s are 160 m/s2");
        let mut speed = part(Checks::Finite, &[-16.0]);
        speed.watch.limit(0, Range::FINITE, Some(200.0));
        speed.take_outputs(0.0).unwrap();
        speed.advance(0.0, 0.001).unwrap();
        let [warning] = speed.take_warnings().try_into().unwrap();
        assert!(
            warning.contains("y0 = -16.0 at 0.001 s was 0.0 only 0.001000 s before"),
            "{warning}"
        );
    }

    #[test]
    fn of_many_variables_the_first_are_told_and_how_many_more() {
        let mut many = part(Checks::Warn, &[f64::NAN; 50]);
        many.advance(0.0, 1.0).unwrap();
        let warnings = many.take_warnings();
        assert_eq!(warnings.len(), MOST_WARNINGS + 1);
        assert_eq!(warnings[MOST_WARNINGS], "m: 30 more variables have values that cannot be");
    }
}
