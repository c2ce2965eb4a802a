//! Kalker's simplified theory (FASTSIM) in dimensionless form.
//!
//! The contact is an ellipse on a Winkler foundation with the flexibilities
//!
//! ```text
//! L1 = 8 a/(3 C11 G),   L2 = 8 a/(3 C22 G),   L3 = pi a sqrt(a/b)/(4 C23 G)                       (C1)
//! ```
//!
//! With x = a x', y = b y', the pressure p0 = 2 N/(pi a b) and tractions q in units of mu p0, material
//! that enters at the leading edge x' = sqrt(1 - y'²) and travels by t' = a^-1 (path) takes up
//!
//! ```text
//! dqx/dt' = nx - nz sqrt(b/a) y',   dqy/dt' = ny + nz sqrt(a/b) x',   |q| <= 1 - x'² - y'²         (C2)
//! nx = a xi/(L1 mu p0),   ny = a eta/(L2 mu p0),   nz = a sqrt(a b) phi/(L3 mu p0)                 (C3)
//! ```
//!
//! and is cut back to the bound where it would exceed it; there the wheel slips. So the law depends on
//! four numbers: nx, ny, nz and a/b. Turning the sign of nx mirrors the contact across, so that xi may
//! count positive in traction, and qx then is the traction on the wheel. Source: Kalker, A fast
//! algorithm for the simplified theory of rolling contact, VSD 11 (1982) 1-13, with the parabolic bound,
//! which gives forces nearer to the exact theory than the elliptic one.
//!
//! The power of the slip field, the integral of traction times slip, is
//!
//! ```text
//! P = V mu N (mu p0/a) (L1 (nx fx - nz sqrt(b/a) mx) + L2 (ny fy + nz sqrt(a/b) my))               (C4)
//! mx = (2/pi) integral y' qx,   my = (2/pi) integral x' qy
//! ```
//!
//! because the foundation gives back at the trailing edge what it took: the sums below are by the
//! trapezoidal rule, with which that holds exactly for any number of elements.

use std::f64::consts::{FRAC_2_PI, FRAC_PI_2, PI};

/// Creepages and spin of equation C3, and the shape of the contact.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct ScaledCreepages {
    /// nx.
    pub longitudinal: f64,
    /// ny.
    pub lateral: f64,
    /// nz.
    pub spin: f64,
    /// a/b.
    pub a_over_b: f64,
}

/// Forces and moments on a dimensionless scale, in the direction of the creepages.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct ScaledForces {
    /// Longitudinal force by mu N.
    pub longitudinal: f64,
    /// Lateral force by mu N.
    pub lateral: f64,
    /// mx: moment of the longitudinal tractions by mu N b.
    pub moment_x: f64,
    /// my: moment of the lateral tractions by mu N a.
    pub moment_y: f64,
}

/// Division of the contact into strips along the rolling direction and of each strip into elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Division {
    /// Pairs of strips: one on either side of the middle.
    pub pairs: usize,
    /// Elements of each strip.
    pub elements: usize,
}

/// Marches through all strips (C2).
///
/// Strips are narrow where the contact is short, and elements are short at both ends of a strip, where
/// the bound is low.
pub(crate) fn march(creepages: &ScaledCreepages, division: Division) -> ScaledForces {
    let half_width = 0.5 * FRAC_PI_2 / division.pairs as f64;
    let mut forces = ScaledForces::default();
    for pair in 0..division.pairs {
        let (y, half) = libm::sincos(half_width * (2 * pair + 1) as f64);
        let width = 2.0 * half * libm::sin(half_width);
        // Adding up both sides at once makes mirrored motions give mirrored forces bit by bit.
        let sides = [y, -y].map(|y| march_strip(creepages, y, half, division.elements));
        let both =
            |of: fn(&ScaledForces) -> f64| FRAC_2_PI * width * (of(&sides[0]) + of(&sides[1]));
        forces.longitudinal += both(|strip| strip.longitudinal);
        forces.lateral += both(|strip| strip.lateral);
        forces.moment_x += both(|strip| strip.moment_x);
        forces.moment_y += both(|strip| strip.moment_y);
    }
    forces
}

/// Integrals over the strip at y' that begins at x' = `half`.
fn march_strip(creepages: &ScaledCreepages, y: f64, half: f64, elements: usize) -> ScaledForces {
    let root = creepages.a_over_b.sqrt();
    let (spin_x, spin_y) = (creepages.spin / root, creepages.spin * root);
    let rise_x = creepages.longitudinal - spin_x * y;
    let (turn_sine, turn_cosine) = libm::sincos(PI / elements as f64);
    let (mut sine, mut cosine) = (0.0, 1.0);
    let (mut x, mut qx, mut qy) = (half, 0.0_f64, 0.0_f64);
    let mut sum = ScaledForces::default();
    for _ in 0..elements {
        (sine, cosine) =
            (sine * turn_cosine + cosine * turn_sine, cosine * turn_cosine - sine * turn_sine);
        let (before_x, before_y) = (qx, qy);
        let step = x - half * cosine;
        let middle = x - 0.5 * step;
        x -= step;
        qx += step * rise_x;
        qy += step * (creepages.lateral + spin_y * middle);
        let bound = half * sine * half * sine;
        let size = qx * qx + qy * qy;
        if size > bound * bound {
            let cut = bound / size.sqrt();
            qx *= cut;
            qy *= cut;
        }
        let (mean_x, mean_y) = (0.5 * step * (before_x + qx), 0.5 * step * (before_y + qy));
        sum.longitudinal += mean_x;
        sum.lateral += mean_y;
        sum.moment_x += y * mean_x;
        sum.moment_y += middle * mean_y;
    }
    sum
}
