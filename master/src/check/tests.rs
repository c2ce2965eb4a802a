//! Each rule on modelDescription.xml finds what breaks it, and nothing in a good file.

use super::{Finding, check_description, rules};

/// A description that keeps all rules and has something for each of them to look at.
const GOOD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="m" guid="{1}" variableNamingConvention="structured" generationDateAndTime="2026-11-22T09:30:00Z">
  <CoSimulation modelIdentifier="m" canGetAndSetFMUstate="true" canSerializeFMUstate="true"/>
  <UnitDefinitions>
    <Unit name="m/s"><BaseUnit m="1" s="-1"/><DisplayUnit name="km/h" factor="3.6"/></Unit>
    <Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit>
  </UnitDefinitions>
  <TypeDefinitions>
    <SimpleType name="Force"><Real unit="N" min="-1000"/></SimpleType>
    <SimpleType name="Mode"><Enumeration><Item name="off" value="1"/><Item name="on" value="2"/></Enumeration></SimpleType>
  </TypeDefinitions>
  <LogCategories><Category name="logEvents"/><Category name="logStatusError"/></LogCategories>
  <DefaultExperiment startTime="0" stopTime="1" tolerance="1e-6" stepSize="0.001"/>
  <ModelVariables>
    <ScalarVariable name="force" valueReference="0" causality="input"><Real declaredType="Force" start="5"/></ScalarVariable>
    <ScalarVariable name="mass" valueReference="1" causality="parameter" variability="fixed"><Real nominal="10" min="1" max="9" start="2"/></ScalarVariable>
    <ScalarVariable name="count" valueReference="0" causality="parameter" variability="tunable"><Integer min="1" max="3" start="2"/></ScalarVariable>
    <ScalarVariable name="mode" valueReference="1" causality="input" variability="discrete"><Enumeration declaredType="Mode" start="1"/></ScalarVariable>
    <ScalarVariable name="speed" valueReference="2" causality="output" initial="exact"><Real unit="m/s" displayUnit="km/h" start="0"/></ScalarVariable>
    <ScalarVariable name="der(speed)" valueReference="3" causality="output"><Real derivative="5"/></ScalarVariable>
    <ScalarVariable name="ratio" valueReference="4" causality="calculatedParameter" variability="fixed"><Real/></ScalarVariable>
    <ScalarVariable name="gauge" valueReference="5" variability="constant"><Real start="1.435"/></ScalarVariable>
    <ScalarVariable name="on" valueReference="0" causality="parameter" variability="fixed"><Boolean start="true"/></ScalarVariable>
    <ScalarVariable name="file" valueReference="0" causality="parameter" variability="fixed"><String start=""/></ScalarVariable>
    <ScalarVariable name="time" valueReference="6" causality="independent"><Real/></ScalarVariable>
  </ModelVariables>
  <ModelStructure>
    <Outputs><Unknown index="5" dependencies=""/><Unknown index="6" dependencies="1" dependenciesKind="dependent"/></Outputs>
    <Derivatives><Unknown index="6" dependencies="1"/></Derivatives>
    <InitialUnknowns><Unknown index="6" dependencies="1" dependenciesKind="dependent"/><Unknown index="7"/></InitialUnknowns>
  </ModelStructure>
</fmiModelDescription>
"#;

/// What is found after a piece of the good description has been replaced.
fn findings(from: &str, to: &str) -> Vec<Finding> {
    assert!(GOOD.contains(from), "{from} is not in the good description");
    check_description(&GOOD.replacen(from, to, 1))
}

