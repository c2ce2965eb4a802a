//! The contact ellipse of two elastic bodies (Hertz 1882, exact).
//!
//! With the half relative curvatures A (rolling direction) and B (across), E* the combined modulus,
//! g = minor/major semi-axis, m = 1 - g^2 and the complete elliptic integrals K(m), E(m):
//!
//! ```text
//! (E/(1 - m) - K)/(K - E) = max(A,B)/min(A,B)        gives g
//! major^3 = 3 N (K - E)/(2 pi E* m min(A,B))
//! p0 = 3 N/(2 pi a b),   approach = p0 minor K/E*
//! ```
//!
//! The larger semi-axis lies in the direction of the smaller curvature. Source: K. L. Johnson,
//! Contact Mechanics, 4.2; validated by `benchmark_hertz_…` in `tests/validation/`.

use crate::material::Material;

/// Contact ellipse for a load of 1 N; semi-axes grow with N^(1/3).
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct UnitContact {
    /// Semi-axis in the rolling direction for 1 N, in m/N^(1/3).
    pub semi_axis_rolling: f64,
    /// Semi-axis across for 1 N, in m/N^(1/3).
    pub semi_axis_lateral: f64,
    /// k of N = k approach^(3/2), in N/m^(3/2).
    pub stiffness: f64,
    /// Cube root of k, for N^(1/3) = k^(1/3) approach^(1/2).
    pub stiffness_root: f64,
}

impl UnitContact {
    /// The contact of two bodies with these half relative curvatures, both positive, in 1/m.
    ///
    /// `rolling` is A, in the rolling direction, and `lateral` B, across.
    pub fn new(rolling: f64, lateral: f64, material: &Material) -> Self {
        let (least, most) = (rolling.min(lateral), rolling.max(lateral));
        let modulus = material.contact_modulus();
        let ratio = semi_axis_ratio(most / least);
        let integrals = EllipticIntegrals::new(ratio);
        let major = libm::cbrt(
            1.5 * integrals.k * integrals.deficit_by_parameter
                / (std::f64::consts::PI * modulus * least),
        );
        let minor = ratio * major;
        let pressure = 1.5 / (std::f64::consts::PI * major * minor);
        let approach = pressure * minor * integrals.k / modulus;
        let (semi_axis_rolling, semi_axis_lateral) =
            if rolling <= lateral { (major, minor) } else { (minor, major) };
        let stiffness = libm::pow(approach, -1.5);
        Self {
            semi_axis_rolling,
            semi_axis_lateral,
            stiffness,
            stiffness_root: libm::cbrt(stiffness),
        }
    }

    /// The contact with a `share` (0 to 1) of the stiffness.
    #[must_use]
    pub fn shared(mut self, share: f64) -> Self {
        self.stiffness *= share;
        self.stiffness_root *= libm::cbrt(share);
        self
    }

    /// Normal force in N for an elastic `approach` (m) along the normal; 0 without contact.
    #[inline]
    pub fn normal_force(&self, approach: f64) -> f64 {
        let approach = approach.max(0.0);
        self.stiffness * approach * approach.sqrt()
    }

    /// Elastic approach in m under `normal_force` (N); 0 without load.
    pub fn approach(&self, normal_force: f64) -> f64 {
        let root = libm::cbrt(normal_force.max(0.0) / self.stiffness);
        root * root
    }

    /// Semi-axes in the rolling direction and across, in m, at an `approach` (m); 0 without contact.
    #[inline]
    pub fn semi_axes(&self, approach: f64) -> (f64, f64) {
        let scale = self.stiffness_root * approach.max(0.0).sqrt();
        (scale * self.semi_axis_rolling, scale * self.semi_axis_lateral)
    }
}

/// K(m) for m = 1 - g^2, and (K - E)/(K m), which has the limit 1/2 for the circle.
struct EllipticIntegrals {
    k: f64,
    deficit_by_parameter: f64,
}

impl EllipticIntegrals {
    /// By the arithmetic-geometric mean: K = pi/(2 agm(1, g)), K - E = K sum 2^(n-1) c_n^2.
    fn new(g: f64) -> Self {
        let (mut mean, mut geometric) = (1.0, g);
        // The sum is divided by c_0^2 = m term by term, so that nothing cancels near the circle.
        let mut sum = 0.5;
        let mut weight = 1.0;
        let mut c_by_root = 1.0;
        for _ in 0..8 {
            let next = 0.5 * (mean + geometric);
            // c_(n+1) = c_n^2 / (4 a_(n+1)), here with c_n = sqrt(m) c_by_root.
            let m = 1.0 - g * g;
            let square = c_by_root * c_by_root;
            c_by_root = square * m.sqrt() / (4.0 * next);
            sum += weight * c_by_root * c_by_root;
            weight *= 2.0;
            geometric = (mean * geometric).sqrt();
            mean = next;
        }
        Self { k: std::f64::consts::FRAC_PI_2 / mean, deficit_by_parameter: sum }
    }

    /// max(A,B)/min(A,B) = (E/(1 - m) - K)/(K - E) = (1 - d)/((1 - m) d) with d = (K - E)/(K m).
    fn curvature_ratio(&self, g: f64) -> f64 {
        (1.0 - self.deficit_by_parameter) / (g * g * self.deficit_by_parameter)
    }
}

/// g = minor/major for a ratio of curvatures >= 1, by bisection.
fn semi_axis_ratio(curvature_ratio: f64) -> f64 {
    let (mut slender, mut round) = (1e-6, 1.0);
    for _ in 0..52 {
        let g = 0.5 * (slender + round);
        if EllipticIntegrals::new(g).curvature_ratio(g) > curvature_ratio {
            slender = g;
        } else {
            round = g;
        }
    }
    0.5 * (slender + round)
}
