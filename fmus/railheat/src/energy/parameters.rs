//! All constants of the model.

use super::bending::Beam;
use super::start::Day;
use super::zones::Azimuth;
use crate::contact::{Material, WheelHeat};
use crate::line::Line;
use crate::section::Outline;
use crate::weather::{Body, Ephemeris, Exchange};

/// How the section is resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// One cell a row: area by depth.
    Column,
    /// Cells over depth and width.
    Plane,
}

/// State of the rail at the start.
#[derive(Clone, Debug, PartialEq)]
pub enum Start {
    /// One temperature, K.
    Uniform(f64),
    /// In equilibrium with the weather at the start.
    Equilibrium,
    /// As a day leaves it that has come again and again.
    Day(Day),
}

/// What the train does to the weather.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrainWeather {
    /// What of the vehicles shades the rail; none: nothing.
    pub shade: Option<Body>,
    /// Wind at the rail under the train over the train's speed.
    pub wind_share: f64,
    /// How far a vehicle reaches beyond its first and last wheel, m.
    pub overhang: f64,
}

impl TrainWeather {
    /// Shade without wind of the train.
    pub const TYPICAL: Self = Self { shade: Some(Body::WAGON), wind_share: 0.0, overhang: 2.8 };
}

/// All constants of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct Parameters {
    /// How the rail is cut along the track.
    pub line: Line,
    /// Outline of the rail.
    pub outline: Outline,
    /// How the section is resolved.
    pub resolution: Resolution,
    /// Size of its cells, m.
    pub cell_size: f64,
    /// Modes that decay faster follow the heat that comes in, s; at most a fifth of the interval.
    pub shortest: f64,
    /// Step of the conduction while there are wheels on the rail, s.
    pub interval: f64,
    /// Steel.
    pub material: Material,
    /// Wheels.
    pub wheel: WheelHeat,
    /// Beam, for the effects of bending.
    pub beam: Beam,
    /// Exchange with the weather.
    pub exchange: Exchange,
    /// Where the track runs.
    pub azimuth: Azimuth,
    /// Where the sun stands; none: where the weather says.
    pub ephemeris: Option<Ephemeris>,
    /// Whether heat is conducted along the track.
    pub conducts_along: bool,
    /// What the train does to the weather.
    pub train: TrainWeather,
    /// State at the start.
    pub start: Start,
    /// Depths at which the rise is read besides surface and foot, m.
    pub depths: Vec<f64>,
    /// Rise of the foot that a camera can see, K.
    pub threshold: f64,
}

impl Parameters {
    /// Size of the section's cells if nothing else is said, m: 0.1 mK at the foot.
    pub const CELL_SIZE: f64 = 0.0025;

    /// A straight rail of a section with the FMU's default values, but all of the sun's light.
    pub fn new(outline: Outline, line: Line) -> Self {
        let of_section = outline.properties();
        Self {
            line,
            resolution: Resolution::Plane,
            cell_size: Self::CELL_SIZE,
            shortest: 0.2,
            interval: 1.0,
            material: Material::PAPER,
            wheel: WheelHeat::TYPICAL,
            beam: Beam {
                second_moment: of_section.second_moment,
                to_foot: outline.height() - of_section.centroid,
                ..Beam::TYPICAL
            },
            exchange: Exchange::TYPICAL,
            azimuth: Azimuth::Constant(0.0),
            ephemeris: None,
            conducts_along: false,
            train: TrainWeather::TYPICAL,
            start: Start::Equilibrium,
            depths: vec![],
            threshold: 0.015,
            outline,
        }
    }
}
