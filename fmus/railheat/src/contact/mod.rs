//! A wheel on the rail: its contact, the heat of its friction, and its own temperature.
//!
//! | file | part |
//! |---|---|
//! | `wheel.rs` | what a wheel does |
//! | `material.rs` | the steel of rail and wheel |
//! | `creep_force.rs` | longitudinal creep force |
//! | `flash.rs` | temperature rise of the rail's surface under a wheel |
//! | `chill.rs` | conduction between wheel and rail |
//! | `wheel_heat.rs` | heat of friction, and the temperature of each wheel |

pub mod chill;
mod creep_force;
mod flash;
mod material;
mod wheel;
mod wheel_heat;

pub use creep_force::{Contact, creep_force, kalker_c11};
pub use flash::{Friction, HERTZ_PEAK, MEAN_OVER_PEAK, flash_rise};
pub use material::Material;
pub use wheel::Wheel;
pub use wheel_heat::WheelHeat;
