//! The FMU's parameters that only `model = "energy"` uses.

use fmu::{Boolean, Declaration, ModelError, Real, Text, Values, unit};

use super::bounds::{not_negative, positive, share, whole, wrong};
use super::parameters::ParameterSignals;
use crate::contact::WheelHeat;
use crate::energy::{Azimuth, Beam, Day, Parameters, Resolution, Start, TrainWeather};
use crate::line::Line;
use crate::section::RailFile;
use crate::weather::{Body, Ephemeris, Exchange};

/// Most elements along the track.
const MOST_ELEMENTS: f64 = 1e6;

/// Handles of the parameters.
#[derive(Debug)]
pub(crate) struct EnergyParameterSignals {
    rail: Text,
    resolution: Text,
    cell_size: Real,
    shortest: Real,
    interval: Real,
    threshold: Real,
    cold_sky: Boolean,
    along: Boolean,
    pad: Real,
    wind_share: Real,
    overhang: Real,
    wheel_capacity: Real,
    wheel_cooling: Real,
    wheel_rise: Real,
    contact_quality: Real,
    modulus: Real,
    track_modulus: Real,
    expansion: Real,
    loss_factor: Real,
}

impl EnergyParameterSignals {
    pub(crate) fn declare(declaration: &mut Declaration) -> Self {
        let rail = declaration.text_parameter(
            "section.rail",
            "Rail section of model energy: AS60, 60E1, 136RE or the path of a rail file",
            "AS60",
        );
        let resolution = declaration.text_parameter(
            "section.model",
            "Section of model energy: \"2d\" or \"column\" (area by depth)",
            "2d",
        );
        let along = declaration.boolean_parameter(
            "section.along",
            "Whether heat is conducted along the track too; for joints and burns, with elements of some cm",
            false,
        );
        let cold_sky = declaration.boolean_parameter(
            "sky.cold",
            "Whether the sky is colder than the air (Swinbank), as on a clear night",
            false,
        );
        let mut real = |name: &str, unit, description: &str, start: f64| {
            declaration.real(name, unit, description).min(0.0).parameter(start)
        };
        Self {
            rail,
            resolution,
            along,
            cold_sky,
            cell_size: real(
                "section.cell_size",
                unit::METRE,
                "Size of the section's cells, about",
                Parameters::CELL_SIZE,
            ),
            shortest: real(
                "section.shortest_time",
                unit::SECOND,
                "Modes of the section that decay faster follow the heat that comes in and are kept for no \
                 element; at most a fifth of section.interval; zero: all modes are kept",
                0.2,
            ),
            interval: real(
                "section.interval",
                unit::SECOND,
                "Step of the section's conduction while there are wheels on the rail",
                1.0,
            ),
            threshold: real(
                "detection.threshold",
                unit::KELVIN,
                "Rise of the foot that a camera can see",
                0.015,
            ),
            pad: real(
                "foot.conductance",
                unit::WATT_PER_SQUARE_METRE_KELVIN,
                "Conductance of the foot's underside to the pad; zero: insulated",
                0.0,
            ),
            wind_share: real(
                "train.wind_share",
                unit::ONE,
                "Wind at the rail under the train over the train's speed; zero: none",
                0.0,
            ),
            overhang: real(
                "train.overhang",
                unit::METRE,
                "How far a vehicle reaches beyond its first and last wheel",
                TrainWeather::TYPICAL.overhang,
            ),
            wheel_capacity: real(
                "wheel.heat_capacity",
                unit::JOULE_PER_KELVIN,
                "Heat capacity of a wheel; about 350 kg",
                WheelHeat::TYPICAL.capacity,
            ),
            wheel_cooling: real(
                "wheel.cooling",
                unit::WATT_PER_KELVIN,
                "Heat that a wheel gives to the air per time and temperature difference",
                WheelHeat::TYPICAL.cooling,
            ),
            wheel_rise: real(
                "wheel.initial_rise",
                unit::KELVIN,
                "Temperature of the wheels above the air at the start",
                0.0,
            ),
            contact_quality: real(
                "wheel.contact_quality",
                unit::ONE,
                "Conductance of the contact over that of a perfect one; zero: no rail chill",
                1.0,
            ),
            modulus: real(
                "rail.modulus",
                unit::PASCAL,
                "Young's modulus of the rail",
                Beam::TYPICAL.modulus,
            ),
            track_modulus: real(
                "track.modulus",
                unit::PASCAL,
                "Track modulus: force per length of rail and deflection",
                Beam::TYPICAL.track_modulus,
            ),
            expansion: real(
                "rail.expansion",
                unit::PER_KELVIN,
                "Coefficient of thermal expansion; zero: no thermoelastic effect",
                Beam::TYPICAL.expansion,
            ),
            loss_factor: real(
                "rail.loss_factor",
                unit::ONE,
                "Loss factor of the rail's steel; zero: no heat by hysteresis",
                Beam::TYPICAL.loss_factor,
            ),
        }
    }

