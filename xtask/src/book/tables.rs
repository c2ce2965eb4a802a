//! Pages of tables: the keys of all files by their schemas, the signals by the interfaces.

use std::fmt::Write as _;
use std::path::Path;

use anyhow::Result;
use serde_json::Value;

use crate::shell::{hotfoot, output, target};

/// Kinds of files that `hotfoot schema` knows by their keys.
const KEYS: [&str; 10] = [
    "scenario",
    "track",
    "driver",
    "vehicle",
    "draft-gear",
    "rail",
    "expected",
    "consist",
    "rail-heat",
    "experiment",
];

/// Kinds of files that it knows by their columns.
const COLUMNS: [&str; 4] = ["weather", "logger", "irregularity", "profile"];

/// The models.
const MODELS: [&str; 4] = ["vehicle", "longitudinal", "railheat", "synchronisation"];

/// Writes the pages into a folder.
pub fn write(folder: &Path) -> Result<()> {
    std::fs::write(folder.join("keys.md"), keys()?)?;
    Ok(std::fs::write(folder.join("signals.md"), signals()?)?)
}

/// A page of all keys and columns.
fn keys() -> Result<String> {
    let mut page = "# Keys of all files\n\nAs the program knows them: `hotfoot schema KIND` prints each as a schema for \
                    editors.\n"
        .to_owned();
    for kind in KEYS {
        let schema = json(hotfoot().args(["schema", kind]))?;
        writeln!(page, "\n## {kind}\n\n{}", text(&schema["description"]))?;
        keys_of(&schema, &mut page)?;
        for (name, part) in schema["$defs"].as_object().into_iter().flatten() {
            if part["properties"].is_object() {
                writeln!(page, "\n### {kind}: {name}\n\n{}", text(&part["description"]))?;
                keys_of(part, &mut page)?;
            }
        }
    }
    for kind in COLUMNS {
        let columns = json(hotfoot().args(["schema", kind]))?;
        writeln!(page, "\n## {kind}\n\n| column | unit | what |\n|---|---|---|")?;
        for column in columns["fields"].as_array().into_iter().flatten() {
            let (name, unit, what) = (&column["name"], &column["unit"], &column["description"]);
            writeln!(page, "| `{}` | {} | {} |", text(name), text(unit), text(what))?;
        }
    }
    Ok(page)
}

/// The table of an object's keys.
fn keys_of(schema: &Value, page: &mut String) -> Result<()> {
    let required = schema["required"].as_array();
    let is_needed = |name: &str| required.is_some_and(|all| all.iter().any(|key| key == name));
    writeln!(page, "\n| key | left out | what |\n|---|---|---|")?;
    for (name, key) in schema["properties"].as_object().into_iter().flatten() {
        let left_out = match key.get("default") {
            _ if is_needed(name) => "needed".to_owned(),
            None | Some(Value::Null) => String::new(),
            Some(Value::Object(_)) => "see below".to_owned(),
            Some(default) => format!("`{default}`"),
        };
        writeln!(page, "| `{name}` | {left_out} | {} |", text(&key["description"]))?;
    }
    Ok(())
}

/// A page of all signals.
fn signals() -> Result<String> {
    let mut page = "# Signals of the models\n\nAs the FMUs show them: `hotfoot interface FMU` prints the same. Train \
                    and rail have a size to show here; there are as many vehicles as a run has.\n"
        .to_owned();
    for model in MODELS {
        let fmu = target().join("fmus").join(model).with_extension("fmu");
        let variables = json(hotfoot().arg("interface").arg(fmu).arg("--json"))?;
        writeln!(
            page,
            "\n## {model}.fmu\n\n| name | kind | unit | start | what |\n|---|---|---|---|---|"
        )?;
        for variable in variables.as_array().into_iter().flatten() {
            let [name, causality, kind, unit, start, what] =
                ["name", "causality", "type", "unit", "start", "description"]
                    .map(|key| text(&variable[key]));
            writeln!(page, "| `{name}` | {causality} {kind} | {unit} | {start} | {what} |")?;
        }
    }
    Ok(page)
}

fn json(command: &mut std::process::Command) -> Result<Value> {
    Ok(serde_json::from_str(&output(command)?)?)
}

/// A text for a cell of a table; nothing for what is no text.
fn text(value: &Value) -> String {
    value.as_str().unwrap_or_default().replace('|', "\\|").replace('\n', " ")
}
