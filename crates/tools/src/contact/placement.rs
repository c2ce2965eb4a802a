//! A wheelset at a lateral displacement: its contacts, and how they share the load.

use contact::{
    ContactError, EquivalentConicity, ProfilePair, RailProfile, WheelContact, WheelProfile,
    WheelsetPairs,
};

use super::arguments::ContactArguments;
use super::outline::MM;
use crate::error::ToolError;

/// Halvings of the interval in which a loaded wheel's descent is sought.
const HALVINGS: usize = 50;

/// A wheelset at one lateral displacement, in the units of the file.
pub(super) struct Placement {
    pub lateral_mm: f64,
    pub roll_mrad: f64,
    pub radius_difference_mm: f64,
    /// Of the radii without roll; nothing where the displacement is none.
    pub conicity: Option<f64>,
    /// Of a wave with this amplitude; nothing where there is none.
    pub equivalent_conicity: Option<f64>,
    /// Contacts of the left and of the right wheel, the first one to touch first.
    pub wheels: [Vec<LoadedContact>; 2],
}

/// A contact under its share of the wheel's load, in the units of the file.
pub(super) struct LoadedContact {
    pub gap_mm: f64,
    pub rail_mm: f64,
    pub wheel_mm: f64,
    pub radius_change_mm: f64,
    pub angle_mrad: f64,
    pub normal_force_n: f64,
    pub a_mm: f64,
    pub b_mm: f64,
    pub approach_mm: f64,
}

impl LoadedContact {
    /// The values in the order of the columns.
    pub(super) fn values(&self) -> [f64; 9] {
        [
            self.gap_mm,
            self.rail_mm,
            self.wheel_mm,
            self.radius_change_mm,
            self.angle_mrad,
            self.normal_force_n,
            self.a_mm,
            self.b_mm,
            self.approach_mm,
        ]
    }
}

/// Wheel and rail on each side.
fn pairs(arguments: &ContactArguments) -> Result<WheelsetPairs, ContactError> {
    let reading = arguments.outline.reading();
    let pair = |wheel: &str, rail: &str, radius| {
        Ok::<_, ContactError>(ProfilePair {
            wheel: WheelProfile::read(wheel, &reading)?,
            rail: RailProfile::read(rail, &reading)?,
            rail_inclination: arguments.inclination,
            gauge: arguments.gauge_mm * MM,
            gauge_depth: arguments.outline.gauge_depth_mm * MM,
            flange_back_distance: arguments.flange_back_distance_mm * MM,
            running_circle_from_flange_back: reading.running_circle,
            nominal_radius: radius,
        })
    };
    let ContactArguments { wheel, rail, radius, .. } = arguments;
    Ok(WheelsetPairs {
        left: pair(
            arguments.left_wheel.as_ref().unwrap_or(wheel),
            arguments.left_rail.as_ref().unwrap_or(rail),
            arguments.left_radius.unwrap_or(*radius),
        )?,
        right: pair(wheel, rail, *radius)?,
    })
}

/// The wheelset at all displacements that are asked for.
pub(super) fn placements(arguments: &ContactArguments) -> Result<Vec<Placement>, ToolError> {
    let pairs = pairs(arguments)?;
    let greatest = arguments.from_mm.abs().max(arguments.to_mm.abs());
    let conicity = EquivalentConicity::new(&pairs, greatest * MM)?;
    let steps = ((arguments.to_mm - arguments.from_mm) / arguments.step_mm + 1e-9).floor();
    let displacements =
        (0..=steps as usize).map(|step| arguments.from_mm + step as f64 * arguments.step_mm);
    displacements
        .map(|lateral_mm| {
            let yaw = arguments.yaw_mrad * MM;
            let geometry = pairs.geometry(lateral_mm * MM, yaw, arguments.roll)?;
            let difference = geometry.radius_difference() / MM;
            let loaded = |contacts: &[WheelContact]| {
                let loads = shared(contacts, arguments.load);
                contacts.iter().zip(loads).map(|(contact, load)| under(contact, load)).collect()
            };
            Ok(Placement {
                lateral_mm,
                roll_mrad: geometry.roll / MM,
                radius_difference_mm: difference,
                conicity: conicity.of_radii_at(lateral_mm * MM),
                equivalent_conicity: conicity.at(lateral_mm.abs() * MM),
                wheels: [loaded(&geometry.left), loaded(&geometry.right)],
            })
        })
        .collect()
}

/// A contact under `load` (N).
fn under(contact: &WheelContact, load: f64) -> LoadedContact {
    let scale = load.cbrt() / MM;
    LoadedContact {
        gap_mm: contact.gap / MM,
        rail_mm: contact.rail_lateral / MM,
        wheel_mm: contact.wheel_lateral / MM,
        radius_change_mm: contact.radius_change / MM,
        angle_mrad: contact.angle / MM,
        normal_force_n: load,
        a_mm: contact.hertz.semi_axis_rolling * scale,
        b_mm: contact.hertz.semi_axis_lateral * scale,
        approach_mm: contact.hertz.approach(load) / MM,
    }
}

/// Normal force of each contact when the wheel sinks until all together hold its vertical load.
fn shared(contacts: &[WheelContact], load: f64) -> Vec<f64> {
    let loads = |sunk: f64| {
        contacts.iter().map(move |contact| {
            contact.hertz.normal_force((sunk - contact.gap) * contact.angle.cos())
        })
    };
    let held = |sunk: f64| {
        loads(sunk).zip(contacts).map(|(load, contact)| load * contact.angle.cos()).sum::<f64>()
    };
    let (mut low, mut high) = (0.0, 10.0 * MM);
    for _ in 0..HALVINGS {
        let sunk = 0.5 * (low + high);
        if held(sunk) < load {
            low = sunk;
        } else {
            high = sunk;
        }
    }
    loads(high).collect()
}
