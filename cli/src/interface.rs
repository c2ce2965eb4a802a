//! `hotfoot interface` and `hotfoot schema`: what may be written of FMUs and in scenarios.

use std::path::Path;

use anyhow::Result;
use hotfoot::{Interface, archive, printable, scenario, xml_text};

use crate::output::{print, write};
use crate::supervise::temporary::Temporary;

/// Lists the variables of an FMU, or prints its model description.
///
/// # Errors
/// When the FMU cannot be read.
pub fn interface(fmu: &Path, xml: bool) -> Result<()> {
    files::exists(fmu)?;
    let folder = Temporary::new()?;
    archive::unpack(fmu, folder.path())?;
    let file = folder.path().join("modelDescription.xml");
    let text = xml_text::read(&file)?;
    if xml {
        return write(text);
    }
    let interface = Interface::from_xml(&text)?;
    for variable in interface.variables() {
        let unit = printable(variable.unit.as_deref().unwrap_or(""));
        print(format_args!("{:<9} {:<52} {unit}", variable.causality, printable(&variable.name)))?;
    }
    Ok(())
}

/// Prints the JSON schema of scenario files.
///
/// # Errors
/// Never in practice.
pub fn schema() -> Result<()> {
    let schema = schemars::schema_for!(scenario::Scenario);
    print(serde_json::to_string_pretty(&schema)?)
}
