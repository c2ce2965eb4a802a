//! `manifest.toml`: what made the results of a run.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::{Duration, SystemTime};

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::begun::{command, utc};
use super::chosen_outputs::ChosenOutputs;
use super::folder::contents::MANIFEST;
use super::output_table::table_name;
use crate::files::file_error::{FileError, read_toml, write_whole};
use crate::report::{ComponentFacts, MainFigure, RunFacts, SystemFacts, UnitFacts};
use crate::system::part::Part;
use crate::system::step::System;

/// What made the results of a run: of a scenario's train, or of any other system.
#[derive(Debug, Serialize, Deserialize)]
pub struct Manifest {
    #[serde(flatten)]
    origin: Origin,
    /// Simulated time reached, s; 0 while the run has not ended.
    simulated_s: f64,
    /// How the run has ended; left out while it goes on.
    #[serde(flatten)]
    ended: Option<Ended>,
    /// Text of the scenario.
    pub scenario: Option<String>,
    /// What the report shows of a train's run.
    pub run: Option<RunFacts>,
    /// What the report shows of another system's run.
    pub system: Option<SystemFacts>,
    /// What the units warned of, and what else the user should know.
    #[serde(skip)]
    pub warnings: Vec<String>,
    #[serde(default)]
    wall_time_of: Vec<WallTime>,
    #[serde(default)]
    fmu: Vec<FmuEntry>,
    /// The units.
    #[serde(default)]
    unit: Vec<UnitFacts>,
    /// The main figures of the report, for programs.
    #[serde(default)]
    pub figure: Vec<MainFigure>,
}

/// The program and the machine.
#[derive(Debug, Serialize, Deserialize)]
pub struct Origin {
    hotfoot_version: String,
    git_commit: String,
    machine: String,
    /// When the program began with it, UTC.
    #[serde(default)]
    begun: String,
    /// The command as it was given.
    #[serde(default)]
    command: String,
}

impl Origin {
    /// This program on this machine.
    pub fn new() -> Self {
        let cores = std::thread::available_parallelism().map_or(0, usize::from);
        Self {
            hotfoot_version: env!("CARGO_PKG_VERSION").to_owned(),
            git_commit: env!("HOTFOOT_GIT_COMMIT").to_owned(),
            machine: format!("{} {}, {cores} cores", std::env::consts::OS, std::env::consts::ARCH),
            begun: utc(SystemTime::now()),
            command: command(std::env::args()),
        }
    }
}

/// How a run has ended.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Ended {
    /// In which way.
    pub end: End,
    /// Why, in a sentence, where it did not come to its end.
    pub end_reason: Option<String>,
}

/// In which way a run has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum End {
    /// It has come to its end.
    Complete,
    /// It was stopped by its user or by the system.
    Interrupted,
    /// An FMU, a file or something else has failed.
    Failed,
    /// Its program was killed, and could do nothing more.
    Killed,
}

impl Ended {
    /// An end with a reason.
    pub fn because(end: End, reason: impl Into<String>) -> Self {
        Self { end, end_reason: Some(reason.into()) }
    }
}

/// Wall time of a part of all steps.
#[derive(Debug, Serialize, Deserialize)]
struct WallTime {
    part: String,
    seconds: f64,
}

/// An FMU that took part.
#[derive(Debug, Serialize, Deserialize)]
pub struct FmuEntry {
    file: String,
    sha256: String,
    guid: String,
}

impl Manifest {
    /// A manifest of a system whose run begins.
    pub fn new(system: &System) -> Self {
        Self {
            origin: Origin::new(),
            simulated_s: 0.0,
            ended: None,
            scenario: None,
            run: None,
            system: None,
            warnings: vec![],
            wall_time_of: vec![],
            fmu: fmus(system),
            unit: vec![],
            figure: vec![],
        }
    }

