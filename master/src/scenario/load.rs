//! Reading a scenario file, with messages that point at the line.

use std::collections::BTreeMap;
use std::path::{Component, Path, PathBuf};

use files::{Check, Document, Mistake, Setting};

use super::check::{check, check_types};
use super::file::Scenario;
use super::value::{Value, quoted};
use crate::files::shipped;

/// The file of the scenario at `path`, which may be its folder.
pub fn file_of(path: &Path) -> PathBuf {
    if path.is_dir() { path.join("scenario.toml") } else { path.to_owned() }
}

/// Reads and checks the scenario at `path`: the file, or the folder with `scenario.toml`.
///
/// The `settings` of the command line go before what stands in the file. The paths become absolute. Gives the
/// scenario, its file and its text.
///
/// # Errors
/// When the file cannot be read, or something in it or in the settings is wrong.
pub fn load(path: &Path, settings: &[Setting]) -> Result<(Scenario, PathBuf, String), Mistake> {
    let file = file_of(path);
    if path.is_dir() && !file.exists() {
        return Err(no_scenario(path));
    }
    let mut document = Document::read(&file)?;
    let mut scenario = read(&document)?;
    if !settings.is_empty() {
        // The file was right by itself, at its own lines.
        document = document.with(settings)?;
        scenario = read(&document)?;
    }
    let folder = std::path::absolute(&file)
        .ok()
        .and_then(|file| file.parent().map(Path::to_owned))
        .unwrap_or_default();
    resolve_paths(&mut scenario, &folder, &document.check())?;
    Ok((scenario, file, document.text().to_owned()))
}

/// The error of a folder that holds nothing that could be run, with the scenarios below it.
fn no_scenario(folder: &Path) -> Mistake {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    // Those of the repository lie beside `stock` and the like.
    let beside = std::fs::read_dir(folder.join("../scenarios")).into_iter().flatten().flatten();
    let paths = entries.chain(beside).map(|entry| entry.path());
    let below = paths.filter(|path| file_of(path).is_file() && path.is_dir());
    let mut below: Vec<_> = below.map(|path| plain(&path).display().to_string()).collect();
    below.sort();
    let below = match below.as_slice() {
        [] => String::new(),
        scenarios => format!("; there are scenarios in {}", scenarios.join(", ")),
    };
    let sentence =
        format!("this folder has neither a scenario.toml nor a SystemStructure.ssd{below}");
    Mistake::in_file(folder.display(), sentence)
}

fn read(document: &Document) -> Result<Scenario, Mistake> {
    let scenario = Scenario { document: document.clone(), ..document.parse()? };
    check(&scenario, &document.check())?;
    Ok(scenario)
}

/// Makes the paths absolute and checks that they are there.
fn resolve_paths(scenario: &mut Scenario, folder: &Path, check: &Check) -> Result<(), Mistake> {
    let resolve = |path: &mut PathBuf, key: &str| {
        *path = there(folder, path, key, check)?;
        Ok(())
    };
    if scenario.stock.as_os_str().is_empty() {
        scenario.stock = default_stock(folder);
    }
    resolve(&mut scenario.stock, "stock")?;
    resolve_vehicle_files(scenario, folder, check)?;
    check_types(scenario, check)?;
    resolve(&mut scenario.track.file, "track.file")?;
    resolve(&mut scenario.driver.file, "driver.file")?;
    for (i, path) in scenario.driver.with.iter_mut().enumerate() {
        resolve(path, &format!("driver.with[{}]", i + 1))?;
    }
    let fmus = &mut scenario.fmus;
    for (key, path) in [
        ("fmus.longitudinal", &mut fmus.longitudinal),
        ("fmus.vehicle", &mut fmus.vehicle),
        ("fmus.railheat", &mut fmus.railheat),
    ] {
        if let Some(path) = path {
            resolve(path, key)?;
        }
    }
    for (i, replacement) in fmus.vehicle_at.iter_mut().enumerate() {
        if let Some(path) = &mut replacement.file {
            resolve(path, &format!("fmus.vehicle_at[{}].file", i + 1))?;
        }
    }
    if let Some(heat) = &mut scenario.heat {
        resolve_values(&mut heat.parameters, folder, &check.section("heat.parameters"))?;
    }
    for (i, other) in fmus.vehicle_at.iter_mut().enumerate() {
        let check = check.element("fmus.vehicle_at", i).section("parameters");
        resolve_values(&mut other.parameters, folder, &check)?;
    }
    Ok(())
}

