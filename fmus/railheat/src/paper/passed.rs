//! Which elements a wheel passes.
//!
//! A wheel heats every element that it touches between two times, from the one it stands on at
//! first to the one it stands on at last. So no element is missed, however fast the wheel or long
//! the step, and the result does not depend on the exchange step
//! (`property_the_field_does_not_depend_on_the_exchange_step`).

use std::ops::RangeInclusive;

use super::rail::Grid;

/// The elements between two chainages, in whichever order; none when all of it lies outside.
pub fn passed(grid: &Grid, from: f64, to: f64) -> Option<RangeInclusive<usize>> {
    let (low, high) = if from <= to { (from, to) } else { (to, from) };
    if high < grid.begin || low >= grid.end() {
        return None;
    }
    let element = |chainage: f64| ((chainage - grid.begin) / grid.element_length) as usize;
    let last = grid.elements - 1;
    Some(element(low.max(grid.begin)).min(last)..=element(high).min(last))
}
