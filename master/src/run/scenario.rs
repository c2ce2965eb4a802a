//! The run of a scenario.

use std::path::Path;

use track::{TrackFile, TrackPoint};

use super::after::Rails;
use super::checkpoint::tape_file;
use super::error::RunError;
use super::expected::limits;
use super::manifest::Manifest;
use super::setup::{Setup, Subject};
use crate::report::{RailFacts, RunFacts, TrackFacts};
use crate::scenario::{Heat, Scenario};
use crate::system::substitute::Substitutes;
use crate::train::error::PrepareError;
use crate::train::fmus::Folders;
use crate::train::layout::{Layout, RailHolder};
use crate::train::locomotives::locomotives;
use crate::train::rails::field_file;
use crate::train::structure::{TrainSystem, of_scenario};
use crate::train::tape::Tape;
use crate::train::traffic::Traffic;

/// The system of a scenario in `file`, with its vehicles where the train has them at the start.
///
/// # Errors
/// When an FMU is missing or unfit, or the train cannot be initialised.
pub fn placed(
    scenario: &Scenario,
    file: &Path,
    folders: &Folders,
) -> Result<TrainSystem, RunError> {
    let mut train = of_scenario(scenario, folders).map_err(RunError::prepare(file))?;
    let probe = train.probe().map_err(RunError::prepare(file))?;
    train.set_vehicle_starts(probe)?;
    Ok(train)
}

/// Sets a scenario up, whose file and text these are, to be run with so many threads.
///
/// # Errors
/// When an FMU is missing or unfit, or a unit refuses.
pub fn setup(
    scenario: Scenario,
    (file, text): (&Path, String),
    folders: &Folders,
    threads: usize,
    substitutes: &mut Substitutes,
) -> Result<Setup, RunError> {
    let at_key = |error: RunError| error.at_key(&scenario);
    let train = placed(&scenario, file, folders).map_err(at_key)?;
    let system = train.system(substitutes);
    let system = system.map_err(RunError::prepare(file)).map_err(at_key)?;
    let TrainSystem { structure, layout, .. } = train;
    let steps = (scenario.duration_s / scenario.step_s).round() as u64;
    let traffic = scenario.heat.as_ref().map(Traffic::of).unwrap_or_default();
    let folder = &folders.results;
    let tape = |number| {
        let error = |source| PrepareError::Tape { folder: folder.display().to_string(), source };
        let tape = match scenario.record.checkpoint_s {
            Some(_) => Tape::in_file(&tape_file(folder, number)),
            None => Tape::new(folder),
        };
        tape.map_err(error)
    };
    let rails = Rails::new(&layout, &system, traffic, tape).map_err(RunError::prepare(file))?;
    let heat = scenario.heat.as_ref();
    let of_rails = heat.map(|heat| RailFacts {
        last_train_end_s: traffic.last_train_end(rails.time(&system, steps)),
        ..rail_facts(heat, &layout)
    });
    let mut manifest = Manifest::new(&system);
    manifest.warnings = structure.notes;
    manifest.scenario = Some(text);
    manifest.run = Some(RunFacts {
        title: scenario.title.clone(),
        train_alone: scenario.train_alone,
        vehicles: scenario.vehicle_count(),
        locomotives: locomotives(&scenario),
        plotted: scenario.recorded_vehicles(),
        outputs: scenario.record.outputs.clone(),
        rails: of_rails,
        heat_maps_at_s: scenario.record.heat_maps_at_s.clone(),
        track: track_facts(&scenario.track.file),
        limits: limits(file),
        step_s: scenario.step_s,
        threads,
        ..RunFacts::default()
    });
    let (stages, stop) = (structure.stages, scenario.duration_s);
    let subject = Subject::Train(Box::new(scenario), layout);
    Ok(Setup { system, stages, steps, stop, subject, rails, manifest, recorded: false })
}

/// What the scenario says of the heated rails.
fn rail_facts(heat: &Heat, layout: &Layout) -> RailFacts {
    RailFacts {
        sides: layout.rails.iter().map(RailHolder::side_name).map(str::to_owned).collect(),
        fields: layout.rails.iter().map(|rail| field_file(heat, rail.side)).collect(),
        trains: heat.trains.count,
        ..RailFacts::default()
    }
}

/// Points of the track that the report shows, at most.
const MOST_POINTS: usize = 400;

/// The track for the report; one that cannot be read has no points here, since the units that need
/// it have already said so.
fn track_facts(track: &Path) -> TrackFacts {
    let Ok(file) = TrackFile::read(track) else { return TrackFacts::default() };
    let profile = file.track().map(|track| track.profile(MOST_POINTS)).unwrap_or_default();
    let column = |pick: fn(&TrackPoint) -> f64| profile.iter().map(|(_, at)| pick(at)).collect();
    TrackFacts {
        chainage_m: profile.iter().map(|(chainage, _)| *chainage).collect(),
        curvature_per_m: column(|at| at.curvature),
        cant_angle_rad: column(|at| at.cant_angle),
        gradient: column(|at| at.gradient),
        speed_limit: file.speed_limits().to_vec(),
    }
}
