//! The section once more by a method that has nothing in common with the model's: rectangles that are wholly steel or
//! wholly air, stepped explicitly. It is what the finite volumes of `docs/reference/section.md` are like, and says
//! where its numbers come from.

use railheat::contact::Material;
use railheat::section::{Cells, Modes, Outline};

use crate::energy_common::outline;

/// A section of rectangles with the rise over that when mixed.
struct Staircase {
    width: f64,
    height: f64,
    columns: usize,
    rows: usize,
    steel: Vec<bool>,
    rise: Vec<f64>,
    other: Vec<f64>,
    now: f64,
}

impl Staircase {
    /// Rectangles whose middles lie in the outline, with an impulse on 30 mm of the crown.
    fn new(outline: &Outline, width: f64, height: f64) -> Self {
        let columns = 2 * (outline.half_width() / width).ceil() as usize;
        let rows = (outline.height() / height).round() as usize;
        let middle = |column: usize| (column as f64 + 0.5 - 0.5 * columns as f64) * width;
        let is_steel = |index: usize| {
            let (y, z) = (middle(index % columns), ((index / columns) as f64 + 0.5) * height);
            let crossings = outline.sides().filter(|(a, b)| {
                (a.z > z) != (b.z > z) && a.y + (z - a.z) / (b.z - a.z) * (b.y - a.y) > y
            });
            crossings.count() % 2 == 1
        };
        let steel: Vec<bool> = (0..rows * columns).map(is_steel).collect();
        let pieces = steel.iter().filter(|is_steel| **is_steel).count();
        let mut rise = vec![0.0; steel.len()];
        let band: Vec<usize> = (0..columns).filter(|c| middle(*c).abs() < 0.015).collect();
        for column in &band {
            let top = (0..rows).map(|row| row * columns + column).find(|index| steel[*index]);
            rise[top.unwrap()] = pieces as f64 / band.len() as f64;
        }
        Self { width, height, columns, rows, other: rise.clone(), rise, steel, now: 0.0 }
    }

    fn go_to(&mut self, time: f64) {
        let alpha = Material::PAPER.diffusivity();
        let smallest = self.width.min(self.height);
        let steps = ((time - self.now) * alpha / (0.2 * smallest * smallest)).ceil();
        let number = |size: f64| alpha * (time - self.now) / steps / (size * size);
        let (across, down) = (number(self.width), number(self.height));
        for _ in 0..steps as u64 {
            for index in (0..self.steel.len()).filter(|index| self.steel[*index]) {
                let (row, column) = (index / self.columns, index % self.columns);
                let here = self.rise[index];
                let mut sum = 0.0;
                for (is_inside, neighbour, number) in [
                    (row > 0, index.wrapping_sub(self.columns), down),
                    (row + 1 < self.rows, index + self.columns, down),
                    (column > 0, index.wrapping_sub(1), across),
                    (column + 1 < self.columns, index + 1, across),
                ] {
                    if is_inside && self.steel[neighbour] {
                        sum += number * (self.rise[neighbour] - here);
                    }
                }
                self.other[index] = here + sum;
            }
            std::mem::swap(&mut self.rise, &mut self.other);
        }
        self.now = time;
    }

    /// On the middle line, linear between the middles of rows.
    fn at(&self, depth: f64) -> f64 {
        let index = (depth / self.height - 0.5).clamp(0.0, (self.rows - 1) as f64);
        let value = |row: usize| self.rise[row * self.columns + self.columns / 2];
        let above = index as usize;
        let share = index - above as f64;
        (1.0 - share) * value(above) + share * value((above + 1).min(self.rows - 1))
    }
}

