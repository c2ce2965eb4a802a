//! Constants that several models share, each written once.
//!
//! Units other than SI stand in files only; the models convert them once, when a file is read.

/// Standard acceleration of free fall, m/s².
///
/// Exact by definition: 3rd General Conference on Weights and Measures, 1901.
pub const STANDARD_GRAVITY: f64 = 9.80665;

/// Stefan-Boltzmann constant, W/(m² K⁴).
///
/// Source: CODATA 2018 (Tiesinga et al., *Reviews of Modern Physics* 93, 2021), to ten digits.
pub const STEFAN_BOLTZMANN: f64 = 5.670_374_419e-8;

/// Zero of the Celsius scale, K.
///
/// Exact by definition: *The International System of Units*, 9th edition, BIPM 2019, 2.3.1.
pub const ZERO_CELSIUS: f64 = 273.15;

/// Kilometres per hour in one metre per second: divide km/h by it to get m/s.
pub const KILOMETRES_PER_HOUR: f64 = 3.6;

/// Miles per hour in one metre per second: divide mph by it to get m/s.
///
/// Exact: the international mile has 1609.344 m (1959).
pub const MILES_PER_HOUR: f64 = 1.0 / 0.447_04;

/// Distance of the middle of each rail head from the middle of the track, m.
///
/// Half of the standard gauge of 1.435 m and half of a rail head of 72 mm (60E1, EN 13674-1).
pub const RAIL_LATERAL_POSITION: f64 = 0.7535;

#[cfg(test)]
mod tests {
    use super::*;

    /// σ = 2 π⁵ k⁴/(15 h³ c²) of the constants that define the SI (BIPM 2019).
    ///
    /// The tolerance is the rounding of σ to ten digits.
    #[test]
    fn analytic_stefan_boltzmann_of_the_defining_constants() {
        let (k, h, c) = (1.380_649e-23, 6.626_070_15e-34, 299_792_458.0_f64);
        let expected = 2.0 * std::f64::consts::PI.powi(5) * f64::powi(k, 4)
            / (15.0 * f64::powi(h, 3) * c.powi(2));
        assert!((STEFAN_BOLTZMANN / expected - 1.0).abs() < 1e-10, "{expected}");
    }

    /// 60 mph are 96.56064 km/h (an international mile has 1.609344 km); rounding.
    #[test]
    fn analytic_speeds_of_a_mile_a_minute() {
        let speed = 60.0 / MILES_PER_HOUR;
        assert!((speed * KILOMETRES_PER_HOUR - 96.560_64).abs() < 1e-12);
    }

    #[test]
    fn analytic_rail_position_is_half_of_gauge_and_head() {
        assert!((RAIL_LATERAL_POSITION - (1.435 + 0.072) / 2.0).abs() < 1e-15);
    }
}
