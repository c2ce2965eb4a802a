//! Resistance to the motion of a vehicle.
//!
//! | file | part |
//! |---|---|
//! | `propulsion.rs` | on straight level track, with the wind |
//! | `curve.rs` | in curves |
//! | `davis.rs`, `aar_rp548.rs`, `arema.rs`, `canadian_national.rs`, `cole.rs` | one formula each for the propulsion resistance |
//! | `coefficients.rs` | the three coefficients that a formula comes down to |

pub mod aar_rp548;
pub mod arema;
pub mod canadian_national;
pub mod coefficients;
pub mod cole;
pub mod curve;
pub mod davis;
pub mod propulsion;
