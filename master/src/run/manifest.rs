//! `manifest.toml`: what made the results of a run.

use std::collections::BTreeMap;
use std::path::Path;
use std::time::Duration;

use serde::Serialize;
use sha2::{Digest, Sha256};

use crate::files::file_error::FileError;
use crate::report::{MainFigure, RailFacts, RunFacts};
use crate::scenario::{Heat, Scenario};
use crate::system::times::StepTimes;
use crate::system::unit::Unit;
use crate::train::lockstep::Lockstep;
use crate::train::prepare_rail::{Extent, field_file};
use crate::train::traffic::Traffic;

/// What made the results of a run.
#[derive(Debug, Serialize)]
pub struct Manifest {
    #[serde(flatten)]
    origin: Origin,
    /// Simulated time reached, s; 0 while the run has not ended.
    simulated_s: f64,
    scenario: String,
    /// What the report shows of the run.
    pub run: RunFacts,
    wall_time_of: Vec<WallTime>,
    fmu: Vec<FmuEntry>,
    /// The main figures of the report, for programs.
    pub figure: Vec<MainFigure>,
}

/// The program and the machine.
#[derive(Debug, Serialize)]
pub struct Origin {
    hotfoot_version: &'static str,
    git_commit: &'static str,
    machine: String,
}

impl Origin {
    /// This program on this machine.
    pub fn new() -> Self {
        let cores = std::thread::available_parallelism().map_or(0, usize::from);
        Self {
            hotfoot_version: env!("CARGO_PKG_VERSION"),
            git_commit: env!("HOTFOOT_GIT_COMMIT"),
            machine: format!("{} {}, {cores} cores", std::env::consts::OS, std::env::consts::ARCH),
        }
    }
}

/// Wall time of a part of all steps.
#[derive(Debug, Serialize)]
struct WallTime {
    part: &'static str,
    seconds: f64,
}

/// An FMU that took part.
#[derive(Debug, Serialize)]
pub struct FmuEntry {
    file: String,
    sha256: String,
    guid: String,
}

impl Manifest {
    /// A manifest of a run that begins.
    pub fn new(scenario: &Scenario, text: String, threads: usize, lockstep: &Lockstep) -> Self {
        let run = RunFacts {
            title: scenario.title.clone(),
            train_alone: scenario.train_alone,
            vehicles: scenario.vehicle_count(),
            plotted: scenario.recorded_vehicles(),
            outputs: scenario.record.outputs.clone(),
            rails: scenario.heat.as_ref().map(|heat| rail_facts(scenario, heat, lockstep)),
            heat_maps_at_s: scenario.record.heat_maps_at_s.clone(),
            curves_m: curves(&scenario.track.file),
            step_s: scenario.step_s,
            threads,
            ..RunFacts::default()
        };
        Self {
            origin: Origin::new(),
            simulated_s: 0.0,
            scenario: text,
            run,
            wall_time_of: vec![],
            fmu: fmus(lockstep.units()),
            figure: vec![],
        }
    }

    /// Adds what is known at the end.
    pub fn finish(&mut self, simulated: f64, wall: Duration, times: &StepTimes) {
        self.simulated_s = simulated;
        self.run.wall_time_s = Some(wall.as_secs_f64());
        let parts = [
            ("train", times.train),
            ("vehicles", times.vehicles),
            ("rail", times.rail),
            ("exchange", times.exchange),
            ("recording", times.recording),
            ("rails after the run", times.rails_after),
        ];
        self.wall_time_of =
            parts.map(|(part, time)| WallTime { part, seconds: time.as_secs_f64() }).into();
    }

    /// Writes the manifest into the results folder.
    ///
    /// # Errors
    /// When the file cannot be written.
    pub fn write(&self, results: &Path) -> Result<(), FileError> {
        write_toml(self, results)
    }
}

/// What the run knows of the heated rails.
fn rail_facts(scenario: &Scenario, heat: &Heat, lockstep: &Lockstep) -> RailFacts {
    let run = (scenario.duration_s / scenario.step_s).round() as u64;
    RailFacts {
        sides: lockstep.rails.iter().map(|rail| rail.side_name().to_owned()).collect(),
        fields: lockstep.rails.iter().map(|rail| field_file(heat, rail.side)).collect(),
        model: heat.model.clone(),
        length_m: Extent::of(scenario, heat).length,
        detection_threshold_k: 1e-3 * heat.detection_threshold_mk,
        trains: heat.trains.count,
        last_train_end_s: Traffic::of(heat).last_train_end(lockstep.rails_time(run)),
    }
}

/// Writes a manifest into the results folder.
///
/// # Errors
/// When the file cannot be written.
pub fn write_toml(manifest: &impl Serialize, results: &Path) -> Result<(), FileError> {
    let path = results.join("manifest.toml");
    let text = toml::to_string(manifest).expect("a manifest is a TOML table");
    std::fs::write(&path, text).map_err(FileError::at(&path))
}

/// The curves of the track, for the figures; a track that cannot be read has none here, since
/// the units that need it have already said so.
fn curves(track: &Path) -> Vec<[f64; 2]> {
    track::Track::from_file(track).map(|track| track.curves()).unwrap_or_default()
}

/// The FMUs that the units of a run are instances of.
pub fn fmus<'u>(units: impl Iterator<Item = &'u dyn Unit>) -> Vec<FmuEntry> {
    let guids: BTreeMap<_, _> =
        units.map(|unit| (unit.source_file(), &unit.interface().guid)).collect();
    let entry = |(file, guid): (&str, &String)| {
        let sha256 = sha256(&std::fs::read(file).ok()?);
        Some(FmuEntry { file: file.to_owned(), sha256, guid: guid.clone() })
    };
    guids.into_iter().filter_map(entry).collect()
}

/// The digest of a file's content as hexadecimal digits.
fn sha256(content: &[u8]) -> String {
    Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect()
}