/// For each rule: what to replace by what, and a part of the sentence that must come.
#[rustfmt::skip]
const BREACHES: &[(&str, &str, &str, &str)] = &[
    ("elements-as-in-schema", "<TypeDefinitions>", "<Odd/><TypeDefinitions>", "<Odd> cannot stand"),
    ("elements-as-in-schema", "<BaseUnit m=\"1\" s=\"-1\"/>", "<BaseUnit/><BaseUnit/>", "only one"),
    ("elements-as-in-schema", "<String start=\"\"/>", "", "lacks <Real> or <Integer>"),
    ("attributes-as-in-schema", "guid=\"{1}\" ", "", "lacks the attribute `guid`"),
    ("attributes-as-in-schema", "kg=\"1\"", "kilo=\"1\"", "has no attribute `kilo`"),
    ("values-as-in-schema", "min=\"1\" max=\"9\"", "min=\"one\"", "\"one\", but must be a number"),
    ("values-as-in-schema", "2026-11-22T", "22.11.2026 ", "a date and time"),
    ("values-as-in-schema", "\"tunable\"", "\"often\"", "one of constant, fixed"),
    ("fmi-version-is-2.0", "fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"", "must be \"2.0\""),
    ("an-interface-is-offered", "CoSimulation", "ModelExchanges", "neither"),
    ("model-identifier-is-a-c-name", "Identifier=\"m\"", "Identifier=\"1 m\"", "a name in C"),
    ("guid-is-not-blank", "guid=\"{1}\"", "guid=\" \"", "blank"),
    ("serializing-needs-states", "canGetAndSetFMUstate=\"true\" ", "", "must be true too"),
    ("log-categories-are-unique", "logStatusError", "logEvents", "there already"),
    ("log-categories-are-given", "<LogCategories><Category name=\"logEvents\"/><Category name=\"logStatusError\"/></LogCategories>", "", "null category"),
    ("experiment-goes-forward", "stopTime=\"1\"", "stopTime=\"-1\"", "after `startTime`, 0"),
    ("experiment-numbers-are-positive", "1e-6", "0", "`tolerance` is 0"),
    ("experiment-is-complete", " tolerance=\"1e-6\"", "", "no `tolerance`"),
    ("units-are-unique", "Unit name=\"N\"", "Unit name=\"m/s\"", "defined already"),
    ("unit-factors-are-not-zero", "factor=\"3.6\"", "factor=\"0\"", "must not be zero"),
    ("units-are-defined", "<Real unit=\"m/s\"", "<Real unit=\"kn\"", "\"kn\", which"),
    ("display-units-are-defined", "displayUnit=\"km/h\"", "displayUnit=\"mph\"", "\"mph\""),
    ("types-are-unique", "name=\"Force\"", "name=\"Mode\"", "\"Mode\" is defined already"),
    ("types-are-unique", "name=\"Force\"", "name=\"mass\"", "has the name of a variable"),
    ("types-are-defined", "declaredType=\"Force\"", "declaredType=\"F\"", "does not define"),
    ("types-are-defined", "declaredType=\"Force\"", "declaredType=\"Mode\"", "\"Mode\" is not"),
    ("names-are-unique", "name=\"on\" valueR", "name=\"mass\" valueR", "variable 2 already"),
    ("names-are-structured", "name=\"gauge\"", "name=\"the gauge\"", "no structured name"),
    ("aliases-have-one-start", "name=\"mass\" valueReference=\"1\"", "name=\"mass\" valueReference=\"0\"", "`force` are the same Real"),
    ("aliases-have-one-start", "name=\"mode\" valueReference=\"1\"", "name=\"mode\" valueReference=\"0\"", "`count` are the same Integer"),
    ("variability-fits-causality", "causality=\"input\" variability=\"discrete\"", "causality=\"input\" variability=\"fixed\"", "input and discrete or continuous"),
    ("initial-fits-causality", "causality=\"input\" variability=\"discrete\"", "causality=\"input\" initial=\"exact\" variability=\"discrete\"", "must have no `initial`"),
    ("only-reals-are-continuous", " variability=\"discrete\"", "", "says no `variability`"),
    ("independent-is-one-real", "causality=\"independent\"><Real", "causality=\"independent\"><Integer", "must be Real"),
    ("derivative-of-a-real", "derivative=\"5\"", "derivative=\"9\"", "that of another Real"),
    ("start-is-given", "declaredType=\"Force\" start=\"5\"", "declaredType=\"Force\"", "an input, so"),
    ("start-is-not-given", "<Real/></ScalarVariable>\n    <ScalarVariable name=\"gauge\"", "<Real start=\"1\"/></ScalarVariable>\n    <ScalarVariable name=\"gauge\"", "calculated, so"),
    ("start-is-within-bounds", "start=\"5\"", "start=\"-2000\"", "below its `min`, -1000"),
    ("start-is-within-bounds", "max=\"3\" start=\"2\"", "max=\"3\" start=\"4\"", "above its `max`, 3"),
    ("bounds-are-in-order", "max=\"9\"", "max=\"0\"", "must not exceed `max`, 0"),
    ("nominal-is-positive", "nominal=\"10\"", "nominal=\"0\"", "greater than zero"),
    ("indices-are-in-range", "<Outputs><Unknown index=\"5\"", "<Outputs><Unknown index=\"0\"", "from 1 to 11"),
    ("indices-are-in-order", "<Unknown index=\"7\"/>", "<Unknown index=\"7\"/><Unknown index=\"7\"/>", "a second time"),
    ("outputs-are-complete", "<Unknown index=\"5\" dependencies=\"\"/>", "", "`speed` (variable 5)"),
    ("outputs-are-complete", "<Unknown index=\"5\" dep", "<Unknown index=\"1\" dep", "`force` stands in <Outputs>"),
    ("derivatives-are-derivatives", "<Derivatives><Unknown index=\"6\"", "<Derivatives><Unknown index=\"5\"", "`speed` stands in <Derivatives>"),
    ("initial-unknowns-are-complete", "<Unknown index=\"7\"/>", "", "`ratio` (variable 7)"),
    ("dependencies-are-in-range", "dependencies=\"1\"", "dependencies=\"99\"", "holds 99"),
    ("dependency-kinds-fit", "\"1\" dependenciesKind", "\"1 4\" dependenciesKind", "2 `dependencies`, but 1"),
    ("initial-dependency-kinds-fit", "dependent\"/><Unknown index=\"7\"", "fixed\"/><Unknown index=\"7\"", "only dependent and constant"),
    ("dependencies-are-stated", "<Unknown index=\"5\" dependencies=\"\"/>", "<Unknown index=\"5\"/>", "every input at once"),
];

