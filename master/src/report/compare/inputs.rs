//! Inputs of two runs that differ: keys of the scenario, files in the FMUs, and the program.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs::File;
use std::io::Read;
use std::path::{Path, PathBuf};

use numerics::seconds;
use serde::Serialize;
use zip::ZipArchive;

use super::error::CompareError;
use super::run::Run;
use crate::files::file_error::FileError;
use crate::ssp::STRUCTURE_FILE;

/// A value of an input that differs.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Serialize)]
pub struct InputDifference {
    /// The file in which it stands.
    pub file: String,
    /// Its key; empty where the file differs as a whole.
    pub key: String,
    /// The value in the first run; none where it is left out.
    pub first: Option<String>,
    /// The value in the other run.
    pub other: Option<String>,
}

impl fmt::Display for InputDifference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, key, first, other } = self;
        let text = |value: &Option<String>| value.clone().unwrap_or_else(|| "left out".to_owned());
        match (first, other) {
            (None, None) => write!(f, "{file} differs"),
            _ => write!(f, "{file}: {key}: {} → {}", text(first), text(other)),
        }
    }
}

/// The inputs of two runs that differ, each once.
pub(super) fn differences(first: &Run, other: &Run) -> Result<Vec<InputDifference>, CompareError> {
    let mut all = of_toml("scenario.toml", &first.provenance.scenario, &other.provenance.scenario);
    let step = |run: &Run| run.step.map(|step| format!("{} s", seconds(step)));
    let simulated = |run: &Run| Some(format!("{} s", seconds(run.provenance.simulated_s)));
    all.extend(value("run", "step of the exchange", step(first), step(other)));
    all.extend(value("run", "simulated time", simulated(first), simulated(other)));
    let version = |run: &Run| Some(run.about.version.clone());
    all.extend(value("hotfoot", "version", version(first), version(other)));
    let structures = [first, other].map(|run| run.folder.join("package").join(STRUCTURE_FILE));
    if let [Ok(a), Ok(b)] = structures.map(std::fs::read)
        && a != b
    {
        all.push(whole(STRUCTURE_FILE));
    }
    let others: BTreeMap<String, &str> = digests(other);
    for (name, digest) in digests(first) {
        match others.get(&name) {
            Some(same) if *same == digest => {}
            Some(_) => all.extend(in_fmu(&name, &file(first, &name), &file(other, &name))?),
            None => all.extend(value("FMUs", &name, Some("takes part".to_owned()), None)),
        }
    }
    let own = digests(first);
    for name in others.keys().filter(|name| !own.contains_key(*name)) {
        all.extend(value("FMUs", name, None, Some("takes part".to_owned())));
    }
    // Each FMU carries the files that it needs, so that one file is in several.
    Ok(all.into_iter().collect::<BTreeSet<_>>().into_iter().collect())
}

/// The FMUs of a run by the names of their files, with their digests.
fn digests(run: &Run) -> BTreeMap<String, &str> {
    let fmus = run.provenance.fmu.iter();
    fmus.map(|fmu| (file_name(&fmu.file), fmu.sha256.as_str())).collect()
}

/// The file of an FMU: in the folder of the results, else where it was.
fn file(run: &Run, name: &str) -> PathBuf {
    let mut fmus = run.provenance.fmu.iter();
    let written = fmus.find(|fmu| file_name(&fmu.file) == name).map(|fmu| PathBuf::from(&fmu.file));
    let packed = run.folder.join("fmus").join(name);
    if packed.exists() { packed } else { written.unwrap_or(packed) }
}

