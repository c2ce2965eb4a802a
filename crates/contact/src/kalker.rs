//! Kalker's linear creep coefficients.
//!
//! For small creepages, xi positive in traction, the forces on the wheel are
//!
//! ```text
//! Fx = +G a b C11 xi
//! Fy = -G a b C22 eta - G (a b)^(3/2) C23 phi
//! Mz = +G (a b)^(3/2) C23 eta - G (a b)^2 C33 phi
//! ```
//!
//! C11, C22, C23 are table E.3 of Kalker, Three-Dimensional Elastic Bodies in Rolling Contact (1990),
//! as tabled in the source of CONTACT (Vollebregt); C33 is Kalker's as an independent public code has
//! it. Between Poisson's ratios 0, 0.25 and 0.5 a parabola in 1/C is used,
//! as in CONTACT; between the rows the values are linear in the ratio of the semi-axes. Below a
//! ratio of 0.1 they follow Kalker's asymptotes, scaled to meet the table at 0.1.

use std::f64::consts::PI;

/// One row of the table: values at Poisson's ratios 0, 0.25 and 0.5.
type Row = [f64; 3];

/// A coefficient at the ratios 0.1, 0.2 ... 1.0 of the smaller to the larger semi-axis.
type Column = [Row; 10];

/// Kalker's coefficients of one contact ellipse.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct CreepCoefficients {
    /// Longitudinal C11.
    pub c11: f64,
    /// Lateral C22.
    pub c22: f64,
    /// Lateral force by spin, and spin moment by lateral creepage, C23.
    pub c23: f64,
    /// Spin moment by spin, C33.
    pub c33: f64,
}

impl CreepCoefficients {
    /// The coefficients for a ratio a/b of semi-axes and a Poisson's ratio between 0 and 0.5.
    ///
    /// a lies in the rolling direction.
    pub fn new(a_over_b: f64, poisson_ratio: f64) -> Self {
        let short = a_over_b <= 1.0;
        let ratio = if short { a_over_b } else { 1.0 / a_over_b };
        let columns = if short { &SHORT } else { &LONG };
        let at = |i: usize| tabled(&columns[i], ratio.max(0.1), poisson_ratio);
        let table = [at(0), at(1), at(2), at(3)];
        let [c11, c22, c23, c33] =
            if ratio >= 0.1 { table } else { slender(table, short, ratio, poisson_ratio) };
        Self { c11, c22, c23, c33 }
    }
}

/// A column at a ratio of at least 0.1, linear between the rows.
fn tabled(column: &Column, ratio: f64, poisson_ratio: f64) -> f64 {
    let position = 10.0 * ratio - 1.0;
    let i = (position.max(0.0) as usize).min(8);
    let at = |row: &Row| at_poisson_ratio(row, poisson_ratio);
    let (before, after) = (at(&column[i]), at(&column[i + 1]));
    before + (position - i as f64) * (after - before)
}

/// The parabola in 1/C through nu = 0, 0.25 and 0.5.
fn at_poisson_ratio(row: &Row, nu: f64) -> f64 {
    let t = 4.0 * nu;
    let lagrange = [0.5 * (t - 1.0) * (t - 2.0), t * (2.0 - t), 0.5 * t * (t - 1.0)];
    let inverse: f64 = row.iter().zip(lagrange).map(|(c, weight)| weight / c).sum();
    1.0 / inverse
}

/// Below the table: the asymptote times a factor that goes from table/asymptote at 0.1 to 1 at 0.
fn slender(table: [f64; 4], short: bool, g: f64, nu: f64) -> [f64; 4] {
    let asymptote = if short { short_asymptote } else { long_asymptote };
    let (here, at_table) = (asymptote(g, nu), asymptote(0.1, nu));
    std::array::from_fn(|i| here[i] * (1.0 + 10.0 * g * (table[i] / at_table[i] - 1.0)))
}

/// Ellipse short in the rolling direction, g = a/b to 0.
fn short_asymptote(g: f64, nu: f64) -> [f64; 4] {
    let c23 = PI * g.sqrt() / (3.0 * (1.0 - nu)) * (1.0 + nu * (libm::log(16.0 / g) - 5.0));
    [PI * PI / (4.0 * (1.0 - nu)), PI * PI / 4.0, c23, PI * PI / (16.0 * (1.0 - nu) * g)]
}

