//! What holds for creep forces at any slip, load and speed.

use contact::kalker::CreepCoefficients;
use contact::{
    ContactPatch, CreepForces, CreepLaw, ExactRolling, FallingFriction, ModifiedFastsim, Polach,
    REFERENCE_SPEED_MIN, Reduction, SlipVelocity,
};
use proptest::prelude::*;

fn patches() -> impl Strategy<Value = ContactPatch> {
    (1.0..3e5, 0.5e-3..12e-3, 0.5e-3..12e-3).prop_map(|(normal_force, a, b)| ContactPatch {
        normal_force,
        a,
        b,
        kalker: CreepCoefficients::new(a / b, 0.28),
    })
}

fn slips() -> impl Strategy<Value = SlipVelocity> {
    // Many orders of magnitude, and exact zeros.
    let value = prop_oneof![
        Just(0.0),
        (-9.0..1.0_f64, any::<bool>()).prop_map(|(power, negative)| {
            let size = 10_f64.powf(power);
            if negative { -size } else { size }
        }),
    ];
    (value.clone(), value.clone(), value).prop_map(|(longitudinal, lateral, spin)| SlipVelocity {
        longitudinal,
        lateral,
        spin,
    })
}

fn speeds() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), -80.0..80.0]
}

/// Friction of a dry rail, as Polach has it.
const DRY: FallingFriction =
    FallingFriction { static_coefficient: 0.55, limit_ratio: 0.4, decay: 0.6 };

/// All laws that friction bounds, on a dry rail.
fn laws() -> [CreepLaw; 5] {
    [
        CreepLaw::ExactRolling(ExactRolling::new(Reduction::EUROSPRINTER, DRY)),
        CreepLaw::ExactRolling(ExactRolling::new(Reduction::NONE, DRY)),
        CreepLaw::Fastsim(ModifiedFastsim::on_line(Reduction::NONE, DRY, 3, 10)),
        CreepLaw::Polach(Polach::DRY),
        CreepLaw::ShenHedrickElkins(DRY.into()),
    ]
}

