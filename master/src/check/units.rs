//! Rules on units and types (§2.2.2, §2.2.3).

use std::collections::HashSet;

use super::description::{Description, Element, KINDS, child, children, number};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "units-are-unique",
        severity: Severity::Error,
        wants: "no two units, and no two display units of a unit, have the same name",
        check: units_unique,
    },
    Rule {
        name: "unit-factors-are-not-zero",
        severity: Severity::Error,
        wants: "the factor of a unit or display unit is not zero",
        check: unit_factors,
    },
    Rule {
        name: "units-are-defined",
        severity: Severity::Error,
        wants: "every unit that a variable or type has is defined",
        check: units_defined,
    },
    Rule {
        name: "display-units-are-defined",
        severity: Severity::Error,
        wants: "a display unit is defined under the unit that stands with it",
        check: display_units_defined,
    },
    Rule {
        name: "types-are-unique",
        severity: Severity::Error,
        wants: "no two types have the same name, and none that of a variable",
        check: types_unique,
    },
    Rule {
        name: "types-are-defined",
        severity: Severity::Error,
        wants: "a declared type is defined and of the variable's kind",
        check: types_defined,
    },
];

/// The elements whose attribute has a value that an earlier one has, with that value.
pub(super) fn repeated<'x>(
    elements: impl IntoIterator<Item = Element<'x>>,
    attribute: &str,
) -> Vec<(Element<'x>, &'x str)> {
    let mut seen = HashSet::new();
    let named = elements.into_iter().filter_map(|e| e.attribute(attribute).map(|name| (e, name)));
    named.filter(|(_, name)| !seen.insert(*name)).collect()
}

fn units<'x>(description: &Description<'x>) -> Vec<Element<'x>> {
    description.list("UnitDefinitions", "Unit")
}

fn types<'x>(description: &Description<'x>) -> Vec<Element<'x>> {
    description.list("TypeDefinitions", "SimpleType")
}

fn units_unique(description: &Description<'_>, breaches: &mut Breaches) {
    let units = units(description);
    for (unit, name) in repeated(units.iter().copied(), "name") {
        breaches.at(unit, format!("the unit \"{name}\" is defined already"));
    }
    for unit in units {
        for (display, name) in repeated(children(unit, "DisplayUnit"), "name") {
            breaches.at(display, format!("the display unit \"{name}\" is defined already"));
        }
    }
}

fn unit_factors(description: &Description<'_>, breaches: &mut Breaches) {
    for unit in units(description) {
        let parts = child(unit, "BaseUnit").into_iter().chain(children(unit, "DisplayUnit"));
        for part in parts.filter(|part| number(*part, "factor") == Some(0.0)) {
            let name = unit.attribute("name").unwrap_or_default();
            let sentence = format!("the `factor` of the unit \"{name}\" must not be zero");
            breaches.at(part, sentence);
        }
    }
}

/// The elements `Real` of variables and types.
fn reals<'x>(description: &Description<'x>) -> impl Iterator<Item = Element<'x>> {
    let of_variables = description.variables.iter().filter_map(|variable| variable.kind);
    let of_types = types(description).into_iter().filter_map(|kind| child(kind, KINDS[0]));
    of_variables.filter(|kind| kind.has_tag_name(KINDS[0])).chain(of_types)
}

/// What a variable's or type's element belongs to, for messages.
fn owner(kind: Element<'_>) -> &str {
    kind.parent_element().and_then(|owner| owner.attribute("name")).unwrap_or_default()
}

fn units_defined(description: &Description<'_>, breaches: &mut Breaches) {
    for real in reals(description) {
        let unknown = |unit: &&str| !description.units.contains_key(unit);
        if let Some(unit) = real.attribute("unit").filter(unknown) {
            let owner = owner(real);
            let sentence = format!(
                "`{owner}` has the unit \"{unit}\", which <UnitDefinitions> does not define"
            );
            breaches.at(real, sentence);
        }
    }
}

fn display_units_defined(description: &Description<'_>, breaches: &mut Breaches) {
    for real in reals(description) {
        let Some(display) = real.attribute("displayUnit") else { continue };
        let unit = unit_of(description, real);
        let known = unit.and_then(|unit| description.units.get(unit));
        let defined = known
            .into_iter()
            .flat_map(|known| children(*known, "DisplayUnit"))
            .any(|known| known.attribute("name") == Some(display));
        if !defined {
            let (owner, unit) = (owner(real), unit.unwrap_or("none"));
            let sentence = format!(
                "`{owner}` has the display unit \"{display}\", which is not defined under its \
                 unit ({unit})"
            );
            breaches.at(real, sentence);
        }
    }
}

/// The unit of an element `Real`: its own or that of its declared type.
fn unit_of<'x>(description: &Description<'x>, real: Element<'x>) -> Option<&'x str> {
    let declared = || {
        let name = real.attribute("declaredType")?;
        child(*description.types.get(name)?, KINDS[0])?.attribute("unit")
    };
    real.attribute("unit").or_else(declared)
}

fn types_unique(description: &Description<'_>, breaches: &mut Breaches) {
    let types = types(description);
    for (kind, name) in repeated(types.iter().copied(), "name") {
        breaches.at(kind, format!("the type \"{name}\" is defined already"));
    }
    let variables: HashSet<_> = description.variables.iter().map(|v| v.name).collect();
    for kind in types {
        if let Some(name) = kind.attribute("name").filter(|name| variables.contains(name)) {
            let sentence = format!("the type \"{name}\" has the name of a variable");
            breaches.at(kind, sentence);
        }
    }
}

fn types_defined(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let Some(name) = variable.of_kind("declaredType") else { continue };
        let found = description.types.get(name);
        let sentence = match found {
            None => format!(
                "`{}` has the type \"{name}\", which <TypeDefinitions> does not define",
                variable.name
            ),
            Some(kind) if child(*kind, variable.type_name()).is_none() => format!(
                "`{}` is {}, but its type \"{name}\" is not",
                variable.name,
                variable.type_name()
            ),
            Some(_) => continue,
        };
        breaches.at(variable.element, sentence);
    }
}