/// The rolling-stock library of a scenario in `folder` that names none.
fn default_stock(folder: &Path) -> PathBuf {
    let near = PathBuf::from("../../stock");
    if folder.join(&near).exists() { near } else { shipped::folder("stock") }
}

/// Makes the paths among the vehicle types files, and types of them that have the files' names.
fn resolve_vehicle_files(
    scenario: &mut Scenario,
    folder: &Path,
    check: &Check,
) -> Result<(), Mistake> {
    let library = scenario.stock.join("vehicles");
    for (i, group) in scenario.train.vehicles.iter_mut().enumerate() {
        let file = PathBuf::from(&group.kind);
        // A name of the library with the ending of its file is a slip, which the check of the types answers.
        let is_slip = library.join(&file).is_file() && !folder.join(&file).is_file();
        if !group.kind.ends_with(".toml") || is_slip {
            continue;
        }
        let key = format!("train.vehicles[{}].type", i + 1);
        group.file = Some(there(folder, &file, &key, check)?);
        group.kind = file.file_stem().unwrap_or_default().display().to_string();
    }
    Ok(())
}

/// The path of a file or folder that a key names, which must be there.
fn there(folder: &Path, path: &Path, key: &str, check: &Check) -> Result<PathBuf, Mistake> {
    let full = plain(&folder.join(path));
    match files::exists(&full) {
        Ok(()) => Ok(full),
        Err(missing) => {
            let (problem, meant) =
                missing.sentence.split_once("; ").unwrap_or((&missing.sentence, ""));
            let meant = if meant.is_empty() { String::new() } else { format!("; {meant}") };
            // The folder that is missing is named already.
            let wanted = match problem.contains("there is no folder") {
                true => problem.to_owned(),
                false => format!("{problem} at {}{meant}", full.display()),
            };
            Err(check.error(key, path.display(), wanted))
        }
    }
}

/// The path without `.`, and without `..` behind a name.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::CurDir => {}
            Component::ParentDir
                if matches!(plain.components().next_back(), Some(Component::Normal(_))) =>
            {
                plain.pop();
            }
            part => plain.push(part),
        }
    }
    plain
}

/// Ending of the names of parameters that are the paths of files.
const FILE: &str = "_file";

/// The parameter that names a file which is written.
const WRITTEN: &str = "field_file";

