//! Heat that each piece of the rail's surface exchanges with air, sky, sun and pad.
//!
//! ```text
//! q = a_s (f I n·s + f_s D) - h (T - T_a) - ε σ (T⁴ - f_s T_s⁴ - (1 - f_s) T_a⁴)
//! h = h_0 + 4.0 W up to 5 m/s, above 7.2 W^0.78 - 5.6 + h_0
//! ```
//!
//! (`docs/theory/railheat/energy.md#eq-12`) with the sun's direction s, the share f_s = (1 +
//! n·up)/2 of the sky in what the surface sees, the diffuse irradiance D and the wind W (McAdams,
//! with 5.6 W/(m²·K) in still air, as in Hong et al., *Int. J. Precis. Eng. Manuf.* 20 (2019)
//! 337-346). The ground is as warm as the air. The underside of the foot has a conductance to the
//! pad instead, zero when insulated. Validated by `analytic_weather_…`.

use numerics::constants::STEFAN_BOLTZMANN;

use super::conditions::Weather;
use crate::section::{Cells, Facet};

/// How the rail exchanges heat.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Exchange {
    /// Heat transfer coefficient in still air h_0, W/(m²·K).
    pub convection: f64,
    /// Emissivity ε.
    pub emissivity: f64,
    /// Share of the sunlight that is absorbed a_s.
    pub absorptivity: f64,
    /// Share of the direct irradiance that arrives f.
    pub filter: f64,
    /// Whether the sky is colder than the air: T_s = 0.0552 T_a^1.5 (Swinbank, K), where the weather does
    /// not say how much it radiates.
    pub cold_sky: bool,
    /// Conductance of the foot's underside to the pad, W/(m²·K).
    pub pad: f64,
}

impl Exchange {
    /// A rusty rail in still air under a sky as warm as the air, insulated from the pad.
    ///
    /// Convection and radiation are those of the paper's Table 4.
    pub const TYPICAL: Self = Self {
        convection: 6.0,
        emissivity: 0.75,
        absorptivity: 0.75,
        filter: 1.0,
        cold_sky: false,
        pad: 0.0,
    };

    /// Heat transfer coefficient to the air in a wind in m/s, W/(m²·K).
    pub fn coefficient(&self, wind: f64) -> f64 {
        let wind = wind.abs();
        self.convection + if wind <= 5.0 { 4.0 * wind } else { 7.2 * libm::pow(wind, 0.78) - 5.6 }
    }

    /// Conductance of radiation around a temperature in K, W/(m²·K).
    pub fn radiation(&self, temperature: f64) -> f64 {
        4.0 * self.emissivity * STEFAN_BOLTZMANN * temperature.powi(3)
    }

    /// Fourth power of the sky's temperature, K⁴.
    fn sky(&self, weather: &Weather) -> f64 {
        match weather.sky {
            Some(radiation) => radiation / STEFAN_BOLTZMANN,
            None if self.cold_sky => fourth(0.0552 * libm::pow(weather.ambient, 1.5)),
            None => fourth(weather.ambient),
        }
    }
}

/// The pieces of a section's surface as the weather sees them.
#[derive(Clone, Debug)]
pub struct Surface {
    facets: Vec<Facet>,
    /// Whether each lies on the pad.
    on_pad: Vec<bool>,
}

impl Surface {
    /// The surface of a section.
    pub fn new(cells: &Cells) -> Self {
        let on_pad =
            |facet: &Facet| facet.normal.z > 0.99 && facet.middle().z > 0.99 * cells.height;
        Self { on_pad: cells.facets.iter().map(on_pad).collect(), facets: cells.facets.clone() }
    }

    /// The pieces.
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }

    /// Whether a piece lies on the pad.
    pub fn lies_on_pad(&self) -> bool {
        self.on_pad.contains(&true)
    }

    /// Length of the outline that the air reaches, m.
    pub fn exposed(&self) -> f64 {
        self.lengths().filter(|(_, on_pad)| !on_pad).map(|(length, _)| length).sum()
    }

    fn lengths(&self) -> impl Iterator<Item = (f64, bool)> + '_ {
        self.facets.iter().zip(&self.on_pad).map(|(facet, on_pad)| (facet.length, *on_pad))
    }

    /// Cells with the share that each has in the surface that the air reaches.
    pub fn shares(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        let exposed = self.exposed();
        let facets = self.facets.iter().zip(&self.on_pad).filter(|(_, on_pad)| !**on_pad);
        facets.map(move |(facet, _)| (facet.cell, facet.length / exposed))
    }

    /// Conductance of each piece to its surroundings around a temperature in K, W/(m²·K).
    pub fn conductances(&self, exchange: &Exchange, wind: f64, temperature: f64) -> Vec<f64> {
        let in_air = exchange.coefficient(wind) + exchange.radiation(temperature);
        self.on_pad.iter().map(|on_pad| if *on_pad { exchange.pad } else { in_air }).collect()
    }

    /// Sunlight that each piece absorbs, W/m²: direct and diffuse.
    pub fn absorbed(&self, exchange: &Exchange, weather: &Weather, lit: &[f64]) -> Vec<f64> {
        let of = |(i, facet): (usize, &Facet)| {
            if self.on_pad[i] {
                return 0.0;
            }
            let direct = exchange.filter * weather.direct * lit[i];
            exchange.absorptivity * (direct + sky_share(facet) * weather.diffuse)
        };
        self.facets.iter().enumerate().map(of).collect()
    }

    /// Heat flux into a piece by air, sky and pad at a temperature in K, W/m².
    pub fn exchanged(
        &self,
        piece: usize,
        exchange: &Exchange,
        weather: &Weather,
        temperature: f64,
    ) -> f64 {
        let Weather { ambient, wind, .. } = *weather;
        if self.on_pad[piece] {
            return exchange.pad * (ambient - temperature);
        }
        let sky = sky_share(&self.facets[piece]);
        let seen = sky * exchange.sky(weather) + (1.0 - sky) * fourth(ambient);
        exchange.coefficient(wind) * (ambient - temperature)
            + exchange.emissivity * STEFAN_BOLTZMANN * (seen - fourth(temperature))
    }

    /// The temperature at which a rail of one temperature gives off what it gets, K.
    ///
    /// Newton's method finds it; without any exchange it is that of the air.
    pub fn balance(&self, exchange: &Exchange, weather: &Weather, absorbed: &[f64]) -> f64 {
        let mut temperature = weather.ambient;
        for _ in 0..50 {
            let conductances = self.conductances(exchange, weather.wind, temperature);
            let (mut heat, mut conductance) = (0.0, 0.0);
            for (i, (facet, slope)) in self.facets.iter().zip(conductances).enumerate() {
                heat += facet.length
                    * (absorbed[i] + self.exchanged(i, exchange, weather, temperature));
                conductance += facet.length * slope;
            }
            if conductance <= 0.0 {
                return weather.ambient;
            }
            temperature += heat / conductance;
            if (heat / conductance).abs() < 1e-12 * temperature {
                break;
            }
        }
        temperature
    }
}

fn fourth(temperature: f64) -> f64 {
    (temperature * temperature) * (temperature * temperature)
}

/// Share of the sky in what a piece of surface sees.
fn sky_share(facet: &Facet) -> f64 {
    0.5 * (1.0 - facet.normal.z)
}
