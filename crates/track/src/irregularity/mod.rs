//! Irregularities of each rail: its offset from the designed line, across and down.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the section `[irregularity]` of a track file, and what its values must be |
//! | `grid.rs` | values at equal distances, from a file of measured irregularities |
//! | `spectrum.rs` | random irregularities by a power spectral density and a seed |
//! | `shape.rs` | single defects: ramp, sine, dip |
//!
//! Across is positive to the right, down positive. The designed line is not touched: the train
//! model does not know irregularities.

mod file;
mod grid;
mod shape;
mod spectrum;

pub(crate) use file::Section;

use grid::Grid;
use shape::Shape;

/// Offset of one rail from its designed line, and the change of the offset along the track.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RailOffset {
    /// Across, to the right, m.
    pub lateral: f64,
    /// Down, m.
    pub vertical: f64,
    /// Change of `lateral` along the track, m/m.
    pub lateral_slope: f64,
    /// Change of `vertical` along the track, m/m.
    pub vertical_slope: f64,
}

/// Irregularities of both rails.
#[derive(Clone, Debug, Default)]
pub struct Irregularity {
    grid: Option<Grid>,
    shapes: Vec<Shape>,
}

impl Irregularity {
    /// Whether both rails lie where they are designed.
    pub fn is_none(&self) -> bool {
        self.grid.is_none() && self.shapes.is_empty()
    }

    /// The left and the right rail at a chainage.
    #[inline]
    pub fn at(&self, chainage: f64) -> [RailOffset; 2] {
        let mut rails = match &self.grid {
            Some(grid) => grid.at(chainage),
            None => [RailOffset::default(); 2],
        };
        for shape in &self.shapes {
            shape.add_to(&mut rails, chainage);
        }
        rails
    }
}
