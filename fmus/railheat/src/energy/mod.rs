//! `model = "energy"`: heat that is conserved, in a real section (theory, second part).
//!
//! | file | part |
//! |---|---|
//! | `model.rs` | what happens in which order |
//! | `build.rs` | the model at its start |
//! | `view.rs` | what can be read of it |
//! | `parameters.rs` | all constants |
//! | `wheels.rs` | heat of friction, and the temperature of each wheel |
//! | `chill.rs` | conduction between wheel and rail |
//! | `bending.rs` | thermoelastic temperature change and hysteresis heat |
//! | `weather.rs` | heat exchanged with air, sky, sun and pad by each piece of surface |
//! | `sun.rs`, `light.rs` | the sun seen from the rail, its shadow, the light absorbed |
//! | `ephemeris.rs` | where the sun stands, by place and time |
//! | `shadow.rs` | the shadow of a vehicle on the rail |
//! | `zones.rs` | the directions in which the track runs |
//! | `untouched.rs` | rail that no wheel has touched |
//! | `initial.rs` | its temperatures at the start |
//! | `crown.rs` | where on the head a contact's heat goes |
//! | `readings.rs` | where in the section the rise is read |
//! | `propagator.rs` | one exact step of the modes |
//! | `elements.rs` | what each element has more than untouched rail |
//! | `followers.rs` | modes so fast that they follow the heat |
//! | `along.rs` | conduction along the track |
//! | `answer.rs` | highest foot rise, first detection, camera on the train |
//! | `surroundings.rs` | shade and wind of the train, and weather that has changed |
//! | `observe.rs` | what is read after each conduction |
//! | `ledger.rs` | heat by source, and the audit |

mod along;
pub mod answer;
pub mod bending;
pub mod build;
pub mod chill;
pub mod crown;
pub mod elements;
pub mod ephemeris;
pub mod followers;
pub mod initial;
pub mod ledger;
mod light;
pub mod model;
mod observe;
pub mod parameters;
pub mod propagator;
pub mod readings;
pub mod shadow;
pub mod sun;
mod surroundings;
pub mod untouched;
mod view;
pub mod weather;
pub mod wheels;
pub mod zones;
