//! The model at its start.

use std::ops::Range;

use super::along::Along;
use super::answer::Answer;
use super::elements::{Elements, Extra};
use super::followers::{self, Followers};
use super::initial::Initial;
use super::ledger::Ledger;
use super::model::{EnergyModel, State};
use super::parameters::{Parameters, Resolution, Start};
use super::start::NeverSettles;
use super::untouched::{self, Untouched};
use super::zones::{self, Sector, Zone};
use crate::line::Highest;
use crate::section::{Cells, Crown, Modes, NoModes, Propagator, Readings};
use crate::weather::{Light, Surface, Weather};

/// The model cannot begin.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum CannotBegin {
    /// The section has no modes.
    #[error(transparent)]
    Modes(#[from] NoModes),
    /// The rail never comes to a daily course.
    #[error(transparent)]
    Day(#[from] NeverSettles),
    /// Nothing of the section lies on the pad.
    #[error(
        "foot.conductance = {0} W/(m2.K), but the rail section has no level underside that could lie \
         on a pad: corners_mm must end with a level side, or foot.conductance be zero"
    )]
    NoUnderside(f64),
}

impl EnergyModel {
    /// A rail at its start, with so many wheels on each vehicle.
    ///
    /// # Errors
    /// When the section has too few or too many cells or no underside for the pad, or never comes to a
    /// daily course.
    pub fn new(
        parameters: Parameters,
        wheelsets: &[usize],
        weather: &Weather,
        start_time: f64,
    ) -> Result<Self, CannotBegin> {
        let Parameters { outline, material, exchange, cell_size, line, .. } = &parameters;
        let cells = match parameters.resolution {
            Resolution::Column => Cells::column(outline, *cell_size),
            Resolution::Plane => Cells::grid(outline, *cell_size),
        };
        let surface = Surface::new(&cells);
        if exchange.pad > 0.0 && !surface.lies_on_pad() {
            return Err(CannotBegin::NoUnderside(exchange.pad));
        }
        let mut weather = *weather;
        if let Some(ephemeris) = &parameters.ephemeris {
            weather.sun = ephemeris.at(start_time);
        }
        let (sectors, zone_of) = zones::sectors(&parameters.azimuth, line.elements);
        let light = Light::new(outline, &surface, exchange, &weather, sectors[0].azimuth);
        let base = match parameters.start {
            Start::Uniform(temperature) => temperature,
            _ => surface.balance(exchange, &weather, &light.absorbed),
        };
        let linear = surface.conductances(exchange, weather.wind, base);
        let modes = Modes::new(&cells, material, &linear, *cell_size)?;
        let mean = modes.weighted(surface.shares());
        let mut untouched = Untouched::new(surface, *exchange, linear, &modes);
        let readings = Readings::new(&cells, &modes, &parameters.depths);
        let crown = Crown::new(&cells, &modes);
        let bending = bending_shape(&cells, &modes, &parameters);
        let propagator = Propagator::new(&modes, parameters.interval);
        let kept = kept(&modes, &parameters);
        let mut followers = Followers::new(&modes, kept, &readings, &crown, [&bending, &mean]);
        followers.set_time(&propagator);
        let mut of_sector = |sector| {
            let start =
                Beginning { parameters: &parameters, modes: &modes, weather: &weather, base };
            let extra = Extra::none(mean.clone(), followers.count());
            start.zone(sector, &mut untouched, extra, readings.levels.len())
        };
        let zones = sectors.into_iter().map(&mut of_sector).collect::<Result<Vec<_>, _>>()?;
        let wheels = wheelsets.iter().sum();
        let counts = Counts {
            untouched: modes.width(),
            kept,
            readings: followers.count(),
            levels: readings.levels.len(),
            wheels,
            zones: zones.len(),
        };
        let initial = State::new(&parameters, &counts, &weather, start_time);
        let mut model = Self {
            zones,
            zone_of,
            along: parameters.conducts_along.then(|| Along::new(line.elements)),
            sections: None,
            crown,
            bending,
            followers,
            hysteresis: parameters.beam.hysteresis(1.0),
            propagator,
            surface: vec![0.0; line.elements],
            foot: Highest { rise: 0.0, chainage: line.chainage(0) },
            chainages: vec![None; wheels],
            source: vec![0.0; kept],
            vehicles: vehicles(wheelsets),
            state: initial,
            untouched,
            readings,
            cells,
            modes,
            parameters,
        };
        model.read_untouched();
        Ok(model)
    }
}

