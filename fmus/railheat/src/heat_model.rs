//! What every heat model of the rail can do.

use crate::contact::Wheel;
use crate::line::{Highest, Line, Stray};
use crate::section::Cell;
use crate::weather::Weather;

/// The whole section, and where its rise is kept.
#[derive(Clone, Debug, PartialEq)]
pub struct KeptSections<'m> {
    /// Chainage of each place, m; there may be none.
    pub chainages: Vec<f64>,
    /// The cells of the section.
    pub cells: &'m [Cell],
    /// Width of their rectangles, m.
    pub cell_width: f64,
    /// Whether the field side is to the right.
    pub field_side_is_right: bool,
}

/// The heat of one rail: a step, and what is read after it.
///
/// A level is a depth at which the rise is read: surface, the depths asked for, foot, in this order.
pub trait HeatModel {
    /// Its name, as the parameter `model` has it.
    fn name(&self) -> &'static str;

    /// One step with the wheels as they are at its end and the weather meanwhile.
    ///
    /// Before the first step a wheel is taken to have come with its speed. The first loaded wheel
    /// that stands outside the modelled track is given back, once in a run; the rail feels wheels
    /// only while they are on it.
    fn step(
        &mut self,
        wheels: &[Wheel],
        weather: &Weather,
        start: f64,
        length: f64,
    ) -> Option<Stray>;

    /// The elements along the track.
    fn line(&self) -> &Line;

    /// Temperature of the running surface at the start, K.
    fn initial_temperature(&self) -> f64;

    /// Depths of a snapshot's values, m.
    fn depths(&self) -> Vec<f64>;

    /// Writes the rises in K into `values`, the depths of the first element first.
    fn snapshot(&self, values: &mut [f32]);

    /// The whole section and where its rise is kept, if the model has one and is to keep it.
    fn kept_sections(&self) -> Option<KeptSections<'_>> {
        None
    }

    /// Writes the rises of the section where the foot is warmest in K, and gives its chainage in m.
    fn warmest_section(&self, _values: &mut [f32]) -> f64 {
        0.0
    }

    /// Writes the rises of the section at these places in K, the cells of the first place first.
    fn sections(&self, _values: &mut [f32]) {}

    /// The rise of an element over the initial state at a level, K.
    fn rise(&self, element: usize, level: usize) -> f64;

    /// The highest rise at each level.
    fn highest(&self) -> &[Highest];

    /// The highest flash temperature rise of any wheel in the last step, K.
    fn highest_flash(&self) -> f64;

    /// The rise of the surface where no wheel has been, K.
    fn untouched_surface(&self) -> f64;

    /// Heat above the initial state per metre of rail at an element, J/m.
    fn heat_per_metre(&self, element: usize) -> f64;
}
