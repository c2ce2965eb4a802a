//! `hotfoot creep`: creep forces, friction power and flash temperature of one contact.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use contact::hertz::UnitContact;
use contact::kalker::CreepCoefficients;
use contact::{
    ContactPatch, CreepForces, CreepLaw, FallingFriction, ModifiedFastsim, Polach, Reduction,
    STEEL, SlipVelocity,
};
use miette::{Result, ensure, miette};
use railheat::contact::{Contact, Material, flash_rise};

use crate::creep_plot;

const MM: f64 = 1e-3;

/// Share of the friction heat that flows into the rail: half, for equal steels.
const PARTITION: f64 = 0.5;

/// The law.
#[derive(Clone, Copy, Debug, ValueEnum)]
pub(crate) enum Law {
    ModifiedFastsim,
    FastsimOnLine,
    Polach,
    ShenHedrickElkins,
    KalkerLinear,
}

/// Arguments of `hotfoot creep`. Left-out creepages are zero; a single one serves for all rows.
#[derive(Args)]
pub struct CreepArguments {
    /// Creep law
    #[arg(long, value_enum, default_value = "modified-fastsim")]
    pub(crate) law: Law,
    /// Normal force, N
    #[arg(long)]
    pub(crate) load: f64,
    /// Semi-axes of the contact in the rolling direction and across, mm; or give --radii-m
    #[arg(long, num_args = 2, conflicts_with = "radii_m")]
    semi_axes_mm: Option<Vec<f64>>,
    /// Relative radii of curvature in the rolling direction and across, m, such as 0.5 0.3 for a
    /// wheel of 0.5 m radius with a straight tread on a rail head of 0.3 m
    #[arg(long, num_args = 2)]
    radii_m: Option<Vec<f64>>,
    /// Friction coefficient without slip
    #[arg(long, default_value_t = 0.36)]
    pub(crate) friction: f64,
    /// Friction at infinite slip velocity by that without slip; 1: Coulomb's constant friction
    #[arg(long, default_value_t = 1.0)]
    limit_ratio: f64,
    /// How fast friction falls with the slip velocity, s/m
    #[arg(long, default_value_t = 0.0)]
    decay: f64,
    /// Modified FASTSIM: k0, alpha and beta; 1 1 0 is FASTSIM
    #[arg(long, num_args = 3, default_values_t = [1.0, 1.0, 0.0])]
    reduction: Vec<f64>,
    /// Polach: kA and kS
    #[arg(long, num_args = 2, default_values_t = [1.0, 1.0])]
    factors: Vec<f64>,
    /// Speed, m/s
    #[arg(long, default_value_t = 10.0)]
    pub(crate) speed: f64,
    /// Longitudinal creepages: slip of the wheel on the rail over the speed. All forces are those on
    /// the wheel, and oppose the slip
    #[arg(long, value_delimiter = ',', default_value = "0", allow_hyphen_values = true)]
    longitudinal: Vec<f64>,
    /// Lateral creepages
    #[arg(long, value_delimiter = ',', default_value = "0", allow_hyphen_values = true)]
    lateral: Vec<f64>,
    /// Spin creepages, 1/m
    #[arg(long, value_delimiter = ',', default_value = "0", allow_hyphen_values = true)]
    spin: Vec<f64>,
    /// Draw the values over the creepage into this SVG file instead of printing them
    #[arg(long, value_name = "FILE.svg")]
    plot: Option<PathBuf>,
}

/// Prints a row of comma-separated values for each creepage, or draws them.
///
/// # Errors
/// When the contact is not given, the lists of creepages differ in length, or the plot cannot be
/// written.
pub fn creep(arguments: &CreepArguments) -> Result<()> {
    ensure!(arguments.load > 0.0, "--load must be greater than zero");
    ensure!(arguments.speed > 0.0, "--speed must be greater than zero");
    ensure!(
        arguments.friction > 0.0 && arguments.limit_ratio >= 0.0 && arguments.decay >= 0.0,
        "--friction must be greater than zero, --limit-ratio and --decay not negative"
    );
    let [initial, remaining, fall] = [0, 1, 2].map(|i| arguments.reduction[i]);
    ensure!(
        initial > 0.0 && (0.0..=1.0).contains(&remaining) && fall >= 0.0,
        "--reduction must be k0 greater than zero, alpha between 0 and 1, beta not negative"
    );
    let [adhesion, slip] = [0, 1].map(|i| arguments.factors[i]);
    ensure!(
        adhesion >= slip && slip > 0.0,
        "--factors must be kA not below kS, both greater than zero"
    );
    let rows = rows(arguments)?;
    match &arguments.plot {
        Some(file) => creep_plot::page(arguments, &rows)?.write(file),
        None => {
            print!("{}", csv(&rows));
            Ok(())
        }
    }
}

