//! The section cut into cells (finite volumes with cut cells).
//!
//! Capacities, conductances and surface are those of `docs/theory/railheat/energy.md#eq-8`.
//! The cells are a grid of rectangles, of which the outline cuts off what is not steel. A cell keeps the area of its steel; two neighbours are joined by what of their common side is
//! steel over the distance of the rectangles' middles; the pieces of the outline in a cell are its
//! surface. A column (one cell a row, as wide as the rail) is the same with one rectangle a row:
//! area by depth. Slivers are merged into the neighbour that they share most with. That shifts their steel by up to a
//! cell, so that only the least are: merging what has up to a tenth of a cell made the foot's rise jump by 0.2 mK
//! in 180 from one size of cells to the next.
//! The right half is the left one mirrored, to the last bit, as the outline is: the modes rely on it.
//! Validated by `analytic_cut_cells_…` and `benchmark_section_…`.

use super::clip::{Rectangle, clip};
use super::outline::{Outline, Point, sides};

/// Cells with less than this share of steel are merged.
const SMALLEST_SHARE: f64 = 0.001;

/// Less steel than this share is rounding of positions on the grid.
const LEAST_SHARE: f64 = 1e-9;

/// Slack in comparing positions, m.
const SAME_POSITION: f64 = 1e-9;

/// A cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cell {
    /// Middle of its rectangle.
    pub middle: Point,
    /// Area of steel, m².
    pub area: f64,
    /// Row counted from the crown.
    pub row: usize,
}

/// Two neighbouring cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Link {
    /// The cells.
    pub cells: [usize; 2],
    /// Common side over distance; times the conductivity it is the conductance, W/(m·K).
    pub ratio: f64,
}

/// A straight piece of the outline in one cell.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Facet {
    /// The cell behind it.
    pub cell: usize,
    /// Ends.
    pub ends: [Point; 2],
    /// Length, m.
    pub length: f64,
    /// Outward normal: y to the right, z downwards.
    pub normal: Point,
}

impl Facet {
    /// The middle of the piece.
    pub fn middle(&self) -> Point {
        let [a, b] = self.ends;
        Point { y: 0.5 * (a.y + b.y), z: 0.5 * (a.z + b.z) }
    }
}

/// The section in cells.
#[derive(Clone, Debug, PartialEq)]
pub struct Cells {
    /// The cells, row after row from the crown.
    pub cells: Vec<Cell>,
    /// Which cells touch.
    pub links: Vec<Link>,
    /// The surface.
    pub facets: Vec<Facet>,
    /// For each cell the one opposite, mirrored at the middle; on the middle the cell itself.
    pub mirror: Vec<usize>,
    /// Height of the rail, m.
    pub height: f64,
    /// Number of rows.
    pub rows: usize,
}

impl Cells {
    /// Cuts an outline into cells of about this size.
    pub fn grid(outline: &Outline, size: f64) -> Self {
        let columns = (2.0 * outline.half_width() / size).ceil().max(1.0) as usize;
        Self::cut(outline, columns, size)
    }

    /// Cuts an outline into rows of about this height, one cell each.
    pub fn column(outline: &Outline, size: f64) -> Self {
        Self::cut(outline, 1, size)
    }

    fn cut(outline: &Outline, columns: usize, size: f64) -> Self {
        let height = outline.height();
        let rows = (height / size).round().max(2.0) as usize;
        let step_z = height / rows as f64;
        let width = if columns == 1 { 2.0 * outline.half_width() } else { size };
        let left = -0.5 * columns as f64 * width;
        let mut grid =
            Grid { parts: vec![Part::default(); rows * columns], columns, width, step_z };
        for row in 0..rows {
            for column in 0..columns.div_ceil(2) {
                let (y, z) = (left + column as f64 * width, row as f64 * step_z);
                let rectangle = Rectangle { y: [y, y + width], z: [z, z + step_z] };
                let part = Part::cut(outline, rectangle, row);
                let index = row * columns + column;
                let opposite = grid.mirror(index);
                grid.parts[opposite] = part.mirrored();
                grid.parts[index] = part;
            }
            // The right side of a rectangle is the left side of the one opposite.
            for column in columns / 2..columns - 1 {
                let index = row * columns + column;
                grid.parts[index].right = grid.parts[grid.mirror(index + 1)].right;
            }
        }
        let owner = grid.merge();
        grid.assemble(&owner, height, rows)
    }

    /// Area of all cells, m².
    pub fn area(&self) -> f64 {
        self.cells.iter().map(|cell| cell.area).sum()
    }
}

/// What of the section lies in one rectangle.
#[derive(Clone, Debug, Default)]
struct Part {
    middle: Point,
    row: usize,
    area: f64,
    /// Steel on the right and on the lower side, m.
    right: f64,
    below: f64,
    /// Pieces of the outline.
    surface: Vec<[Point; 2]>,
}

