//! The options of `hotfoot creep`.

use std::path::PathBuf;

use clap::{Args, ValueEnum};

use crate::number::{not_negative, number, positive};

/// The law.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(super) enum Law {
    /// Kalker's exact theory (1990), from a table
    #[value(alias = "modified-fastsim")]
    ExactRolling,
    /// Modified FASTSIM (Spiryagin, Polach and Cole 2013), computed anew for each row
    FastsimOnLine,
    /// Polach's closed formula (2005)
    Polach,
    /// Kalker's linear theory with a limit (Shen, Hedrick and Elkins 1983)
    ShenHedrickElkins,
    /// Kalker's linear theory without a limit
    KalkerLinear,
}

/// Arguments of `hotfoot creep`. Left-out creepages are zero; a single one serves for all rows.
#[derive(Args)]
pub struct CreepArguments {
    /// Creep law
    #[arg(long, value_enum, default_value = "exact-rolling")]
    pub(super) law: Law,
    /// Normal force, N
    #[arg(long, value_parser = positive)]
    pub(super) load: f64,
    /// Semi-axes of the contact in the rolling direction and across, mm; or give --radii-m
    #[arg(long, num_args = 2, value_parser = positive, conflicts_with = "radii_m",
          required_unless_present = "radii_m")]
    pub(super) semi_axes_mm: Option<Vec<f64>>,
    /// Relative radii of curvature in the rolling direction and across, m
    ///
    /// Such as 0.5 0.3 for a wheel of 0.5 m radius with a straight tread on a rail head of 0.3 m.
    #[arg(long, num_args = 2, value_parser = positive)]
    pub(super) radii_m: Option<Vec<f64>>,
    /// Friction coefficient without slip
    #[arg(long, default_value_t = 0.36, value_parser = positive)]
    pub(super) friction: f64,
    /// Friction at infinite slip velocity by that without slip; 1: Coulomb's constant friction
    #[arg(long, default_value_t = 1.0, value_parser = not_negative)]
    pub(super) limit_ratio: f64,
    /// How fast friction falls with the slip velocity, s/m
    #[arg(long, default_value_t = 0.0, value_parser = not_negative)]
    pub(super) decay: f64,
    /// Exact rolling and FASTSIM: reduction k0, alpha and beta of the stiffness; 1 1 0 is none
    #[arg(long, num_args = 3, value_parser = not_negative, default_values_t = [1.0, 1.0, 0.0])]
    pub(super) reduction: Vec<f64>,
    /// Polach: kA and kS
    #[arg(long, num_args = 2, value_parser = positive, default_values_t = [1.0, 1.0])]
    pub(super) factors: Vec<f64>,
    /// Speed, m/s
    #[arg(long, default_value_t = 10.0, value_parser = positive)]
    pub(super) speed: f64,
    /// Longitudinal creepages, positive in traction: speed of the rim less the speed, over the speed.
    /// All forces are those on the wheel; in traction the longitudinal one is positive
    #[arg(long, value_delimiter = ',', value_parser = number, default_value = "0", allow_hyphen_values = true)]
    pub(super) longitudinal: Vec<f64>,
    /// Lateral creepages, positive where the wheel slips to the right; the force opposes them
    #[arg(long, value_delimiter = ',', value_parser = number, default_value = "0", allow_hyphen_values = true)]
    pub(super) lateral: Vec<f64>,
    /// Spin creepages, 1/m, positive about the vertical axis down
    #[arg(long, value_delimiter = ',', value_parser = number, default_value = "0", allow_hyphen_values = true)]
    pub(super) spin: Vec<f64>,
    /// Draw the values over the creepage into this SVG file instead of printing them
    #[arg(long, value_name = "FILE.svg")]
    pub(super) plot: Option<PathBuf>,
}
