//! The rail-heat model against closed forms and published numbers.
//!
//! The closed forms V1 to V17 and the values of flash temperature and rail chill are those of
//! `docs/reference/conduction.md`; those of the section and of bending are in
//! `docs/reference/section.md`. Both were computed by programs that share no code with this one.
//! All with the paper's steel (k = 40, ρ = 7850, c = 450) unless stated.

/// The page that has the table of all comparisons.
pub const PAGE: validation::Page<'static> = validation::Page {
    path: "docs/validation/railheat.md",
    text: include_str!("../../../../docs/validation/railheat.md"),
};

mod along;
mod closed_forms;
mod common;
mod conduction;
mod contact_forms;
mod crown;
mod effects;
mod energy;
mod energy_common;
mod exact;
mod flash;
mod paper;
mod resolution;
mod section;
mod sections;
mod site;
mod staircase;
mod weather;
