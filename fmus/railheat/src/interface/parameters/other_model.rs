//! A parameter that has no effect in the chosen model is refused.
//!
//! It is known by a value that differs from its start value; one that is set to its start value
//! cannot be told from one that is not set. `detection.threshold` and `rail.lateral_position`
//! are not refused in `model = "paper"`: they say what a camera can see and which rail this is, and
//! a master sets them without knowing the model. Both section models have the same parameters.

use fmu::ModelError;

use super::common::{Common, ModelChoice};
use super::energy::EnergyParameters;
use super::site::SiteParameters;

/// All parameters of an instance.
#[derive(PartialEq)]
pub(crate) struct AllParameters {
    pub common: Common,
    pub energy: EnergyParameters,
    pub site: SiteParameters,
}

/// Nothing in the chosen model has the effect.
const NOTHING: &str = "";

/// Names, whether they differ from the start and what has the effect in the chosen model.
macro_rules! changed {
    ($now:expr, $start:expr; $($($field:ident).+: $name:literal, $instead:expr;)+) => {
        [$(($name, $now.$($field).+ != $start.$($field).+, $instead)),+]
    };
}

/// Refuses what differs from the start and has no effect in the chosen model.
pub(crate) fn check(now: &AllParameters, start: &AllParameters) -> Result<(), ModelError> {
    let (chosen, other, without_effect) = match now.common.model {
        ModelChoice::Paper => ("paper", "energy", of_energy(now, start)),
        ModelChoice::Energy => ("energy", "paper", of_paper(now, start)),
    };
    let Some((name, _, instead)) = without_effect.into_iter().find(|(_, changed, _)| *changed)
    else {
        return Ok(());
    };
    let remedy = match instead {
        NOTHING => "leave it at its start value".to_owned(),
        instead => format!("{instead} has the effect"),
    };
    Err(ModelError::new(format!(
        "{name} is a parameter of model = \"{other}\" and does nothing with model = \"{chosen}\": {remedy}"
    )))
}

type Change = (&'static str, bool, &'static str);

/// What only the paper's model has.
fn of_paper(now: &AllParameters, start: &AllParameters) -> Vec<Change> {
    changed! { now.common, start.common;
        column.height: "rail.height", "section.rail";
        column.width: "rail.width", "section.rail";
        column.cell_size: "cell.size", "section.cell_size";
        column.interval: "conduction.interval", "section.interval";
        friction: "friction.coefficient", "the input friction_power of each wheel";
    }
    .to_vec()
}

/// What only the energy model has.
fn of_energy(now: &AllParameters, start: &AllParameters) -> Vec<Change> {
    let of_section = changed! { now.energy, start.energy;
        rail: "section.rail", "rail.height";
        section_model: "section.model", NOTHING;
        along: "section.along", NOTHING;
        cold_sky: "sky.cold", NOTHING;
        cell_size: "section.cell_size", "cell.size";
        shortest: "section.shortest_time", NOTHING;
        interval: "section.interval", "conduction.interval";
        pad: "foot.conductance", NOTHING;
        wind_share: "train.wind_share", NOTHING;
        overhang: "train.overhang", NOTHING;
        wheel_capacity: "wheel.heat_capacity", NOTHING;
        wheel_cooling: "wheel.cooling", NOTHING;
        wheel_rise: "wheel.initial_rise", NOTHING;
        contact_quality: "wheel.contact_quality", NOTHING;
        modulus: "rail.modulus", NOTHING;
        track_modulus: "track.modulus", NOTHING;
        expansion: "rail.expansion", NOTHING;
        loss_factor: "rail.loss_factor", NOTHING;
    };
    let of_site = changed! { now.site, start.site;
        date_time: "site.date_time", NOTHING;
        track_file: "track_file", NOTHING;
        day: "initial.day", "initial.equilibrium";
        shade: "train.shade", NOTHING;
        azimuth: "track.azimuth", NOTHING;
        latitude: "site.latitude", NOTHING;
        longitude: "site.longitude", NOTHING;
        half_width: "train.half_width", NOTHING;
        floor: "train.floor_height", NOTHING;
        roof: "train.roof_height", NOTHING;
    };
    [&of_section[..], &of_site[..]].concat()
}
