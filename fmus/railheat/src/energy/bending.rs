//! The rail as a beam on a Winkler foundation: what bending does to its temperature.
//!
//! Under a wheel load P, with β = (u/(4 E I))^¼ (`docs/theory/railheat/energy.md#eq-20`,
//! `docs/theory/railheat/energy.md#eq-21`, `docs/theory/railheat/energy.md#eq-22`):
//!
//! ```text
//! M(x) = P/(4β) e^(-β|x|) (cos β|x| - sin β|x|)
//! ΔT   = -(α_L T/(ρ c)) σ,        σ = M e/I in the outermost fibre, tension positive
//! E'   = π η M_a²/(E I)           heat per wheel and metre by hysteresis, M_a = 0.604 P/(4β)
//! ```
//!
//! The first is reversible: it comes and goes with the wheel and leaves no heat. M_a is half the
//! range of the moment while a single wheel passes (its uplift is -0.208 of the highest); the
//! heat goes where the stress is, with the square of the distance from the neutral axis.
//! Validated by `benchmark_bending_…`.

/// Half the range of the moment of a single wheel, over its highest: (1 + e^(-π/2))/2.
const AMPLITUDE: f64 = 0.603_939_788_174_3;

/// Beyond so many decay lengths a wheel's moment is below 1e-8 of its highest.
const REACH: f64 = 20.0;

/// The rail as a beam.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beam {
    /// Young's modulus E, Pa.
    pub modulus: f64,
    /// Second moment of area I, m⁴.
    pub second_moment: f64,
    /// Distance of the foot's underside from the neutral axis, m.
    pub to_foot: f64,
    /// Track modulus u, Pa.
    pub track_modulus: f64,
    /// Coefficient of thermal expansion α_L, 1/K.
    pub expansion: f64,
    /// Loss factor η of the steel.
    pub loss_factor: f64,
}

impl Beam {
    /// Steel on track of usual stiffness; what of it is the section's is that of AS60.
    pub const TYPICAL: Self = Self {
        modulus: 207e9,
        second_moment: 29.3e-6,
        to_foot: 0.07923,
        track_modulus: 35e6,
        expansion: 11.5e-6,
        loss_factor: 2e-4,
    };

    /// β, 1/m.
    pub fn decay(&self) -> f64 {
        (self.track_modulus / (4.0 * self.modulus * self.second_moment)).sqrt().sqrt()
    }

    /// Bending moment under wheel loads in N at their distances in m, N·m.
    ///
    /// A positive moment puts the foot in tension.
    pub fn moment(&self, loads: impl IntoIterator<Item = (f64, f64)>) -> f64 {
        let decay = self.decay();
        let reach = REACH / decay;
        let near = loads.into_iter().filter(|(_, distance)| distance.abs() <= reach);
        let of_load = |(load, distance): (f64, f64)| {
            let x = decay * distance.abs();
            load * libm::exp(-x) * (libm::cos(x) - libm::sin(x))
        };
        near.map(of_load).sum::<f64>() / (4.0 * decay)
    }

    /// Reversible temperature change of the foot's underside by a bending moment in N·m, K.
    ///
    /// The rail has a temperature in K and a heat capacity in J/(m³·K).
    pub fn thermoelastic(&self, moment: f64, temperature: f64, heat_capacity: f64) -> f64 {
        let stress = moment * self.to_foot / self.second_moment;
        -self.expansion * temperature / heat_capacity * stress
    }

    /// Heat in J/m that a passing wheel load in N leaves by hysteresis.
    pub fn hysteresis(&self, load: f64) -> f64 {
        let amplitude = AMPLITUDE * load / (4.0 * self.decay());
        std::f64::consts::PI * self.loss_factor * amplitude * amplitude
            / (self.modulus * self.second_moment)
    }
}