/// What the zones of a track are made of.
struct Beginning<'b> {
    parameters: &'b Parameters,
    modes: &'b Modes,
    weather: &'b Weather,
    /// Temperature around which the modes are linear, K.
    base: f64,
}

impl Beginning<'_> {
    fn zone(
        &self,
        sector: Sector,
        untouched: &mut Untouched,
        extra: Extra,
        levels: usize,
    ) -> Result<Zone, NeverSettles> {
        let Self { parameters, modes, weather, base } = *self;
        let (outline, exchange) = (&parameters.outline, &parameters.exchange);
        let light = Light::new(outline, untouched.surface(), exchange, weather, sector.azimuth);
        let pieces = untouched.surface().facets().len();
        let initial = match &parameters.start {
            Start::Uniform(temperature) => Initial::uniform(pieces, modes, *temperature),
            Start::Equilibrium => {
                Initial::equilibrium(untouched, modes, weather, &light.absorbed, base)
            }
            Start::Day(day) => {
                Initial::after_days(untouched, modes, outline, sector.azimuth, day, base)?
            }
        };
        // In equilibrium nothing shall change, so that the mean stands for what the modes have.
        let around = match parameters.start {
            Start::Equilibrium => initial.mean(untouched.surface()),
            _ => base,
        };
        Ok(Zone {
            in_modes: exchange.coefficient(weather.wind) + exchange.radiation(around),
            crown: initial.crown(untouched.surface()),
            rises: vec![0.0; levels],
            sector,
            initial,
            light,
            extra,
        })
    }
}

/// How many there are of what a state has.
struct Counts {
    /// Amplitudes of untouched rail.
    untouched: usize,
    /// Amplitudes of an element.
    kept: usize,
    readings: usize,
    levels: usize,
    wheels: usize,
    zones: usize,
}

impl State {
    fn new(parameters: &Parameters, counts: &Counts, weather: &Weather, start_time: f64) -> Self {
        let Counts { untouched, kept, readings, levels, wheels, zones } = *counts;
        let nowhere = Highest { rise: 0.0, chainage: parameters.line.chainage(0) };
        let untouched = untouched::State { amplitudes: vec![0.0; untouched], weather: 0.0 };
        Self {
            elements: Elements::new(parameters.line.elements, kept, readings),
            kept_elements: vec![],
            untouched: vec![untouched; zones],
            conducted: start_time,
            positions: vec![None; wheels],
            wheels: vec![weather.ambient + parameters.wheel.initial_rise; wheels],
            ledger: Ledger::default(),
            highest: vec![nowhere; levels],
            highest_flash: 0.0,
            answer: Answer::default(),
            stray_warned: false,
        }
    }
}

/// Number of amplitudes that are kept for an element: of modes that do not follow.
fn kept(modes: &Modes, parameters: &Parameters) -> usize {
    let shortest = parameters.shortest.min(parameters.interval / followers::DECAYS);
    if shortest > 0.0 { modes.width_below(1.0 / shortest) } else { modes.even_width() }
}

/// Amplitudes by 1 J/m of hysteresis heat: with the square of the distance from the neutral axis.
fn bending_shape(cells: &Cells, modes: &Modes, parameters: &Parameters) -> Vec<f64> {
    let axis = parameters.outline.properties().centroid;
    let weight = |cell: &crate::section::Cell| cell.area * (cell.middle.z - axis).powi(2);
    let sum: f64 = cells.cells.iter().map(weight).sum();
    modes.weighted(cells.cells.iter().enumerate().map(|(i, cell)| (i, weight(cell) / sum)))
}

/// The wheels of each vehicle in the order of all wheels.
fn vehicles(wheelsets: &[usize]) -> Vec<Range<usize>> {
    let mut first = 0;
    let range = |count: &usize| {
        let range = first..first + count;
        first += count;
        range
    };
    wheelsets.iter().map(range).collect()
}