    /// The constants of the model, with the depths in m at which the rise is read.
    pub(crate) fn read(
        &self,
        common: &ParameterSignals,
        site: Site,
        values: &Values,
        depths: &[f64],
    ) -> Result<Parameters, ModelError> {
        let Site { azimuth, ephemeris, shade, day, line } = site;
        let rail = RailFile::open(&values[self.rail]).map_err(ModelError::from_error)?;
        let outline = rail.outline();
        let of_section = outline.properties();
        let cell_size = positive("section.cell_size", values[self.cell_size])?;
        Ok(Parameters {
            line,
            azimuth,
            ephemeris,
            conducts_along: values[self.along],
            resolution: self.resolution(values)?,
            cell_size,
            shortest: not_negative("section.shortest_time", values[self.shortest])?,
            interval: positive("section.interval", values[self.interval])?,
            material: common.material(values)?,
            wheel: WheelHeat {
                partition: share("friction.partition", values[common.partition])?,
                capacity: positive("wheel.heat_capacity", values[self.wheel_capacity])?,
                cooling: not_negative("wheel.cooling", values[self.wheel_cooling])?,
                initial_rise: not_negative("wheel.initial_rise", values[self.wheel_rise])?,
                contact_quality: share("wheel.contact_quality", values[self.contact_quality])?,
            },
            beam: Beam {
                modulus: positive("rail.modulus", values[self.modulus])?,
                second_moment: of_section.second_moment,
                to_foot: outline.height() - of_section.centroid,
                track_modulus: positive("track.modulus", values[self.track_modulus])?,
                expansion: not_negative("rail.expansion", values[self.expansion])?,
                loss_factor: not_negative("rail.loss_factor", values[self.loss_factor])?,
            },
            exchange: self.exchange(common, values)?,
            train: TrainWeather {
                shade,
                wind_share: not_negative("train.wind_share", values[self.wind_share])?,
                overhang: not_negative("train.overhang", values[self.overhang])?,
            },
            start: match day {
                Some(day) => Start::Day(day),
                None if values[common.equilibrium] => Start::Equilibrium,
                None => {
                    Start::Uniform(positive("initial.temperature", values[common.temperature])?)
                }
            },
            depths: depths.to_vec(),
            threshold: positive("detection.threshold", values[self.threshold])?,
            outline,
        })
    }

    fn resolution(&self, values: &Values) -> Result<Resolution, ModelError> {
        match values[self.resolution].as_str() {
            "2d" => Ok(Resolution::Plane),
            "column" => Ok(Resolution::Column),
            other => Err(ModelError::new(format!(
                "section.model = \"{other}\": must be \"2d\" or \"column\""
            ))),
        }
    }

    fn exchange(&self, common: &ParameterSignals, values: &Values) -> Result<Exchange, ModelError> {
        Ok(Exchange {
            convection: not_negative("surface.convection", values[common.convection])?,
            emissivity: share("surface.emissivity", values[common.emissivity])?,
            absorptivity: share("solar.absorptivity", values[common.absorptivity])?,
            filter: share("solar.filter", values[common.filter])?,
            cold_sky: values[self.cold_sky],
            pad: not_negative("foot.conductance", values[self.pad])?,
        })
    }
}

/// What the parameters of site and time amount to.
pub(crate) struct Site {
    pub line: Line,
    pub azimuth: Azimuth,
    pub ephemeris: Option<Ephemeris>,
    pub shade: Option<Body>,
    pub day: Option<Day>,
}

/// The elements along the track.
pub(crate) fn line(common: &ParameterSignals, values: &Values) -> Result<Line, ModelError> {
    let begin = values[common.begin];
    if !begin.is_finite() {
        return Err(wrong("track.begin", begin, "must be a finite number"));
    }
    let element_length = positive("element.length", values[common.element_length])?;
    let elements = whole("track.length", values[common.length], "element.length", element_length)?;
    if elements > MOST_ELEMENTS {
        return Err(ModelError::new(format!(
            "the track has {elements} elements, more than {MOST_ELEMENTS}; choose a shorter \
             track.length or longer elements"
        )));
    }
    Ok(Line { begin, element_length, elements: elements as usize })
}
