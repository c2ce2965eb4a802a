//! Irregularities of each rail: its offset from the designed line, across and down.
//!
//! | file | part |
//! |---|---|
//! | `file.rs` | the section `[irregularity]` of a track file, and what its values must be |
//! | `grid.rs` | values at equal distances, from a file of measured irregularities |
//! | `spectrum.rs` | random irregularities by a power spectral density and a seed |
//! | `shape.rs` | single defects: ramp, sine, dip |
//! | `rail_offset.rs` | what they come down to at a chainage |
//!
//! Across is positive to the right, down positive. The designed line is not touched: the train
//! model does not know irregularities.

mod file;
mod grid;
mod rail_offset;
mod shape;
mod spectrum;

pub use file::COLUMNS;
pub(crate) use file::Section;
pub use rail_offset::RailOffset;

use grid::Grid;
use shape::Shape;

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
