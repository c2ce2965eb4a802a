//! A model's interface, made ready for an instance: checked, and compact where calls are often.

use std::collections::HashSet;
use std::fmt::Display;
use std::path::Path;

use crate::calls::{Phase, Phases, settable};
use crate::error::Error;
use crate::guid::Guid;
use crate::model::{Model, ModelError};
use crate::variable::{Causality, Declaration, Kind, Variability, Variable};

/// What an instance knows of its variables.
pub(crate) struct Interface<M: Model> {
    pub(crate) declaration: Declaration,
    pub(crate) signals: M::Signals,
    pub(crate) guid: Guid,
    pub(crate) rules: Rules,
}

impl<M: Model> Interface<M> {
    /// Declares the variables of the model with the files in `resources`.
    pub(crate) fn new(resources: &Path) -> Result<Self, Error> {
        let mut declaration = Declaration::default();
        let signals = M::declare(resources, &mut declaration).map_err(Error::Interface)?;
        check(declaration.variables()).map_err(Error::Interface)?;
        Ok(Self {
            guid: Guid::of(M::IDENTITY.identifier, declaration.variables()),
            rules: Rules::of(declaration.variables()),
            signals,
            declaration,
        })
    }
}

/// Names must be unique, and start values finite and within their bounds (§2.2.7).
fn check(variables: &[Variable]) -> Result<(), ModelError> {
    let mut names = HashSet::new();
    for Variable { name, kind, .. } in variables {
        if !names.insert(name) {
            return Err(ModelError::new(format!("`{name}` is declared twice")));
        }
        let inside = match kind {
            Kind::Real { start, min, max, .. } => Rule::real(*min, *max).admits(start),
            Kind::Integer { start, min, max } => Rule::integer(*min, *max).admits(start),
            Kind::Boolean { .. } | Kind::Text { .. } => true,
        };
        if !inside {
            let bounds = kind.bounds();
            return Err(ModelError::new(format!("the start value of `{name}` must be {bounds}")));
        }
    }
    Ok(())
}

/// When variables may be set and to what, by type and value reference.
#[derive(Default)]
pub(crate) struct Rules {
    pub(crate) reals: Vec<Rule<f64>>,
    pub(crate) integers: Vec<Rule<i32>>,
    pub(crate) booleans: Vec<Rule<bool>>,
    pub(crate) texts: Vec<Phases>,
}

impl Rules {
    fn of(variables: &[Variable]) -> Self {
        let mut rules = Self::default();
        for variable in variables {
            let settable = settable(variable);
            match &variable.kind {
                Kind::Real { min, max, .. } => {
                    rules.reals.push(Rule { settable, ..Rule::real(*min, *max) })
                }
                Kind::Integer { min, max, .. } => {
                    rules.integers.push(Rule { settable, ..Rule::integer(*min, *max) })
                }
                Kind::Boolean { .. } => {
                    rules.booleans.push(Rule { settable, min: false, max: true })
                }
                Kind::Text { .. } => rules.texts.push(settable),
            }
        }
        rules
    }
}

/// When a variable may be set, and the smallest and largest value.
#[derive(Clone, Copy)]
pub(crate) struct Rule<T> {
    pub(crate) settable: Phases,
    min: T,
    max: T,
}

impl Rule<f64> {
    /// Without bounds every finite value is admitted.
    fn real(min: Option<f64>, max: Option<f64>) -> Self {
        Self { settable: Phases::NONE, min: min.unwrap_or(f64::MIN), max: max.unwrap_or(f64::MAX) }
    }
}

impl Rule<i32> {
    fn integer(min: Option<i32>, max: Option<i32>) -> Self {
        Self { settable: Phases::NONE, min: min.unwrap_or(i32::MIN), max: max.unwrap_or(i32::MAX) }
    }
}

impl<T: PartialOrd> Rule<T> {
    /// Whether the value is within the bounds; NaN never is.
    pub(crate) fn admits(&self, value: &T) -> bool {
        *value >= self.min && *value <= self.max
    }
}

impl Kind {
    /// What a value must be, in words.
    pub(crate) fn bounds(&self) -> String {
        let any = match self {
            Self::Real { .. } => "a finite number",
            Self::Integer { .. } => "a whole number",
            Self::Boolean { .. } => "true or false",
            Self::Text { .. } => "a text",
        };
        match self.range().as_str() {
            "" => any.to_owned(),
            range => format!("{any}, {range}"),
        }
    }

    /// From where to where a value may be, in words; empty if anywhere.
    pub(crate) fn range(&self) -> String {
        fn words<T: Display>(min: Option<T>, max: Option<T>) -> String {
            match (min, max) {
                (None, None) => String::new(),
                (Some(min), None) => format!("at least {min}"),
                (None, Some(max)) => format!("at most {max}"),
                (Some(min), Some(max)) => format!("from {min} to {max}"),
            }
        }
        match *self {
            Self::Real { min, max, .. } => words(min, max),
            Self::Integer { min, max, .. } => words(min, max),
            Self::Boolean { .. } | Self::Text { .. } => String::new(),
        }
    }
}

impl Variable {
    /// What the variable is, in words for a refusal.
    fn nature(&self) -> &'static str {
        match (self.causality, self.variability) {
            (Causality::Output, _) => "an output",
            (Causality::Input, _) => "an input",
            (Causality::Parameter, Variability::Tunable) => "a tunable parameter",
            (Causality::Parameter, _) => "a fixed parameter",
        }
    }

    /// The error that the variable may not be set in `phase`.
    pub(crate) fn not_settable(&self, phase: Phase) -> Error {
        Error::NotSettable { variable: self.name.clone(), nature: self.nature(), phase }
    }

    /// The error that the variable cannot have `value`.
    pub(crate) fn out_of_bounds(&self, value: impl ToString) -> Error {
        Error::OutOfBounds {
            variable: self.name.clone(),
            value: value.to_string(),
            bounds: self.kind.bounds(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::unit;

    fn mass(declaration: &mut Declaration, start: f64) {
        let mass = declaration.real("mass", unit::KILOGRAM, "Mass").min(1.0);
        let _ = mass.parameter(start);
    }

    #[test]
    fn a_name_that_is_declared_twice_is_refused() {
        let mut declaration = Declaration::default();
        mass(&mut declaration, 2.0);
        mass(&mut declaration, 2.0);
        let error = check(declaration.variables()).unwrap_err();
        assert_eq!(error.to_string(), "`mass` is declared twice");
    }

    #[test]
    fn a_start_value_out_of_bounds_is_refused() {
        for start in [0.0, f64::NAN, f64::INFINITY] {
            let mut declaration = Declaration::default();
            mass(&mut declaration, start);
            let error = check(declaration.variables()).unwrap_err();
            let sentence = "the start value of `mass` must be a finite number, at least 1";
            assert_eq!(error.to_string(), sentence);
        }
    }
}
