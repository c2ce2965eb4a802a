//! Shen, Hedrick and Elkins' law against CONTACT, and Kalker's linear forces.

use crate::{eurosprinter, near};
use contact::{CreepLaw, FallingFriction, STEEL, SlipVelocity};

/// CONTACT with Coulomb friction 0.33 (docs/reference/contact.md, series 1): the stated band of -4.4 to -1.7 % below
/// saturation and 0.1 % in it, widened by half of the last digit.
#[test]
fn benchmark_shen_hedrick_elkins_eurosprinter() {
    let law = CreepLaw::ShenHedrickElkins(FallingFriction::constant(0.33).into());
    let force = |creepage: f64| {
        let slip = SlipVelocity { longitudinal: 10.0 * creepage, ..SlipVelocity::default() };
        law.force(&eurosprinter(), &slip, 10.0).force.longitudinal
    };
    for (creepage, expected) in [(0.0004, 9112.0), (0.0012, 22820.0), (0.002, 31040.0)] {
        let error = force(creepage) / expected - 1.0;
        assert!((-0.0445..-0.0165).contains(&error), "{error} at {creepage}");
    }
    for creepage in [0.006, 0.03, 0.25] {
        near("saturated force", force(creepage), 35210.0, 0.0015 * 35210.0);
    }
}

/// Kalker's forces by hand: G a b C11 xi, -G a b C22 eta - G (a b)^1.5 C23 phi, and the moment
/// G (a b)^1.5 C23 eta - G (a b)^2 C33 phi. Rounding.
#[test]
fn analytic_kalker_linear_forces() {
    let (patch, speed) = (eurosprinter(), 20.0);
    let (xi, eta, phi) = (1e-3, -2e-3, 0.3);
    let slip = SlipVelocity { longitudinal: speed * xi, lateral: speed * eta, spin: speed * phi };
    let found = CreepLaw::KalkerLinear.force(&patch, &slip, speed);
    let (g, area, k) = (STEEL.shear_modulus, patch.a * patch.b, patch.kalker);
    let coupling = g * area.powf(1.5) * k.c23;
    near("Fx in N", found.force.longitudinal, g * area * k.c11 * xi, 1e-7);
    near("Fy in N", found.force.lateral, -g * area * k.c22 * eta - coupling * phi, 1e-7);
    near("Mz in N m", found.spin_moment, coupling * eta - g * area * area * k.c33 * phi, 1e-7);
}
