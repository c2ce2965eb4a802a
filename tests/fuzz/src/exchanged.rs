//! The files of other tools: FMUs, and packages of SSP.

use hotfoot::{Interface, archive, check, ssp, xml_text};

use crate::scratch::Scratch;

/// A structure that names a file with values and one that maps their names.
const STRUCTURE: &str = r#"<ssd:SystemStructureDescription version="1.0" name="read"
    xmlns:ssd="http://ssp-standard.org/SSP1/SystemStructureDescription"
    xmlns:ssc="http://ssp-standard.org/SSP1/SystemStructureCommon"><ssd:System name="root">
  <ssd:ParameterBindings><ssd:ParameterBinding source="values.ssv">
    <ssd:ParameterMapping source="mapping.ssm"/></ssd:ParameterBinding></ssd:ParameterBindings>
  <ssd:Elements><ssd:Component name="body" source="resources/body.fmu"><ssd:Connectors>
    <ssd:Connector name="mass" kind="parameter"><ssc:Real/></ssd:Connector>
  </ssd:Connectors></ssd:Component></ssd:Elements></ssd:System></ssd:SystemStructureDescription>"#;

/// Values for a parameter of that structure.
const VALUES: &str = r#"<ssv:ParameterSet version="1.0" name="values"
    xmlns:ssv="http://ssp-standard.org/SSP1/SystemStructureParameterValues"><ssv:Parameters>
  <ssv:Parameter name="weight"><ssv:Real value="10"/></ssv:Parameter>
</ssv:Parameters></ssv:ParameterSet>"#;

/// The name of that value as the component has it.
const MAPPING: &str = r#"<ssm:ParameterMapping version="1.0"
    xmlns:ssm="http://ssp-standard.org/SSP1/SystemStructureParameterMapping">
  <ssm:MappingEntry source="weight" target="body.mass"/></ssm:ParameterMapping>"#;

/// A model description in any encoding, with all the rules of the standard.
pub fn model_description(bytes: &[u8]) {
    let scratch = Scratch::with("modelDescription.xml", bytes);
    if let Ok(text) = xml_text::read(&scratch.path("modelDescription.xml")) {
        let _ = Interface::from_xml(&text);
        let _ = check::check_description(&text);
    }
}

pub fn structure(bytes: &[u8]) {
    package(bytes, VALUES.as_bytes(), MAPPING.as_bytes());
}

pub fn values(bytes: &[u8]) {
    package(STRUCTURE.as_bytes(), bytes, MAPPING.as_bytes());
}

pub fn mapping(bytes: &[u8]) {
    package(STRUCTURE.as_bytes(), VALUES.as_bytes(), bytes);
}

fn package(structure: &[u8], values: &[u8], mapping: &[u8]) {
    let scratch = Scratch::with(ssp::STRUCTURE_FILE, structure);
    scratch.write("values.ssv", values);
    scratch.write("mapping.ssm", mapping);
    let _ = ssp::read(scratch.folder(), ssp::STRUCTURE_FILE);
}

/// The archive that an FMU and a package are.
pub fn archive(bytes: &[u8]) {
    let scratch = Scratch::with("read.fmu", bytes);
    let _ = archive::unpack(&scratch.path("read.fmu"), &scratch.path("unpacked"));
    let _ = archive::uncommon_entries(&scratch.path("read.fmu"));
}
