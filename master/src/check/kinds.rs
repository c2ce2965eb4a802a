//! Rules on what a variable is: its causality, variability, initial and type together (§2.2.7).

use super::description::{Description, KINDS, Variable};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "variability-fits-causality",
        severity: Severity::Error,
        wants: "causality and variability are a pair that the standard has",
        check: variability,
    },
    Rule {
        name: "initial-fits-causality",
        severity: Severity::Error,
        wants: "initial is one that the standard has for the causality and variability",
        check: initial,
    },
    Rule {
        name: "only-reals-are-continuous",
        severity: Severity::Error,
        wants: "a variable that is not Real says another variability than continuous, which is \
                the default",
        check: continuous,
    },
    Rule {
        name: "independent-is-one-real",
        severity: Severity::Error,
        wants: "there is at most one independent variable, and it is Real",
        check: independent,
    },
    Rule {
        name: "derivative-of-a-real",
        severity: Severity::Error,
        wants: "the attribute derivative is the index of another Real variable",
        check: derivative,
    },
];

/// The variabilities that a causality may have (§2.2.7, table of the combinations).
fn variabilities(causality: &str) -> &'static [&'static str] {
    match causality {
        "parameter" | "calculatedParameter" => &["fixed", "tunable"],
        "input" => &["discrete", "continuous"],
        "output" => &["constant", "discrete", "continuous"],
        "independent" => &["continuous"],
        _ => &["constant", "fixed", "tunable", "discrete", "continuous"],
    }
}

/// The initials that a causality and variability may have.
fn initials(causality: &str, variability: &str) -> &'static [&'static str] {
    match (causality, variability) {
        ("input" | "independent", _) => &[],
        ("parameter", _) | (_, "constant") => &["exact"],
        ("calculatedParameter", _) | ("local", "fixed" | "tunable") => &["approx", "calculated"],
        _ => &["exact", "approx", "calculated"],
    }
}

fn variability(description: &Description<'_>, breaches: &mut Breaches) {
    for Variable { element, name, causality, variability, .. } in &description.variables {
        let allowed = variabilities(causality);
        if !allowed.contains(variability) {
            let allowed = allowed.join(" or ");
            let sentence = format!(
                "`{name}` is {causality} and {variability}, but must be {causality} and {allowed}"
            );
            breaches.at(*element, sentence);
        }
    }
}

fn initial(description: &Description<'_>, breaches: &mut Breaches) {
    for Variable { element, name, causality, variability, .. } in &description.variables {
        let Some(initial) = element.attribute("initial") else { continue };
        let allowed = initials(causality, variability);
        if !allowed.contains(&initial) {
            let must = match allowed {
                [] => "must have no `initial`".to_owned(),
                some => format!("must be {}", some.join(" or ")),
            };
            let sentence = format!(
                "`{name}` is {initial}, but as {causality} that is {variability} it {must}"
            );
            breaches.at(*element, sentence);
        }
    }
}

fn continuous(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let kind = variable.type_name();
        if variable.variability == "continuous" && !matches!(kind, "" | "Real") {
            let name = variable.name;
            let sentence = match variable.element.has_attribute("variability") {
                true => format!("`{name}` is {kind} and cannot be continuous"),
                false => format!(
                    "`{name}` is {kind} and says no `variability`, which then is continuous; only \
                     a Real may be that"
                ),
            };
            breaches.at(variable.element, sentence);
        }
    }
}

fn independent(description: &Description<'_>, breaches: &mut Breaches) {
    let mut independents =
        description.variables.iter().filter(|variable| variable.causality == "independent");
    let Some(first) = independents.next() else { return };
    if first.type_name() != KINDS[0] {
        let sentence = format!("`{}` is independent, so it must be Real", first.name);
        breaches.at(first.element, sentence);
    }
    for other in independents {
        let sentence = format!(
            "`{}` is independent, as `{}` is; there may be one only",
            other.name, first.name
        );
        breaches.at(other.element, sentence);
    }
}

fn derivative(description: &Description<'_>, breaches: &mut Breaches) {
    for variable in &description.variables {
        let Some(of) = variable.of_kind("derivative") else { continue };
        let state = of.parse::<usize>().ok().and_then(|index| {
            description.variables.get(index.checked_sub(1)?).filter(|v| v.index != variable.index)
        });
        if state.is_none_or(|state| state.type_name() != KINDS[0]) {
            let sentence = format!(
                "`{}` is the derivative of variable {of}, but must be that of another Real among \
                 1 to {}",
                variable.name,
                description.variables.len()
            );
            breaches.at(variable.element, sentence);
        }
    }
}
