//! Rules on the files of an FMU and on its binary (§2.3, §2.1.5).

use std::path::Path;

use super::rule::{Finding, Severity};
use super::rules::{FILE, check_description};
use super::terminals;
use crate::files::archive;
use crate::files::xml_text;
use crate::fmi::{self, FmuInstance, Import};
use crate::interface::Interface;

/// An error of a rule that no single element breaks.
fn error(rule: &'static str, location: impl Into<String>, sentence: impl Into<String>) -> Finding {
    let (location, sentence) = (location.into(), sentence.into());
    Finding { rule, severity: Severity::Error, location, sentence }
}

/// Checks an FMU: its archive, its model description and its binary, as far as they can be read.
pub fn check(fmu: &Path) -> Vec<Finding> {
    let name = fmu.file_name().unwrap_or_default().to_string_lossy().into_owned();
    let folder = match tempfile::tempdir() {
        Ok(folder) => folder,
        Err(source) => return vec![error("archive-can-be-unpacked", name, source.to_string())],
    };
    let mut findings = match archive::uncommon_entries(fmu) {
        Ok(entries) => entries.into_iter().map(uncommon).collect(),
        Err(_) => vec![],
    };
    if let Err(source) = archive::unpack(fmu, folder.path()) {
        findings.push(error("archive-can-be-unpacked", name, source.to_string()));
        return findings;
    }
    let text = match xml_text::read(&folder.path().join(FILE)) {
        Ok(text) => text,
        Err(source) => {
            let sentence = format!("the FMU has no readable {FILE}: {source}");
            findings.push(error("description-is-there", name, sentence));
            return findings;
        }
    };
    findings.extend(check_description(&text));
    findings.extend(terminals::check(folder.path(), &text));
    if let Ok(interface) = Interface::from_xml(&text) {
        findings.extend(binary(fmu, folder.path(), &interface));
    }
    findings
}

fn uncommon((entry, method): (String, String)) -> Finding {
    let sentence = format!("the entry is packed by {method}, but FMI 2.0 allows store and deflate");
    error("archive-is-stored-or-deflated", entry, sentence)
}

/// Checks the binary, where there is one for this platform.
fn binary(fmu: &Path, folder: &Path, interface: &Interface) -> Vec<Finding> {
    let path = fmi::binary_path(&interface.identifier);
    let location = path.display().to_string();
    let file = folder.join(&path);
    if !file.exists() {
        return vec![missing_binary(folder, location)];
    }
    match fmi::missing_functions(&file, &fmu.display().to_string()) {
        Err(source) => {
            let sentence = format!("the binary cannot be loaded: {}", fmi::reason(&source));
            vec![error("binary-can-be-loaded", location, sentence)]
        }
        Ok(missing) if !missing.is_empty() => {
            let sentence = format!(
                "the binary lacks {}; all 34 functions must be there, also those that the FMU \
                 does not support",
                missing.join(", ")
            );
            vec![error("functions-are-complete", location, sentence)]
        }
        Ok(_) => instance(fmu, &location),
    }
}

/// The finding for an FMU that has no binary at all, or only sources or binaries of other platforms.
fn missing_binary(folder: &Path, location: String) -> Finding {
    let has = fmi::Binaries::of(folder);
    match has.are_elsewhere() {
        false => error("binary-is-there", location, has.sentence()),
        true => Finding {
            rule: "binary-is-for-this-platform",
            severity: Severity::Advice,
            location,
            sentence: has.sentence(),
        },
    }
}

/// What the binary says, and whether it makes an instance.
fn instance(fmu: &Path, location: &str) -> Vec<Finding> {
    let import = match Import::open(fmu) {
        Ok(import) => import,
        Err(source) => return vec![error("binary-can-be-loaded", location, source.to_string())],
    };
    let mut findings = vec![];
    let (version, platform) = import.version_and_platform();
    if version != "2.0" {
        let sentence = format!("fmi2GetVersion gives \"{version}\", but must give \"2.0\"");
        findings.push(error("binary-is-of-fmi-2.0", location, sentence));
    }
    if platform != "default" {
        let sentence =
            format!("fmi2GetTypesPlatform gives \"{platform}\", but must give \"default\"");
        findings.push(error("binary-is-of-fmi-2.0", location, sentence));
    }
    if let Err(source) = FmuInstance::new(&import, "check") {
        let sentence = format!(
            "fmi2Instantiate makes no instance for the GUID {}{}",
            import.interface().guid,
            source.last_message.map(|text| format!(": {text}")).unwrap_or_default()
        );
        findings.push(error("instance-can-be-made", location, sentence));
    }
    findings
}
