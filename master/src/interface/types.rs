//! What variables take from units and declared types.

use std::collections::HashMap;

use super::range::Range;
use super::si::SiUnit;
use super::xml;

/// The units that a model description defines, and the declared types.
pub struct Types {
    /// The units by name, in SI base units.
    pub units: HashMap<String, SiUnit>,
    of_type: HashMap<String, xml::SimpleType>,
}

impl Types {
    /// Those of a model description.
    pub fn of(units: Option<xml::UnitDefinitions>, types: Option<xml::TypeDefinitions>) -> Self {
        let units = units.map(|list| list.units).unwrap_or_default().into_iter();
        let types = types.map(|list| list.types).unwrap_or_default().into_iter();
        Self {
            units: units.filter_map(|unit| Some((unit.name, unit.base?.si()?))).collect(),
            of_type: types.map(|simple| (simple.name.clone(), simple)).collect(),
        }
    }

    /// The type that a variable declares.
    fn declared(&self, name: &Option<String>) -> Option<&xml::SimpleType> {
        self.of_type.get(name.as_ref()?)
    }

    /// Unit of a Real variable, from itself or its declared type, and what it is in SI.
    pub fn of_real(&self, real: &xml::Real) -> (Option<String>, Option<SiUnit>) {
        let declared = self.declared(&real.declared_type).and_then(|simple| simple.real.as_ref());
        let unit = real.unit.clone().or_else(|| declared?.unit.clone());
        let relative = real.relative || declared.is_some_and(|declared| declared.relative);
        let mut si = unit.as_ref().and_then(|name| self.units.get(name).copied());
        if let (Some(si), true) = (&mut si, relative) {
            // A difference of two values knows no offset (§2.2.2).
            si.to_base.offset = 0.0;
        }
        (unit, si)
    }

    /// What a Real may be, by itself or its declared type.
    pub fn range_of_real(&self, real: &xml::Real) -> Range {
        let declared = self.declared(&real.declared_type).and_then(|simple| simple.real.as_ref());
        let min = real.min.as_ref().or_else(|| declared?.min.as_ref());
        let max = real.max.as_ref().or_else(|| declared?.max.as_ref());
        Range::stated(number(min), number(max))
    }

    /// What an Integer or Enumeration may be, by itself or its declared type.
    pub fn range_of_integer(&self, integer: &xml::Other) -> Range {
        let declared =
            self.declared(&integer.declared_type).and_then(|simple| simple.integer.as_ref());
        let min = integer.min.as_ref().or_else(|| declared?.min.as_ref());
        let max = integer.max.as_ref().or_else(|| declared?.max.as_ref());
        Range::stated(number(min), number(max))
    }
}

/// The number that an attribute states.
fn number(text: Option<&String>) -> Option<f64> {
    text?.trim().parse().ok()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::Interface;

    /// FMI 2.0 §2.2.7: what a variable states goes before what its type does.
    #[test]
    fn ranges_are_those_of_the_variable_or_of_its_type() {
        let xml = r#"<fmiModelDescription fmiVersion="2.0" modelName="m" guid="1">
            <CoSimulation modelIdentifier="m"/><TypeDefinitions>
              <SimpleType name="Share"><Real min="0" max="1"/></SimpleType>
              <SimpleType name="Count"><Integer min="1"/></SimpleType></TypeDefinitions>
            <ModelVariables>
              <ScalarVariable name="share" valueReference="5"><Real declaredType="Share"/></ScalarVariable>
              <ScalarVariable name="half" valueReference="6">
                <Real declaredType="Share" max=" 0.5 "/></ScalarVariable>
              <ScalarVariable name="count" valueReference="7">
                <Integer declaredType="Count" max="9"/></ScalarVariable>
              <ScalarVariable name="any" valueReference="8"><Real/></ScalarVariable>
            </ModelVariables></fmiModelDescription>"#;
        let interface = Interface::from_xml(xml).unwrap();
        let range = |name| interface.variable(name).unwrap().range;
        assert_eq!(range("share"), Range { min: 0.0, max: 1.0 });
        assert_eq!(range("half"), Range { min: 0.0, max: 0.5 });
        assert_eq!(range("count"), Range { min: 1.0, max: 9.0 });
        assert_eq!(range("any"), Range::FINITE);
    }
}
