//! What a set of creepages does in one contact: force, friction power and flash temperature.

use contact::hertz::UnitContact;
use contact::kalker::CreepCoefficients;
use contact::{
    ContactPatch, CreepForces, CreepLaw, ExactRolling, FallingFriction, ModifiedFastsim, Polach,
    Reduction, STEEL, SlipVelocity,
};
use railheat::contact::{Contact, Material, flash_rise};

use super::arguments::{CreepArguments, Law};
use crate::error::{ToolError, ensure};

const MM: f64 = 1e-3;

/// Share of the friction heat that flows into the rail: half, for equal steels.
const PARTITION: f64 = 0.5;

/// What one set of creepages does.
pub(super) struct Row {
    /// Longitudinal and lateral creepage, and spin in 1/m.
    pub creepages: [f64; 3],
    pub forces: CreepForces,
    /// Highest rise of the rail's surface, K.
    pub flash: f64,
}

/// A row for each set of creepages.
pub(super) fn rows(arguments: &CreepArguments) -> Result<Vec<Row>, ToolError> {
    let patch = patch(arguments)?;
    let law = law(arguments);
    let lists = [&arguments.longitudinal, &arguments.lateral, &arguments.spin];
    let count = lists.iter().map(|list| list.len()).max().unwrap_or(0);
    ensure(
        lists.iter().all(|list| list.len() == 1 || list.len() == count),
        "the lists of creepages must have the same length, or one value for all rows",
    )?;
    let speed = arguments.speed;
    let rows = (0..count).map(|i| {
        let creepages = lists.map(|list| list[i.min(list.len() - 1)]);
        let [longitudinal, lateral, spin] = creepages.map(|creepage| speed * creepage);
        let forces = law.force(&patch, &SlipVelocity { longitudinal, lateral, spin }, speed);
        Row { creepages, forces, flash: flash(&patch, &forces, speed) }
    });
    Ok(rows.collect())
}

/// The contact ellipse, given or by Hertz.
fn patch(arguments: &CreepArguments) -> Result<ContactPatch, ToolError> {
    let (a, b) = match (&arguments.semi_axes_mm, &arguments.radii_m) {
        (Some(axes), None) => (axes[0] * MM, axes[1] * MM),
        (None, Some(radii)) => {
            let hertz = UnitContact::new(0.5 / radii[0], 0.5 / radii[1], &STEEL);
            let scale = arguments.load.cbrt();
            (hertz.semi_axis_rolling * scale, hertz.semi_axis_lateral * scale)
        }
        _ => {
            let wanted = "give either --semi-axes-mm A B or --radii-m RX RY";
            return Err(ToolError::Options(wanted.to_owned()));
        }
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
        Law::ExactRolling => CreepLaw::ExactRolling(ExactRolling::new(reduction, friction)),
        Law::FastsimOnLine => {
            CreepLaw::Fastsim(ModifiedFastsim::on_line(reduction, friction, 20, 100))
        }
        Law::Polach => CreepLaw::Polach(Polach {
            adhesion_factor: arguments.factors[0],
            slip_factor: arguments.factors[1],
            friction: friction.into(),
        }),
        Law::ShenHedrickElkins => CreepLaw::ShenHedrickElkins(friction.into()),
        Law::KalkerLinear => CreepLaw::KalkerLinear,
    }
}