fn file_name(path: &str) -> String {
    Path::new(path).file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// What differs in an FMU of that name; the whole where one of the files is gone.
fn in_fmu(name: &str, first: &Path, other: &Path) -> Result<Vec<InputDifference>, CompareError> {
    let (Some(a), Some(b)) = (resources(first)?, resources(other)?) else {
        return Ok(vec![whole(name)]);
    };
    let names: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let mut found = vec![];
    for file in names {
        match (a.get(file), b.get(file)) {
            (Some(a), Some(b)) if a == b => {}
            (Some(a), Some(b)) => found.extend(of_file(file, a, b)),
            (a, _) => {
                let there = |is: bool| is.then(|| "is there".to_owned());
                found.extend(value(file, "", there(a.is_some()), there(a.is_none())));
            }
        }
    }
    if found.is_empty() {
        found.push(whole(name));
    }
    Ok(found)
}

/// The files in the resources of an FMU with their contents; none where there is no such FMU any more.
fn resources(fmu: &Path) -> Result<Option<BTreeMap<String, Vec<u8>>>, CompareError> {
    let Ok(file) = File::open(fmu) else { return Ok(None) };
    let failed = |source: std::io::Error| CompareError::File(FileError::at(fmu)(source));
    let mut archive = ZipArchive::new(file).map_err(|error| failed(error.into()))?;
    let mut files = BTreeMap::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index(index).map_err(|error| failed(error.into()))?;
        let name = entry.name().map_err(|error| failed(error.into()))?.into_owned();
        let Some(name) = name.strip_prefix("resources/").map(str::to_owned) else { continue };
        let mut content = vec![];
        entry.read_to_end(&mut content).map_err(failed)?;
        files.insert(name, content);
    }
    Ok(Some(files))
}

/// What differs in a file of two contents.
fn of_file(name: &str, first: &[u8], other: &[u8]) -> Vec<InputDifference> {
    let texts = [first, other].map(|content| String::from_utf8_lossy(content).into_owned());
    let keys = match name.ends_with(".toml") {
        true => of_toml(name, &texts[0], &texts[1]),
        false => vec![],
    };
    if keys.is_empty() { vec![whole(name)] } else { keys }
}

/// The keys of two TOML texts that differ; comments and order do not count.
fn of_toml(file: &str, first: &str, other: &str) -> Vec<InputDifference> {
    let keys = |text: &str| {
        let mut keys = BTreeMap::new();
        if let Ok(table) = text.parse::<toml::Table>() {
            flatten(&toml::Value::Table(table), "", &mut keys);
        }
        keys
    };
    let (a, b) = (keys(first), keys(other));
    let names: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let differ = |key: &String| value(file, key, a.get(key).cloned(), b.get(key).cloned());
    names.into_iter().flat_map(differ).collect()
}

/// The values of a TOML text by their keys, as in messages: `train.vehicles[2].count`.
fn flatten(value: &toml::Value, key: &str, keys: &mut BTreeMap<String, String>) {
    match value {
        toml::Value::Table(table) => {
            for (name, value) in table {
                let plain = name.chars().all(|c| c.is_alphanumeric() || "_-".contains(c));
                let name = if plain { name.clone() } else { format!("\"{name}\"") };
                let dot = if key.is_empty() { "" } else { "." };
                flatten(value, &format!("{key}{dot}{name}"), keys);
            }
        }
        toml::Value::Array(list) if list.iter().any(toml::Value::is_table) => {
            for (index, value) in list.iter().enumerate() {
                flatten(value, &format!("{key}[{}]", index + 1), keys);
            }
        }
        value => drop(keys.insert(key.to_owned(), value.to_string())),
    }
}

fn whole(file: &str) -> InputDifference {
    InputDifference { file: file.to_owned(), key: String::new(), first: None, other: None }
}

/// A value, if it differs.
fn value(
    file: &str,
    key: &str,
    first: Option<String>,
    other: Option<String>,
) -> Option<InputDifference> {
    let (file, key) = (file.to_owned(), key.to_owned());
    (first != other).then_some(InputDifference { file, key, first, other })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_are_told_as_people_write_them_and_comments_do_not_count() {
        let first = "# one\na = 1\n[[train.vehicles]]\ncount = 1\n[[train.vehicles]]\ncount = 4\n[heat]\n\"wind.speed\" = 2.0\n";
        let other = "a = 1 # two\n[[train.vehicles]]\ncount = 1\n[[train.vehicles]]\ncount = 9\n";
        let found = of_toml("scenario.toml", first, other);
        let shown: Vec<_> = found
            .iter()
            .map(|d| (d.key.as_str(), d.first.as_deref(), d.other.as_deref()))
            .collect();
        let expected = [
            ("heat.\"wind.speed\"", Some("2.0"), None),
            ("train.vehicles[2].count", Some("4"), Some("9")),
        ];
        assert_eq!(shown, expected);
    }
}
