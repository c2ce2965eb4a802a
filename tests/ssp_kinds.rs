//! Packages as the tools of other makers write them: where start values and connections may stand, and
//! how files are named. Each value arrives or is named.

use hotfoot_tests::probe::{Package, bindings, component, connections, parameter_set};

/// A nested or the outermost system's connectors.
fn connectors(connectors: &[(&str, &str)]) -> String {
    let connector = |(name, kind): &(&str, &str)| {
        format!("<ssd:Connector name=\"{name}\" kind=\"{kind}\"><ssc:Real/></ssd:Connector>")
    };
    let all: String = connectors.iter().map(connector).collect();
    format!("<ssd:Connectors>{all}</ssd:Connectors>")
}

fn elements(elements: &str) -> String {
    format!("<ssd:Elements>{elements}</ssd:Elements>")
}

/// The last y of component `name` when the package has run, with what the run said.
fn result(system: &str, name: &str) -> (f64, String) {
    let package = Package::new(system, &[]);
    let told = package.run_well(&[]);
    (*package.recorded(name, "y").last().unwrap(), told)
}

#[test]
fn a_value_at_a_systems_input_or_parameter_reaches_the_component() {
    for (port, kind, inner, other, expected) in
        [("U", "input", "a.u", ("k", 3.0), 15.0), ("P", "parameter", "a.k", ("u", 2.0), 10.0)]
    {
        let system = connectors(&[(port, kind)])
            + &bindings(&[(port, 5.0)])
            + &elements(&component("a", &[other]))
            + &connections(&[(port, inner, "")]);
        let (y, told) = result(&system, "a");
        assert_eq!(y, expected, "{kind}");
        assert!(!told.contains("warning"), "{told}");
    }
}

/// Through two systems, with the transformations of both connections; what stands at the outer system
/// comes later and counts.
#[test]
fn a_value_goes_through_nested_systems_with_their_transformations() {
    let twice = "<ssc:LinearTransformation factor=\"2\"/>";
    let more = "<ssc:LinearTransformation offset=\"1\"/>";
    let inner = format!(
        "<ssd:System name=\"inner\">{}{}{}{}</ssd:System>",
        connectors(&[("V", "input")]),
        bindings(&[("V", 100.0)]),
        elements(&component("a", &[])),
        connections(&[("V", "a.u", more)])
    );
    let outer = connectors(&[("U", "input")])
        + &bindings(&[("U", 5.0)])
        + &elements(&inner)
        + &connections(&[("U", "inner.V", twice)]);
    assert_eq!(result(&outer, "inner.a").0, 11.0, "2 · 5 + 1");
    let by_name = bindings(&[("inner.V", 7.0), ("inner.a.k", 10.0)]) + &elements(&inner);
    assert_eq!(result(&by_name, "inner.a").0, 80.0, "10 (7 + 1)");
    assert_eq!(result(&elements(&inner), "inner.a").0, 101.0, "the inner system's own");
}

/// The start of a system's output is that of the output inside; of one that nothing gives, what takes it
/// gets it.
#[test]
fn a_value_at_a_systems_output_reaches_what_is_connected() {
    let inner = format!(
        "<ssd:System name=\"inner\">{}{}</ssd:System>",
        connectors(&[("Y", "output")]),
        elements(&component("b", &[]))
    );
    let system = bindings(&[("inner.Y", 4.0)])
        + &elements(&(inner + &component("a", &[("k", 2.0)])))
        + &connections(&[("inner.Y", "a.u", "")]);
    let (y, told) = result(&system, "a");
    assert_eq!(y, 8.0);
    assert!(!told.contains("warning"), "{told}");
    // The probe takes a start value of y and computes another.
    let given = connectors(&[("Y", "output")])
        + &bindings(&[("Y", 4.0)])
        + &elements(&component("a", &[("u", 3.0)]))
        + &connections(&[("a.y", "Y", "")]);
    let (y, told) = result(&given, "a");
    assert_eq!(y, 3.0);
    assert!(!told.contains("warning"), "{told}");
}

