//! Figures of a draft gear.

use files::Mistake;
use stock::{Characteristic, Library};

use super::entry::{Entry, Figure, Kind};

/// The entry of a draft gear.
pub(super) fn entry(library: &Library, name: &str) -> Result<Entry, Mistake> {
    let gear = library.draft_gear(name)?;
    let mut figures = figures(&gear.draft);
    if gear.buff != gear.draft {
        figures.push(Figure::number("travel in buff", gear.buff.loading.travel_mm(), "mm", 1));
        let force = force(&gear.buff);
        figures.push(Figure::number("force at the travel in buff", force, "kN", 0));
    }
    Ok(Entry {
        kind: Kind::DraftGear,
        name: name.to_owned(),
        title: gear.name,
        file: Some(library.draft_gear_path(name).display().to_string()),
        source: gear.source.trim().to_owned(),
        figures,
    })
}

/// Force at the end of the loading curve, kN.
fn force(gear: &Characteristic) -> f64 {
    gear.loading.force_at_kn(gear.loading.travel_mm())
}

fn figures(gear: &Characteristic) -> Vec<Figure> {
    let travel = gear.loading.travel_mm();
    let taken = gear.loading.energy_to_kj(travel);
    let kept = 100.0 * (1.0 - gear.unloading.energy_to_kj(travel) / taken);
    vec![
        Figure::number("travel", travel, "mm", 1).main(),
        Figure::number("force at the travel", force(gear), "kN", 0).main(),
        Figure::number("preload", gear.loading.force_at_kn(0.0), "kN", 0),
        Figure::number("energy taken up to the travel", taken, "kJ", 1).main(),
        Figure::number("share of the energy that is lost", kept, "%", 0).main(),
        Figure::number("stiffness beyond the travel", gear.structure_stiffness_mn_m, "MN/m", 1),
        Figure::number("stiffness between the curves", gear.locked_stiffness_mn_m, "MN/m", 1),
        Figure::number("viscous damping", gear.damping_kn_s_m, "kN s/m", 1),
    ]
}
