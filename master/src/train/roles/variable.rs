//! A variable of a role, and how it is found in an FMU.

use std::collections::BTreeMap;

use crate::interface::range::Range;
use crate::interface::si::{Linear, SignalUnit};
use crate::interface::{Interface, Variable, VariableType};
use crate::system::structure::Sampling;

/// Another maker's names for ours.
pub type Names = BTreeMap<String, String>;

/// A Real variable that a role wants.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RoleVariable {
    /// Hotfoot's name, behind a prefix such as `vehicle[3].`.
    pub name: &'static str,
    /// The SI unit of the exchange.
    pub unit: SignalUnit,
    /// Whether the role cannot do without.
    pub required: bool,
    /// What a receiver gets that steps less often than the exchange.
    pub sampling: Sampling,
    /// What it can be: far more than any train has, and less than an FMU that has lost its way gives.
    pub range: Range,
    /// The fastest that it can change, a second; none: at any rate.
    pub most_per_second: Option<f64>,
}

impl RoleVariable {
    /// A variable of which a slower receiver gets means.
    pub const fn new(name: &'static str, unit: SignalUnit, required: bool) -> Self {
        let (sampling, range) = (Sampling::Mean, Range::FINITE);
        Self { name, unit, required, sampling, range, most_per_second: None }
    }

    /// The same variable, which cannot be less than `min` nor more than `max`.
    #[must_use]
    pub const fn within(self, min: f64, max: f64) -> Self {
        Self { range: Range { min, max }, ..self }
    }

    /// The same variable, which cannot change faster.
    #[must_use]
    pub const fn slower_than(self, most_per_second: f64) -> Self {
        Self { most_per_second: Some(most_per_second), ..self }
    }

    /// The same variable, of which a slower receiver gets the last value.
    #[must_use]
    pub const fn last(self) -> Self {
        Self { sampling: Sampling::Last, ..self }
    }
}

/// The variable of a table with that name.
///
/// # Panics
/// When the table has none: tables and names are constants.
pub const fn named(table: &'static [RoleVariable], name: &str) -> &'static RoleVariable {
    let mut index = 0;
    while index < table.len() {
        if equal(table[index].name.as_bytes(), name.as_bytes()) {
            return &table[index];
        }
        index += 1;
    }
    panic!("the table has no such variable")
}

const fn equal(a: &[u8], b: &[u8]) -> bool {
    let mut index = 0;
    while index < a.len() && index < b.len() && a[index] == b[index] {
        index += 1;
    }
    index == a.len() && index == b.len()
}

/// Finds a role's variable behind `prefix` in an interface, whose maker may have other `names`: its
/// name there, and the conversion from its unit to that of the exchange. None where it is not needed
/// and not there.
///
/// # Errors
/// A sentence if it is required and missing, not Real, or in a unit that cannot be converted.
pub fn find(
    interface: &Interface,
    prefix: &str,
    variable: &RoleVariable,
    causality: &str,
    names: &Names,
) -> Result<Option<(String, Linear)>, String> {
    let ours = format!("{prefix}{}", variable.name);
    let name = names.get(&ours).unwrap_or(&ours);
    match interface.variable(name) {
        Some(v) if v.kind == VariableType::Real && v.causality == causality => {
            Ok(Some((name.clone(), conversion(v, variable.unit)?)))
        }
        Some(v) => Err(format!(
            "variable '{name}' is {} {:?}, but must be a Real {causality}",
            v.causality, v.kind
        )),
        None if variable.required => Err(format!("the Real {causality} '{name}' is missing")),
        None => Ok(None),
    }
}

/// The conversion from a variable's unit to that of the exchange.
fn conversion(variable: &Variable, wanted: SignalUnit) -> Result<Linear, String> {
    let Some(unit) = &variable.unit else { return Ok(Linear::IDENTITY) };
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
    use crate::interface::si::Dimension;

    const SPEED: RoleVariable = RoleVariable::new(
        "speed",
        SignalUnit { symbol: "m/s", dimension: Dimension::mechanical(0, 1, -1) },
        true,
    );

    /// Looks for the speed in an FMU that calls it `v` and has it in `unit`.
    fn find_speed(unit: &str, definition: &str) -> Result<Option<(String, Linear)>, String> {
        let xml = format!(
            r#"<fmiModelDescription fmiVersion="2.0" modelName="m" guid="1">
              <CoSimulation modelIdentifier="m"/>
              <UnitDefinitions><Unit name="{unit}">{definition}</Unit></UnitDefinitions>
              <ModelVariables><ScalarVariable name="v" valueReference="0" causality="input">
                <Real unit="{unit}"/></ScalarVariable></ModelVariables>
            </fmiModelDescription>"#
        );
        let names = Names::from([("wheel.speed".to_owned(), "v".to_owned())]);
        let interface = Interface::from_xml(&xml).unwrap();
        find(&interface, "wheel.", &SPEED, "input", &names)
    }

    /// The definition of km/h; tolerance: rounding of the factor.
    #[test]
    fn analytic_values_are_converted_to_the_unit_of_the_exchange_and_back() {
        let kilometre_per_hour = r#"<BaseUnit m="1" s="-1" factor="0.2777777777777778"/>"#;
        let (name, conversion) = find_speed("km/h", kilometre_per_hour).unwrap().unwrap();
        assert_eq!(name, "v");
        assert!((conversion.apply(36.0) - 10.0).abs() < 1e-12);
        assert!((conversion.inverse().apply(10.0) - 36.0).abs() < 1e-12);
    }

    #[test]
    fn a_unit_that_cannot_be_converted_is_answered_with_a_sentence() {
        let mass = find_speed("kg", r#"<BaseUnit kg="1"/>"#).unwrap_err();
        assert!(mass.contains("variable 'v' is in 'kg'") && mass.contains("m.s-1"), "{mass}");
        let unknown = find_speed("knots", "").unwrap_err();
        assert!(unknown.contains("does not say what that is in SI"), "{unknown}");
        assert!(find_speed("m/s", "").is_ok(), "the SI unit itself needs no definition");
    }

    #[test]
    fn what_is_missing_is_answered_if_it_is_required() {
        let missing = |variable: RoleVariable| {
            find(&Interface::default(), "", &variable, "output", &Names::new())
        };
        assert_eq!(missing(SPEED).unwrap_err(), "the Real output 'speed' is missing");
        assert_eq!(missing(RoleVariable { required: false, ..SPEED }), Ok(None));
    }
}
