//! The parameters that only `model = "energy"` has, and its constants.

use fmu::ModelError;

use super::common::Common;
use super::site::Site;
use crate::contact::WheelHeat;
use crate::energy::{Beam, Parameters, Resolution, Start, TrainWeather};
use crate::line::Line;
use crate::section::RailFile;
use crate::weather::Exchange;

/// Most elements along the track.
const MOST_ELEMENTS: usize = 1_000_000;

fmu::choices! {
    /// How the section is resolved.
    pub(crate) enum SectionModel {
        /// Cells over depth and width.
        Plane = "2d",
        /// One cell a row.
        Column = "column",
    }
}

fmu::variables! {
    /// What only `model = "energy"` has, but for the site.
    pub(crate) struct EnergyParameters: parameter {
        /// Rail section of model energy: AS60, 60E1, 136RE or the path of a rail file
        rail: "section.rail", String = "AS60";
        /// Section of model energy: "2d" or "column" (area by depth)
        section_model: "section.model", choice(SectionModel) = SectionModel::Plane;
        /// Whether heat is conducted along the track too; for joints and burns, with elements of some cm
        along: "section.along", bool = false;
        /// Whether the sky is colder than the air (Swinbank), as on a clear night
        cold_sky: "sky.cold", bool = false;
        /// Size of the section's cells, about
        cell_size: "section.cell_size", METRE = Parameters::CELL_SIZE, above(0.0);
        /// Modes of the section that decay faster follow the heat that comes in and are kept for no
        /// element; at most a fifth of section.interval; zero: all modes are kept
        shortest: "section.shortest_time", SECOND = 0.2, 0.0..;
        /// Step of the section's conduction while there are wheels on the rail
        interval: "section.interval", SECOND = 1.0, above(0.0);
        /// Rise of the foot that a camera can see
        threshold: "detection.threshold", KELVIN = 0.015, above(0.0);
        /// Conductance of the foot's underside to the pad; zero: insulated
        pad: "foot.conductance", WATT_PER_SQUARE_METRE_KELVIN = 0.0, 0.0..;
        /// Wind at the rail under the train over the train's speed; zero: none
        wind_share: "train.wind_share", ONE = 0.0, 0.0..;
        /// How far a vehicle reaches beyond its first and last wheel
        overhang: "train.overhang", METRE = TrainWeather::TYPICAL.overhang, 0.0..;
        /// Heat capacity of a wheel; about 350 kg
        wheel_capacity: "wheel.heat_capacity", JOULE_PER_KELVIN = WheelHeat::TYPICAL.capacity,
            above(0.0);
        /// Heat that a wheel gives to the air per time and temperature difference
        wheel_cooling: "wheel.cooling", WATT_PER_KELVIN = WheelHeat::TYPICAL.cooling, 0.0..;
        /// Temperature of the wheels above the air at the start
        wheel_rise: "wheel.initial_rise", KELVIN = 0.0, 0.0..;
        /// Conductance of the contact over that of a perfect one; zero: no rail chill
        contact_quality: "wheel.contact_quality", ONE = 1.0, 0.0..=1.0;
        /// Young's modulus of the rail
        modulus: "rail.modulus", PASCAL = Beam::TYPICAL.modulus, above(0.0);
        /// Track modulus: force per length of rail and deflection
        track_modulus: "track.modulus", PASCAL = Beam::TYPICAL.track_modulus, above(0.0);
        /// Coefficient of thermal expansion; zero: no thermoelastic effect
        expansion: "rail.expansion", PER_KELVIN = Beam::TYPICAL.expansion, 0.0..;
        /// Loss factor of the rail's steel; zero: no heat by hysteresis
        loss_factor: "rail.loss_factor", ONE = Beam::TYPICAL.loss_factor, 0.0..;
    }
}

impl EnergyParameters {
    /// The constants, with the depths in m at which the rise is read.
    pub(crate) fn constants(
        &self,
        common: &Common,
        site: Site,
        depths: &[f64],
    ) -> Result<Parameters, ModelError> {
        let rail = RailFile::open(&self.rail).map_err(ModelError::from_error)?;
        let outline = rail.outline();
        let of_section = outline.properties();
        Ok(Parameters {
            line: site.line,
            azimuth: site.azimuth,
            ephemeris: site.ephemeris,
            conducts_along: self.along,
            resolution: match self.section_model {
                SectionModel::Plane => Resolution::Plane,
                SectionModel::Column => Resolution::Column,
            },
            cell_size: self.cell_size,
            shortest: self.shortest,
            interval: self.interval,
            material: common.steel.material(),
            wheel: WheelHeat {
                partition: common.partition,
                capacity: self.wheel_capacity,
                cooling: self.wheel_cooling,
                initial_rise: self.wheel_rise,
                contact_quality: self.contact_quality,
            },
            beam: Beam {
                modulus: self.modulus,
                second_moment: of_section.second_moment,
                to_foot: outline.height() - of_section.centroid,
                track_modulus: self.track_modulus,
                expansion: self.expansion,
                loss_factor: self.loss_factor,
            },
            exchange: Exchange {
                convection: common.convection,
                emissivity: common.emissivity,
                absorptivity: common.absorptivity,
                filter: common.filter,
                cold_sky: self.cold_sky,
                pad: self.pad,
            },
            train: TrainWeather {
                shade: site.shade,
                wind_share: self.wind_share,
                overhang: self.overhang,
            },
            start: match site.day {
                Some(day) => Start::Day(day),
                None if common.equilibrium => Start::Equilibrium,
                None => Start::Uniform(common.temperature),
            },
            depths: depths.to_vec(),
            threshold: self.threshold,
            outline,
        })
    }
}

/// The elements along the track, if there are not too many.
pub(crate) fn line(common: &Common) -> Result<Line, ModelError> {
    let line = common.line()?;
    if line.elements > MOST_ELEMENTS {
        return Err(ModelError::new(format!(
            "the track has {} elements, more than {MOST_ELEMENTS}; choose a shorter track.length or \
             longer elements",
            line.elements
        )));
    }
    Ok(line)
}
