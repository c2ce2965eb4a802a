//! The vehicle against known answers. Each test: case, expected value and its source, tolerance
//! and why.
//!
//! | file | what |
//! |---|---|
//! | `reference_set.rs` | the representative Co-Co locomotive against independent figures |
//! | `contacts.rs` | several contacts a wheel, wheels off their rails |
//! | `manchester.rs` | creepages of the Manchester contact benchmark |
//! | `vehicles.rs` | all vehicles of the stock library; the track under them; critical speeds |
//! | `acceptance.rs` | the acceptance scenarios |
//! | `common.rs` | vehicles and tracks of the tests |

mod acceptance;
mod common;
mod contacts;
mod manchester;
mod reference_set;
mod vehicles;
