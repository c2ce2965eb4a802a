//! `model = "energy"`: heat that is conserved, in a real section (theory, second part).
//!
//! | file | part |
//! |---|---|
//! | `model.rs` | what happens in which order |
//! | `build.rs` | the model at its start |
//! | `view.rs` | what can be read of it |
//! | `parameters.rs` | all constants |
//! | `bending.rs` | thermoelastic temperature change and hysteresis heat |
//! | `zones.rs` | the directions in which the track runs |
//! | `untouched.rs` | rail that no wheel has touched |
//! | `initial.rs`, `start.rs` | its temperatures at the start, and how they are found |
//! | `elements.rs` | what each element has more than untouched rail |
//! | `followers.rs` | modes so fast that they follow the heat |
//! | `along.rs` | conduction along the track |
//! | `kept_elements.rs`, `sections.rs` | the rise of the whole section at some places, and where the foot is warmest |
//! | `answer.rs` | highest foot rise, first detection, camera on the train |
//! | `surroundings.rs` | shade and wind of the train, and weather that has changed |
//! | `observe.rs` | what is read after each conduction |
//! | `ledger.rs` | heat by source, and the audit |

mod along;
mod answer;
mod bending;
mod build;
mod elements;
mod followers;
mod initial;
mod kept_elements;
mod ledger;
mod model;
mod observe;
mod parameters;
mod sections;
mod start;
mod surroundings;
mod untouched;
mod view;
mod zones;

pub use answer::{Answer, Finding};
pub use bending::Beam;
pub use build::CannotBegin;
pub use initial::Initial;
pub use ledger::{Ledger, Sources};
pub use model::{EnergyModel, LONGEST_IDLE, State};
pub use parameters::{Parameters, Resolution, Start, TrainWeather};
pub use start::{Day, NeverSettles};
pub use zones::{Azimuth, SECTOR, Sector, sectors};
