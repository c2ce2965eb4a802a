//! Rules on the values of variables: start, bounds, nominal (§2.2.3, §2.2.7).

use super::description::{Description, Element, Variable, child, number};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "start-is-given",
        severity: Severity::Error,
        wants: "inputs, and variables whose initial is exact or approx, have a start value",
        check: given,
    },
    Rule {
        name: "start-is-not-given",
        severity: Severity::Error,
        wants: "variables that are calculated or independent have no start value",
        check: not_given,
    },
    Rule {
        name: "start-is-within-bounds",
        severity: Severity::Error,
        wants: "a start value is from min to max",
        check: within_bounds,
    },
    Rule {
        name: "bounds-are-in-order",
        severity: Severity::Error,
        wants: "min is not greater than max",
        check: bounds,
    },
    Rule {
        name: "nominal-is-positive",
        severity: Severity::Error,
        wants: "a nominal value is greater than zero",
        check: nominal,
    },
];

fn given(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let Variable { element, name, causality, initial, .. } = variable;
        let reason = match (*causality, *initial) {
            ("input", _) => "an input",
            (_, Some("exact")) => "exact",
            (_, Some("approx")) => "approx",
            _ => continue,
        };
        if variable.kind.is_some() && variable.of_kind("start").is_none() {
            breaches.at(*element, format!("`{name}` is {reason}, so it must have a `start`"));
        }
    }
}

fn not_given(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let Variable { element, name, causality, initial, .. } = variable;
        let reason = match (*causality, *initial) {
            ("independent", _) => "independent",
            (_, Some("calculated")) => "calculated",
            _ => continue,
        };
        if variable.of_kind("start").is_some() {
            breaches.at(*element, format!("`{name}` is {reason}, so it must have no `start`"));
        }
    }
}

/// A number that a variable states, else that of its declared type.
fn stated(description: &Description<'_>, variable: &Variable<'_>, attribute: &str) -> Option<f64> {
    let kind = variable.kind?;
    let declared = || -> Option<Element<'_>> {
        let name = kind.attribute("declaredType")?;
        child(*description.types.get(name)?, variable.type_name())
    };
    number(kind, attribute).or_else(|| number(declared()?, attribute))
}

fn within_bounds(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let Some(start) = variable.kind.and_then(|kind| number(kind, "start")) else { continue };
        let name = variable.name;
        if let Some(min) = stated(description, variable, "min").filter(|min| start < *min) {
            let sentence = format!("`{name}` starts at {start}, below its `min`, {min}");
            breaches.at(variable.element, sentence);
        }
        if let Some(max) = stated(description, variable, "max").filter(|max| start > *max) {
            let sentence = format!("`{name}` starts at {start}, above its `max`, {max}");
            breaches.at(variable.element, sentence);
        }
    }
}

fn bounds(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let bound = |attribute| stated(description, variable, attribute);
        if let (Some(min), Some(max)) = (bound("min"), bound("max"))
            && min > max
        {
            let sentence =
                format!("`{}` has `min` {min}, but it must not exceed `max`, {max}", variable.name);
            breaches.at(variable.element, sentence);
        }
    }
}

fn nominal(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let nominal = stated(description, variable, "nominal");
        if let Some(nominal) = nominal.filter(|nominal| *nominal <= 0.0) {
            let sentence = format!(
                "`{}` has `nominal` {nominal}, but it must be greater than zero",
                variable.name
            );
            breaches.at(variable.element, sentence);
        }
    }
}
