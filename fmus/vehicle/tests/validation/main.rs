//! The vehicle against known answers. Each test: case, expected value and its source, tolerance
//! and why.
//!
//! | file | what |
//! |---|---|
//! | `statics.rs` | the representative Co-Co locomotive against independent figures: loads, modes |
//! | `running.rs` | balances of force, moment and energy; Klingel; free curving |
//! | `starting.rs` | the start in equilibrium, in tight curves and at standstill |
//! | `stepping.rs` | convergence of the step, any speed, saved states |
//! | `contacts.rs` | several contacts a wheel, wheels off their rails |
//! | `manchester.rs` | creepages of the Manchester contact benchmark |
//! | `vehicles.rs` | all vehicles of the stock library; the track under them; critical speeds |
//! | `acceptance.rs` | the acceptance scenarios |
//! | `common.rs` | vehicles and tracks of the tests |

mod acceptance;
mod common;
mod contacts;
mod manchester;
mod running;
mod starting;
mod statics;
mod stepping;
mod vehicles;
