//! The modelled length of rail: a column of cells for each element along the track.
//!
//! Columns that no wheel has touched see the same weather and share one reference column. They
//! are worked on in blocks of [`LANES`]; a block takes part once a wheel has heated one of its
//! elements.

use serde::{Deserialize, Serialize};

use super::column::{self, LANES};
use super::running_surface::RunningSurface;
use crate::line::{Highest, Line};
use crate::weather::Weather;

/// How the rail is cut along the track and over its depth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid {
    /// Elements along the track.
    pub line: Line,
    /// Size of a cell over the depth, m.
    pub cell_size: f64,
    /// Number of cells of a column.
    pub cells: usize,
}

impl Grid {
    /// Depth of the middle of a cell, m.
    pub fn depth(&self, cell: usize) -> f64 {
        (cell as f64 + 0.5) * self.cell_size
    }

    /// Number of blocks; the last one may have columns beyond the end, which no wheel touches.
    fn blocks(&self) -> usize {
        self.line.elements.div_ceil(LANES)
    }

    /// Number of columns of a block that are part of the rail.
    fn columns(&self, block: usize) -> usize {
        LANES.min(self.line.elements - block * LANES)
    }
}

/// A depth at which the rise is read: linear between the middles of two cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Level {
    above: usize,
    below: usize,
    share: f64,
}

impl Level {
    /// The cell at the surface: there the wheels set the temperature.
    pub const SURFACE: Self = Self { above: 0, below: 0, share: 0.0 };

    /// The lowest cell.
    pub fn foot(grid: &Grid) -> Self {
        Self { above: grid.cells - 1, below: grid.cells - 1, share: 0.0 }
    }

    /// A depth in m; above the first middle of a cell the surface, below the last one the foot.
    pub fn at_depth(grid: &Grid, depth: f64) -> Self {
        let last = grid.cells - 1;
        let position = (depth / grid.cell_size - 0.5).clamp(0.0, last as f64);
        let above = position as usize;
        Self { above, below: (above + 1).min(last), share: position - above as f64 }
    }

    /// The rise where `cell` gives that of each cell.
    #[inline]
    fn read(&self, cell: impl Fn(usize) -> f64) -> f64 {
        let above = cell(self.above);
        above + self.share * (cell(self.below) - above)
    }

    /// The highest rise of a block's first `columns` and its lane, if it is over `limit`.
    fn higher(&self, cells: &[f64], columns: usize, limit: f64) -> Option<(usize, f64)> {
        let rise = |lane: usize| self.read(|cell| cells[cell * LANES + lane]);
        // Eight at a time, which the compiler makes vector instructions of.
        let mut highest = [limit; 8];
        let whole = columns - columns % 8;
        for first in (0..whole).step_by(8) {
            for (lane, highest) in highest.iter_mut().enumerate() {
                let rise = rise(first + lane);
                *highest = if rise > *highest { rise } else { *highest };
            }
        }
        let highest = (whole..columns).map(rise).chain(highest).fold(limit, f64::max);
        let lane = (0..columns).find(|lane| highest > limit && rise(*lane) == highest)?;
        Some((lane, highest))
    }
}

/// Sums of temperature changes in K over cells, from one step of the rail.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Sums {
    /// Rise of all cells after the step.
    pub stored: f64,
    /// Change of all surface cells by the weather.
    pub weather: f64,
}

impl Sums {
    fn add(&mut self, times: f64, other: Self) {
        self.stored += times * other.stored;
        self.weather += times * other.weather;
    }
}

/// What the weather does to a surface cell in one step.
pub struct SurfaceStep<'w> {
    /// The surface.
    pub surface: &'w RunningSurface,
    /// The weather.
    pub weather: &'w Weather,
    /// Initial temperature of the rail, K.
    pub initial: f64,
    /// Rise of a cell by a flux of 1 W/m² in one step (`docs/theory/railheat/paper.md#eq-6`), K·m²/W.
    pub rise_per_flux: f64,
}

impl SurfaceStep<'_> {
    /// Change in one step of a surface cell that has risen by `rise`, K.
    #[inline]
    pub fn change(&self, rise: f64) -> f64 {
        self.rise_per_flux * self.surface.flux(self.initial + rise, self.weather)
    }
}

