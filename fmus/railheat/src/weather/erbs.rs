//! The global irradiance of a horizontal surface, split into what comes from the sun and from the sky.
//!
//! ```text
//! k_t = G / (I_0 sin h)
//! D/G = 1 - 0.09 k_t                                                            k_t ≤ 0.22
//! D/G = 0.9511 - 0.1604 k_t + 4.388 k_t² - 16.638 k_t³ + 12.336 k_t⁴     0.22 < k_t ≤ 0.80
//! D/G = 0.165                                                            0.80 < k_t
//! I = (G - D) / sin h
//! ```
//!
//! with the global irradiance G, its diffuse part D, the irradiance I of a surface that faces the sun,
//! I_0 of such a surface outside of the atmosphere, and the sun's elevation h: Erbs, Klein and Duffie,
//! *Solar Energy* 28 (1982) 293-302, made of hourly means of four stations in the United States. Below
//! an elevation of 3° all is diffuse, since I is a quotient of two small numbers there. Validated by
//! `benchmark_global_irradiance_is_split`: 1e-8 of what pvlib gives.

/// Sine of the least elevation at which there is direct light, 3°.
const LOWEST: f64 = 0.052_335_956_242_943_835;

/// Share of the diffuse irradiance in the global one by the clearness index k_t.
pub fn diffuse_share(clearness: f64) -> f64 {
    let k = clearness;
    if k <= 0.22 {
        1.0 - 0.09 * k
    } else if k <= 0.80 {
        0.9511 + k * (-0.1604 + k * (4.388 + k * (-16.638 + k * 12.336)))
    } else {
        0.165
    }
}

/// Irradiance of a surface that faces the sun, and diffuse one of a horizontal surface, W/m².
///
/// Of the global irradiance of a horizontal surface in W/m² while the sun is at this elevation in rad,
/// with its irradiance outside of the atmosphere in W/m²; no more than that one is direct.
pub fn split(global: f64, elevation: f64, outside: f64) -> [f64; 2] {
    let sine = libm::sin(elevation);
    if sine < LOWEST {
        return [0.0, global];
    }
    let clearness = global / (outside * sine);
    let direct = (global * (1.0 - diffuse_share(clearness)) / sine).min(outside);
    [direct, global - direct * sine]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of the published equations at their limits; the pieces meet within 3e-4 there.
    #[test]
    fn benchmark_diffuse_share_by_erbs() {
        for (clearness, share) in [(0.0, 1.0), (0.22, 0.9802), (0.5, 0.65915), (0.81, 0.165)] {
            assert!((diffuse_share(clearness) - share).abs() < 1e-12, "{clearness}");
        }
        for limit in [0.22, 0.80] {
            let step = diffuse_share(limit) - diffuse_share(limit + 1e-9);
            assert!(step.abs() < 3e-4, "{limit}: {step}");
        }
    }

    /// The test of pvlib's `erbs` (`test_irradiance.py`), with the irradiance outside of the atmosphere that its
    /// clearness index means. The tolerance is what nine digits of that index leave.
    #[test]
    fn benchmark_global_irradiance_is_split() {
        for (global, zenith, clearness, direct, diffuse) in [
            (50.0, 85.0_f64, 0.405723511, 96.7192672, 41.5703604),
            (1000.0, 10.0, 0.718132729, 794.205651, 217.860117),
            (1000.0, 10.0, 0.768214312, 842.001578, 170.790318),
        ] {
            let elevation = (90.0 - zenith).to_radians();
            let outside = global / clearness / elevation.sin();
            let [own_direct, own_diffuse] = split(global, elevation, outside);
            assert!((own_direct / direct - 1.0).abs() < 1e-8, "{own_direct}");
            assert!((own_diffuse / diffuse - 1.0).abs() < 1e-8, "{own_diffuse}");
        }
    }

    #[test]
    fn property_the_parts_are_the_whole() {
        for degrees in [-10.0_f64, 0.0, 1.0, 2.9, 3.1, 20.0, 90.0] {
            for global in [0.0, 5.0, 100.0, 600.0, 1300.0] {
                let elevation = degrees.to_radians();
                let [direct, diffuse] = split(global, elevation, 1367.0);
                let whole = direct * elevation.sin().max(0.0) + diffuse;
                assert!((whole - global).abs() < 1e-9, "{degrees}° {global}: {whole}");
                assert!((0.0..=1367.0).contains(&direct) && diffuse >= 0.0, "{degrees}° {global}");
            }
        }
    }
}