#[test]
fn a_good_description_breaks_no_rule() {
    let findings = check_description(GOOD);
    assert!(findings.is_empty(), "{findings:#?}");
}

#[test]
fn each_breach_is_found_by_its_rule_with_the_line() {
    for &(rule, from, to, part) in BREACHES {
        let findings = findings(from, to);
        let own = findings.iter().find(|f| f.rule == rule && f.sentence.contains(part));
        let own = own.unwrap_or_else(|| panic!("{rule}: {part}: {findings:#?}"));
        let line = GOOD[..GOOD.find(from).expect("checked")].matches('\n').count() + 1;
        let found: usize = own.location.rsplit(':').next().unwrap().parse().unwrap();
        // An element that lacks something is named where it begins.
        assert!(found <= line + 1, "{rule}: {}", own.location);
    }
}

#[test]
fn no_rule_is_without_a_test() {
    for rule in rules() {
        assert!(BREACHES.iter().any(|breach| breach.0 == rule.name), "{}", rule.name);
    }
}

#[test]
fn names_of_rules_are_unique() {
    let mut names: Vec<_> = rules().map(|rule| rule.name).collect();
    let count = names.len();
    names.sort_unstable();
    names.dedup();
    assert_eq!(names.len(), count);
}

#[test]
fn of_another_version_nothing_else_is_said() {
    let other = GOOD.replace("fmiVersion=\"2.0\"", "fmiVersion=\"3.0\"").replace("guid", "token");
    let findings = check_description(&other);
    assert_eq!(findings.iter().map(|f| f.rule).collect::<Vec<_>>(), ["fmi-version-is-2.0"]);
}

#[test]
fn what_is_not_xml_is_said_with_its_line() {
    let findings = check_description("<fmiModelDescription>\n<a>\n</fmiModelDescription>");
    assert_eq!(findings.len(), 1);
    assert_eq!(findings[0].rule, "xml-is-well-formed");
    assert_eq!(findings[0].location, "modelDescription.xml:3");
}

/// 100 000 outputs, each with a breach, in a fraction of what a time that grows with the square takes.
#[test]
fn a_wide_description_is_checked_in_linear_time() {
    let outputs: String = (0..100_000)
        .map(|i| {
            format!(
                "<ScalarVariable name=\"y{i}\" valueReference=\"{i}\" causality=\"output\">\n\
                 <Real declaredType=\"Force\"/></ScalarVariable>\n"
            )
        })
        .collect();
    let wide = GOOD.replace("</ModelVariables>", &format!("{outputs}</ModelVariables>"));
    let begin = std::time::Instant::now();
    let found = check_description(&wide);
    assert!(found.len() >= 100_000, "each output is missing in ModelStructure: {}", found.len());
    assert!(begin.elapsed().as_secs() < 60, "{} s", begin.elapsed().as_secs());
    let last = format!("modelDescription.xml:{}", 26 + 2 * 99_999);
    assert!(found.iter().any(|finding| finding.location == last), "lines are those of the text");
}

#[test]
fn a_deep_description_is_refused_at_once() {
    let deep = "<a>".repeat(200_000);
    let found = check_description(&GOOD.replace("<TypeDefinitions>", &deep));
    assert_eq!((found.len(), found[0].rule), (1, "xml-is-well-formed"));
    assert!(found[0].sentence.contains("more than 200 others"), "{}", found[0]);
}
