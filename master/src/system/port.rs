//! A port: a group of Real variables of a unit that are set or got together, in the fixed order
//! of the exchange.

use std::collections::BTreeMap;

use crate::interface::si::{Dimension, Linear};
use crate::interface::{Interface, Variable, VariableType};
use crate::system::unit::{Unit, UnitError};

/// A variable that a role wants.
#[derive(Debug, Clone, PartialEq)]
pub struct Signal {
    /// Hotfoot's name.
    pub name: String,
    /// Whether the role cannot do without.
    pub required: bool,
    /// The unit of the exchange; none: as the unit has it.
    pub unit: Option<SignalUnit>,
}

/// The SI unit in which a signal is exchanged.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SignalUnit {
    /// Symbol, such as `N`.
    pub symbol: &'static str,
    /// What it is in base units; its factor is one.
    pub dimension: Dimension,
}

impl Signal {
    /// A signal that must be there.
    pub fn required(name: impl Into<String>) -> Self {
        Self { name: name.into(), required: true, unit: None }
    }

    /// A signal that is zero (as an output) or dropped (as an input) where it is missing.
    pub fn optional(name: impl Into<String>) -> Self {
        Self { name: name.into(), required: false, unit: None }
    }

    /// The signal in an SI unit, to which the port converts.
    #[must_use]
    pub fn in_unit(mut self, unit: SignalUnit) -> Self {
        self.unit = Some(unit);
        self
    }
}

/// Variables in the order of the exchange, with their present values.
///
/// Optional variables that the unit lacks keep the value zero.
#[derive(Debug, Clone, Default)]
pub struct Port {
    /// Values in the order of the signals.
    pub values: Vec<f64>,
    /// Names in the unit of the signals that it has.
    names: Vec<String>,
    /// Value references of the signals that the unit has.
    references: Vec<u32>,
    /// Place of each of them in `values`.
    places: Vec<usize>,
    /// Their values in the order of `references`.
    buffer: Vec<f64>,
    /// Places in `buffer` of values that the unit has in another unit, and the way from that
    /// to the unit of the exchange.
    conversions: Vec<(usize, Linear)>,
}

impl Port {
    /// Finds the signals in a unit's interface; `names` maps our names to the unit's.
    ///
    /// # Errors
    /// One sentence for each signal that is required and missing, not Real, or in a unit that
    /// cannot be converted.
    pub fn connect(
        interface: &Interface,
        signals: &[Signal],
        causality: &str,
        names: &BTreeMap<String, String>,
    ) -> Result<Self, Vec<String>> {
        let mut port = Self { values: vec![0.0; signals.len()], ..Self::default() };
        let mut problems = vec![];
        for (place, signal) in signals.iter().enumerate() {
            let name = names.get(&signal.name).unwrap_or(&signal.name);
            match interface.variable(name) {
                Some(v) if v.kind == VariableType::Real && v.causality == causality => {
                    match conversion(v, signal.unit) {
                        Ok(way) if way.is_identity() => {}
                        Ok(way) => port.conversions.push((port.references.len(), way)),
                        Err(problem) => problems.push(problem),
                    }
                    port.names.push(name.clone());
                    port.references.push(v.reference);
                    port.places.push(place);
                }
                Some(v) => problems.push(format!(
                    "variable '{name}' is {} {:?}, but must be a Real {causality}",
                    v.causality, v.kind
                )),
                None if signal.required => {
                    problems.push(format!("the Real {causality} '{name}' is missing"));
                }
                None => {}
            }
        }
        port.buffer = vec![0.0; port.references.len()];
        if problems.is_empty() { Ok(port) } else { Err(problems) }
    }

    /// The unit's variable behind the signal at `place`, and the way from its unit of
    /// measurement to that of the exchange; none where the unit has no such variable.
    pub fn variable(&self, place: usize) -> Option<(&str, Linear)> {
        let at = self.places.iter().position(|&other| other == place)?;
        let conversion = self.conversions.iter().find(|(other, _)| *other == at);
        let way = conversion.map_or(Linear::IDENTITY, |(_, way)| *way);
        Some((&self.names[at], way))
    }