/// SSP 1.0 wants them ignored; the user is told.
#[test]
fn values_without_a_home_are_named() {
    let system = bindings(&[("b.k", 1.0), ("Q", 2.0)])
        + &elements(&component("a", &[("u", 2.0), ("k", 3.0), ("t_end", 9.0)]));
    let (y, told) = result(&system, "a");
    assert_eq!(y, 6.0);
    for name in ["'a.t_end'", "'b.k'", "'Q'"] {
        assert!(told.contains(&format!("warning: {name} has a start value")), "{name}: {told}");
    }
    let open =
        connectors(&[("U", "input")]) + &bindings(&[("U", 5.0)]) + &elements(&component("a", &[]));
    assert!(result(&open, "a").1.contains("'U' has a start value at the system 's'"));
}

#[test]
fn connections_that_lead_nowhere_are_refused() {
    let inner = format!(
        "<ssd:System name=\"inner\">{}{}</ssd:System>",
        connectors(&[("V", "input"), ("W", "output")]),
        connections(&[("V", "W", "")])
    );
    for (system, wanted) in [
        (
            connectors(&[("U", "input"), ("V", "input")])
                + &elements(&component("a", &[]))
                + &connections(&[("U", "a.u", ""), ("V", "a.u", "")]),
            "'a.u' is connected already",
        ),
        (
            elements(&component("a", &[])) + &connections(&[("a.y", "a.x", "")]),
            "'a' has no connector 'x'",
        ),
        (
            elements(&(inner + &component("a", &[])))
                + &connections(&[("inner.W", "inner.V", ""), ("inner.W", "a.u", "")]),
            "go round in a circle",
        ),
        (
            elements(&component("a", &[])) + &connections(&[("a.y", "a.k", "")]),
            "no input of its FMU",
        ),
    ] {
        let message = Package::new(&system, &[]).refusal();
        assert!(message.contains(wanted), "{wanted}: {message}");
    }
}

/// As OMSimulator writes a connection from the system itself.
#[test]
fn an_empty_name_of_an_element_is_the_system() {
    let system = connectors(&[("U", "input")])
        + &bindings(&[("U", 5.0)])
        + &elements(&component("a", &[("k", 3.0)]))
        + &connections(&[("U", "a.u", "")]).replace("startC", "startElement=\"\" startC");
    assert!(system.contains("startElement=\"\""));
    assert_eq!(result(&system, "a").0, 15.0);
}

/// All files of a package: FMU, SSV and SSM.
#[test]
fn sources_are_relative_references_with_dots_and_percents() {
    let mapping = "<?xml version=\"1.0\"?><ssm:ParameterMapping version=\"1.0\" \
        xmlns:ssm=\"http://ssp-standard.org/SSP1/SystemStructureParameterMapping\">\
        <ssm:MappingEntry source=\"gross\" target=\"k\"/></ssm:ParameterMapping>";
    let values = parameter_set(&[("gross", 3.0), ("net", 1.0)]);
    let files: [(&str, &[u8]); 2] = [
        ("resources/my values.ssv", values.as_bytes()),
        ("resources/my mapping.ssm", mapping.as_bytes()),
    ];
    let binding =
        "<ssd:ParameterBindings><ssd:ParameterBinding source=\"./resources/my%20values.ssv\">\
        <ssd:ParameterMapping source=\"resources/my%20mapping.ssm\"/></ssd:ParameterBinding>\
        <ssd:ParameterBinding><ssd:ParameterValues>"
            .to_owned()
            + &parameter_set(&[("u", 2.0)])
            + "</ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>";
    let own = component("a", &[]);
    let system =
        elements(&own.replace(&bindings(&[]), &binding).replace("\"resources/", "\"./resources/"));
    let package = Package::new(&system, &files);
    let told = package.run_well(&[]);
    assert_eq!(package.recorded("a", "y").last(), Some(&6.0));
    let wanted = "'net' has a start value that ./resources/my%20mapping.ssm maps to nothing";
    assert!(told.contains(wanted), "{told}");
}

/// libcosim and ecos take the prefix for theirs, and so a file without its declaration runs.
#[test]
fn an_undeclared_prefix_of_osp_is_read_with_a_warning() {
    let algorithm = "<ssd:Annotations><ssc:Annotation type=\"com.opensimulationplatform\">\
        <osp:Algorithm><osp:FixedStepAlgorithm baseStepSize=\"0.02\"/></osp:Algorithm>\
        </ssc:Annotation></ssd:Annotations>";
    let system = elements(&component("a", &[("u", 2.0)])) + algorithm;
    let (y, told) = result(&system, "a");
    assert_eq!(y, 2.0);
    assert!(told.contains("warning: SystemStructure.ssd uses the prefix 'osp' without"), "{told}");
}
