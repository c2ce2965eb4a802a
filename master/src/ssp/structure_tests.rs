//! Structures from XML and back.

use std::path::Path;

use super::read::{STRUCTURE_FILE, read};
use super::write::write;
use crate::interface::si::Linear;
use crate::system::structure::{Parameter, Sampling, Schedule, Structure, Value};

const NAMESPACES: &str = r#"xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription"
    xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"
    xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues"
    xmlns:ssm="http://ssp-standard.org/SSP1/SystemStructureParameterMapping""#;

/// The structure whose system has this content, with further files in the package.
fn structure(system: &str, files: &[(&str, &str)]) -> Result<Structure, String> {
    structure_with(r#"<ssd:DefaultExperiment startTime="1" stopTime="3"/>"#, system, files)
}

/// The same with another experiment.
fn structure_with(
    experiment: &str,
    system: &str,
    files: &[(&str, &str)],
) -> Result<Structure, String> {
    let text = format!(
        r#"<ssd:SystemStructureDescription {NAMESPACES} version="1.0" name="test">
        <ssd:System name="root">{system}</ssd:System>
        <ssd:Units><ssc:Unit name="kN"><ssc:BaseUnit kg="1" m="1" s="-2" factor="1000"/></ssc:Unit></ssd:Units>
        {experiment}
        </ssd:SystemStructureDescription>"#
    );
    let folder = tempfile::tempdir().unwrap();
    for (name, text) in files.iter().chain(&[(STRUCTURE_FILE, text.as_str())]) {
        std::fs::write(folder.path().join(name), text).unwrap();
    }
    read(folder.path(), STRUCTURE_FILE).map_err(|error| error.to_string())
}

fn component(name: &str, content: &str) -> String {
    format!(
        r#"<ssd:Component name="{name}" source="resources/f.fmu"><ssd:Connectors>
        <ssd:Connector name="u" kind="input"><ssc:Real unit="kN"/></ssd:Connector>
        <ssd:Connector name="y" kind="output"><ssc:Real/></ssd:Connector>
        </ssd:Connectors>{content}</ssd:Component>"#
    )
}

fn connection(start: &str, stop: &str, content: &str) -> String {
    let end = |which: &str, name: &str| match name.split_once('.') {
        Some((element, connector)) => {
            format!(r#"{which}Element="{element}" {which}Connector="{connector}""#)
        }
        None => format!(r#"{which}Connector="{name}""#),
    };
    let (start, stop) = (end("start", start), end("end", stop));
    format!("<ssd:Connection {start} {stop}>{content}</ssd:Connection>")
}

#[test]
fn a_connection_is_read_whichever_end_is_named_first() {
    for (first, second) in [("a.y", "b.u"), ("b.u", "a.y")] {
        let transformation = r#"<ssc:LinearTransformation factor="2" offset="1"/>"#;
        let system = format!(
            "<ssd:Elements>{}{}</ssd:Elements><ssd:Connections>{}</ssd:Connections>",
            component("a", ""),
            component("b", ""),
            connection(first, second, transformation)
        );
        let structure = structure(&system, &[]).unwrap();
        let [connection] = structure.connections.as_slice() else { panic!("{structure:?}") };
        assert_eq!((connection.from.element.as_str(), connection.to.element.as_str()), ("a", "b"));
        assert_eq!(connection.transformation.apply(10.0), 21.0);
        assert_eq!((structure.start, structure.stop), (Some(1.0), Some(3.0)));
        assert_eq!(structure.units["kN"].to_base.apply(2.0), 2000.0);
        let unit = structure.component("b").unwrap().connector("u").unwrap().unit.as_deref();
        assert_eq!(unit, Some("kN"));
    }
}

#[test]
fn a_nested_system_is_made_flat_with_both_transformations() {
    let inner = format!(
        r#"<ssd:System name="inner"><ssd:Connectors><ssd:Connector name="in" kind="input"/></ssd:Connectors>
        <ssd:Elements>{}</ssd:Elements><ssd:Connections>{}</ssd:Connections></ssd:System>"#,
        component("b", ""),
        connection("in", "b.u", r#"<ssc:LinearTransformation factor="3"/>"#)
    );
    let system = format!(
        "<ssd:Elements>{}{inner}</ssd:Elements><ssd:Connections>{}</ssd:Connections>",
        component("a", ""),
        connection("a.y", "inner.in", r#"<ssc:LinearTransformation offset="1"/>"#)
    );
    let structure = structure(&system, &[]).unwrap();
    let [connection] = structure.connections.as_slice() else { panic!("{structure:?}") };
    assert_eq!(connection.to.element, "inner.b");
    assert_eq!(connection.transformation.apply(1.0), 6.0, "3 (1 + 1)");
}

#[test]
fn start_values_come_from_the_structure_from_files_and_through_mappings() {
    let set = |name: &str, value: &str| {
        format!(
            r#"<ssv:ParameterSet {NAMESPACES} version="1.0" name="s"><ssv:Parameters>
            <ssv:Parameter name="{name}">{value}</ssv:Parameter></ssv:Parameters></ssv:ParameterSet>"#
        )
    };
    let inline = set("mass", r#"<ssv:Real value="2.5" unit="kN"/>"#);
    let mapping = r#"<ssd:ParameterMapping><ssm:ParameterMapping version="1.0">
        <ssm:MappingEntry source="gross" target="net"><ssc:LinearTransformation factor="0.5"/></ssm:MappingEntry>
        </ssm:ParameterMapping></ssd:ParameterMapping>"#;
    let bindings = format!(
        r#"<ssd:ParameterBindings>
        <ssd:ParameterBinding><ssd:ParameterValues>{inline}</ssd:ParameterValues></ssd:ParameterBinding>
        <ssd:ParameterBinding source="values.ssv">{mapping}</ssd:ParameterBinding>
        </ssd:ParameterBindings>"#
    );
    let of_system = set("a.on", r#"<ssv:Boolean value="1"/>"#);
    let system = format!(
        r#"<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>{of_system}</ssd:ParameterValues>
        </ssd:ParameterBinding></ssd:ParameterBindings><ssd:Elements>{}</ssd:Elements>"#,
        component("a", &bindings)
    );
    let file = set("gross", r#"<ssv:Real value="10"/>"#);
    let structure = structure(&system, &[("values.ssv", &file)]).unwrap();
    let parameter = |name: &str, value, unit: Option<&str>| Parameter {
        name: name.to_owned(),
        value,
        unit: unit.map(str::to_owned),
        si: None,
        local: false,
        transformation: Linear::IDENTITY,
    };
    assert_eq!(
        structure.component("a").unwrap().parameters,
        [
            parameter("mass", Value::Real(2.5), Some("kN")),
            parameter("net", Value::Real(5.0), None),
            parameter("on", Value::Boolean(true), None),
        ]
    );
}

#[test]
fn an_item_of_an_enumeration_is_given_by_its_name_or_number() {
    let value = |attributes: &str| {
        let bindings = format!(
            r#"<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>
            <ssv:ParameterSet {NAMESPACES} version="1.0" name="s"><ssv:Parameters>
            <ssv:Parameter name="gear"><ssv:Enumeration {attributes}/></ssv:Parameter></ssv:Parameters>
            <ssv:Enumerations><ssc:Enumeration name="Gear"><ssc:Item name="reverse" value="-1"/>
            <ssc:Item name="first" value="4"/></ssc:Enumeration></ssv:Enumerations></ssv:ParameterSet>
            </ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>"#
        );
        let elements = format!("<ssd:Elements>{}</ssd:Elements>", component("a", &bindings));
        let structure = structure(&elements, &[]).map_err(|error| error.to_string())?;
        Ok(structure.component("a").unwrap().parameters[0].value.clone())
    };
    for (attributes, number) in
        [(r#"value="first""#, 4), (r#"name="Gear" value="reverse""#, -1), (r#"value="2""#, 2)]
    {
        assert_eq!(value(attributes), Ok(Value::Integer(number)), "{attributes}");
    }
    let refused: Result<_, String> = value(r#"value="second""#);
    let refused = refused.unwrap_err();
    assert!(refused.contains("which has reverse, first"), "{refused}");
    let unknown = value(r#"name="Door" value="first""#).unwrap_err();
    assert!(unknown.contains("declares no enumeration of it"), "{unknown}");
}

#[test]
fn what_is_written_is_read_as_it_was() {
    let system = format!(
        "<ssd:Elements>{}{}</ssd:Elements><ssd:Connections>{}</ssd:Connections>",
        component("a", ""),
        component("b", ""),
        connection("a.y", "b.u", r#"<ssc:LinearTransformation factor="2"/>"#)
    );
    let mut written = structure(&system, &[]).unwrap();
    written.units.clear();
    written.step = Some(1e-3);
    written.connections[0].convert_units = false;
    for component in &mut written.components {
        component.connectors.iter_mut().for_each(|connector| connector.unit = None);
    }
    let text = |value: &str| Value::Text(value.to_owned());
    let values = [Value::Real(1e-3), Value::Integer(-2), Value::Boolean(true), text("a <b>")];
    written.components[0].parameters =
        values.into_iter().map(|value| Parameter::new("p", value)).collect();
    assert_eq!(written_and_read(&written), written);
}

fn written_and_read(structure: &Structure) -> Structure {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join(STRUCTURE_FILE), write(structure).unwrap()).unwrap();
    read(folder.path(), STRUCTURE_FILE).unwrap()
}

/// Rates, stages with their names and what a slower component gets stand in annotations.
#[test]
fn a_schedule_is_read_as_it_was_written() {
    let system = format!(
        "<ssd:Elements>{}{}</ssd:Elements><ssd:Connections>{}</ssd:Connections>",
        component("a", ""),
        component("b", ""),
        connection("a.y", "b.u", "")
    );
    let plain = structure(&system, &[]).unwrap();
    assert_eq!(plain.components[1].schedule, Schedule::default());
    for sampling in [Sampling::Mean, Sampling::Sum, Sampling::Last] {
        let mut written = plain.clone();
        written.units.clear();
        for component in &mut written.components {
            component.connectors.iter_mut().for_each(|connector| connector.unit = None);
        }
        written.step = Some(1e-3);
        written.stages = vec!["train".to_owned(), "rail".to_owned()];
        written.components[1].schedule = Schedule { stage: 1, every: 10, ..Schedule::default() };
        written.connections[0].sampling = sampling;
        assert_eq!(written_and_read(&written), written);
    }
}

/// Another maker's annotation of the same name says nothing to us.
#[test]
fn a_wrong_schedule_is_answered_with_its_line_and_a_foreign_one_is_left_alone() {
    let annotated = |namespace: &str, content: &str| {
        let annotation = format!(
            r#"<ssd:Annotations><ssc:Annotation type="org.hotfoot.schedule">
            <h:Schedule xmlns:h="{namespace}" {content}</h:Schedule></ssc:Annotation></ssd:Annotations>"#
        );
        let system = format!("<ssd:Elements>{}</ssd:Elements>", component("a", &annotation));
        structure(&system, &[])
    };
    for (content, wanted) in [
        (r#"every="0">"#, "every at least 1"),
        (r#"stage="-1">"#, "stage=\"-1\" must be a whole number"),
        (r#"stage="5000">"#, "at most 1000"),
        (r#"><h:Input name="u" sampling="first"/>"#, "must be mean, sum or last"),
    ] {
        let message = annotated("urn:hotfoot:ssp", content).unwrap_err();
        assert!(message.contains("line 9") && message.contains(wanted), "{message}");
    }
    let foreign = annotated("urn:other", r#"every="0">"#).unwrap();
    assert_eq!(foreign.components[0].schedule, Schedule::default());
}

#[test]
fn a_wrong_experiment_is_answered_with_line_attribute_value_and_remedy() {
    for (experiment, wanted) in [
        (
            r#"<ssd:DefaultExperiment startTime="3" stopTime="1"/>"#,
            "line 7: stopTime=\"1\" must be after startTime=\"3\"",
        ),
        (
            r#"<ssd:DefaultExperiment stopTime="soon"/>"#,
            "line 7: stopTime=\"soon\" must be a number such as 0.5",
        ),
        (
            r#"<ssd:DefaultExperiment><FixedStepAlgorithm baseStepSize="0"/></ssd:DefaultExperiment>"#,
            "line 7: baseStepSize=\"0\" must be greater than zero",
        ),
    ] {
        let message = structure_with(experiment, "", &[]).unwrap_err();
        assert!(message.contains(STRUCTURE_FILE) && message.contains(wanted), "{message}");
    }
}

#[test]
fn what_is_wrong_is_answered_with_file_and_line() {
    let elements = |content: &str| format!("<ssd:Elements>\n{content}</ssd:Elements>");
    for (system, wanted) in [
        (
            elements(&component("a", ""))
                + "<ssd:Connections>"
                + &connection("a.y", "b.u", "")
                + "</ssd:Connections>",
            "'b' has no connector 'u'",
        ),
        (
            elements(&component("a", ""))
                + "<ssd:Connections>"
                + &connection("a.y", "a.y", "")
                + "</ssd:Connections>",
            "one must give values and the other take them",
        ),
        (elements(&(component("a", "") + &component("a", ""))), "two components with the name 'a'"),
        (
            elements(r#"<ssd:Component name="a"/>"#),
            "line 6: element Component lacks the attribute 'source'",
        ),
        (
            elements(r#"<ssd:SignalDictionaryReference name="d"/>"#),
            "element SignalDictionaryReference is not supported",
        ),
        (
            elements(&component(
                "a",
                r#"<ssd:ParameterBindings><ssd:ParameterBinding source="../x.ssv"/></ssd:ParameterBindings>"#,
            )),
            "must be a path inside of the package",
        ),
    ] {
        let message = structure(&system, &[]).unwrap_err();
        assert!(message.contains(STRUCTURE_FILE) && message.contains(wanted), "{message}");
    }
    let folder = tempfile::tempdir().unwrap();
    let message = read(folder.path(), STRUCTURE_FILE).unwrap_err().to_string();
    assert!(message.contains(STRUCTURE_FILE), "{message}");
    assert!(!Path::new(STRUCTURE_FILE).exists());
}