    /// Sends the values to the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn set(&mut self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        for (value, &place) in self.buffer.iter_mut().zip(&self.places) {
            *value = self.values[place];
        }
        for (at, way) in &self.conversions {
            self.buffer[*at] = way.inverse().apply(self.buffer[*at]);
        }
        unit.set_reals(&self.references, &self.buffer)
    }

    /// Takes the values from the unit.
    ///
    /// # Errors
    /// When the unit refuses.
    pub fn get(&mut self, unit: &mut dyn Unit) -> Result<(), UnitError> {
        unit.get_reals(&self.references, &mut self.buffer)?;
        for (at, way) in &self.conversions {
            self.buffer[*at] = way.apply(self.buffer[*at]);
        }
        for (value, &place) in self.buffer.iter().zip(&self.places) {
            self.values[place] = *value;
        }
        Ok(())
    }
}

/// The way from a variable's unit to that of the exchange.
fn conversion(variable: &Variable, wanted: Option<SignalUnit>) -> Result<Linear, String> {
    let (Some(wanted), Some(unit)) = (wanted, &variable.unit) else {
        return Ok(Linear::IDENTITY);
    };
    let name = &variable.name;
    match variable.si {
        Some(si) if si.dimension == wanted.dimension => Ok(si.to_base),
        Some(si) => Err(format!(
            "variable '{name}' is in '{unit}', which is {} in SI base units, but must be in '{}' \
             or a unit that can be converted to it ({})",
            si.dimension, wanted.symbol, wanted.dimension
        )),
        None if unit == wanted.symbol => Ok(Linear::IDENTITY),
        None => Err(format!(
            "variable '{name}' is in '{unit}', and its FMU does not say what that is in SI base \
             units (UnitDefinitions), so it cannot be converted to '{}'",
            wanted.symbol
        )),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::system::mock::Mock;

    const SPEED: SignalUnit =
        SignalUnit { symbol: "m/s", dimension: Dimension::mechanical(0, 1, -1) };

    fn interface(unit: &str, definition: &str) -> Interface {
        let xml = format!(
            r#"<fmiModelDescription fmiVersion="2.0" modelName="m" guid="1">
              <CoSimulation modelIdentifier="m"/>
              <UnitDefinitions><Unit name="{unit}">{definition}</Unit></UnitDefinitions>
              <ModelVariables><ScalarVariable name="v" valueReference="0" causality="input">
                <Real unit="{unit}"/></ScalarVariable></ModelVariables>
            </fmiModelDescription>"#
        );
        Interface::from_xml(&xml).unwrap()
    }

    fn connect(unit: &str, definition: &str) -> Result<Port, Vec<String>> {
        let signal = Signal::required("speed").in_unit(SPEED);
        let names = BTreeMap::from([("speed".to_owned(), "v".to_owned())]);
        Port::connect(&interface(unit, definition), &[signal], "input", &names)
    }

    /// The definition of km/h; tolerance: rounding of the factor.
    #[test]
    fn analytic_values_are_converted_to_the_unit_and_back() {
        let kilometre_per_hour = r#"<BaseUnit m="1" s="-1" factor="0.2777777777777778"/>"#;
        let mut port = connect("km/h", kilometre_per_hour).unwrap();
        let mut unit =
            Mock::new("u", &[("v".to_owned(), "input")], &Default::default(), |_, _, _| {});
        port.values[0] = 10.0;
        port.set(&mut unit).unwrap();
        let mut in_unit = [0.0];
        unit.get_reals(&[0], &mut in_unit).unwrap();
        assert!((in_unit[0] - 36.0).abs() < 1e-12, "{in_unit:?}");
        port.values[0] = 0.0;
        port.get(&mut unit).unwrap();
        assert!((port.values[0] - 10.0).abs() < 1e-12, "{}", port.values[0]);
    }

    #[test]
    fn a_unit_that_cannot_be_converted_is_answered_with_a_sentence() {
        let problem = |unit, definition| connect(unit, definition).unwrap_err().join("; ");
        let mass = problem("kg", r#"<BaseUnit kg="1"/>"#);
        assert!(mass.contains("variable 'v' is in 'kg'") && mass.contains("m.s-1"), "{mass}");
        let unknown = problem("knots", "");
        assert!(unknown.contains("does not say what that is in SI"), "{unknown}");
        assert!(connect("m/s", "").is_ok(), "the SI unit itself needs no definition");
    }
}