/// Makes texts that name files into these files; a parameter that is for a file must name one.
fn resolve_values(
    values: &mut BTreeMap<String, Value>,
    folder: &Path,
    check: &Check,
) -> Result<(), Mistake> {
    for (name, value) in values {
        let Value::Text(text) = value else { continue };
        if folder.join(&*text).is_file() {
            *value = Value::File(folder.join(&*text));
        } else if name.ends_with(FILE) && name != WRITTEN && !text.is_empty() {
            there(folder, Path::new(text.as_str()), &quoted(name), check)?;
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use files::Mark;

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

    fn parse(text: &str) -> Result<Scenario, Mistake> {
        read(&Document::new("s.toml", text))
    }

    /// The sentence of a mistake, and what it marks.
    fn message(text: &str) -> (String, Option<String>) {
        let Mistake { sentence, mark, .. } = parse(text).unwrap_err();
        let marked = |Mark { text, column, width, .. }: Mark| {
            text.chars().skip(column - 1).take(width).collect()
        };
        (sentence, mark.map(marked))
    }

    #[test]
    fn a_good_scenario_has_the_defaults_of_the_paper() {
        let scenario = parse(GOOD).unwrap();
        assert_eq!(scenario.step_s, 1e-3);
        assert_eq!(scenario.synchronisation.kp_kn_per_m, 2.0);
        assert_eq!(scenario.synchronisation.kd_kn_s_per_m, 10.0);
        assert_eq!(scenario.vehicle_count(), 2);
    }

    #[test]
    fn a_typo_is_answered_with_its_position_and_the_keys_allowed() {
        let (message, at) = message(&GOOD.replace("duration_s", "duraton_s"));
        assert!(
            message.contains(
                "there is no key `duraton_s`; did you mean `duration_s`? Known here: `title`"
            ),
            "{message}"
        );
        assert_eq!(at.as_deref(), Some("duraton_s"));
    }

    #[test]
    fn a_step_of_zero_is_answered_with_its_position_and_bounds() {
        let (message, at) =
            message(&GOOD.replace("duration_s = 1.0", "duration_s = 1.0\nstep_s = 0.0"));
        assert_eq!(message, "step_s = 0.0: must be at least 0.000001");
        assert_eq!(at.as_deref(), Some("0.0"));
    }

    #[test]
    fn an_index_in_a_key_counts_from_one() {
        let (message, at) = message(&GOOD.replace("count = 2", "count = 0"));
        assert!(
            message.starts_with("train.vehicles[1].count = 0: must be at least 1"),
            "{message}"
        );
        assert_eq!(at.as_deref(), Some("0"));
    }

    #[test]
    fn a_train_alone_heats_no_rail() {
        let text = GOOD.replace("duration_s = 1.0", "duration_s = 1.0\ntrain_alone = true");
        assert!(parse(&text).unwrap().train_alone);
        let (message, at) = message(&format!("{text}\n[heat]\nfield_interval_s = 1.0\n"));
        assert!(message.contains("leave [heat] out"), "{message}");
        assert_eq!(at.as_deref(), Some("true"));
    }

    #[test]
    fn two_fmus_for_one_vehicle_are_refused() {
        let other = "[[fmus.vehicle_at]]\nvehicle = 2\nfile = \"v.fmu\"\n";
        let (message, at) = message(&format!("{GOOD}\n{other}{other}"));
        assert_eq!(
            message,
            "fmus.vehicle_at[2].vehicle = 2: has an FMU already; leave one of them out"
        );
        assert_eq!(at.as_deref(), Some("2"));
    }

    #[test]
    fn an_interval_between_two_steps_is_answered_with_its_position() {
        let (message, at) = message(&format!("{GOOD}\n[record]\ninterval_s = 0.0015\n"));
        assert_eq!(message, "record.interval_s = 0.0015: must be a multiple of step_s = 0.001 s");
        assert_eq!(at.as_deref(), Some("0.0015"));
    }

    #[test]
    fn a_wheel_record_behind_the_tail_is_refused() {
        let (message, at) = message(&format!("{GOOD}\n[record]\nwheels_of = [1, 3]\n"));
        assert!(message.starts_with("record.wheels_of[2] = 3: is behind the tail"), "{message}");
        assert_eq!(at.as_deref(), Some("3"));
        assert!(message.contains("the train has 2 vehicles"), "{message}");
    }

    #[test]
    fn a_file_that_is_not_there_is_answered_with_its_key_and_the_one_that_is_meant() {
        let folder = tempfile::tempdir().unwrap();
        let stock = folder.path().join("stock");
        std::fs::create_dir_all(stock.join("vehicles")).unwrap();
        for file in ["track.toml", "driver.toml", "stock/vehicles/locomotive.toml"] {
            std::fs::write(folder.path().join(file), "").unwrap();
        }
        let file = folder.path().join("scenario.toml");
        let text = GOOD.replace("[train]", "stock = \"stock\"\n[train]");
        std::fs::write(&file, &text).unwrap();
        let (scenario, found, _) = load(folder.path(), &[]).unwrap();
        assert_eq!((scenario.stock, found), (stock, file.clone()));
        std::fs::write(&file, text.replace("track.toml", "trak.toml")).unwrap();
        let message = load(folder.path(), &[]).unwrap_err().to_string();
        assert!(message.contains("scenario.toml:11:8: track.file = \"trak.toml\": "), "{message}");
        assert!(message.contains("there is no such file at "), "{message}");
        assert!(message.contains("; did you mean `track.toml`?"), "{message}");
    }
}
