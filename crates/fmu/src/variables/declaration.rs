//! The declaration of a model's variables: all that `ModelVariables` (§2.2.7) states of them.

use super::bounds::Bounds;
use super::unit::Unit;
use super::values::{Real, Type, Values};
use super::variable::{Causality, Initial, Kind, Terminal, Variability, Variable};

/// All variables of a model in the order in which they are declared.
///
/// Most variables stand in tables, which [`variables!`](crate::variables!) declares; this declares
/// those that fit no table:
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

    /// Gives a declared variable another start value than its table has: one that a file tells.
    pub fn set_start(&mut self, variable: Real, value: f64) {
        for declared in &mut self.variables {
            if let Kind::Real { start, .. } = &mut declared.kind
                && declared.reference == variable.reference()
            {
                *start = value;
            }
        }
        self.start[variable] = value;
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
    ) -> VariableDeclaration<'_, f64> {
        self.variable(name.into(), description.into(), (unit, Bounds::NONE))
    }

    /// Begins an Integer variable.
    pub fn integer(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
    ) -> VariableDeclaration<'_, i32> {
        self.variable(name.into(), description.into(), Bounds::NONE)
    }

    /// Begins a Boolean variable.
    pub fn boolean(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
    ) -> VariableDeclaration<'_, bool> {
        self.variable(name.into(), description.into(), ())
    }

    /// Begins a String variable.
    pub fn text(
        &mut self,
        name: impl Into<String>,
        description: impl Into<String>,
    ) -> VariableDeclaration<'_, String> {
        self.variable(name.into(), description.into(), [].as_slice())
    }

    fn variable<T: Type>(
        &mut self,
        name: String,
        description: String,
        domain: T::Domain,
    ) -> VariableDeclaration<'_, T> {
        VariableDeclaration { declaration: self, name, description, domain }
    }
}

/// A variable that is being declared; `input`, `output`, `parameter` or `tunable` ends it.
#[must_use = "ends with input, output, parameter or tunable"]
pub struct VariableDeclaration<'d, T: Type> {
    declaration: &'d mut Declaration,
    name: String,
    description: String,
    /// What belongs to the type besides the start value: unit, bounds, choices.
    domain: T::Domain,
}

impl VariableDeclaration<'_, f64> {
    /// Smallest and largest value allowed.
    pub fn within(mut self, bounds: impl Into<Bounds<f64>>) -> Self {
        self.domain.1 = bounds.into();
        self
    }
}

impl VariableDeclaration<'_, i32> {
    /// Smallest and largest value allowed.
    pub fn within(mut self, bounds: impl Into<Bounds<i32>>) -> Self {
        self.domain = bounds.into();
        self
    }
}

impl VariableDeclaration<'_, String> {
    /// The texts allowed.
    pub fn one_of(mut self, choices: &'static [&'static str]) -> Self {
        self.domain = choices;
        self
    }
}

impl<T: Type> VariableDeclaration<'_, T> {
    /// An input with its start value.
    pub fn input(self, start: impl Into<T>) -> T::Handle {
        self.declare(start.into(), Causality::Input, T::VARIABILITY, None)
    }

    /// An output that the model computes.
    pub fn output(self) -> T::Handle {
        let initial = Some(Initial::Calculated);
        self.declare(T::default(), Causality::Output, T::VARIABILITY, initial)
    }

    /// A parameter that is fixed once the initialisation has ended.
    pub fn parameter(self, start: impl Into<T>) -> T::Handle {
        let initial = Some(Initial::Exact);
        self.declare(start.into(), Causality::Parameter, Variability::Fixed, initial)
    }

    /// A parameter that may change between steps.
    pub fn tunable(self, start: impl Into<T>) -> T::Handle {
        let initial = Some(Initial::Exact);
        self.declare(start.into(), Causality::Parameter, Variability::Tunable, initial)
    }

    fn declare(
        self,
        start: T,
        causality: Causality,
        variability: Variability,
        initial: Option<Initial>,
    ) -> T::Handle {
        let Self { declaration, name, description, domain } = self;
        let values = T::store(&mut declaration.start);
        let reference = u32::try_from(values.len()).expect("fewer than 2^32 variables");
        values.push(start.clone());
        declaration.variables.push(Variable {
            name,
            description,
            reference,
            causality,
            variability,
            initial,
            kind: T::kind(start, domain),
        });
        T::handle(reference)
    }
}

#[cfg(test)]
mod tests {
    use super::super::unit;
    use super::*;

    /// The output of every type: its kind says what the C interface and the XML make of it.
    #[test]
    fn an_output_is_continuous_if_real_and_discrete_otherwise() {
        let mut declaration = Declaration::default();
        let _ = declaration.real("speed", unit::METRE_PER_SECOND, "Speed").output();
        let _ = declaration.integer("notch", "Notch").output();
        let _ = declaration.boolean("sanding", "Whether sand is given").output();
        let _ = declaration.text("aspect", "Aspect of the signal").output();
        let variabilities = declaration.variables().iter().map(|variable| variable.variability);
        let (continuous, discrete) = (Variability::Continuous, Variability::Discrete);
        let expected = [continuous, discrete, discrete, discrete];
        assert_eq!(variabilities.collect::<Vec<_>>(), expected);
    }

    #[test]
    fn a_start_value_from_a_file_stands_in_place_of_that_of_the_table() {
        let mut declaration = Declaration::default();
        let axles = declaration.integer("axles", "Axles").parameter(4);
        let friction = declaration.real("friction", unit::ONE, "Friction").within(0.0..).input(0.3);
        declaration.set_start(friction, 0.36);
        let [first, second] = declaration.variables() else { panic!("two variables") };
        assert!(matches!(first.kind, Kind::Integer { start: 4, .. }));
        assert!(matches!(second.kind, Kind::Real { start: 0.36, .. }));
        let start = declaration.start_values();
        assert_eq!((start[axles], start[friction]), (4, 0.36));
    }

    #[test]
    fn references_count_each_type_by_itself() {
        let mut declaration = Declaration::default();
        let mass = declaration.real("mass", unit::KILOGRAM, "Mass").parameter(1.0);
        let axles = declaration.integer("axles", "Axles").within(2..=8).parameter(4);
        let load = declaration.real("load", unit::KILOGRAM, "Load").tunable(2.0);
        let references = (mass.reference(), axles.reference(), load.reference());
        assert_eq!(references, (0, 0, 1));
        let start = declaration.start_values();
        assert_eq!((start[mass], start[axles], start[load]), (1.0, 4, 2.0));
    }
}
