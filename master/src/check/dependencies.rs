//! Rules on what the unknowns of `ModelStructure` depend on (§2.2.8).

use super::description::Description;
use super::rule::{Breaches, Rule, Severity};
use super::structure::{LISTS, unknowns};

pub const RULES: &[Rule] = &[
    Rule {
        name: "dependencies-are-in-range",
        severity: Severity::Error,
        wants: "dependencies are indices of variables, counted from one",
        check: in_range,
    },
    Rule {
        name: "dependency-kinds-fit",
        severity: Severity::Error,
        wants: "there is a kind for each dependency, and no kinds without dependencies",
        check: kinds,
    },
    Rule {
        name: "initial-dependency-kinds-fit",
        severity: Severity::Error,
        wants: "dependencies of initial unknowns are of the kinds dependent or constant",
        check: initial_kinds,
    },
    Rule {
        name: "dependencies-are-stated",
        severity: Severity::Advice,
        wants: "outputs say what they depend on; an empty list says that there is no direct \
                feedthrough, while none at all means that there is from every input",
        check: stated,
    },
];

fn in_range(description: &Description<'_>, breaches: &mut Breaches) {
    let count = description.variables.len();
    for unknown in LISTS.iter().flat_map(|list| unknowns(description, list)) {
        let dependencies = unknown.attribute("dependencies").unwrap_or_default();
        let numbers = dependencies.split_whitespace().filter_map(|word| word.parse().ok());
        for index in numbers.filter(|index: &usize| *index == 0 || *index > count) {
            let sentence =
                format!("`dependencies` holds {index}, but variables count from 1 to {count}");
            breaches.at(unknown, sentence);
        }
    }
}

fn kinds(description: &Description<'_>, breaches: &mut Breaches) {
    for unknown in LISTS.iter().flat_map(|list| unknowns(description, list)) {
        let Some(kinds) = unknown.attribute("dependenciesKind") else { continue };
        let kinds = kinds.split_whitespace().count();
        match unknown.attribute("dependencies") {
            None => {
                let sentence = "`dependenciesKind` needs `dependencies` beside it";
                breaches.at(unknown, sentence.to_owned());
            }
            Some(dependencies) => {
                let count = dependencies.split_whitespace().count();
                if count != kinds {
                    let sentence = format!(
                        "there are {count} `dependencies`, but {kinds} in `dependenciesKind`"
                    );
                    breaches.at(unknown, sentence);
                }
            }
        }
    }
}

fn initial_kinds(description: &Description<'_>, breaches: &mut Breaches) {
    for unknown in unknowns(description, "InitialUnknowns") {
        let kinds = unknown.attribute("dependenciesKind").unwrap_or_default();
        let wrong = |kind: &&str| matches!(*kind, "fixed" | "tunable" | "discrete");
        if let Some(kind) = kinds.split_whitespace().find(wrong) {
            let sentence = format!(
                "`dependenciesKind` holds {kind}, but in <InitialUnknowns> only dependent and \
                 constant are allowed"
            );
            breaches.at(unknown, sentence);
        }
    }
}

fn stated(description: &Description<'_>, breaches: &mut Breaches) {
    for unknown in unknowns(description, "Outputs") {
        if !unknown.has_attribute("dependencies") {
            let sentence = "the output states no `dependencies`, which means that it depends on \
                            every input at once; an empty list says that it depends on none";
            breaches.at(unknown, sentence.to_owned());
        }
    }
}