/// Rise of every cell above the initial temperature, K.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Rail {
    /// Block after block; in a block depth after depth; in a depth [`LANES`] columns.
    cells: Vec<f64>,
    /// Whether a wheel has heated an element of the block.
    touched: Vec<bool>,
    /// The reference column, [`LANES`] times the same, so that it is treated as the others are.
    untouched: Vec<f64>,
}

impl Rail {
    /// A rail at its initial temperature.
    pub fn new(grid: &Grid) -> Self {
        let block = grid.cells * LANES;
        Self {
            cells: vec![0.0; grid.blocks() * block],
            touched: vec![false; grid.blocks()],
            untouched: vec![0.0; block],
        }
    }

    /// Rise of the surface where no wheel has been, K.
    pub fn untouched_surface(&self) -> f64 {
        self.untouched[0]
    }

    /// Raises the surface of an element to `rise` if it is colder, and gives by how much.
    pub fn heat_surface(&mut self, element: usize, rise: f64) -> f64 {
        let (block, lane) = (element / LANES, element % LANES);
        let size = self.untouched.len();
        if !self.touched[block] {
            if rise <= self.untouched[0] {
                return 0.0;
            }
            self.cells[block * size..][..size].copy_from_slice(&self.untouched);
            self.touched[block] = true;
        }
        let surface = &mut self.cells[block * size + lane];
        let before = *surface;
        *surface = before.max(rise);
        *surface - before
    }

    /// One step of all columns: first the weather acts on the surfaces, then heat is conducted.
    /// The highest rise at each of `levels` after it goes into `highest`; it is looked for here
    /// because a block costs more to fetch from memory than to work on.
    pub fn step(
        &mut self,
        grid: &Grid,
        exchange: &SurfaceStep<'_>,
        number: f64,
        levels: &[Level],
        highest: &mut [Highest],
    ) -> Sums {
        let size = self.untouched.len();
        let of_untouched = step_block(&mut self.untouched, exchange, number, 1);
        let mut sums = Sums::default();
        highest.iter_mut().for_each(|highest| highest.rise = f64::NEG_INFINITY);
        for (block, cells) in self.cells.chunks_exact_mut(size).enumerate() {
            let columns = grid.columns(block);
            let cells = if self.touched[block] {
                sums.add(1.0, step_block(cells, exchange, number, columns));
                &*cells
            } else {
                sums.add(columns as f64, of_untouched);
                &self.untouched
            };
            for (highest, level) in highest.iter_mut().zip(levels) {
                if let Some((lane, rise)) = level.higher(cells, columns, highest.rise) {
                    let chainage = grid.line.chainage(block * LANES + lane);
                    *highest = Highest { rise, chainage };
                }
            }
        }
        sums
    }

    /// The rise of an element at a depth, K.
    pub fn rise(&self, element: usize, level: &Level) -> f64 {
        let (block, lane) = (self.block(element / LANES), element % LANES);
        level.read(|cell| block[cell * LANES + lane])
    }

    /// Sum of the rise over the cells of an element, K.
    pub fn sum(&self, element: usize) -> f64 {
        let (block, lane) = (self.block(element / LANES), element % LANES);
        block[lane..].iter().step_by(LANES).sum()
    }

    /// Writes all rises into `values`, the depths of the first element first.
    pub fn snapshot(&self, grid: &Grid, values: &mut [f32]) {
        for (element, column) in values.chunks_exact_mut(grid.cells).enumerate() {
            let (block, lane) = (self.block(element / LANES), element % LANES);
            for (value, rise) in column.iter_mut().zip(block[lane..].iter().step_by(LANES)) {
                *value = *rise as f32;
            }
        }
    }

    /// The cells of a block, those of the reference column if no wheel has touched it.
    fn block(&self, index: usize) -> &[f64] {
        let size = self.untouched.len();
        if self.touched[index] { &self.cells[index * size..][..size] } else { &self.untouched }
    }
}

/// One step of a block, of which the first `columns` count in the sums.
fn step_block(cells: &mut [f64], exchange: &SurfaceStep<'_>, number: f64, columns: usize) -> Sums {
    let mut change = [0.0; LANES];
    let (surface, _) = cells.split_at_mut(LANES);
    for lane in 0..LANES {
        change[lane] = exchange.change(surface[lane]);
        surface[lane] += change[lane];
    }
    let stored = column::conduct(cells, number);
    Sums { stored: stored[..columns].iter().sum(), weather: change[..columns].iter().sum() }
}
