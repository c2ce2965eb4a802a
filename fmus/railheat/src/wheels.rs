//! Which elements a wheel passes.
//!
//! A wheel heats every element that it touches between two times, from the one it stands on at
//! first to the one it stands on at last. So no element is missed, however fast the wheel or long
//! the step, and the result does not depend on the exchange step
//! (`property_the_field_does_not_depend_on_the_exchange_step`).

use std::ops::RangeInclusive;

use crate::creep_force::Contact;
use crate::rail::Grid;

/// What a wheel does during a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wheel {
    /// Chainage at the end of the step, m.
    pub position: f64,
    /// Running speed, m/s.
    pub speed: f64,
    /// Longitudinal creepage (wheel - rail) / speed.
    pub creepage: f64,
    /// Contact with the rail.
    pub contact: Contact,
    /// Friction power of the contact, W.
    pub friction_power: f64,
    /// Place of the contact on the head, to the right of its middle, m.
    pub lateral_position: f64,
    /// Heat of the tread brake into the wheel, W.
    pub brake_power: f64,
}

impl Wheel {
    /// Whether there is no such wheel now: it neither runs nor carries, as before the train has come
    /// and between two trains. A wheel that is there again comes with its speed, and has the
    /// temperature that wheels have at the start.
    pub fn is_absent(&self) -> bool {
        self.speed == 0.0 && self.contact.normal_force == 0.0
    }

    /// Where the wheel is for the next step, if it is there, m.
    pub fn place(&self) -> Option<f64> {
        (!self.is_absent()).then_some(self.position)
    }
}

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
