//! The foot study: runs its scenarios one after the other, and makes its summary table and the
//! files of expected figures from their manifests.

use std::fmt::Write;
use std::path::Path;

use anyhow::{Context, Result};
use toml::Table;

use crate::shell::run_scenario;

/// Folder of the scenarios.
const FOLDER: &str = "scenarios/foot-study";

/// Scenarios in the order of the table, in words, and the probe whose heat it shows.
const CASES: [(&str, &str, &str); 8] = [
    ("straight", "straight", "chainage_300_m"),
    ("r800", "R = 800 m", "chainage_210_m"),
    ("r300", "R = 300 m, cant 100 mm", "chainage_210_m"),
    ("traction", "238 kN at 4.5 m/s, straight", "chainage_40_m"),
    ("drag-braking", "straight, wheels 100 K warm", "chainage_300_m"),
    ("night", "R = 800 m, clear night", "chainage_210_m"),
    ("day", "R = 800 m, sunny day", "chainage_210_m"),
    ("traffic", "R = 800 m, eight trains", "chainage_210_m"),
];

/// Figures of a rail that are kept as expected, with their tolerance: a share of the value, for a
/// change of the last digits by a compiler or a step is no error.
const EXPECTED: [(&str, f64); 4] = [
    ("foot.highest", 0.01),
    ("foot.detection", 0.1),
    ("camera.train", 0.02),
    ("heat.friction.mean_of_the_modelled_rail", 0.01),
];

/// The figure of a rail's energy audit, and the most that its error may be of the heat that wheels put in.
const AUDIT: (&str, f64) = ("energy.audit", 1e-9);

/// Runs all scenarios into `results`.
pub fn run_all(results: &Path) -> Result<()> {
    for (name, ..) in CASES {
        run_scenario(&format!("{FOLDER}/{name}.toml"), &results.join(name), &[])?;
    }
    Ok(())
}

/// The summary table of the runs in `results`, as Markdown.
pub fn table(results: &Path) -> Result<String> {
    let mut text = String::from(
        "| case | rail | heat, kJ/m: friction / chill / bending | camera on the train | camera at the track \
         side | at, after the train | first over 15 mK | audit |\n|---|---|---|---|---|---|---|---|\n",
    );
    for (name, words, probe) in CASES {
        let manifest = manifest(&results.join(name))?;
        for side in ["left", "right"] {
            let said = |key: &str, what: &str| -> Result<String> {
                let figure = figure(&manifest, &format!("{side}.{key}"))?;
                let text = figure.get(what).and_then(toml::Value::as_str);
                Ok(text.unwrap_or_default().to_owned())
            };
            let heat = |source: &str| -> Result<f64> {
                let figure = figure(&manifest, &format!("{side}.heat.{source}.{probe}"))?;
                let value = figure.get("value").and_then(toml::Value::as_float);
                Ok(value.context("heat is a number")? / 1e3)
            };
            let stated = said("camera.track_side", "place")?;
            let after = stated.rsplit(", ").next().unwrap_or_default();
            let after = after.split(" after").next().unwrap_or_default().to_owned();
            writeln!(
                text,
                "| {words} | {side} | {:.2} / {:.2} / {:.2} | {} | {} | {after} | {} | {} |",
                heat("friction")?,
                heat("chill")?,
                heat("bending")?,
                said("camera.train", "text")?,
                said("camera.track_side", "text")?,
                said("foot.detection", "text")?,
                said(AUDIT.0, "text")?,
            )?;
        }
    }
    Ok(text)
}

/// Writes what the runs in `results` gave as what is expected of them.
pub fn write_expected(results: &Path) -> Result<()> {
    for (name, ..) in CASES {
        let manifest = manifest(&results.join(name))?;
        let simulated = manifest.get("simulated_s").and_then(toml::Value::as_float).unwrap_or(0.0);
        let mut text =
            format!("# `cargo xtask foot-study`; see ../README.md.\nsimulated_s = {simulated:?}\n");
        for side in ["left", "right"] {
            for (key, share) in EXPECTED {
                let key = format!("{side}.{key}");
                writeln!(text, "\n[[figure]]\nkey = \"{key}\"")?;
                if let Some(value) =
                    figure(&manifest, &key)?.get("value").and_then(|v| v.as_float())
                {
                    writeln!(text, "value = {value:?}\ntolerance = {:.1e}", share * value.abs())?;
                }
                writeln!(text, "source = \"own run with version {}\"", env!("CARGO_PKG_VERSION"))?;
            }
            let (key, most) = AUDIT;
            figure(&manifest, &format!("{side}.{key}"))?;
            writeln!(
                text,
                "\n[[figure]]\nkey = \"{side}.{key}\"\nvalue = 0.0\ntolerance = {most:?}"
            )?;
            writeln!(text, "source = \"conservation of energy: 1e-9 of the heat put in\"")?;
        }
        let file = format!("{FOLDER}/expected/{name}.toml");
        std::fs::create_dir_all(format!("{FOLDER}/expected")).context(FOLDER)?;
        std::fs::write(&file, text).context(file)?;
    }
    Ok(())
}

fn manifest(results: &Path) -> Result<Table> {
    let file = results.join("manifest.toml");
    let text = std::fs::read_to_string(&file).with_context(|| file.display().to_string())?;
    toml::from_str(&text).with_context(|| file.display().to_string())
}

/// The figure of that key in a manifest.
fn figure<'m>(manifest: &'m Table, key: &str) -> Result<&'m Table> {
    let figures = manifest.get("figure").and_then(toml::Value::as_array);
    let mut tables = figures.into_iter().flatten().filter_map(toml::Value::as_table);
    let has_key = |figure: &&Table| figure.get("key").and_then(toml::Value::as_str) == Some(key);
    tables.find(has_key).with_context(|| format!("the manifest has no figure {key}"))
}
