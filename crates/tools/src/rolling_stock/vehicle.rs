//! Figures of a vehicle.

use files::Mistake;
use stock::{
    BrakeControl, DynamicBrake, Library, Multibody, Resistance, ResistanceFormula, Traction,
    Vehicle,
};

use super::entry::{Entry, Figure, Kind};

/// The entry of a vehicle type.
pub(super) fn entry(library: &Library, name: &str) -> Result<Entry, Mistake> {
    let vehicle = library.vehicle(name)?;
    let sources = [Some(&vehicle.source), vehicle.multibody.as_ref().map(|body| &body.source)];
    let mut sources: Vec<&str> =
        sources.into_iter().flatten().map(|source| source.trim()).collect();
    sources.dedup();
    Ok(Entry {
        kind: Kind::Vehicle,
        name: name.to_owned(),
        title: vehicle.name.clone(),
        file: Some(library.vehicle_path(name).display().to_string()),
        source: sources.join("\nIn three dimensions: "),
        figures: figures(&vehicle),
    })
}

fn figures(vehicle: &Vehicle) -> Vec<Figure> {
    let tonnes = vehicle.mass_kg / 1e3;
    let coupler = &vehicle.coupler;
    let mut figures = vec![
        Figure::number("mass", tonnes, "t", 1).main(),
        Figure::number("axle load", tonnes / f64::from(vehicle.axles), "t", 1).main(),
        Figure::count("axles", vehicle.axles as usize).main(),
        Figure::number("length over the couplers", vehicle.length_m, "m", 2).main(),
        Figure::number("mass of the rotating parts", vehicle.rotating_mass_kg / 1e3, "t", 2),
        Figure::text("coupler", coupler.kind.clone()),
        Figure::text("draft gear", coupler.draft_gear.clone()).main(),
        Figure::number("slack of a coupler", coupler.slack_mm, "mm", 1),
    ];
    if coupler.rear.is_some() {
        figures.push(Figure::text("coupler at the rear", coupler.rear_kind()));
        figures.push(Figure::text("draft gear at the rear", coupler.rear_draft_gear()));
        figures.push(Figure::number("slack at the rear", coupler.rear_slack_mm(), "mm", 1));
    }
    figures.extend(vehicle.traction.iter().flat_map(of_traction));
    figures.extend(vehicle.dynamic_brake.iter().map(of_dynamic_brake));
    figures.extend(of_resistance(&vehicle.resistance));
    let brake = &vehicle.brake;
    let control = match brake.control {
        BrakeControl::Air => "pressure in the pipe",
        BrakeControl::Ecp => "cable",
    };
    figures.push(Figure::text("brake command", control));
    figures.push(Figure::number("net braking ratio", 100.0 * brake.net_braking_ratio, "%", 1));
    figures.push(Figure::number("time to build the brake up", brake.build_up_s, "s", 1));
    if let Some(brake) = &vehicle.locomotive_brake {
        let ratio = 100.0 * brake.net_braking_ratio;
        figures.push(Figure::number("net braking ratio of the locomotive brake", ratio, "%", 1));
    }
    if let Some(brake) = &vehicle.hand_brake {
        let ratio = 100.0 * brake.net_braking_ratio;
        figures.push(Figure::number("net braking ratio of the hand brake", ratio, "%", 1));
    }
    let dimensions = if vehicle.multibody.is_some() { "yes" } else { "no" };
    figures.push(Figure::text("in three dimensions", dimensions).main());
    figures.extend(vehicle.multibody.iter().flat_map(of_multibody));
    figures
}

fn of_traction(traction: &Traction) -> Vec<Figure> {
    let mut figures = vec![];
    if let Some(power) = traction.power_kw {
        figures.push(Figure::number("power for traction", power, "kW", 0).main());
    }
    let of_table = traction.effort.iter().flat_map(|effort| &effort.effort_kn);
    let of_notches = traction.by_notch.iter().flat_map(|table| table.effort_kn.iter().flatten());
    let greatest = of_table.chain(of_notches).copied().fold(0.0, f64::max);
    if greatest > 0.0 {
        figures.push(Figure::number("greatest tractive effort", greatest, "kN", 0).main());
    }
    figures
}

fn of_dynamic_brake(brake: &DynamicBrake) -> Figure {
    let greatest = brake.effort.effort_kn.iter().copied().fold(0.0, f64::max);
    Figure::number("greatest effort of the dynamic brake", greatest, "kN", 0)
}

fn of_resistance(resistance: &Resistance) -> Vec<Figure> {
    let formula = match resistance.formula {
        ResistanceFormula::Coefficients => "coefficients of the file",
        ResistanceFormula::Davis => "Davis 1926",
        ResistanceFormula::AarRp548 => "AAR RP-548",
        ResistanceFormula::Arema => "AREMA 1970",
        ResistanceFormula::CanadianNational => "Canadian National 1992",
        ResistanceFormula::Cole => "Cole 2006",
        ResistanceFormula::Table => "force by speed",
    };
    vec![Figure::text("propulsion resistance", formula)]
}

fn of_multibody(multibody: &Multibody) -> Vec<Figure> {
    let contact = &multibody.contact;
    let mut figures = vec![
        Figure::count("bodies besides the wheelsets", multibody.body.len()),
        Figure::count("wheelsets", multibody.wheelset.len()),
    ];
    if let Some(wheelset) = multibody.wheelset.first() {
        figures.push(Figure::number("wheel radius", 1e3 * wheelset.wheel_radius_m, "mm", 1));
    }
    let powered = multibody.wheelset.iter().filter(|wheelset| wheelset.powered).count();
    figures.push(Figure::count("wheelsets that are driven", powered));
    figures.push(Figure::text("wheel profile", file_name(&contact.wheel)));
    figures.push(Figure::text("rail profile", file_name(&contact.rail)));
    figures.push(Figure::number("gauge", contact.gauge_mm, "mm", 0));
    figures.push(Figure::number("height of the couplers", multibody.coupler.height_m, "m", 2));
    figures
}

/// The name of a profile, or of its file without the folder.
fn file_name(profile: &str) -> String {
    profile.rsplit('/').next().unwrap_or(profile).to_owned()
}
