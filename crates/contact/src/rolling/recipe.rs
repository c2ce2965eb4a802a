//! How the table of the creep law is made: a ray of growing creepage at a time.

use super::grid::Cells;
use super::solver::{LANES, RollingContact, RollingForces, RollingMotion, SPIN_AHEAD};
use crate::creep::rolling_table::{self, FILE, HEAD_BYTES, NODES, Node};
use crate::kalker::CreepCoefficients;
use crate::material::STEEL;
use std::f64::consts::PI;

/// Distance from the ends 0 and 1 of a coordinate at which ratios with a vanishing creepage are taken.
const EDGE: f64 = 0.02;

/// The same over size: a two-hundredth of saturation.
const LEAST_SIZE: f64 = 0.005;

/// Share of the power below which the grid does not resolve the slip zone.
const RESOLVED: f64 = 0.7;

/// Elements along each axis of a circle.
const ELEMENTS: usize = 24;

/// One ray of the table: all sizes of a motion at these indices over direction, spin and shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Ray {
    /// Index over the direction.
    pub direction: usize,
    /// Index over the part of the spin.
    pub spin: usize,
    /// Index over the shape.
    pub shape: usize,
}

impl Ray {
    /// All rays of the table.
    pub fn all() -> Vec<Self> {
        let [_, directions, spins, shapes] = NODES;
        let rays = (0..directions * spins * shapes).map(|index| Self {
            direction: index % directions,
            spin: index / directions % spins,
            shape: index / directions / spins,
        });
        rays.collect()
    }
}

/// The file of the table from the nodes of all rays.
pub fn file(rays: &[(Ray, Vec<[f32; 8]>)]) -> Vec<u8> {
    let count: usize = NODES.iter().product();
    let mut nodes = vec![[0.0_f32; 8]; count];
    for (ray, of_ray) in rays {
        for (size, node) in of_ray.iter().enumerate() {
            nodes[rolling_table::index_of([size, ray.direction, ray.spin, ray.shape])] = *node;
        }
    }
    let bytes: Vec<u8> = nodes.iter().flatten().flat_map(|value| value.to_le_bytes()).collect();
    let mut file = hash(&bytes).to_le_bytes().to_vec();
    file.extend(bytes);
    file
}

/// Whether the shipped table was made by this recipe, and is whole.
pub fn shipped_is_whole() -> bool {
    let (head, nodes) = FILE.split_at(HEAD_BYTES);
    head == hash(nodes).to_le_bytes()
}

/// A node of the shipped table.
pub fn shipped(ray: Ray, size: usize) -> [f32; 8] {
    rolling_table::stored(rolling_table::index_of([size, ray.direction, ray.spin, ray.shape]))
}

/// One node of a ray, solved by itself.
pub fn node(ray: Ray, size: usize) -> [f32; 8] {
    Solver::new(ray).node(size)
}

/// Hash of the recipe and of the nodes (FNV-1a).
fn hash(nodes: &[u8]) -> u64 {
    let recipe = format!(
        "{NODES:?} {EDGE} {LEAST_SIZE} {RESOLVED} {ELEMENTS} {SPIN_AHEAD} {}",
        STEEL.poisson_ratio
    );
    recipe.bytes().chain(nodes.iter().copied()).fold(0xcbf2_9ce4_8422_2325, |hash, byte| {
        (hash ^ u64::from(byte)).wrapping_mul(0x0000_0100_0000_01b3)
    })
}

/// The nodes of a ray, by size.
pub fn nodes(ray: Ray) -> Vec<[f32; 8]> {
    let sizes = NODES[0];
    let mut solver = Solver::new(ray);
    let mut nodes: Vec<Node> = (0..sizes).map(|size| solver.node(size)).collect();
    // Where the slip zone is too short for the grid, its heat is as next to it.
    for size in (0..sizes - 1).rev() {
        if solver.resolved[size] < RESOLVED {
            nodes[size][6] = nodes[size + 1][6];
            nodes[size][7] = nodes[size + 1][7];
        }
    }
    nodes
}

