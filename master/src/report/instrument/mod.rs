//! What the linked view of the page shows: the run as numbers, decimated so that a page stays small.
//!
//! | file | part |
//! |---|---|
//! | `packed.rs` | numbers as text that a page can hold |
//! | `decimate.rs` | which records are shown, and what lies between them |
//! | `quantities.rs` | quantities over time, with unit and label |
//! | `train.rs` | the train, its vehicles and its driver |
//! | `couplings.rs` | power that is lost or made where train and vehicle are coupled |
//! | `wheels.rs` | the recorded wheels |
//! | `outputs.rs` | further outputs of the recorded vehicles |
//! | `rail.rs` | temperature field and foot of a rail |
//! | `sections.rs` | the whole section of a rail where its foot is warmest, and at its probes |
//!
//! Everything is in SI units; the page chooses the units that people read.

mod couplings;
mod decimate;
mod outputs;
mod packed;
mod quantities;
mod rail;
mod sections;
mod train;
mod wheels;

#[cfg(test)]
mod tests;

use std::path::Path;

use serde::Serialize;
use track::SpeedLimit;

use super::data::RailData;
use super::error::ReportError;
use super::facts::TrackFacts;
use super::results::Results;
pub(super) use couplings::Residual;
pub(super) use packed::Packed;
#[cfg(test)]
pub(super) use train::OF_TRAIN;

/// All numbers of the linked view.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Instrument {
    /// Number of vehicles.
    vehicles: usize,
    /// Numbers of those with traction, from 1.
    locomotives: Vec<usize>,
    /// Whether there are no vehicles in three dimensions.
    train_alone: bool,
    /// Rise of the foot that a camera can see, K; none without a heated rail.
    threshold: Option<f64>,
    /// Times at which the scenario asks for the field, s.
    wanted_times: Vec<f64>,
    /// The track.
    track: Track,
    /// Train, driver and vehicles.
    train: train::Train,
    /// The recorded wheels.
    wheels: wheels::Wheels,
    /// Further outputs of the recorded vehicles.
    outputs: outputs::Outputs,
    /// Speed limits of the track.
    speed_limits: Vec<SpeedLimit>,
    /// Root mean square of the speed less that of a logger, m/s; none without a logger.
    speed_rms: Option<f64>,
    /// The heated rails.
    rails: Vec<rail::Rail>,
    /// Powers that are lost at the couplings of train and vehicles.
    #[serde(skip)]
    pub residual: Option<Residual>,
    /// Where sections are, for rails that have none where their foot is warmest.
    #[serde(skip)]
    pub sections_elsewhere: Vec<String>,
    /// Fields that cannot be read, each in a sentence.
    #[serde(skip)]
    pub unread: Vec<String>,
}

/// The track by points, between which it is linear.
#[derive(Debug, Clone, Serialize)]
struct Track {
    chainage: Packed,
    curvature: Packed,
    cant_angle: Packed,
    gradient: Packed,
}

impl Instrument {
    /// Reads the numbers from the results in `folder`; what the report says of the rails is known.
    ///
    /// # Errors
    /// When a series cannot be read.
    pub fn of(folder: &Path, results: &Results, rails: &[RailData]) -> Result<Self, ReportError> {
        let facts = &results.facts;
        let (train, residual) = train::Train::of(results)?;
        let (mut of_rails, mut unread, mut sections_elsewhere) = (vec![], vec![], vec![]);
        if let Some(rail_facts) = &facts.rails {
            for (rail, store) in rails.iter().zip(&rail_facts.fields) {
                let store = folder.join(store);
                let warmest = sections::warmest_foot(rail).and_then(|figure| figure.time_s);
                let wanted: Vec<f64> =
                    facts.heat_maps_at_s.iter().copied().chain(warmest).collect();
                // A field that was damaged, as by a full disk, must not cost the rest of the report.
                let field = match store.is_dir() {
                    true => rail::Field::read(&store, &wanted, rails.len()),
                    false => Ok(None),
                };
                let field = field.unwrap_or_else(|error| {
                    unread.push(format!("{error}; the report goes without it"));
                    None
                });
                let has_warmest = |field: &rail::Field| {
                    field.sections.as_ref().is_some_and(sections::Sections::has_warmest)
                };
                if let Some(field) = field.as_ref().filter(|field| !has_warmest(field)) {
                    let elsewhere = sections::elsewhere(rail, &field.probes, field.element_length);
                    sections_elsewhere.extend(elsewhere);
                }
                of_rails.push(rail::Rail::of(rail, field));
            }
        }
        Ok(Self {
            vehicles: facts.vehicles,
            locomotives: facts.locomotives.clone(),
            train_alone: facts.train_alone,
            threshold: facts.rails.as_ref().map(|rails| rails.detection_threshold_k),
            wanted_times: facts.heat_maps_at_s.clone(),
            track: Track::of(&facts.track),
            wheels: wheels::Wheels::of(folder, facts)?,
            outputs: outputs::Outputs::of(results.outputs.as_ref())?,
            speed_limits: facts.track.speed_limit.clone(),
            speed_rms: results.speed_rms()?,
            train,
            rails: of_rails,
            residual,
            sections_elsewhere,
            unread,
        })
    }

    /// The numbers as JSON that can stand in a page: no `<` ends the element that holds it.
    pub fn json(&self) -> String {
        let json = serde_json::to_string(self).expect("numbers and texts are JSON");
        json.replace('<', "\\u003c")
    }
}

impl Track {
    fn of(facts: &TrackFacts) -> Self {
        let packed = |values: &[f64]| Packed::of(values.iter().copied());
        Self {
            chainage: packed(&facts.chainage_m),
            curvature: packed(&facts.curvature_per_m),
            cant_angle: packed(&facts.cant_angle_rad),
            gradient: packed(&facts.gradient),
        }
    }
}