impl Part {
    fn cut(outline: &Outline, rectangle: Rectangle, row: usize) -> Self {
        let Rectangle { y, z } = rectangle;
        let middle = Point { y: 0.5 * (y[0] + y[1]), z: 0.5 * (z[0] + z[1]) };
        let mut part = Self { middle, row, ..Self::default() };
        let height = outline.height();
        let lies = |a: f64, b: f64, at: f64| (a - at).abs() + (b - at).abs() < SAME_POSITION;
        for (a, b) in sides(&clip(outline.points(), &rectangle)) {
            part.area += (a.y * b.z - b.y * a.z) / 2.0;
            if libm::hypot(b.y - a.y, b.z - a.z) < SAME_POSITION {
                continue;
            }
            let foot = lies(a.z, b.z, height);
            // The signs make sides that are run through both ways cancel.
            if lies(a.y, b.y, y[1]) && !on_outline(outline, a, b) {
                part.right += b.z - a.z;
            } else if lies(a.z, b.z, z[1]) && !foot {
                part.below += a.y - b.y;
            } else if !(lies(a.y, b.y, y[0]) && !on_outline(outline, a, b)
                || lies(a.z, b.z, z[0]) && z[0] > 0.0)
            {
                part.surface.push([a, b]);
            }
        }
        let whole = (y[1] - y[0]) * (z[1] - z[0]);
        if part.area > LEAST_SHARE * whole { part } else { Self { middle, row, ..Self::default() } }
    }

    /// The same on the other side of the middle, but for what it has in common with its right
    /// neighbour.
    fn mirrored(&self) -> Self {
        let opposite = |point: Point| Point { y: -point.y, z: point.z };
        // Run through the other way, so that the steel stays on the same side.
        let surface = self.surface.iter().map(|[a, b]| [opposite(*b), opposite(*a)]).collect();
        Self { middle: opposite(self.middle), right: 0.0, surface, ..*self }
    }
}

/// Whether a vertical side is part of the outline, such as the toe of the foot or the web.
fn on_outline(outline: &Outline, a: Point, b: Point) -> bool {
    let (low, high) = (a.z.min(b.z), a.z.max(b.z));
    outline.sides().any(|(from, to)| {
        let upright = (from.y - a.y).abs() < SAME_POSITION && (to.y - a.y).abs() < SAME_POSITION;
        let (top, bottom) = (from.z.min(to.z), from.z.max(to.z));
        upright && top < low + SAME_POSITION && bottom > high - SAME_POSITION
    })
}

/// The rectangles before merging.
struct Grid {
    parts: Vec<Part>,
    columns: usize,
    width: f64,
    step_z: f64,
}

impl Grid {
    /// Pairs of rectangles with their ratio of common side to distance.
    fn joints(&self) -> Vec<([usize; 2], f64)> {
        let mut joints = vec![];
        for (index, part) in self.parts.iter().enumerate() {
            if part.right > SAME_POSITION {
                joints.push(([index, index + 1], part.right / self.width));
            }
            if part.below > SAME_POSITION {
                joints.push(([index, index + self.columns], part.below / self.step_z));
            }
        }
        joints
    }

    /// The rectangle opposite.
    fn mirror(&self, index: usize) -> usize {
        let column = index % self.columns;
        index + self.columns - 1 - 2 * column
    }

    /// For each rectangle the one whose cell it belongs to.
    fn merge(&self) -> Vec<usize> {
        let joints = self.joints();
        let smallest = SMALLEST_SHARE * self.width.min(self.step_z) * self.step_z;
        let mut owner: Vec<usize> = (0..self.parts.len()).collect();
        for (index, part) in self.parts.iter().enumerate() {
            let opposite = self.mirror(index);
            if index > opposite || part.area <= 0.0 || part.area >= smallest {
                continue;
            }
            // What lies on the middle stays there.
            let may_own = |other: usize| {
                self.parts[other].area >= smallest
                    && (index != opposite || self.mirror(other) == other)
            };
            let neighbour = |(pair, ratio): &([usize; 2], f64)| {
                let other = match *pair {
                    [a, b] if a == index => b,
                    [a, b] if b == index => a,
                    _ => return None,
                };
                may_own(other).then_some((other, *ratio))
            };
            let best = joints.iter().filter_map(neighbour).max_by(|a, b| a.1.total_cmp(&b.1));
            if let Some((other, _)) = best {
                owner[index] = other;
                owner[opposite] = self.mirror(other);
            }
        }
        owner
    }

    fn assemble(self, owner: &[usize], height: f64, rows: usize) -> Cells {
        let mut number = vec![usize::MAX; self.parts.len()];
        let mut cells = vec![];
        for (index, part) in self.parts.iter().enumerate() {
            if owner[index] == index && part.area > 0.0 {
                number[index] = cells.len();
                cells.push(Cell { middle: part.middle, area: 0.0, row: part.row });
            }
        }
        let cell_of = |index: usize| number[owner[index]];
        let mut facets = vec![];
        for (index, part) in self.parts.iter().enumerate().filter(|(_, part)| part.area > 0.0) {
            cells[cell_of(index)].area += part.area;
            facets.extend(part.surface.iter().map(|ends| facet(cell_of(index), *ends)));
        }
        let links = self
            .joints()
            .into_iter()
            .map(|(pair, ratio)| Link { cells: pair.map(cell_of), ratio })
            .filter(|link| link.cells[0] != link.cells[1])
            .collect();
        let own = (0..self.parts.len()).filter(|index| number[*index] != usize::MAX);
        let mirror = own.map(|index| number[self.mirror(index)]).collect();
        Cells { cells, links, facets, mirror, height, rows }
    }
}

fn facet(cell: usize, ends: [Point; 2]) -> Facet {
    let [a, b] = ends;
    let length = libm::hypot(b.y - a.y, b.z - a.z);
    let normal = Point { y: (b.z - a.z) / length, z: -(b.y - a.y) / length };
    Facet { cell, ends, length, normal }
}