/// Solves along a ray.
struct Solver {
    ray: Ray,
    a_over_b: f64,
    /// For lateral creepage with spin and against it.
    contacts: [RollingContact; 2],
    resolved: Vec<f64>,
}

impl Solver {
    fn new(ray: Ray) -> Self {
        let a_over_b = rolling_table::shape_at(share(ray.shape, 3));
        let contact = || RollingContact::new(a_over_b, STEEL.poisson_ratio, cells(a_over_b));
        let contacts = [contact(), contact()];
        Self { ray, a_over_b, contacts, resolved: Vec::new() }
    }

    fn node(&mut self, size: usize) -> Node {
        let m = rolling_table::size_at(share(size, 0)).max(LEAST_SIZE);
        let Ray { direction, spin, .. } = self.ray;
        let (direction, tilt) = (share(direction, 1), share(spin, 2));
        let direction = direction.clamp(EDGE, 1.0 - EDGE);
        let tilt = tilt.clamp(EDGE, 1.0 - EDGE);
        let slide = m * (1.0 - tilt) / libm::hypot(tilt, 1.0 - tilt);
        let nz = m * tilt / libm::hypot(tilt, 1.0 - tilt);
        let diagonal = libm::hypot(direction, 1.0 - direction);
        let (nx, ny) = (slide * (1.0 - direction) / diagonal, slide * direction / diagonal);
        let mut solve = |against: usize| {
            let lateral = if against == 1 { -ny } else { ny };
            solved(&mut self.contacts[against], self.a_over_b, [nx, lateral, nz])
        };
        let (with, against) = (solve(0), solve(1));
        self.resolved.push(with.resolved.min(against.resolved));
        let q = (1.0 + m * m).sqrt();
        let mean = |of: fn(&RollingForces) -> f64| 0.5 * (of(&with) + of(&against));
        let half = |of: fn(&RollingForces) -> f64| 0.5 * (of(&with) - of(&against));
        let flash = (m / (1.0 + m)).sqrt();
        // Without lateral creepage, or without spin, both signs are one motion.
        let turned = if self.ray.direction == 0 || self.ray.spin == 0 { 0.0 } else { 1.0 };
        let ratios = [
            mean(|forces| forces.longitudinal) * q / nx,
            half(|forces| forces.lateral) * q / ny,
            mean(|forces| forces.lateral) * q / nz,
            mean(|forces| forces.moment) * q / nz,
            half(|forces| forces.moment) * q / ny,
            turned * half(|forces| forces.longitudinal) * q / nx,
            mean(|forces| forces.flash) * flash,
            turned * half(|forces| forces.flash) * flash,
        ];
        ratios.map(|ratio| ratio as f32)
    }
}

/// Share of the range of a coordinate.
fn share(index: usize, coordinate: usize) -> f64 {
    index as f64 / (NODES[coordinate] - 1) as f64
}

/// Elements of an ellipse: nearly square ones on contacts that are not too slender.
fn cells(a_over_b: f64) -> Cells {
    let stretch = a_over_b.sqrt().sqrt();
    let count = |factor: f64| ELEMENTS as f64 * factor.clamp(0.66, 1.34);
    let along = (count(stretch) / LANES as f64).round() as usize * LANES;
    Cells { along, across: (count(1.0 / stretch) / 2.0).round() as usize * 2 }
}

/// Forces at the motion (nx, ny, nz) of C15; the moment is by mu N R.
fn solved(contact: &mut RollingContact, a_over_b: f64, [nx, ny, nz]: [f64; 3]) -> RollingForces {
    let kalker = CreepCoefficients::new(a_over_b, STEEL.poisson_ratio);
    // a b G = 1 and mu N = 2 pi/3.
    let unit = 2.0 * PI / (0.5 * (kalker.c11 + kalker.c22));
    let reach = (a_over_b + 1.0 / a_over_b).sqrt();
    let forces = contact.solve(&RollingMotion {
        longitudinal: unit * nx,
        lateral: unit * ny,
        spin: unit * nz / reach,
    });
    RollingForces { moment: forces.moment / reach, ..forces }
}