fn law() -> impl Strategy<Value = CreepLaw> {
    (0..laws().len()).prop_map(|i| laws()[i])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    /// Friction bounds the force. Rounding: 1e-12.
    #[test]
    fn property_force_within_friction(law in law(), patch in patches(), slip in slips(), speed in speeds()) {
        let force = law.force(&patch, &slip, speed);
        let slip_velocity = slip.longitudinal.hypot(slip.lateral);
        let limit = DRY.coefficient(slip_velocity) * patch.normal_force;
        prop_assert!(force.force.longitudinal.hypot(force.force.lateral) <= limit * (1.0 + 1e-12));
    }

    /// Friction turns motion into heat, never the reverse: the power is what force and moment take
    /// from the slip, which counts against the wheel's motion along the track. Rounding: 1e-12 of the
    /// largest term.
    #[test]
    fn property_friction_power(law in law(), patch in patches(), slip in slips(), speed in speeds()) {
        let force = law.force(&patch, &slip, speed);
        let terms = [
            -force.force.longitudinal * slip.longitudinal,
            force.force.lateral * slip.lateral,
            force.spin_moment * slip.spin,
        ];
        let scale = terms.iter().fold(0.0_f64, |largest, term| largest.max(term.abs()));
        prop_assert!(force.friction_power >= 0.0);
        prop_assert!((force.friction_power + terms.iter().sum::<f64>()).abs() <= 1e-12 * scale);
    }

    /// Without spin the force drives where the slip is traction, and opposes lateral slip.
    #[test]
    fn property_force_follows_traction_and_opposes_lateral_slip(law in law(), patch in patches(), slip in slips(), speed in speeds()) {
        let slip = SlipVelocity { spin: 0.0, ..slip };
        let force = law.force(&patch, &slip, speed);
        prop_assert!(force.force.longitudinal * slip.longitudinal >= 0.0);
        prop_assert!(force.force.lateral * slip.lateral <= 0.0);
        prop_assert_eq!(force.spin_force, 0.0);
    }

    /// The parts handed to an implicit integrator add up, and the damping is at least the tangent
    /// of the creep curve, so that a step with it is stable. Along one direction of slip, no spin.
    #[test]
    fn property_damping_bounds_the_tangent(
        law in law(),
        patch in patches(),
        size in 1e-6..1.0_f64,
        speed in speeds(),
    ) {
        let at = |v: f64| law.force(&patch, &SlipVelocity { longitudinal: v, ..SlipVelocity::default() }, speed);
        let (here, further) = (at(size), at(size * 1.001));
        let tangent = (further.force.longitudinal - here.force.longitudinal) / (0.001 * size);
        prop_assert!(here.damping.longitudinal >= 0.0);
        prop_assert!(tangent <= here.damping.longitudinal * (1.0 + 1e-9));
        let parts = here.damping.longitudinal * size;
        prop_assert!((parts - here.force.longitudinal).abs() <= 1e-12 * parts.abs());
    }

    /// Mirrored slip gives mirrored forces, bit by bit.
    #[test]
    fn property_mirror(law in law(), patch in patches(), slip in slips(), speed in speeds()) {
        let mirror = SlipVelocity { longitudinal: slip.longitudinal, lateral: -slip.lateral, spin: -slip.spin };
        let (here, there) = (law.force(&patch, &slip, speed), law.force(&patch, &mirror, speed));
        prop_assert_eq!(here.force.longitudinal, there.force.longitudinal);
        prop_assert_eq!(here.force.lateral, -there.force.lateral);
        prop_assert_eq!(here.spin_moment, -there.spin_moment);
        prop_assert_eq!(here.friction_power, there.friction_power);
    }

    /// Rolling backwards is rolling forwards seen from the other side of the track.
    #[test]
    fn property_reverse_running(law in law(), patch in patches(), slip in slips(), speed in 0.0..80.0) {
        let turned = SlipVelocity { longitudinal: -slip.longitudinal, lateral: -slip.lateral, spin: slip.spin };
        let (here, there) = (law.force(&patch, &slip, speed), law.force(&patch, &turned, -speed));
        prop_assert_eq!(here.force.longitudinal, -there.force.longitudinal);
        prop_assert_eq!(here.force.lateral, -there.force.lateral);
        prop_assert_eq!(here.spin_moment, there.spin_moment);
    }
}

/// No load, no friction or no slip: no force, and no NaN.
#[test]
fn property_nothing_from_nothing() {
    let kalker = CreepCoefficients::new(1.0, 0.28);
    let patch = |normal_force: f64, a: f64| ContactPatch { normal_force, a, b: a, kalker };
    let slip = SlipVelocity { longitudinal: 0.1, lateral: -0.1, spin: 1.0 };
    for law in laws() {
        for patch in [patch(0.0, 0.0), patch(-5.0, 0.0), patch(f64::NAN, 0.0)] {
            let force = law.force(&patch, &slip, 20.0);
            assert_eq!(force, CreepForces::default());
        }
        let at_rest = law.force(&patch(1e5, 6e-3), &SlipVelocity::default(), 0.0);
        assert_eq!(at_rest.force.longitudinal, 0.0);
        assert_eq!(at_rest.force.lateral, 0.0);
        assert_eq!(at_rest.spin_moment, 0.0);
        assert_eq!(at_rest.friction_power, 0.0);
        assert!(at_rest.damping.longitudinal > 0.0, "a wheel at rest still resists");
        assert!(at_rest.damping.lateral > 0.0, "also sideways");
    }
}

/// Below the least reference speed creepages and forces no longer depend on the speed.
#[test]
fn property_standstill() {
    let slip = SlipVelocity { longitudinal: 1e-4, lateral: 2e-4, spin: 0.0 };
    assert_eq!(slip.creepages(0.0), slip.creepages(REFERENCE_SPEED_MIN));
    assert_eq!(slip.creepages(0.0).longitudinal, 1e-4 / REFERENCE_SPEED_MIN);
    assert_eq!(slip.creepages(-20.0), slip.creepages(20.0));
}
