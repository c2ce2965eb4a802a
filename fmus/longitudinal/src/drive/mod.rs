//! The drive of a locomotive.
//!
//! | file | part |
//! |---|---|
//! | `lever.rs` | the drive on its way to what the driver asks for |
//! | `traction.rs` | tractive effort by notch and speed |
//! | `dynamic_brake.rs` | the motors as generators |

pub mod dynamic_brake;
pub mod lever;
pub mod traction;
