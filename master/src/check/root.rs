//! Rules on what the FMU is and can do, on log categories and on the default experiment
//! (§2.2.1, §2.2.4, §2.2.5, §4.3.1).

use super::description::{Description, child, number};
use super::rule::{Breaches, Rule, Severity};
use super::units::repeated;
use crate::interface::identifier::{C_NAME, is_c_name};

/// Name of the rule on the version, without which the others make no sense.
pub(super) const VERSION: &str = "fmi-version-is-2.0";

pub const RULES: &[Rule] = &[
    Rule {
        name: VERSION,
        severity: Severity::Error,
        wants: "fmiVersion is 2.0",
        check: fmi_version,
    },
    Rule {
        name: "an-interface-is-offered",
        severity: Severity::Error,
        wants: "there is an element CoSimulation or ModelExchange",
        check: interface,
    },
    Rule {
        name: "model-identifier-is-a-c-name",
        severity: Severity::Error,
        wants: "modelIdentifier is a name in C, since functions and the binary are named by it",
        check: model_identifier,
    },
    Rule {
        name: "guid-is-not-blank",
        severity: Severity::Error,
        wants: "guid is not blank",
        check: guid,
    },
    Rule {
        name: "serializing-needs-states",
        severity: Severity::Error,
        wants: "an FMU that can serialize its state can also get and set it",
        check: serializing,
    },
    Rule {
        name: "log-categories-are-unique",
        severity: Severity::Error,
        wants: "no two log categories have the same name",
        check: log_categories_unique,
    },
    Rule {
        name: "log-categories-are-given",
        severity: Severity::Advice,
        wants: "there are log categories; without them an FMU must log with a null category, at \
                which tools crash",
        check: log_categories_given,
    },
    Rule {
        name: "experiment-goes-forward",
        severity: Severity::Error,
        wants: "the default experiment ends after it starts",
        check: experiment_order,
    },
    Rule {
        name: "experiment-numbers-are-positive",
        severity: Severity::Error,
        wants: "tolerance and stepSize of the default experiment are greater than zero",
        check: experiment_positive,
    },
    Rule {
        name: "experiment-is-complete",
        severity: Severity::Advice,
        wants: "the default experiment says stop time, tolerance and step size",
        check: experiment_complete,
    },
];

fn fmi_version(description: &Description<'_>, breaches: &mut Breaches) {
    let root = description.root;
    if let Some(version) = root.attribute("fmiVersion").filter(|version| *version != "2.0") {
        breaches.at(root, format!("`fmiVersion` is \"{version}\", but must be \"2.0\""));
    }
}

fn interface(description: &Description<'_>, breaches: &mut Breaches) {
    let root = description.root;
    if child(root, "CoSimulation").is_none() && child(root, "ModelExchange").is_none() {
        let sentence = "there is neither <CoSimulation> nor <ModelExchange>; one is needed";
        breaches.at(root, sentence.to_owned());
    }
}

fn model_identifier(description: &Description<'_>, breaches: &mut Breaches) {
    let interfaces = ["CoSimulation", "ModelExchange"];
    for interface in interfaces.iter().filter_map(|name| child(description.root, name)) {
        let Some(name) = interface.attribute("modelIdentifier") else { continue };
        if !is_c_name(name) {
            let sentence = format!("`modelIdentifier` is \"{name}\", but must be {C_NAME}");
            breaches.at(interface, sentence);
        }
    }
}

fn guid(description: &Description<'_>, breaches: &mut Breaches) {
    let root = description.root;
    if root.attribute("guid").is_some_and(|guid| guid.trim().is_empty()) {
        breaches.at(root, "`guid` is blank, but the binary must recognise it".to_owned());
    }
}

fn serializing(description: &Description<'_>, breaches: &mut Breaches) {
    let is = |name| move |text: &&str| name == *text;
    let interfaces = ["CoSimulation", "ModelExchange"];
    for interface in interfaces.iter().filter_map(|name| child(description.root, name)) {
        let says = |flag| {
            let value = interface.attribute(flag);
            value.filter(is("true")).or(value.filter(is("1"))).is_some()
        };
        if says("canSerializeFMUstate") && !says("canGetAndSetFMUstate") {
            let sentence = "`canSerializeFMUstate` is true, so `canGetAndSetFMUstate` must be \
                            true too";
            breaches.at(interface, sentence.to_owned());
        }
    }
}

fn log_categories_unique(description: &Description<'_>, breaches: &mut Breaches) {
    let categories = description.list("LogCategories", "Category");
    for (category, name) in repeated(categories, "name") {
        breaches.at(category, format!("the log category \"{name}\" is there already"));
    }
}

fn log_categories_given(description: &Description<'_>, breaches: &mut Breaches) {
    if description.list("LogCategories", "Category").is_empty() {
        let sentence = "there are no <LogCategories>; without them fmi2 loggers get a null \
                        category, at which some tools crash";
        breaches.at(description.root, sentence.to_owned());
    }
}

fn experiment_order(description: &Description<'_>, breaches: &mut Breaches) {
    let Some(experiment) = child(description.root, "DefaultExperiment") else { return };
    let start = number(experiment, "startTime").unwrap_or(0.0);
    if let Some(stop) = number(experiment, "stopTime").filter(|stop| *stop <= start) {
        let sentence = format!("`stopTime` is {stop}, but must be after `startTime`, {start}");
        breaches.at(experiment, sentence);
    }
}

fn experiment_positive(description: &Description<'_>, breaches: &mut Breaches) {
    let Some(experiment) = child(description.root, "DefaultExperiment") else { return };
    for name in ["tolerance", "stepSize"] {
        if let Some(value) = number(experiment, name).filter(|value| *value <= 0.0) {
            breaches.at(experiment, format!("`{name}` is {value}, but must be greater than zero"));
        }
    }
}

fn experiment_complete(description: &Description<'_>, breaches: &mut Breaches) {
    let Some(experiment) = child(description.root, "DefaultExperiment") else {
        let sentence = "there is no <DefaultExperiment>; tools then guess how to run the FMU";
        breaches.at(description.root, sentence.to_owned());
        return;
    };
    for name in ["stopTime", "tolerance", "stepSize"] {
        if !experiment.has_attribute(name) {
            breaches.at(experiment, format!("<DefaultExperiment> says no `{name}`"));
        }
    }
}
