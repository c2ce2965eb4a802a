//! `hotfoot interface` and `hotfoot schema`: what may be written of FMUs and in scenarios.

use std::path::Path;

use anyhow::Result;
use hotfoot::{Interface, archive, scenario, xml_text};

/// Lists the variables of an FMU, or prints its model description.
///
/// # Errors
/// When the FMU cannot be read.
pub fn interface(fmu: &Path, xml: bool) -> Result<()> {
    files::exists(fmu)?;
    let folder = tempfile::tempdir()?;
    archive::unpack(fmu, folder.path())?;
    let file = folder.path().join("modelDescription.xml");
    let text = xml_text::read(&file)?;
    if xml {
        print!("{text}");
        return Ok(());
    }
    let interface = Interface::from_xml(&text)?;
    for variable in interface.variables() {
        let unit = variable.unit.as_deref().unwrap_or("");
        println!("{:<9} {:<52} {unit}", variable.causality, variable.name);
    }
    Ok(())
}

/// Prints the JSON schema of scenario files.
///
/// # Errors
/// Never in practice.
pub fn schema() -> Result<()> {
    let schema = schemars::schema_for!(scenario::Scenario);
    println!("{}", serde_json::to_string_pretty(&schema)?);
    Ok(())
}
