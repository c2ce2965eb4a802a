//! The mutations of one good FMU by which the checkers of other makers were compared: `hotfoot
//! check` finds each by its rule (docs/validation/fmi.md).

use hotfoot::check::check;
use hotfoot_tests::fmu_copy::FmuCopy;

const DESCRIPTION: &str = "modelDescription.xml";

/// A variable at the end of the list, so that no index of another changes.
fn added(text: &str, variable: &str) -> String {
    text.replacen("</ModelVariables>", &format!("{variable}</ModelVariables>"), 1)
}

fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from} is not in the model description");
    text.replacen(from, to, 1)
}

/// The text without the first line, after `after`, that holds `what`.
fn without(text: &str, after: &str, what: &str) -> String {
    let (before, rest) = text.split_once(after).expect("it is there");
    let line = rest.lines().find(|line| line.contains(what)).expect("it is there");
    format!("{before}{after}{}", rest.replacen(line, "", 1))
}

/// The mutations of one good FMU by which eight tools were compared, each with the rule that finds
/// it; no rule: the mutation is legal.
#[test]
fn each_mutation_is_found_by_its_rule() {
    let copy = FmuCopy::of("vehicle");
    let good = copy.text(DESCRIPTION);
    let local = |rest: &str| {
        added(
            &good,
            &format!("<ScalarVariable name=\"more\" valueReference=\"0\" {rest}</ScalarVariable>"),
        )
    };
    let index = |name: &str| {
        let names = good.split("<ScalarVariable name=\"").skip(1);
        1 + names.into_iter().position(|text| text.starts_with(&format!("{name}\""))).unwrap()
    };
    let position = format!("index=\"{}\"", index("position"));
    let mutations: [(&str, Option<&str>, String); 21] = [
        (
            "an output is not in ModelStructure/Outputs",
            Some("outputs-are-complete"),
            without(&good, "<Outputs>", &position),
        ),
        (
            "a calculated output is not in InitialUnknowns",
            Some("initial-unknowns-are-complete"),
            without(&good, "<InitialUnknowns>", &position),
        ),
        (
            "an input has no start",
            Some("start-is-given"),
            replaced(&good, "<Real unit=\"N\" start=\"0\"/>", "<Real unit=\"N\"/>"),
        ),
        (
            "a unit is not defined",
            Some("units-are-defined"),
            replaced(&good, "<Real unit=\"N\" start=\"0\"/>", "<Real unit=\"lbf\" start=\"0\"/>"),
        ),
        (
            "two variables of a type and reference have starts",
            Some("aliases-have-one-start"),
            local("causality=\"parameter\" variability=\"fixed\"><Real start=\"1\"/>"),
        ),
        (
            "a name is there twice",
            Some("names-are-unique"),
            replaced(&good, "name=\"velocity\"", "name=\"position\""),
        ),
        (
            "a parameter is continuous",
            Some("variability-fits-causality"),
            local("causality=\"parameter\" variability=\"continuous\"><Real start=\"1\"/>"),
        ),
        (
            "local, fixed and exact",
            Some("initial-fits-causality"),
            local(
                "causality=\"local\" variability=\"fixed\" initial=\"exact\"><Real start=\"1\"/>",
            ),
        ),
        (
            "a start is outside of the bounds",
            Some("start-is-within-bounds"),
            replaced(&good, "min=\"0.01\"", "min=\"0.9\""),
        ),
        (
            "the GUID is wrong",
            Some("instance-can-be-made"),
            replaced(&good, "guid=\"{", "guid=\"{0"),
        ),
        (
            "the modelIdentifier is wrong",
            Some("binary-is-there"),
            replaced(&good, "modelIdentifier=\"vehicle\"", "modelIdentifier=\"wagon\""),
        ),
        (
            "a name is not structured",
            Some("names-are-structured"),
            replaced(&good, "name=\"velocity\"", "name=\"v 1\""),
        ),
        (
            "the experiment stops before it starts",
            Some("experiment-goes-forward"),
            replaced(&good, "startTime=\"0\"", "startTime=\"20\""),
        ),
        (
            "an index in Outputs is 0",
            Some("indices-are-in-range"),
            replaced(&good, &format!("<Unknown {position}"), "<Unknown index=\"0\""),
        ),
        (
            "a unit is there twice",
            Some("units-are-unique"),
            replaced(&good, "<Unit name=\"N\">", "<Unit name=\"m\">"),
        ),
        (
            "a log category is there twice",
            Some("log-categories-are-unique"),
            replaced(&good, "name=\"logEvents\"", "name=\"logAll\""),
        ),
        (
            "a state can be serialized but not got",
            Some("serializing-needs-states"),
            replaced(&good, "canGetAndSetFMUstate=\"true\"", "canGetAndSetFMUstate=\"false\""),
        ),
        (
            "the independent variable has a start",
            Some("start-is-not-given"),
            added(
                &good,
                "<ScalarVariable name=\"time\" valueReference=\"9999\" causality=\"independent\" variability=\"continuous\"><Real start=\"0\"/></ScalarVariable>",
            ),
        ),
        (
            "a dependency is beyond the variables",
            Some("dependencies-are-in-range"),
            replaced(&good, "dependencies=\"\"", "dependencies=\"99999\""),
        ),
        ("there is no independent variable", None, good.clone()),
        (
            "the description is not XML",
            Some("xml-is-well-formed"),
            replaced(&good, "</ModelVariables>", ""),
        ),
    ];
    for (mutation, rule, text) in mutations {
        let findings = copy.with(DESCRIPTION, &text, check);
        match rule {
            None => assert!(findings.is_empty(), "{mutation}: {findings:#?}"),
            Some(rule) => {
                assert!(findings.iter().any(|f| f.rule == rule), "{mutation}: {findings:#?}")
            }
        }
    }
}
