//! `hotfoot contact`: how a wheelset touches its rails over the lateral displacement.

use std::path::PathBuf;

use clap::Args;
use contact::{
    EquivalentConicity, ProfilePair, RailProfile, WheelContact, WheelProfile, wheelset_geometry,
};
use miette::{IntoDiagnostic, Result, ensure};

use crate::contact_plot;

const MM: f64 = 1e-3;

/// Halvings of the interval in which a loaded wheel's descent is sought.
const HALVINGS: usize = 50;

/// Most displacements of a table: each takes a search of some milliseconds.
const MOST_PLACES: f64 = 1e4;

/// Arguments of `hotfoot contact`.
#[derive(Args)]
pub struct ContactArguments {
    /// Wheel profile: a name such as S1002 or cone-1-20, or a file of points
    #[arg(long, default_value = "S1002")]
    pub(crate) wheel: String,
    /// Rail profile: a name such as 60E1 or AS60, or a file of points
    #[arg(long, default_value = "60E1")]
    pub(crate) rail: String,
    /// Inclination of the rails, 0.025 for 1:40
    #[arg(long, default_value_t = 0.025)]
    pub(crate) inclination: f64,
    /// Track gauge, mm
    #[arg(long, default_value_t = 1435.0)]
    gauge_mm: f64,
    /// Distance of the flange backs, mm
    #[arg(long, default_value_t = 1360.0)]
    flange_back_distance_mm: f64,
    /// Radius of the wheels at the running circle, m
    #[arg(long, default_value_t = 0.46)]
    radius: f64,
    /// Vertical load of a wheel, N, for the sizes of the patches
    #[arg(long, default_value_t = 100e3)]
    pub(crate) load: f64,
    /// First lateral displacement of the wheelset to the right, mm
    #[arg(long, default_value_t = -8.0, allow_hyphen_values = true)]
    from_mm: f64,
    /// Last lateral displacement, mm
    #[arg(long, default_value_t = 8.0, allow_hyphen_values = true)]
    to_mm: f64,
    /// Step of the displacement, mm
    #[arg(long, default_value_t = 0.5)]
    step_mm: f64,
    /// Yaw of the wheelset, mrad
    #[arg(long, default_value_t = 0.0, allow_hyphen_values = true)]
    yaw_mrad: f64,
    /// Draw the values into this SVG file instead of printing them
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// Prints the contacts of both wheels as comma-separated values, a row for each contact, or draws them.
///
/// # Errors
/// When a profile is not known, a wheel stands beside its rail, or the plot cannot be written.
pub fn contact(arguments: &ContactArguments) -> Result<()> {
    ensure!(arguments.step_mm > 0.0, "--step-mm must be greater than zero");
    ensure!(arguments.load > 0.0, "--load must be greater than zero");
    let span = arguments.to_mm - arguments.from_mm;
    ensure!(span >= 0.0, "--to-mm must not be below --from-mm");
    ensure!(
        span / arguments.step_mm <= MOST_PLACES,
        "--step-mm makes more than {MOST_PLACES} rows"
    );
    let placements = placements(arguments)?;
    match &arguments.plot {
        Some(file) => contact_plot::page(arguments, &placements).write(file),
        None => {
            print!("{}", csv(&placements));
            Ok(())
        }
    }
}

/// A wheelset at one lateral displacement, in the units of the file.
pub(crate) struct Placement {
    pub lateral_mm: f64,
    pub roll_mrad: f64,
    pub radius_difference_mm: f64,
    /// Nothing where the displacement is none.
    pub conicity: Option<f64>,
    /// Of a wave with this amplitude; nothing where there is none.
    pub equivalent_conicity: Option<f64>,
    /// Contacts of the left and of the right wheel, the first one to touch first.
    pub wheels: [Vec<LoadedContact>; 2],
}

/// A contact under its share of the wheel's load, in the units of the file.
pub(crate) struct LoadedContact {
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

/// The wheelset at all displacements that are asked for.
fn placements(arguments: &ContactArguments) -> Result<Vec<Placement>> {
    let pair = ProfilePair {
        wheel: WheelProfile::named(&arguments.wheel).into_diagnostic()?,
        rail: RailProfile::named(&arguments.rail).into_diagnostic()?,
        rail_inclination: arguments.inclination,
        gauge: arguments.gauge_mm * MM,
        flange_back_distance: arguments.flange_back_distance_mm * MM,
        nominal_radius: arguments.radius,
    };
    let greatest = arguments.from_mm.abs().max(arguments.to_mm.abs());
    let conicity = EquivalentConicity::new(&pair, greatest * MM).into_diagnostic()?;
    let steps = ((arguments.to_mm - arguments.from_mm) / arguments.step_mm + 1e-9).floor();
    let places =
        (0..=steps as usize).map(|step| arguments.from_mm + step as f64 * arguments.step_mm);
    places
        .map(|lateral_mm| {
            let yaw = arguments.yaw_mrad * MM;
            let geometry = wheelset_geometry(&pair, lateral_mm * MM, yaw).into_diagnostic()?;
            let difference = geometry.radius_difference() / MM;
            let loaded = |contacts: &[WheelContact]| {
                let loads = shared(contacts, arguments.load);
                contacts.iter().zip(loads).map(|(contact, load)| under(contact, load)).collect()
            };
            Ok(Placement {
                lateral_mm,
                roll_mrad: geometry.roll / MM,
                radius_difference_mm: difference,
                conicity: (lateral_mm != 0.0).then(|| difference / (2.0 * lateral_mm)),
                equivalent_conicity: conicity.at(lateral_mm.abs() * MM),
                wheels: [loaded(&geometry.left), loaded(&geometry.right)],
            })
        })
        .collect()
}

/// The rows of all contacts, with their header.
fn csv(placements: &[Placement]) -> String {
    let mut text = String::from(
        "lateral_mm,roll_mrad,radius_difference_mm,conicity,equivalent_conicity,side,contact,\
         gap_mm,rail_mm,wheel_mm,radius_change_mm,angle_mrad,normal_force_n,a_mm,b_mm,approach_mm\n",
    );
    let optional = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:.5}"));
    for placement in placements {
        let Placement { lateral_mm, roll_mrad, radius_difference_mm: difference, .. } = placement;
        let conicity = optional(placement.conicity);
        let equivalent = optional(placement.equivalent_conicity);
        let head = format!("{lateral_mm},{roll_mrad:.5},{difference:.5},{conicity},{equivalent}");
        for (side, contacts) in ["left", "right"].into_iter().zip(&placement.wheels) {
            for (number, contact) in contacts.iter().enumerate() {
                let values = contact.values().map(|value| format!("{value:.5}")).join(",");
                text += &format!("{head},{side},{},{values}\n", number + 1);
            }
        }
    }
    text
}

impl LoadedContact {
    /// The values in the order of the columns.
    fn values(&self) -> [f64; 9] {
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
