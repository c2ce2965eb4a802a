//! `hotfoot critical-speed`: the speed at which a vehicle on straight track becomes unstable.

use clap::Args;
use miette::{Result, ensure};
use vehicle::linear::Rolling;

use crate::VehicleArgument;

/// Arguments of `hotfoot critical-speed`.
#[derive(Args)]
pub struct CriticalSpeedArguments {
    #[command(flatten)]
    vehicle: VehicleArgument,
    /// Equivalent conicities
    #[arg(long, value_delimiter = ',', default_values_t = [0.05, 0.10, 0.15, 0.20, 0.30])]
    conicity: Vec<f64>,
    /// Half distance of the contacts of a wheelset, m; left out: that of the running circles
    #[arg(long)]
    half_distance: Option<f64>,
    /// Radius of the rail head, m
    #[arg(long, default_value_t = 0.3)]
    rail_radius: f64,
    /// Greatest speed that is looked at, m/s
    #[arg(long, default_value_t = 150.0)]
    greatest: f64,
    /// Print comma-separated values
    #[arg(long)]
    csv: bool,
}

/// Prints the linear critical speed for each conicity.
///
/// # Errors
/// When the vehicle cannot be read.
pub fn critical_speed(arguments: &CriticalSpeedArguments) -> Result<()> {
    let positive = |value: &f64| value.is_finite() && *value > 0.0;
    ensure!(arguments.conicity.iter().all(positive), "--conicity must be greater than zero");
    ensure!(
        arguments.half_distance.iter().all(positive),
        "--half-distance must be greater than zero"
    );
    ensure!(positive(&arguments.rail_radius), "--rail-radius must be greater than zero");
    ensure!(positive(&arguments.greatest), "--greatest must be greater than zero");
    let structure = arguments.vehicle.structure()?;
    let running_circles = structure.wheelsets[0].wheel.half_distance;
    match arguments.csv {
        true => println!("conicity,critical_speed_m_s,frequency_hz"),
        false => println!("conicity  critical speed            frequency"),
    }
    for &conicity in &arguments.conicity {
        let half_distance = arguments.half_distance.unwrap_or(running_circles);
        let rolling = Rolling { conicity, half_distance, rail_radius: arguments.rail_radius };
        match rolling.critical_speed(&structure, arguments.greatest) {
            Some(found) if arguments.csv => {
                println!("{conicity},{:.2},{:.3}", found.speed, found.frequency);
            }
            Some(found) => println!(
                "{conicity:8.3}  {:6.1} m/s ({:5.0} km/h)  {:6.2} Hz",
                found.speed,
                3.6 * found.speed,
                found.frequency
            ),
            None if arguments.csv => println!("{conicity},,"),
            None => println!("{conicity:8.3}  stable up to {} m/s", arguments.greatest),
        }
    }
    Ok(())
}
