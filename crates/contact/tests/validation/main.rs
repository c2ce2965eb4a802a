//! Validation of the contact crate: each test names its source and why its tolerance is what it is.
//!
//! | file | against |
//! |---|---|
//! | `hertz.rs` | exact Hertz table, CONTACT |
//! | `kalker.rs` | Kalker's table, interpolated |
//! | `profiles.rs` | EN 13715, EN 13674-1, points of the Manchester benchmark |
//! | `manchester.rs` | Manchester contact benchmark: a rigid search, and CONTACT |
//! | `geometry.rs` | the geometry table's own laws |
//! | `fastsim.rs` | FASTSIM and modified FASTSIM of CONTACT: force and friction power |
//! | `polach.rs` | published creep curves, CONTACT |
//! | `shen_hedrick_elkins.rs` | CONTACT; Kalker's linear forces |
//! | `properties.rs` | creep forces for any slip |
//!
//! "reference" below is the project's collection of published figures, `reference/vehicle.md`.

mod fastsim;
mod geometry;
mod hertz;
mod kalker;
mod manchester;
mod polach;
mod profiles;
mod properties;
mod shen_hedrick_elkins;

use contact::{ProfilePair, RailProfile, WheelProfile};

/// A wheel on a rail inclined 1:40 with standard gauge and a radius of 460 mm, as in the benchmark.
pub fn pair(wheel: &str, rail: &str) -> ProfilePair {
    ProfilePair::standard_gauge(
        WheelProfile::named(wheel).unwrap(),
        RailProfile::named(rail).unwrap(),
        1.0 / 40.0,
        0.460,
    )
}

/// Fails with the case's name unless `value` is `expected` within `tolerance`.
pub fn near(case: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{case}: {value} instead of {expected}, more than {tolerance} off"
    );
}
