//! Validation of the contact crate: each test names its source and why its tolerance is what it is.
//!
//! | file | against |
//! |---|---|
//! | `hertz.rs` | exact Hertz table, CONTACT |
//! | `kalker.rs` | Kalker's table, interpolated |
//! | `profiles.rs` | EN 13715, EN 13674-1, points of the Manchester benchmark |
//! | `manchester.rs` | Manchester contact benchmark, geometry: a rigid search, and CONTACT |
//! | `manchester_forces.rs` | the same, creep forces and friction power of CONTACT |
//! | `en15302.rs` | annex E of EN 15302: equivalent conicity |
//! | `measured.rs` | profiles as they are measured, against the clean ones |
//! | `geometry.rs` | the geometry table's own laws |
//! | `pressed.rs` | a loaded contact as the gradient of its energy |
//! | `fastsim.rs` | FASTSIM and modified FASTSIM of CONTACT: force and friction power |
//! | `rolling.rs` | exact rolling by table: Kalker's tables, CONTACT, the solver |
//! | `temperature.rs` | friction by temperature and flash temperature: CONTACT |
//! | `polach.rs` | published creep curves, CONTACT |
//! | `shen_hedrick_elkins.rs` | CONTACT; Kalker's linear forces |
//! | `properties.rs` | creep forces for any slip |

mod en15302;
mod fastsim;
mod geometry;
mod hertz;
mod kalker;
mod manchester;
mod manchester_forces;
mod measured;
mod polach;
mod pressed;
mod profiles;
mod properties;
mod rolling;
mod shen_hedrick_elkins;
mod temperature;

use contact::kalker::CreepCoefficients;
use contact::{ContactPatch, ProfilePair, RailProfile, STEEL, SlipVelocity, WheelProfile};
use validation::Page;

/// A wheel on a rail inclined 1:40 with standard gauge and a radius of 460 mm, as in the benchmark.
pub fn pair(wheel: &str, rail: &str) -> ProfilePair {
    ProfilePair::standard_gauge(
        WheelProfile::named(wheel).unwrap(),
        RailProfile::named(rail).unwrap(),
        1.0 / 40.0,
        0.460,
    )
}

/// Siemens Eurosprinter 127 001 in CONTACT's examples: 106.7 kN, a 6.304 mm, b 12.61 mm.
pub fn eurosprinter() -> ContactPatch {
    ContactPatch {
        normal_force: 106_700.0,
        a: 6.304e-3,
        b: 12.61e-3,
        kalker: CreepCoefficients::new(0.5, STEEL.poisson_ratio),
    }
}

/// Creepages and forces of CONTACT for the Eurosprinter with Coulomb friction 0.33 (series 1 of
/// docs/reference/contact.md): half-space, 48 by 44 elements.
pub const EUROSPRINTER_COULOMB: [(f64, f64); 9] = [
    (1e-5, 247.0),
    (0.0004, 9112.0),
    (0.0012, 22820.0),
    (0.002, 31040.0),
    (0.0028, 34620.0),
    (0.0036, 35180.0),
    (0.006, 35200.0),
    (0.03, 35210.0),
    (0.25, 35210.0),
];

/// Lateral creep with spin in an example of CONTACT (docs/reference/contact.md): 82 kN, a 8 mm, b 4 mm,
/// eta -0.000625 and phi 0.625/m at a `speed` in m/s.
pub fn creep_with_spin(speed: f64) -> (ContactPatch, SlipVelocity) {
    let patch = ContactPatch {
        normal_force: 82_000.0,
        a: 8e-3,
        b: 4e-3,
        kalker: CreepCoefficients::new(2.0, STEEL.poisson_ratio),
    };
    let slip = SlipVelocity { longitudinal: 0.0, lateral: -0.000625 * speed, spin: 0.625 * speed };
    (patch, slip)
}

/// The page that has the table of all comparisons with numbers.
pub const PAGE: Page = Page {
    path: "docs/validation/contact.md",
    text: include_str!("../../../../docs/validation/contact.md"),
};

/// Fails with the case's name unless `value` is `expected` within `tolerance`.
pub fn near(case: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{case}: {value} instead of {expected}, more than {tolerance} off"
    );
}
