//! A variable as the model description shows it (§2.2.7), and what belongs together to a terminal.

use serde::Serialize;

use super::bounds::Bounds;
use super::unit::Unit;

/// What a variable is for (§2.2.7, `causality`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Causality {
    /// Constant while the instance runs; set before the initialisation ends.
    Parameter,
    /// Set from outside at any communication point.
    Input,
    /// Computed by the model.
    Output,
}

/// When a variable may change (§2.2.7, `variability`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Variability {
    /// After the initialisation never.
    Fixed,
    /// Between steps, by the environment.
    Tunable,
    /// At events only: all that is not Real.
    Discrete,
    /// At any time.
    Continuous,
}

/// Where the initial value comes from (§2.2.7, `initial`).
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub enum Initial {
    /// From the attribute `start`.
    Exact,
    /// The model computes it.
    Calculated,
}

/// Type of a variable with its start value and what else belongs to the type.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub enum Kind {
    /// A real number.
    Real {
        /// Unit; SI throughout Hotfoot.
        unit: Unit,
        /// Start value.
        start: f64,
        /// Smallest and largest value.
        bounds: Bounds<f64>,
    },
    /// A whole number.
    Integer {
        /// Start value.
        start: i32,
        /// Smallest and largest value.
        bounds: Bounds<i32>,
    },
    /// True or false.
    Boolean {
        /// Start value.
        start: bool,
    },
    /// Text.
    Text {
        /// Start value.
        start: String,
        /// The texts allowed; none: every text.
        #[serde(skip_serializing_if = "<[_]>::is_empty")]
        choices: &'static [&'static str],
    },
}

impl Kind {
    /// What a value must be, in words.
    pub(crate) fn requirement(&self) -> String {
        let (any, unit) = match self {
            Self::Real { unit, .. } => ("a finite number", *unit),
            Self::Integer { .. } => ("a whole number", super::unit::ONE),
            Self::Boolean { .. } => return "true or false".to_owned(),
            Self::Text { choices: [], .. } => return "a text".to_owned(),
            Self::Text { .. } => return self.range(),
        };
        match self.range().as_str() {
            "" => any.to_owned(),
            range => format!("{any}, {}", unit.after(range)),
        }
    }

    /// What values are allowed, in words without unit; empty if all are.
    pub(crate) fn range(&self) -> String {
        match self {
            Self::Real { bounds, .. } => bounds.to_string(),
            Self::Integer { bounds, .. } => bounds.to_string(),
            Self::Boolean { .. } => String::new(),
            Self::Text { choices, .. } => {
                let quoted: Vec<_> = choices.iter().map(|text| format!("\"{text}\"")).collect();
                quoted.join(" or ")
            }
        }
    }
}

/// One variable as the model description shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Structured name, such as `wheelset[1].left.creepage.longitudinal`.
    pub name: String,
    /// One sentence for the user.
    pub description: String,
    /// Value reference: index in the array of the variable's type.
    pub reference: u32,
    /// What it is for.
    pub causality: Causality,
    /// When it may change.
    pub variability: Variability,
    /// Where its first value comes from; inputs have none.
    pub initial: Option<Initial>,
    /// Type, start value, unit, bounds.
    pub kind: Kind,
}

/// Variables that are connected together: all whose names begin with `name` and a dot.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Terminal {
    /// What the names of the variables begin with, such as `coupler.front`.
    pub name: String,
    /// What it is, so that only terminals that fit are connected, such as `coupler`.
    pub kind: &'static str,
    /// One sentence for the user.
    pub description: String,
}