/// What one set of creepages does.
pub(crate) struct Row {
    /// Longitudinal and lateral creepage, and spin in 1/m.
    pub creepages: [f64; 3],
    pub forces: CreepForces,
    /// Highest rise of the rail's surface, K.
    pub flash: f64,
}

/// A row for each set of creepages.
fn rows(arguments: &CreepArguments) -> Result<Vec<Row>> {
    let patch = patch(arguments)?;
    let law = law(arguments);
    let lists = [&arguments.longitudinal, &arguments.lateral, &arguments.spin];
    let count = lists.iter().map(|list| list.len()).max().unwrap_or(0);
    ensure!(
        lists.iter().all(|list| list.len() == 1 || list.len() == count),
        "the lists of creepages must have the same length, or one value for all rows"
    );
    let speed = arguments.speed;
    let rows = (0..count).map(|i| {
        let creepages = lists.map(|list| list[i.min(list.len() - 1)]);
        let [longitudinal, lateral, spin] = creepages.map(|creepage| speed * creepage);
        let forces = law.force(&patch, &SlipVelocity { longitudinal, lateral, spin }, speed);
        Row { creepages, forces, flash: flash(&patch, forces.friction_power, speed) }
    });
    Ok(rows.collect())
}

/// The rows with their header.
fn csv(rows: &[Row]) -> String {
    let mut text = String::from(
        "longitudinal,lateral,spin_1_m,force_longitudinal_n,force_lateral_n,spin_moment_n_m,\
         friction_power_w,flash_temperature_k\n",
    );
    for Row { creepages: [xi, eta, phi], forces, flash } in rows {
        let CreepForces { longitudinal, lateral, spin_moment, friction_power, .. } = forces;
        text += &format!(
            "{xi},{eta},{phi},{longitudinal:.3},{lateral:.3},{spin_moment:.4},\
             {friction_power:.4},{flash:.3}\n"
        );
    }
    text
}

/// The contact ellipse, given or by Hertz.
fn patch(arguments: &CreepArguments) -> Result<ContactPatch> {
    let positive = |values: &[f64]| values.iter().all(|value| *value > 0.0 && value.is_finite());
    let (a, b) = match (&arguments.semi_axes_mm, &arguments.radii_m) {
        (Some(axes), None) if positive(axes) => (axes[0] * MM, axes[1] * MM),
        (None, Some(radii)) if positive(radii) => {
            let hertz = UnitContact::new(0.5 / radii[0], 0.5 / radii[1], &STEEL);
            let scale = arguments.load.cbrt();
            (hertz.semi_axis_rolling * scale, hertz.semi_axis_lateral * scale)
        }
        _ => return Err(miette!("give --semi-axes-mm A B or --radii-m RX RY, greater than zero")),
    };
    let kalker = CreepCoefficients::new(a / b, STEEL.poisson_ratio);
    Ok(ContactPatch { normal_force: arguments.load, a, b, kalker })
}

fn law(arguments: &CreepArguments) -> CreepLaw {
    let friction = FallingFriction {
        static_coefficient: arguments.friction,
        limit_ratio: arguments.limit_ratio,
        decay: arguments.decay,
    };
    let reduction = Reduction {
        initial: arguments.reduction[0],
        remaining: arguments.reduction[1],
        fall: arguments.reduction[2],
    };
    match arguments.law {
        Law::ModifiedFastsim => CreepLaw::Fastsim(ModifiedFastsim::by_table(reduction, friction)),
        Law::FastsimOnLine => {
            CreepLaw::Fastsim(ModifiedFastsim::on_line(reduction, friction, 20, 100))
        }
        Law::Polach => CreepLaw::Polach(Polach {
            adhesion_factor: arguments.factors[0],
            slip_factor: arguments.factors[1],
            friction,
        }),
        Law::ShenHedrickElkins => CreepLaw::ShenHedrickElkins(friction),
        Law::KalkerLinear => CreepLaw::KalkerLinear,
    }
}

/// Highest rise of the rail's surface behind the contact, in K.
fn flash(patch: &ContactPatch, friction_power: f64, speed: f64) -> f64 {
    let contact = Contact { normal_force: patch.normal_force, a: patch.a, b: patch.b };
    // Power by speed is the energy on a metre: force times creepage.
    flash_rise(&contact, friction_power / speed, 1.0, speed, PARTITION, &Material::PAPER)
}
