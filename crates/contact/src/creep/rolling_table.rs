//! Steady rolling of the half-space (`rolling/`), tabulated.
//!
//! With mu N the friction, C = (C11 + C22)/2 and R² = a² + b² the law depends on three motions and a/b:
//!
//! ```text
//! (nx, ny, nz) = (xi, eta, phi R) G a b C/(3 mu N)                                                 (C15)
//! ```
//!
//! Mirrored across the rolling direction, and turned over, tractions change sign as creepages do. So
//! these ratios are even in nx, ny and nz, with m² = nx² + ny² + nz², q² = 1 + m² and t = sign(ny nz):
//!
//! ```text
//! fx = (cx + cd t) nx/q    fy = (cy ny + cs nz)/q    M = mu N R (ds nz + dy ny)/q                  (C5)
//! flash = (k0 + k1 t) sqrt((1 + m)/m)
//! ```
//!
//! They are finite where a creepage vanishes and where all slips, and change little between, so that a
//! table interpolated linearly serves. It goes over m/(1 + m), ny/(nx + ny), nz/(nz + sqrt(nx² + ny²))
//! and r/(1 + r) with r² = a/b.
//!
//! The table is a file beside the code, made by `cargo xtask creep-table` (`rolling/recipe.rs`).

use std::array::from_fn;
use std::fmt;
use std::sync::OnceLock;

/// Numbers of nodes over size, direction, part of the spin and shape.
pub(crate) const NODES: [usize; 4] = [25, 9, 17, 11];

/// Distances of neighbouring nodes over size, direction, part of the spin and shape.
const STRIDES: [usize; 4] = [1, NODES[0], NODES[0] * NODES[1], NODES[0] * NODES[1] * NODES[2]];

/// Number of all nodes.
const COUNT: usize = STRIDES[3] * NODES[3];

/// Nodes from the first to the last one of a cell between neighbouring nodes.
const CELL: usize = 1 + STRIDES[0] + STRIDES[1] + STRIDES[2] + STRIDES[3];

/// First nodes in a cell of its edges over size.
const EDGES: [usize; 8] = {
    let [_, x, y, z] = STRIDES;
    [0, x, y, x + y, z, x + z, y + z, x + y + z]
};

/// Largest m; beyond it all slips, and only the direction counts.
const LARGEST: f64 = 100.0;

/// Least m in the flash factor, which rises without bound where nearly all sticks and nothing heats.
const LEAST_SLIDE: f64 = 1e-6;

/// Least and greatest r/(1 + r), r² = a/b: ellipses of 1:25.
const SHAPES: (f64, f64) = (1.0 / 6.0, 5.0 / 6.0);

/// 1 over the range of shapes.
const PER_SHAPES: f64 = 1.0 / (SHAPES.1 - SHAPES.0);

/// Ratios at one node: cx, cy, cs, ds, dy, cd, k0, k1. Single precision is far finer than the table is
/// exact, and makes half as many cache lines of it.
pub(crate) type Node = [f32; 8];

/// Bytes of a node.
pub(crate) const NODE_BYTES: usize = size_of::<Node>();

/// Bytes of the head of the file: the recipe's hash.
pub(crate) const HEAD_BYTES: usize = 8;

/// The file.
pub(crate) const FILE: &[u8; HEAD_BYTES + COUNT * NODE_BYTES] =
    include_bytes!("../../data/exact-rolling.table");

/// The law as a table.
pub(crate) struct RollingTable {
    nodes: Vec<Node>,
}

/// Motion nx, ny, nz of equation C15, and the shape of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ScaledMotion {
    /// nx.
    pub longitudinal: f64,
    /// ny.
    pub lateral: f64,
    /// nz.
    pub spin: f64,
    /// a/b.
    pub a_over_b: f64,
}

/// Ratios of equation C5 divided by q, and so the law for one contact.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ratios {
    /// fx = longitudinal nx.
    pub longitudinal: f64,
    /// fy = lateral ny + spin nz.
    pub lateral: f64,
    /// See `lateral`.
    pub spin: f64,
    /// M = mu N R (moment.0 nz + moment.1 ny).
    pub moment: (f64, f64),
    /// Highest flash temperature by that of the same power spread over the contact as the pressure.
    pub flash: f64,
}

