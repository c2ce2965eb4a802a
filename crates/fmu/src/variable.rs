//! The declaration of a model's variables: one place for names, units, value references,
//! start values and everything else that `ModelVariables` (§2.2.7) states.

use serde::Serialize;

use crate::terminals::Terminal;
use crate::unit::Unit;
use crate::values::{Boolean, Integer, Real, Text, Values};

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
        /// Smallest value allowed.
        min: Option<f64>,
        /// Largest value allowed.
        max: Option<f64>,
    },
    /// A whole number with its start value and smallest and largest value.
    Integer {
        /// Start value.
        start: i32,
        /// Smallest value allowed.
        min: Option<i32>,
        /// Largest value allowed.
        max: Option<i32>,
    },
    /// True or false, with its start value.
    Boolean {
        /// Start value.
        start: bool,
    },
    /// Text with its start value.
    Text {
        /// Start value.
        start: String,
    },
}

/// One variable as the model description shows it.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Structured name, such as `wheelset[1].left.creepage.longitudinal`.
    pub name: String,
    /// One sentence for the user.
    pub description: String,
    /// Value reference: place in the array of the variable's type.
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

/// All variables of a model in the order in which they are declared.
///
/// ```
/// use fmu::{Declaration, unit};
/// let mut declaration = Declaration::default();
/// let force = declaration
///     .real("coupler.front.force", unit::NEWTON, "Force of the front coupler, tension positive")
///     .input(0.0);
/// let position = declaration
///     .real("position", unit::METRE, "Chainage of the vehicle's middle")
///     .output();
/// assert_eq!(declaration.variables().len(), 2);
/// assert_eq!((force.reference(), position.reference()), (0, 1));
/// ```
#[derive(Clone, Debug, Default)]
pub struct Declaration {
    variables: Vec<Variable>,
    start: Values,
    terminals: Vec<Terminal>,
}

impl Declaration {
    /// The declared variables in order.
    pub fn variables(&self) -> &[Variable] {
        &self.variables
    }

    /// The start values of all variables; outputs start at zero.
    pub fn start_values(&self) -> &Values {
        &self.start
    }

    /// The declared terminals in order.
    pub fn terminals(&self) -> &[Terminal] {
        &self.terminals
    }

    /// Says that the variables whose names begin with `name` and a dot are connected together.
    pub fn terminal(
        &mut self,
        name: impl Into<String>,
        kind: &'static str,
        description: impl Into<String>,
    ) {
        let terminal = Terminal { name: name.into(), kind, description: description.into() };
        self.terminals.push(terminal);
    }

    /// Begins a Real variable in SI `unit`.
    pub fn real(
        &mut self,
        name: impl Into<String>,
        unit: Unit,
        description: impl Into<String>,
    ) -> RealDeclaration<'_> {
        RealDeclaration {
            declaration: self,
            name: name.into(),
            description: description.into(),
            unit,
            min: None,
            max: None,
        }
    }

    /// A String parameter, such as a file name, with its start value.
    pub fn text_parameter(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
        start: impl Into<String>,
    ) -> Text {
        let start = start.into();
        let reference = push(&mut self.start.texts, start.clone());
        self.parameter(name.into(), description.into(), reference, Kind::Text { start });
        Text(reference)
    }

    /// An Integer parameter with its start value and bounds.
    pub fn integer_parameter(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
        start: i32,
        bounds: (i32, i32),
    ) -> Integer {
        let reference = push(&mut self.start.integers, start);
        let kind = Kind::Integer { start, min: Some(bounds.0), max: Some(bounds.1) };
        self.parameter(name.into(), description.into(), reference, kind);
        Integer(reference)
    }

    /// A Boolean parameter with its start value.
    pub fn boolean_parameter(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
        start: bool,
    ) -> Boolean {
        let reference = push(&mut self.start.booleans, start);
        self.parameter(name.into(), description.into(), reference, Kind::Boolean { start });
        Boolean(reference)
    }

    fn parameter(&mut self, name: String, description: String, reference: u32, kind: Kind) {
        self.variables.push(Variable {
            name,
            description,
            reference,
            causality: Causality::Parameter,
            variability: Variability::Fixed,
            initial: Some(Initial::Exact),
            kind,
        });
    }
}

/// A Real variable on its way into the [`Declaration`]; `input`, `output`, `parameter` or
/// `tunable` ends it and gives the handle.
#[must_use = "ends with input, output, parameter or tunable"]
pub struct RealDeclaration<'d> {
    declaration: &'d mut Declaration,
    name: String,
    description: String,
    unit: Unit,
    min: Option<f64>,
    max: Option<f64>,
}

impl RealDeclaration<'_> {
    /// Smallest value allowed.
    pub fn min(mut self, min: f64) -> Self {
        self.min = Some(min);
        self
    }

    /// Largest value allowed.
    pub fn max(mut self, max: f64) -> Self {
        self.max = Some(max);
        self
    }

    /// A continuous input with its start value.
    pub fn input(self, start: f64) -> Real {
        self.declare(start, Causality::Input, Variability::Continuous, None)
    }

    /// A continuous output that the model computes.
    pub fn output(self) -> Real {
        let initial = Some(Initial::Calculated);
        self.declare(0.0, Causality::Output, Variability::Continuous, initial)
    }

    /// A parameter that is fixed once the initialisation has ended.
    pub fn parameter(self, start: f64) -> Real {
        self.declare(start, Causality::Parameter, Variability::Fixed, Some(Initial::Exact))
    }

    /// A parameter that may change between steps.
    pub fn tunable(self, start: f64) -> Real {
        self.declare(start, Causality::Parameter, Variability::Tunable, Some(Initial::Exact))
    }

    fn declare(
        self,
        start: f64,
        causality: Causality,
        variability: Variability,
        initial: Option<Initial>,
    ) -> Real {
        let reference = push(&mut self.declaration.start.reals, start);
        self.declaration.variables.push(Variable {
            name: self.name,
            description: self.description,
            reference,
            causality,
            variability,
            initial,
            kind: Kind::Real { unit: self.unit, start, min: self.min, max: self.max },
        });
        Real(reference)
    }
}

/// Appends a start value and gives its place.
fn push<T>(values: &mut Vec<T>, value: T) -> u32 {
    let reference = u32::try_from(values.len()).expect("fewer than 2^32 variables");
    values.push(value);
    reference
}
