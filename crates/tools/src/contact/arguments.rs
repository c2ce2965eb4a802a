//! The options of `hotfoot contact`.

use std::path::PathBuf;

use clap::Args;
use contact::Roll;

use super::outline::OutlineOptions;
use crate::number::{not_negative, number, positive};

/// Arguments of `hotfoot contact`.
#[derive(Args)]
pub struct ContactArguments {
    /// Wheel profile: a name such as S1002 or cone-1-20, or a file of points
    #[arg(long, default_value = "S1002")]
    pub(super) wheel: String,
    /// Rail profile: a name such as 60E1 or AS60, or a file of points
    #[arg(long, default_value = "60E1")]
    pub(super) rail: String,
    /// Wheel profile on the left, if it differs
    #[arg(long)]
    pub(super) left_wheel: Option<String>,
    /// Rail profile on the left, if it differs
    #[arg(long)]
    pub(super) left_rail: Option<String>,
    /// Inclination of the rails, 0.025 for 1:40
    #[arg(long, default_value_t = 0.025, value_parser = not_negative)]
    pub(super) inclination: f64,
    /// Track gauge, mm
    #[arg(long, default_value_t = 1435.0, value_parser = positive)]
    pub(super) gauge_mm: f64,
    /// Distance of the flange backs, mm
    #[arg(long, default_value_t = 1360.0, value_parser = positive)]
    pub(super) flange_back_distance_mm: f64,
    #[command(flatten)]
    pub(super) outline: OutlineOptions,
    /// Radius of the wheels at the running circle, m
    #[arg(long, default_value_t = 0.46, value_parser = positive)]
    pub(super) radius: f64,
    /// Radius of the left wheel, if it differs, m
    #[arg(long, value_parser = positive)]
    pub(super) left_radius: Option<f64>,
    /// Vertical load of a wheel, N, for the sizes of the patches
    #[arg(long, default_value_t = 100e3, value_parser = positive)]
    pub(super) load: f64,
    /// First lateral displacement of the wheelset to the right, mm
    #[arg(long, default_value_t = -8.0, value_parser = number, allow_hyphen_values = true)]
    pub(super) from_mm: f64,
    /// Last lateral displacement, mm
    #[arg(long, default_value_t = 8.0, value_parser = number, allow_hyphen_values = true)]
    pub(super) to_mm: f64,
    /// Step of the displacement, mm
    #[arg(long, default_value_t = 0.5, value_parser = positive)]
    pub(super) step_mm: f64,
    /// Yaw of the wheelset, mrad
    #[arg(long, default_value_t = 0.0, value_parser = number, allow_hyphen_values = true)]
    pub(super) yaw_mrad: f64,
    /// Roll of the wheelset: free (both wheels touch), off, or an angle, right side down, mrad
    #[arg(long, default_value = "free", value_parser = roll, allow_hyphen_values = true)]
    pub(super) roll: Roll,
    /// Draw the values into this SVG file instead of printing them
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}

/// The roll that an option has.
fn roll(text: &str) -> Result<Roll, String> {
    match text {
        "free" => Ok(Roll::Free),
        "off" => Ok(Roll::Fixed(0.0)),
        _ => match number(text) {
            Ok(mrad) => Ok(Roll::Fixed(1e-3 * mrad)),
            Err(wanted) => Err(format!("{wanted}; or free, or off")),
        },
    }
}