impl fmt::Debug for RollingTable {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.debug_struct("RollingTable").finish_non_exhaustive()
    }
}

impl RollingTable {
    /// The table of this process.
    pub(crate) fn shared() -> &'static Self {
        static TABLE: OnceLock<RollingTable> = OnceLock::new();
        TABLE.get_or_init(|| Self { nodes: (0..COUNT).map(stored).collect() })
    }

    /// The law at these creepages.
    #[inline]
    pub(crate) fn at(&self, motion: &ScaledMotion) -> Ratios {
        let (nx, ny, nz) = (motion.longitudinal.abs(), motion.lateral.abs(), motion.spin.abs());
        let slide_squared = nx * nx + ny * ny;
        let slide = slide_squared.sqrt();
        let m = (slide_squared + nz * nz).sqrt();
        let root = motion.a_over_b.sqrt();
        // A wheel that does not creep at all has any direction.
        let tiny = f64::MIN_POSITIVE;
        let inside = m.min(LARGEST);
        let coordinates = [
            inside / (1.0 + inside) * ((1.0 + LARGEST) / LARGEST),
            ny / (nx + ny + tiny),
            nz / (slide + nz + tiny),
            (root / (1.0 + root) - SHAPES.0) * PER_SHAPES,
        ];
        let v = self.interpolated(coordinates);
        let turn = 1.0_f64.copysign(motion.lateral * motion.spin);
        // 1/q; beyond the table's end f keeps the size it has there.
        let shrink = if m > LARGEST { LARGEST / m } else { 1.0 };
        let scale = shrink / (1.0 + inside * inside).sqrt();
        Ratios {
            longitudinal: scale * (v[0] + v[5] * turn),
            lateral: scale * v[1],
            spin: scale * v[2],
            moment: (scale * v[3], scale * v[4]),
            flash: (v[6] + v[7] * turn) * ((1.0 + inside) / (inside + LEAST_SLIDE)).sqrt(),
        }
    }

    /// Linear in all four coordinates, each from 0 to 1.
    #[inline]
    fn interpolated(&self, coordinates: [f64; 4]) -> [f64; 8] {
        let mut first = 0;
        let mut part = [0.0; 4];
        for k in 0..4 {
            let node = coordinates[k].clamp(0.0, 1.0) * (NODES[k] - 1) as f64;
            let index = (node as u32 as usize).min(NODES[k] - 2);
            first += index * STRIDES[k];
            part[k] = node - index as f64;
        }
        let cell =
            self.nodes[first..].first_chunk::<CELL>().expect("coordinates lie within the table");
        let at = |node: usize| cell[node].map(f64::from);
        let edges = EDGES.map(|node| between(&at(node), &at(node + STRIDES[0]), part[0]));
        let faces: [_; 4] = from_fn(|i| between(&edges[2 * i], &edges[2 * i + 1], part[1]));
        let sides: [_; 2] = from_fn(|i| between(&faces[2 * i], &faces[2 * i + 1], part[2]));
        between(&sides[0], &sides[1], part[3])
    }
}

/// Linear between the ratios at two points, at this share of their distance.
#[inline]
fn between(one: &[f64; 8], other: &[f64; 8], part: f64) -> [f64; 8] {
    from_fn(|i| one[i] + part * (other[i] - one[i]))
}

/// A node of the file.
pub(crate) fn stored(index: usize) -> Node {
    let begin = HEAD_BYTES + index * NODE_BYTES;
    from_fn(|i| {
        let bytes = FILE[begin + 4 * i..].first_chunk().expect("the file has all nodes");
        f32::from_le_bytes(*bytes)
    })
}

/// Index of a node in the file.
pub(crate) fn index_of(node: [usize; 4]) -> usize {
    node.iter().zip(STRIDES).map(|(index, stride)| index * stride).sum()
}

/// m of a share of the range over size, from 0 to 1.
pub(crate) fn size_at(share: f64) -> f64 {
    let reduced = share * LARGEST / (1.0 + LARGEST);
    reduced / (1.0 - reduced)
}

/// a/b of a share of the range over shapes, from 0 to 1.
pub(crate) fn shape_at(share: f64) -> f64 {
    let shape = SHAPES.0 + share * (SHAPES.1 - SHAPES.0);
    let root = shape / (1.0 - shape);
    root * root
}
