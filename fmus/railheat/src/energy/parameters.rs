//! All constants of the model.

use super::bending::Beam;
use super::ephemeris::Ephemeris;
use super::initial::Day;
use super::shadow::Body;
use super::weather::Exchange;
use super::wheels::WheelHeat;
use super::zones::Azimuth;
use crate::material::Material;
use crate::section::Outline;

/// How the section is resolved.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Resolution {
    /// One cell a row: area by depth.
    Column,
    /// Cells over depth and width.
    Plane,
}

/// How the rail is cut along the track.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line {
    /// Chainage at which the first element begins, m.
    pub begin: f64,
    /// Length of an element, m.
    pub element_length: f64,
    /// Number of elements.
    pub elements: usize,
}

impl Line {
    /// Chainage at which the last element ends, m.
    pub fn end(&self) -> f64 {
        self.begin + self.elements as f64 * self.element_length
    }

    /// Chainage of the middle of an element, m.
    pub fn chainage(&self, element: usize) -> f64 {
        self.begin + (element as f64 + 0.5) * self.element_length
    }

    /// The element at a chainage, if it is modelled.
    pub fn element(&self, chainage: f64) -> Option<usize> {
        let place = (chainage - self.begin) / self.element_length;
        (place >= 0.0 && place < self.elements as f64).then_some(place as usize)
    }

    /// The element at a chainage, or the one that is nearest to it.
    pub fn nearest(&self, chainage: f64) -> usize {
        let place = (chainage - self.begin) / self.element_length;
        (place.max(0.0) as usize).min(self.elements - 1)
    }

    /// The elements that a way covers, with the share of it in each. A point is a way too.
    pub fn shares(&self, from: f64, to: f64) -> impl Iterator<Item = (usize, f64)> {
        let Self { begin, element_length, elements } = *self;
        let (low, high) = if from <= to { (from, to) } else { (to, from) };
        let place = |chainage: f64| (chainage - begin) / element_length;
        let (low, high) = (place(low), place(high));
        let way = high - low;
        let first = low.max(0.0) as usize;
        let last = (high.max(-1.0) + 1.0).min(elements as f64) as usize;
        (first..last).filter_map(move |element| {
            let (start, end) = (element as f64, element as f64 + 1.0);
            if way > 0.0 {
                let part = high.min(end) - low.max(start);
                return (part > 0.0).then_some((element, part / way));
            }
            (low >= start && low < end).then_some((element, 1.0))
        })
    }
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
