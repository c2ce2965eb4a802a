//! `hotfoot critical-speed`: the speed at which a vehicle on straight track becomes unstable.

use std::fmt::Write;

use clap::Args;
use numerics::constants::KILOMETRES_PER_HOUR;
use vehicle::linear::Rolling;

use crate::VehicleArgument;
use crate::error::ToolError;
use crate::number::positive;

/// Arguments of `hotfoot critical-speed`.
#[derive(Args)]
pub struct CriticalSpeedArguments {
    #[command(flatten)]
    /// The vehicle.
    pub vehicle: VehicleArgument,
    /// Equivalent conicities
    #[arg(long, value_delimiter = ',', value_parser = positive, default_values_t = [0.05, 0.10, 0.15, 0.20, 0.30])]
    conicity: Vec<f64>,
    /// Half distance of the contacts of a wheelset, m; left out: that of the running circles
    #[arg(long, value_parser = positive)]
    half_distance: Option<f64>,
    /// Radius of the rail head, m
    #[arg(long, default_value_t = 0.3, value_parser = positive)]
    rail_radius: f64,
    /// Greatest speed that is looked at, m/s
    #[arg(long, default_value_t = 150.0, value_parser = positive)]
    greatest: f64,
    /// Print comma-separated values
    #[arg(long)]
    csv: bool,
}

/// The linear critical speed for each conicity, as a table or as comma-separated values.
///
/// # Errors
/// When the vehicle cannot be read.
pub fn critical_speed(arguments: &CriticalSpeedArguments) -> Result<String, ToolError> {
    let CriticalSpeedArguments { rail_radius, greatest, csv, .. } = *arguments;
    let structure = arguments.vehicle.structure()?;
    let running_circles = structure.wheelsets[0].wheel.half_distance;
    let half_distance = arguments.half_distance.unwrap_or(running_circles);
    let mut text = String::from(match csv {
        true => "conicity,critical_speed_m_s,frequency_hz\n",
        false => "conicity  critical speed            frequency\n",
    });
    for &conicity in &arguments.conicity {
        let rolling = Rolling { conicity, half_distance, rail_radius };
        let found = rolling.critical_speed(&structure, greatest);
        let found = found.map(|found| (found.speed, found.frequency));
        // Writing to a text cannot fail.
        let _ = match (found, csv) {
            (Some((speed, frequency)), true) => {
                writeln!(text, "{conicity},{speed:.2},{frequency:.3}")
            }
            (Some((speed, frequency)), false) => writeln!(
                text,
                "{conicity:8.3}  {speed:6.1} m/s ({:5.0} km/h)  {frequency:6.2} Hz",
                KILOMETRES_PER_HOUR * speed
            ),
            (None, true) => writeln!(text, "{conicity},,"),
            (None, false) => writeln!(text, "{conicity:8.3}  stable up to {greatest} m/s"),
        };
    }
    Ok(text)
}
