//! `hotfoot contact`: how a wheelset touches its rails over the lateral displacement.

use clap::Args;
use contact::{ProfilePair, RailProfile, WheelContact, WheelProfile, wheelset_geometry};
use miette::{IntoDiagnostic, Result, ensure};

const MM: f64 = 1e-3;

/// Halvings of the interval in which a loaded wheel's descent is sought.
const HALVINGS: usize = 50;

/// Arguments of `hotfoot contact`.
#[derive(Args)]
pub struct ContactArguments {
    /// Wheel profile: a name such as S1002 or cone-1-20, or a file of points
    #[arg(long, default_value = "S1002")]
    wheel: String,
    /// Rail profile: a name such as 60E1 or AS60, or a file of points
    #[arg(long, default_value = "60E1")]
    rail: String,
    /// Inclination of the rails, 0.025 for 1:40
    #[arg(long, default_value_t = 0.025)]
    inclination: f64,
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
    load: f64,
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
}

/// Prints the contacts of both wheels as comma-separated values: a row for each contact.
///
/// # Errors
/// When a profile is not known, or a wheel stands beside its rail.
pub fn contact(arguments: &ContactArguments) -> Result<()> {
    ensure!(arguments.step_mm > 0.0, "--step-mm must be greater than zero");
    ensure!(arguments.load > 0.0, "--load must be greater than zero");
    let pair = ProfilePair {
        wheel: WheelProfile::named(&arguments.wheel).into_diagnostic()?,
        rail: RailProfile::named(&arguments.rail).into_diagnostic()?,
        rail_inclination: arguments.inclination,
        gauge: arguments.gauge_mm * MM,
        flange_back_distance: arguments.flange_back_distance_mm * MM,
        nominal_radius: arguments.radius,
    };
    println!(
        "lateral_mm,roll_mrad,radius_difference_mm,conicity,side,contact,gap_mm,rail_mm,wheel_mm,\
         radius_change_mm,angle_mrad,normal_force_n,a_mm,b_mm,approach_mm"
    );
    let steps = ((arguments.to_mm - arguments.from_mm) / arguments.step_mm + 1e-9).floor();
    for step in 0..=steps.max(0.0) as usize {
        let lateral = arguments.from_mm + step as f64 * arguments.step_mm;
        let geometry = wheelset_geometry(&pair, lateral * MM, arguments.yaw_mrad * MM);
        let geometry = geometry.into_diagnostic()?;
        let difference = geometry.radius_difference() / MM;
        // At no displacement both radii are equal and the conicity has no value.
        let conicity = match lateral == 0.0 {
            true => String::new(),
            false => format!("{:.5}", difference / (2.0 * lateral)),
        };
        let head = format!("{lateral},{:.5},{difference:.5},{conicity}", geometry.roll / MM);
        for (side, contacts) in [("left", &geometry.left), ("right", &geometry.right)] {
            let loads = shared(contacts, arguments.load);
            for (number, (contact, load)) in contacts.iter().zip(loads).enumerate() {
                println!("{head},{side},{},{}", number + 1, row(contact, load));
            }
        }
    }
    Ok(())
}

/// Values of a contact under `load` (N).
fn row(contact: &WheelContact, load: f64) -> String {
    let scale = load.cbrt() / MM;
    [
        contact.gap / MM,
        contact.rail_lateral / MM,
        contact.wheel_lateral / MM,
        contact.radius_change / MM,
        contact.angle / MM,
        load,
        contact.hertz.semi_axis_rolling * scale,
        contact.hertz.semi_axis_lateral * scale,
        contact.hertz.approach(load) / MM,
    ]
    .map(|value| format!("{value:.5}"))
    .join(",")
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
