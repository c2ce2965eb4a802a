//! Rules on `ModelStructure`: which variables its lists hold (§2.2.8).

use std::collections::HashSet;

use super::description::{Description, Element, Variable};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "indices-are-in-range",
        severity: Severity::Error,
        wants: "the index of an unknown is the index of a variable, counted from one",
        check: in_range,
    },
    Rule {
        name: "indices-are-in-order",
        severity: Severity::Error,
        wants: "outputs and initial unknowns stand once each; initial unknowns in order",
        check: in_order,
    },
    Rule {
        name: "outputs-are-complete",
        severity: Severity::Error,
        wants: "ModelStructure/Outputs holds every output, and nothing else",
        check: outputs,
    },
    Rule {
        name: "derivatives-are-derivatives",
        severity: Severity::Error,
        wants: "ModelStructure/Derivatives holds variables with the attribute derivative",
        check: derivatives,
    },
    Rule {
        name: "initial-unknowns-are-complete",
        severity: Severity::Error,
        wants: "ModelStructure/InitialUnknowns holds outputs and states that are calculated or \
                approx, all calculated parameters, and nothing else",
        check: initial_unknowns,
    },
];

/// The lists of `ModelStructure`.
pub(super) const LISTS: [&str; 3] = ["Outputs", "Derivatives", "InitialUnknowns"];

/// The elements `Unknown` of a list.
pub(super) fn unknowns<'x>(description: &Description<'x>, list: &str) -> Vec<Element<'x>> {
    let structure = super::description::child(description.root, "ModelStructure");
    let list = structure.and_then(|structure| super::description::child(structure, list));
    list.into_iter().flat_map(|list| super::description::children(list, "Unknown")).collect()
}

/// The index of an unknown; `None` where it is missing or is not a number.
fn index(unknown: Element<'_>) -> Option<usize> {
    unknown.attribute("index")?.trim().parse().ok()
}

/// The variable of an unknown.
fn variable<'d, 'x>(
    description: &'d Description<'x>,
    unknown: Element<'x>,
) -> Option<&'d Variable<'x>> {
    description.variables.get(index(unknown)?.checked_sub(1)?)
}

fn in_range(description: &Description<'_>, breaches: &mut Breaches) {
    let count = description.variables.len();
    for list in LISTS {
        for unknown in unknowns(description, list) {
            if let Some(index) = index(unknown).filter(|index| *index == 0 || *index > count) {
                let sentence = format!(
                    "`index` is {index} in <{list}>, but variables count from 1 to {count}"
                );
                breaches.at(unknown, sentence);
            }
        }
    }
}

fn in_order(description: &Description<'_>, breaches: &mut Breaches) {
    for list in LISTS {
        let mut seen = HashSet::new();
        let mut last = 0;
        for unknown in unknowns(description, list) {
            let Some(index) = index(unknown) else { continue };
            if !seen.insert(index) {
                let sentence = format!("variable {index} stands in <{list}> a second time");
                breaches.at(unknown, sentence);
            } else if index < last && list == "InitialUnknowns" {
                let sentence = format!("variable {index} must stand before {last} in <{list}>");
                breaches.at(unknown, sentence);
            }
            last = last.max(index);
        }
    }
}

fn outputs(description: &Description<'_>, breaches: &mut Breaches) {
    let wanted = |variable: &Variable<'_>| variable.causality == "output";
    compare(description, "Outputs", wanted, "an output", breaches);
}

fn derivatives(description: &Description<'_>, breaches: &mut Breaches) {
    for unknown in unknowns(description, "Derivatives") {
        if let Some(variable) = variable(description, unknown)
            && variable.of_kind("derivative").is_none()
        {
            let sentence = format!(
                "`{}` stands in <Derivatives>, so it must say of what it is the `derivative`",
                variable.name
            );
            breaches.at(unknown, sentence);
        }
    }
}

fn initial_unknowns(description: &Description<'_>, breaches: &mut Breaches) {
    let states = states(description);
    let wanted = |variable: &Variable<'_>| {
        let unknown = matches!(variable.initial, Some("calculated" | "approx"));
        let may_be = variable.causality == "output" || states.contains(&variable.index);
        variable.causality == "calculatedParameter" || (unknown && may_be)
    };
    let what = "an unknown of the initialization";
    compare(description, "InitialUnknowns", wanted, what, breaches);
}

/// The indices of the states and derivatives that `Derivatives` names.
fn states(description: &Description<'_>) -> HashSet<usize> {
    let unknowns = unknowns(description, "Derivatives");
    let derivatives = unknowns.into_iter().filter_map(|unknown| variable(description, unknown));
    derivatives
        .flat_map(|derivative| {
            let state = derivative.of_kind("derivative").and_then(|index| index.parse().ok());
            state.into_iter().chain([derivative.index])
        })
        .collect()
}

/// A list must hold the wanted variables and no others.
fn compare(
    description: &Description<'_>,
    list: &str,
    wanted: impl Fn(&Variable<'_>) -> bool,
    what: &str,
    breaches: &mut Breaches,
) {
    let unknowns = unknowns(description, list);
    let listed: HashSet<_> = unknowns.iter().filter_map(|unknown| index(*unknown)).collect();
    for Variable { element, name, index, .. } in
        description.variables.iter().filter(|variable| wanted(variable))
    {
        if !listed.contains(index) {
            let sentence = format!(
                "`{name}` (variable {index}) is {what}, but ModelStructure/{list} lacks it"
            );
            breaches.at(*element, sentence);
        }
    }
    for unknown in unknowns {
        if let Some(variable) = variable(description, unknown).filter(|v| !wanted(v)) {
            let name = variable.name;
            breaches.at(unknown, format!("`{name}` stands in <{list}>, but is not {what}"));
        }
    }
}
