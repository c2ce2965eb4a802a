//! Reading a scenario file, with messages that point at the line.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use miette::{Diagnostic, NamedSource, SourceSpan};
use toml::de::{DeTable, DeValue};

use super::check::{Wrong, check};
use super::file::Scenario;
use super::value::Value;

/// Why a scenario cannot be run.
#[derive(Debug, thiserror::Error, Diagnostic)]
pub enum ScenarioError {
    /// The file cannot be read.
    #[error("scenario {file} cannot be read: {source}")]
    Read {
        /// File.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// A key or value is wrong.
    #[error("scenario {file}: {message}")]
    Wrong {
        /// File.
        file: String,
        /// What is wrong and what is allowed.
        message: String,
        /// The text of the file.
        #[source_code]
        text: Arc<NamedSource<String>>,
        /// Where.
        #[label("here")]
        place: Option<SourceSpan>,
    },
    /// The scenario is wrong with the times of the command line.
    #[error("scenario {file} with {options}: {message}")]
    Times {
        /// File.
        file: String,
        /// The options with their values.
        options: String,
        /// Key, what is wrong and what is allowed.
        message: String,
    },
    /// A file that the scenario names is missing.
    #[error("scenario {file}: {key} = \"{value}\": there is no such {what} at {path}")]
    Missing {
        /// Scenario.
        file: String,
        /// Key.
        key: String,
        /// Value.
        value: String,
        /// What it should be.
        what: &'static str,
        /// Path looked at.
        path: String,
    },
}

/// The file of the scenario at `path`, which may be its folder.
pub fn file_of(path: &Path) -> PathBuf {
    if path.is_dir() { path.join("scenario.toml") } else { path.to_owned() }
}

/// Reads the scenario at `path` (the file, or the folder with `scenario.toml`), checks it, and
/// makes the paths in it absolute. Gives the scenario, its file and its text.
///
/// # Errors
/// When the file cannot be read or something in it is wrong.
pub fn load(path: &Path) -> Result<(Scenario, PathBuf, String), ScenarioError> {
    let file = file_of(path);
    let name = file.display().to_string();
    let text = std::fs::read_to_string(&file)
        .map_err(|source| ScenarioError::Read { file: name.clone(), source })?;
    let mut scenario = parse(&text, &name)?;
    let folder = std::path::absolute(&file)
        .ok()
        .and_then(|file| file.parent().map(Path::to_owned))
        .unwrap_or_default();
    resolve_paths(&mut scenario, &folder, &name)?;
    Ok((scenario, file, text))
}

fn parse(text: &str, name: &str) -> Result<Scenario, ScenarioError> {
    let wrong = |message: String, place: Option<std::ops::Range<usize>>| ScenarioError::Wrong {
        file: name.to_owned(),
        message,
        text: Arc::new(NamedSource::new(name, text.to_owned()).with_language("toml")),
        place: place.map(SourceSpan::from),
    };
    let scenario: Scenario = toml::from_str(text)
        .map_err(|error| wrong(error.message().trim().replace('\n', "; "), error.span()))?;
    check(&scenario).map_err(|Wrong { key, message }| {
        let place = span_of(text, &key);
        let value = place.clone().and_then(|place| text.get(place));
        // Of a long value the place says enough.
        let stated = match value.filter(|value| value.len() <= LONGEST_VALUE) {
            Some(value) if !value.contains('\n') => format!("{key} = {value}"),
            _ => key,
        };
        wrong(format!("{stated}: {message}"), place)
    })?;
    Ok(scenario)
}

/// Characters of a value that a message repeats.
const LONGEST_VALUE: usize = 40;

/// Where the value of a key such as `train.vehicles[0].count` stands in the text.
fn span_of(text: &str, key: &str) -> Option<std::ops::Range<usize>> {
    let root = DeTable::parse(text).ok()?;
    let mut span = None;
    let mut value: Option<&DeValue<'_>> = None;
    for step in key.split(['.', '[', ']']).filter(|step| !step.is_empty()) {
        let found = match (value, step.parse::<usize>()) {
            (None, _) => root.get_ref().get(step)?,
            (Some(DeValue::Table(table)), _) => table.get(step)?,
            (Some(DeValue::Array(array)), Ok(index)) => array.get(index)?,
            _ => return span,
        };
        span = Some(found.span());
        value = Some(found.get_ref());
    }
    span
}

/// Makes the paths absolute and checks that they are there.
fn resolve_paths(scenario: &mut Scenario, folder: &Path, file: &str) -> Result<(), ScenarioError> {
    let resolve = |path: &mut PathBuf, key: &str, what: &'static str| {
        let full = folder.join(&*path);
        if full.exists() {
            *path = full;
            return Ok(());
        }
        Err(ScenarioError::Missing {
            file: file.to_owned(),
            key: key.to_owned(),
            value: path.display().to_string(),
            what,
            path: full.display().to_string(),
        })
    };
    resolve(&mut scenario.stock, "stock", "folder")?;
    resolve(&mut scenario.track.file, "track.file", "track file")?;
    resolve(&mut scenario.driver.file, "driver.file", "driver file")?;
    for (i, path) in scenario.driver.with.iter_mut().enumerate() {
        resolve(path, &format!("driver.with[{i}]"), "file")?;
    }
    let fmus = &mut scenario.fmus;
    for (key, path) in [
        ("fmus.longitudinal", &mut fmus.longitudinal),
        ("fmus.vehicle", &mut fmus.vehicle),
        ("fmus.railheat", &mut fmus.railheat),
    ] {
        if let Some(path) = path {
            resolve(path, key, "FMU")?;
        }
    }
    for (i, replacement) in fmus.vehicle_at.iter_mut().enumerate() {
        if let Some(path) = &mut replacement.file {
            resolve(path, &format!("fmus.vehicle_at[{i}].file"), "FMU")?;
        }
    }
    let of_rails = scenario.heat.iter_mut().flat_map(|heat| heat.parameters.values_mut());
    let of_vehicles = fmus.vehicle_at.iter_mut().flat_map(|other| other.parameters.values_mut());
    for value in of_rails.chain(of_vehicles) {
        if let Value::Text(text) = value
            && folder.join(&*text).is_file()
        {
            *value = Value::File(folder.join(&*text));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    const GOOD: &str = r#"
title = "t"
duration_s = 1.0
[train]
speed_m_per_s = 16.67
[[train.vehicles]]
type = "locomotive"
count = 2
[track]
file = "track.toml"
[driver]
file = "driver.toml"
"#;

    fn message(text: &str) -> (String, Option<String>) {
        match parse(text, "s.toml").unwrap_err() {
            ScenarioError::Wrong { message, place, .. } => {
                let at = place.map(|p| text[p.offset()..p.offset() + p.len()].to_owned());
                (message, at)
            }
            other => panic!("unexpected {other}"),
        }
    }

    #[test]
    fn a_good_scenario_has_the_defaults_of_the_paper() {
        let scenario = parse(GOOD, "s.toml").unwrap();
        assert_eq!(scenario.step_s, 1e-3);
        assert_eq!(scenario.synchronisation.kp_kn_per_m, 2.0);
        assert_eq!(scenario.synchronisation.kd_kn_s_per_m, 10.0);
        assert_eq!(scenario.vehicle_count(), 2);
    }

    #[test]
    fn a_typo_is_answered_with_its_place_and_the_keys_allowed() {
        let (message, at) = message(&GOOD.replace("duration_s", "duraton_s"));
        assert!(message.contains("unknown field `duraton_s`"), "{message}");
        assert!(message.contains("duration_s"), "{message}");
        assert_eq!(at.as_deref(), Some("duraton_s"));
    }

    #[test]
    fn a_step_of_zero_is_answered_with_its_place_and_bounds() {
        let (message, at) =
            message(&GOOD.replace("duration_s = 1.0", "duration_s = 1.0\nstep_s = 0.0"));
        assert_eq!(message, "step_s = 0.0: lower than 0.000001");
        assert_eq!(at.as_deref(), Some("0.0"));
    }

    #[test]
    fn an_index_in_a_key_is_followed_to_its_place() {
        let (message, at) = message(&GOOD.replace("count = 2", "count = 0"));
        assert!(message.starts_with("train.vehicles[0].count"), "{message}");
        assert_eq!(at.as_deref(), Some("0"));
    }

    #[test]
    fn a_train_alone_heats_no_rail() {
        let text = GOOD.replace("duration_s = 1.0", "duration_s = 1.0\ntrain_alone = true");
        assert!(parse(&text, "s.toml").unwrap().train_alone);
        let (message, at) = message(&format!("{text}\n[heat]\nfield_interval_s = 1.0\n"));
        assert!(message.contains("leave [heat] out"), "{message}");
        assert_eq!(at.as_deref(), Some("true"));
    }

    #[test]
    fn two_fmus_for_one_place_are_refused() {
        let other = "[[fmus.vehicle_at]]\nplace = 2\nfile = \"v.fmu\"\n";
        let (message, _) = message(&format!("{GOOD}\n{other}{other}"));
        assert!(message.contains("two FMUs for place 2"), "{message}");
    }

    #[test]
    fn an_interval_between_two_steps_is_answered_with_its_place() {
        let (message, at) = message(&format!("{GOOD}\n[record]\ninterval_s = 0.0015\n"));
        assert!(message.starts_with("record.interval_s = 0.0015: "), "{message}");
        assert!(message.ends_with("is not a multiple of step_s = 0.001 s"), "{message}");
        assert_eq!(at.as_deref(), Some("0.0015"));
    }

    #[test]
    fn a_wheel_record_behind_the_tail_is_refused() {
        let (message, _) = message(&format!("{GOOD}\n[record]\nwheels_of = [3]\n"));
        assert!(message.contains("the train has 2 vehicles"), "{message}");
    }
}
