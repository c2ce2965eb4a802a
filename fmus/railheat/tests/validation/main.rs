//! The rail-heat model against closed forms and published numbers.
//!
//! Sources: V1 to V16 and the sections named are those of `docs/theory/railheat`, whose
//! reference values were computed independently of this code. All with the paper's steel
//! (k = 40, ρ = 7850, c = 450) unless stated.

mod along;
mod closed_forms;
mod common;
mod conduction;
mod contact_forms;
mod effects;
mod energy;
mod energy_common;
mod exact;
mod flash;
mod paper;
mod resolution;
mod section;
mod site;
mod staircase;
mod weather;
