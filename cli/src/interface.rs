//! `hotfoot interface` and `hotfoot schema`: what may be written of FMUs and in scenarios.

use std::path::Path;

use hotfoot::{Interface, archive, scenario};
use miette::{IntoDiagnostic, Result};

/// Lists the variables of an FMU, or prints its model description.
///
/// # Errors
/// When the FMU cannot be read.
pub fn interface(fmu: &Path, xml: bool) -> Result<()> {
    let folder = tempfile::tempdir().into_diagnostic()?;
    archive::unpack(fmu, folder.path()).into_diagnostic()?;
    let file = folder.path().join("modelDescription.xml");
    let text = std::fs::read_to_string(file).into_diagnostic()?;
    if xml {
        print!("{text}");
        return Ok(());
    }
    let interface = Interface::from_xml(&text).into_diagnostic()?;
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
    println!("{}", serde_json::to_string_pretty(&schema).into_diagnostic()?);
    Ok(())
}