/// Highest rise of the rail's surface behind the contact, in K.
fn flash(patch: &ContactPatch, forces: &CreepForces, speed: f64) -> f64 {
    let contact = Contact { normal_force: patch.normal_force, a: patch.a, b: patch.b };
    // Power by speed is the energy on a metre: force times creepage.
    let energy = forces.friction_power / speed;
    forces.flash_factor * flash_rise(&contact, energy, 1.0, speed, PARTITION, &Material::PAPER)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use clap::{Args, Command, FromArgMatches};
    use fmu::{Instance, Phase};
    use vehicle::Vehicle;

    use super::*;

    /// The options as the command line gives them.
    fn arguments(options: &str) -> CreepArguments {
        let command = CreepArguments::augment_args(Command::new("creep").no_binary_name(true));
        let matches = command.try_get_matches_from(options.split_whitespace()).unwrap();
        CreepArguments::from_arg_matches(&matches).unwrap()
    }

    /// Values of the tread contact of the leading left wheel, in its initial equilibrium, of the
    /// locomotive's FMU with this traction (N) on straight track at 10 m/s.
    fn values_of_the_fmu<const N: usize>(traction: f64, names: [&str; N]) -> [f64; N] {
        let stock = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../stock/vehicles");
        let resources = tempfile::tempdir().unwrap();
        let file = |name: &str| resources.path().join(name);
        let locomotive = "locomotive-coco-134t.toml";
        std::fs::create_dir_all(file("stock/vehicles")).unwrap();
        std::fs::copy(stock.join(locomotive), file("stock/vehicles").join(locomotive)).unwrap();
        std::fs::write(file("vehicle.toml"), "extends = \"locomotive-coco-134t\"").unwrap();
        std::fs::write(file("track.toml"), "alignment = []").unwrap();
        let mut fmu =
            Instance::<Vehicle>::new(resources.path(), "vehicle", Box::new(|_, _| {})).unwrap();
        let reference = |fmu: &Instance<Vehicle>, name: &str| {
            let mut variables = fmu.declaration().variables().iter();
            variables.find(|variable| variable.name == name).expect(name).reference
        };
        let inputs = ["initial.velocity", "traction.force"].map(|name| reference(&fmu, name));
        let outputs =
            names.map(|name| reference(&fmu, &format!("wheelset[1].left.patch[1].{name}")));
        fmu.set_real(&inputs, [10.0, traction]).unwrap();
        fmu.setup_experiment(0.0, None).unwrap();
        fmu.enter_initialization_mode().unwrap();
        fmu.exit_initialization_mode().unwrap();
        assert_eq!(fmu.phase(), Phase::StepComplete);
        let mut values = fmu.get_real(&outputs).unwrap();
        std::array::from_fn(|_| values.next().unwrap())
    }

    /// Traction has positive creepage and force, and braking negative ones, at the command as in the
    /// FMU, and both give one value for one contact. Tolerance 1e-3 of the force: the FMU's table has
    /// Kalker's coefficients linear between its rows.
    #[test]
    fn property_the_command_and_the_fmu_agree_in_sign_and_value() {
        for traction in [200e3, -200e3] {
            let [xi, eta, phi, along, across, load, power, a, b] = values_of_the_fmu(
                traction,
                [
                    "creepage.longitudinal",
                    "creepage.lateral",
                    "creepage.spin",
                    "force.longitudinal",
                    "force.lateral",
                    "force.normal",
                    "friction_power",
                    "contact.a",
                    "contact.b",
                ],
            );
            let [a, b] = [a / MM, b / MM];
            // Parameters of the creep law in the locomotive's file.
            let rows = rows(&arguments(&format!(
                "--load {load} --semi-axes-mm {a} {b} --friction 0.36 --limit-ratio 0.38 --decay 0.7 \
                 --reduction 0.54 0.02 0.62 --speed 10 --longitudinal {xi} --lateral {eta} --spin {phi}"
            )))
            .unwrap();
            let CreepForces { force, friction_power, .. } = rows[0].forces;
            assert!(xi * traction > 0.0 && along * traction > 0.0, "{xi}, {along} N");
            let near = |found: f64, expected: f64, within: f64| {
                assert!((found - expected).abs() <= within, "{found} instead of {expected}");
            };
            near(force.longitudinal, along, 1e-3 * along.abs());
            near(force.lateral, across, 1e-3 * along.abs());
            near(friction_power, power, 1e-3 * power);
        }
    }
}