/// Ellipse long in the rolling direction, g = b/a to 0; of C33 the limit at 0, as it hardly changes.
fn long_asymptote(g: f64, nu: f64) -> [f64; 4] {
    let l = libm::log(16.0 / (g * g));
    let d = (1.0 - nu) * l + 2.0 * nu;
    let e = l - 2.0 * nu;
    let rise = 3.0 - libm::log(4.0_f64);
    [
        2.0 * PI / (e * g) * (1.0 + rise / e),
        2.0 * PI / (d * g) * (1.0 + (1.0 - nu) * rise / d),
        2.0 * PI / (3.0 * g * g.sqrt() * ((1.0 - nu) * l - 2.0 + 4.0 * nu)),
        PI / 4.0 * (1.0 - 2.0 * nu) / (1.0 - nu),
    ]
}

/// C11, C22, C23, C33 for a/b from 0.1 to 1.
#[allow(clippy::approx_constant)] // 3.14 is C22 here
const SHORT: [Column; 4] = [
    [
        [2.51, 3.31, 4.85],
        [2.59, 3.37, 4.81],
        [2.68, 3.44, 4.8],
        [2.78, 3.53, 4.82],
        [2.88, 3.62, 4.83],
        [2.98, 3.72, 4.91],
        [3.09, 3.81, 4.97],
        [3.19, 3.91, 5.05],
        [3.29, 4.01, 5.12],
        [3.4, 4.12, 5.2],
    ],
    [
        [2.51, 2.52, 2.53],
        [2.59, 2.63, 2.66],
        [2.68, 2.75, 2.81],
        [2.78, 2.88, 2.98],
        [2.88, 3.01, 3.14],
        [2.98, 3.14, 3.31],
        [3.09, 3.28, 3.48],
        [3.19, 3.41, 3.65],
        [3.29, 3.54, 3.82],
        [3.4, 3.67, 3.98],
    ],
    [
        [0.334, 0.473, 0.731],
        [0.483, 0.603, 0.809],
        [0.607, 0.715, 0.889],
        [0.72, 0.823, 0.977],
        [0.827, 0.929, 1.07],
        [0.93, 1.03, 1.18],
        [1.03, 1.14, 1.29],
        [1.13, 1.25, 1.4],
        [1.23, 1.36, 1.51],
        [1.33, 1.47, 1.63],
    ],
    [
        [6.42, 8.28, 11.7],
        [3.46, 4.27, 5.66],
        [2.49, 2.96, 3.72],
        [2.02, 2.32, 2.77],
        [1.74, 1.93, 2.22],
        [1.56, 1.68, 1.86],
        [1.43, 1.5, 1.6],
        [1.34, 1.37, 1.42],
        [1.27, 1.27, 1.27],
        [1.21, 1.19, 1.16],
    ],
];

/// C11, C22, C23, C33 for b/a from 0.1 to 1.
const LONG: [Column; 4] = [
    [
        [10.7, 11.7, 12.9],
        [6.96, 7.78, 8.82],
        [5.57, 6.34, 7.34],
        [4.84, 5.57, 6.57],
        [4.37, 5.1, 6.11],
        [4.06, 4.78, 5.8],
        [3.82, 4.54, 5.58],
        [3.65, 4.36, 5.42],
        [3.51, 4.22, 5.3],
        [3.4, 4.12, 5.2],
    ],
    [
        [10.7, 12.8, 16.0],
        [6.96, 8.14, 9.79],
        [5.57, 6.4, 7.51],
        [4.84, 5.48, 6.31],
        [4.37, 4.9, 5.56],
        [4.06, 4.5, 5.04],
        [3.82, 4.21, 4.67],
        [3.65, 3.99, 4.39],
        [3.51, 3.81, 4.16],
        [3.4, 3.67, 3.98],
    ],
    [
        [12.2, 14.6, 18.0],
        [5.72, 6.63, 7.89],
        [3.79, 4.32, 5.01],
        [2.88, 3.24, 3.7],
        [2.35, 2.62, 2.96],
        [2.01, 2.23, 2.5],
        [1.76, 1.95, 2.18],
        [1.58, 1.75, 1.94],
        [1.44, 1.59, 1.77],
        [1.33, 1.47, 1.63],
    ],
    [
        [0.795, 0.526, 0.228],
        [0.828, 0.601, 0.341],
        [0.868, 0.674, 0.446],
        [0.912, 0.747, 0.549],
        [0.958, 0.819, 0.65],
        [1.01, 0.892, 0.751],
        [1.05, 0.965, 0.852],
        [1.1, 1.04, 0.954],
        [1.16, 1.11, 1.06],
        [1.21, 1.19, 1.16],
    ],
];
