//! `hotfoot interface`: the variables of an FMU.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::{Interface, Variable, archive, printable, xml_text};
use serde::Serialize;

use crate::output::{print_json, print_table, write};
use crate::supervise::temporary::Temporary;

/// Arguments of `hotfoot interface`.
#[derive(Args)]
pub struct InterfaceArguments {
    /// FMU
    fmu: PathBuf,
    /// Print the variables as JSON
    #[arg(long, conflicts_with = "xml")]
    json: bool,
    /// Print the modelDescription.xml as it is
    #[arg(long)]
    xml: bool,
}

/// A variable as it is listed.
#[derive(Serialize)]
struct Listed {
    name: String,
    causality: String,
    #[serde(rename = "type")]
    kind: &'static str,
    unit: Option<String>,
    start: Option<String>,
    min: Option<f64>,
    max: Option<f64>,
    description: String,
}

impl Listed {
    fn new(variable: &Variable) -> Self {
        let stated = |bound: f64| (bound.abs() < f64::MAX).then_some(bound);
        Self {
            name: variable.name.clone(),
            causality: variable.causality.clone(),
            kind: variable.kind.fmi_name(),
            unit: variable.unit.clone(),
            start: variable.start.clone(),
            min: stated(variable.range.min),
            max: stated(variable.range.max),
            description: variable.description.clone(),
        }
    }

    /// What it may be: `0 … 1`, `≥ 0`.
    fn bounds(&self) -> String {
        match (self.min, self.max) {
            (Some(min), Some(max)) => format!("{min} … {max}"),
            (Some(min), None) => format!("≥ {min}"),
            (None, Some(max)) => format!("≤ {max}"),
            (None, None) => String::new(),
        }
    }

    /// Its cells; text of the FMU cannot steer the terminal.
    fn cells(&self) -> [String; 7] {
        let text = |text: &Option<String>| printable(text.as_deref().unwrap_or_default());
        [
            self.causality.clone(),
            self.kind.to_owned(),
            printable(&self.name),
            text(&self.unit),
            text(&self.start),
            self.bounds(),
            printable(&self.description),
        ]
    }
}

/// Lists the variables of an FMU, or prints its model description.
///
/// # Errors
/// When the FMU cannot be read.
pub fn interface(arguments: &InterfaceArguments) -> Result<()> {
    let InterfaceArguments { fmu, json, xml } = arguments;
    files::exists(fmu)?;
    let folder = Temporary::new()?;
    archive::unpack(fmu, folder.path())?;
    let file = folder.path().join("modelDescription.xml");
    let text = xml_text::read(&file)?;
    if *xml {
        return write(text);
    }
    let interface = Interface::from_xml(&text)?;
    let listed: Vec<Listed> = interface.variables().into_iter().map(Listed::new).collect();
    if *json {
        return print_json(&listed);
    }
    let heading = ["causality", "type", "name", "unit", "start", "bounds", "description"];
    let mut rows = vec![heading.map(str::to_owned)];
    rows.extend(listed.iter().map(Listed::cells));
    print_table(&rows)
}
