//! Heat that the running surface exchanges with the weather.
//!
//! `docs/theory/railheat/paper.md#eq-5`, Table 4 of the paper:
//!
//! ```text
//! q = a_s f I - h (T - T_a) - ε_r σ (T⁴ - T_a⁴)
//! ```
//!
//! per area of the running surface, positive into the rail. The sky is as warm as the air; wind,
//! and where the sun stands, have no influence. Validated by `analytic_weather_equilibrium`.

use numerics::constants::STEFAN_BOLTZMANN;

use crate::weather::Weather;

/// How the running surface exchanges heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RunningSurface {
    /// Heat transfer coefficient to the air h, W/(m²·K).
    pub convection: f64,
    /// Emissivity ε_r.
    pub emissivity: f64,
    /// Share of the sunlight that is absorbed a_s.
    pub absorptivity: f64,
    /// Share of the direct irradiance that the atmosphere lets through f.
    pub filter: f64,
}

impl RunningSurface {
    /// Table 4 of the paper.
    pub const PAPER: Self =
        Self { convection: 6.0, emissivity: 0.75, absorptivity: 0.75, filter: 0.5 };

    /// Heat flux into the surface at `temperature` in K, W/m².
    #[inline]
    pub fn flux(&self, temperature: f64, weather: &Weather) -> f64 {
        let fourth = |t: f64| (t * t) * (t * t);
        let radiated = self.emissivity * STEFAN_BOLTZMANN;
        self.absorptivity * self.filter * weather.direct
            - self.convection * (temperature - weather.ambient)
            - radiated * (fourth(temperature) - fourth(weather.ambient))
    }

    /// How fast the flux falls with the temperature, W/(m²·K).
    pub fn conductance(&self, temperature: f64) -> f64 {
        self.convection + 4.0 * self.emissivity * STEFAN_BOLTZMANN * temperature.powi(3)
    }

    /// Temperature at which nothing flows, K, by Newton's method.
    ///
    /// The flux falls with the temperature and is concave, so that the method always converges.
    /// Without convection and radiation there is no such temperature: the ambient one is given.
    pub fn equilibrium(&self, weather: &Weather) -> f64 {
        let mut temperature = weather.ambient;
        for _ in 0..50 {
            let conductance = self.conductance(temperature);
            if conductance <= 0.0 {
                return weather.ambient;
            }
            let change = self.flux(temperature, weather) / conductance;
            temperature += change;
            if change.abs() <= f64::EPSILON * temperature {
                break;
            }
        }
        temperature
    }
}