/// What the model's section makes of the same impulse, at depths and a time.
fn of_modes(outline: &Outline, size: f64, depths: [f64; 3], time: f64) -> [f64; 3] {
    let cells = Cells::grid(outline, size);
    let insulated = vec![0.0; cells.facets.len()];
    let modes = Modes::new(&cells, &Material::PAPER, &insulated, size).unwrap();
    let on_band = |facet: &&railheat::section::Facet| {
        facet.normal.z < 0.0 && facet.middle().y.abs() < 0.015 && facet.middle().z < 0.016
    };
    let band: Vec<_> = cells.facets.iter().filter(on_band).collect();
    let length: f64 = band.iter().map(|facet| facet.length).sum();
    let heat = modes.weighted(band.iter().map(|facet| (facet.cell, facet.length / length)));
    let mixture = 1.0 / (Material::PAPER.heat_capacity() * cells.area());
    let readings = railheat::section::Readings::new(&cells, &modes, &depths);
    [1, 2, 3].map(|level| {
        let shape = &readings.levels[level];
        let of_mode = |k: usize| shape[k] * heat[k] * (-modes.rates[k] * time).exp();
        (0..modes.count).map(of_mode).sum::<f64>() / mixture
    })
}

/// Two methods, one section: 8, 16 and 32 rectangles over the web's 16.5 mm come to the model's result with an error of
/// first order in their size, since they cut the slopes into stairs. 60 mm deep, in the middle of the web and at the foot
/// the limit of the last two is the model's with cells of 3 mm within 2 %, or 3e-4 of the rise when mixed where the
/// heat just arrives (0.1 mK after a train on R 800 m); the model's own error is of second order.
#[test]
fn benchmark_section_against_stairs() {
    let outline = outline("60E1");
    let depths = [0.060, 0.092, 0.171];
    let (mut found, times) = (vec![], [100.0, 200.0]);
    for count in [8.0, 16.0, 32.0] {
        let mut section = Staircase::new(&outline, 0.0165 / count, 0.172 / (10.75 * count));
        found.push(times.map(|time| {
            section.go_to(time);
            depths.map(|depth| section.at(depth))
        }));
    }
    for (step, time) in times.into_iter().enumerate() {
        let model = of_modes(&outline, 0.003, depths, time);
        for (index, model) in model.into_iter().enumerate() {
            let [coarse, middle, fine] = [0, 1, 2].map(|size: usize| found[size][step][index]);
            let limit = 2.0 * fine - middle;
            let depth = depths[index];
            println!(
                "{time} s, {depth} m: stairs {coarse:.5} {middle:.5} {fine:.5} -> {limit:.5}, model {model:.5}"
            );
            assert!((model - limit).abs() < 0.02 * limit + 3e-4, "{time} s, {depth} m");
        }
    }
}

/// The table of `docs/reference/section.md` (UIC60 outline, squares of 2 mm) is that of such squares, read in the row whose upper side is
/// at the depth named: its "60 mm deep" is 61 mm deep, its "mid web (z = 80)" stands 79 mm above the foot. Its outline
/// is another than ours, by up to 1 mm in the fillets (rounded to mm), which makes the rest: the heat comes
/// 9 % stronger to 60 mm at 30 s with ours, and 3 % at 100 s. The same squares on that page's outline meet its rows
/// within 2.5 % (docs/validation).
#[test]
fn benchmark_what_the_reference_read() {
    let mut section = Staircase::new(&outline("60E1"), 0.002, 0.002);
    for (time, deep, web, foot, allowed) in [
        (30.0, 0.341, 0.010, 0.0, 0.09),
        (100.0, 1.309, 0.449, 0.0039, 0.04),
        (200.0, 1.514, 0.842, 0.0633, 0.02),
        (600.0, 1.393, 1.021, 0.388, 0.02),
        (1800.0, 1.107, 1.006, 0.834, 0.01),
    ] {
        section.go_to(time);
        let found = [section.at(0.061), section.at(0.093), section.at(0.171)];
        println!("{time} s: {found:.4?}, reference {deep} {web} {foot}");
        for (found, wanted) in found.into_iter().zip([deep, web, foot]) {
            assert!((found - wanted).abs() < allowed * wanted + 5e-4, "{time} s: {found} {wanted}");
        }
    }
}
