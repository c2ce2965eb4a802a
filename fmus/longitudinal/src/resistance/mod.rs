//! Resistance to the motion of a vehicle.
//!
//! | file | part |
//! |---|---|
//! | `propulsion.rs` | on straight level track, with the wind |
//! | `curve.rs` | in curves |

pub mod curve;
pub mod propulsion;