    /// Adds what is known at the end: the wall time, and where it went; `stages` are the names of the
    /// stages.
    pub fn finish(&mut self, system: &System, stages: &[String]) {
        let times = &system.times;
        let wall = times.run;
        if let Some(run) = &mut self.run {
            run.wall_time_s = Some(wall.as_secs_f64());
        }
        self.unit = unit_facts(system);
        if let Some(facts) = &mut self.system {
            facts.wall_time_s = Some(wall.as_secs_f64());
            facts.recording_s = times.recording.as_secs_f64();
            for (component, part) in facts.component.iter_mut().zip(&system.parts) {
                component.wall_time_s = part.wall.as_secs_f64();
            }
        }
        let of_stages = stages.iter().cloned().zip(times.stages.iter().copied());
        let others = [
            ("exchange", times.exchange),
            ("recording", times.recording),
            ("rails after the run", times.after),
            ("checkpoints", times.checkpoints),
        ];
        let others = others.map(|(part, time)| (part.to_owned(), time));
        let wall_time =
            |(part, time): (String, Duration)| WallTime { part, seconds: time.as_secs_f64() };
        self.wall_time_of = of_stages.chain(others).map(wall_time).collect();
    }

    /// The FMUs by their files, with their digests.
    pub fn digests(&self) -> Vec<(String, String)> {
        self.fmu.iter().map(|fmu| (fmu.file.clone(), fmu.sha256.clone())).collect()
    }

    /// Writes the manifest into the results folder.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, results: &Path) -> Result<(), FileError> {
        let path = results.join(MANIFEST);
        let text = toml::to_string(self).expect("a manifest is a TOML table");
        write_whole(&path, &text)
    }

    /// Reads the manifest of a results folder.
    ///
    /// # Errors
    /// When the file cannot be read, or is not what a run writes.
    pub fn read(results: &Path) -> Result<Self, FileError> {
        read_toml(&results.join(MANIFEST))
    }

    /// Whether it says how the run has ended.
    pub fn has_ended(&self) -> bool {
        self.ended.is_some()
    }

    /// Adds how the run has ended, and after which simulated time, s.
    pub fn end(&mut self, simulated: f64, ended: Ended) {
        self.simulated_s = simulated;
        if let Some(system) = &mut self.system {
            system.simulated_s = simulated;
        }
        if let (Some(run), Some(reason)) = (&mut self.run, &ended.end_reason) {
            run.warnings.push(reason.clone());
        }
        self.ended = Some(ended);
    }
}

/// What the run knows of each unit.
fn unit_facts(system: &System) -> Vec<UnitFacts> {
    let facts = |part: &Part| UnitFacts {
        name: part.unit.name().to_owned(),
        fmu: file_name(part.unit.source_file()),
        wall_time_s: part.wall.as_secs_f64(),
        slowest_step_s: part.slowest.wall.as_secs_f64(),
        slowest_at_s: part.slowest.end,
        last_message: part.last_message.clone(),
    };
    system.parts.iter().map(facts).collect()
}

fn file_name(path: &str) -> String {
    Path::new(path).file_name().unwrap_or_default().to_string_lossy().into_owned()
}

/// What the run knows of each component, of which these outputs are recorded.
pub fn component_facts(system: &System, chosen: &ChosenOutputs) -> Vec<ComponentFacts> {
    let facts = |part: &Part| ComponentFacts {
        name: part.unit.name().to_owned(),
        fmu: file_name(part.unit.source_file()),
        series: table_name(part.unit.as_ref(), chosen),
        wall_time_s: part.wall.as_secs_f64(),
    };
    system.parts.iter().map(facts).collect()
}

/// The FMUs that the units of a run are instances of; a unit of the program itself is none.
fn fmus(system: &System) -> Vec<FmuEntry> {
    let units = system.units().filter(|unit| !unit.interface().guid.is_empty());
    let guids: BTreeMap<_, _> =
        units.map(|unit| (unit.source_file(), &unit.interface().guid)).collect();
    let entry = |(file, guid): (&str, &String)| {
        let sha256 = sha256(&std::fs::read(file).ok()?);
        Some(FmuEntry { file: file.to_owned(), sha256, guid: guid.clone() })
    };
    guids.into_iter().filter_map(entry).collect()
}

/// The digest of a file's content as hexadecimal digits.
pub fn sha256(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}
