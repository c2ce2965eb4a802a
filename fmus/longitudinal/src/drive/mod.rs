//! The drive of a locomotive.
//!
//! | file | part |
//! |---|---|
//! | `lever.rs` | the lever of a drive, which follows the command at a limited rate |
//! | `traction.rs` | tractive effort by notch and speed |
//! | `dynamic_brake.rs` | the motors as generators |

pub mod dynamic_brake;
pub mod lever;
pub mod traction;
