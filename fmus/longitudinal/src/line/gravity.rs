//! The force of a gradient.
//!
//! ```text
//! F_g = −m g dz/ds      (theory, eq. 11)
//! ```
//!
//! with the elevation z over the chainage s at the vehicle's middle. As s is measured along the
//! rising track, dz/ds is the sine of its slope and the formula is exact.

use numerics::constants::STANDARD_GRAVITY;

/// Force along the track on a mass, kg, where the track rises with `gradient`, in N; forward
/// downhill.
pub fn force(mass: f64, gradient: f64) -> f64 {
    -mass * STANDARD_GRAVITY * gradient
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A mass of 1000 t has a weight of 9806.65 kN; one permille uphill is a thousandth of it.
    #[test]
    fn analytic_force_of_one_permille() {
        assert!((force(1e6, 1e-3) + 9806.65).abs() < 1e-9);
        assert!(force(1e6, -1e-3) > 0.0);
    }
}
