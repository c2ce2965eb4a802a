//! The parameters: their tables, and what the models make of them.
//!
//! | file | part |
//! |---|---|
//! | `common.rs` | the modelled track, steel, surface, start and files |
//! | `paper.rs` | the constants of `model = "paper"` |
//! | `energy.rs` | the constants of `model = "energy"` |
//! | `site.rs` | where the track runs, where the sun stands, what day it is |
//! | `other_model.rs` | parameters that have no effect in the chosen model are refused |

pub(super) mod common;
pub(super) mod energy;
pub(super) mod other_model;
pub(super) mod paper;
pub(super) mod site;
