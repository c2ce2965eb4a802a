//! The parameters of both models, with those of the paper's column among them.

use fmu::ModelError;

use crate::contact::{Friction, Material};
use crate::line::Line;
use crate::paper::RunningSurface;
use crate::weather::Exchange;

fmu::choices! {
    /// Which heat model computes the rail.
    pub(crate) enum ModelChoice {
        /// The model of Bosomworth et al. 2018.
        Paper = "paper",
        /// Heat that is conserved, in a real section.
        Energy = "energy",
    }

    /// What a field that cannot be written does to the run.
    pub(crate) enum FieldFailure {
        /// Ends it.
        Stop = "stop",
        /// Lets it continue without the field.
        Continue = "go_on",
    }
}

fmu::variables! {
    /// The column of cells that conducts heat in the paper's model.
    pub(crate) struct Column: parameter {
        /// Height of the rail, a whole number of cells; AS 60 kg rail
        height: "rail.height", METRE = 0.170, above(0.0);
        /// Width of the column that conducts heat; scales the energies only
        width: "rail.width", METRE = 0.075, above(0.0);
        /// Size of a cell over the depth; the heat that a wheel puts in is proportional to it
        /// (known defect of the paper's model)
        cell_size: "cell.size", METRE = 0.005, above(0.0);
        /// Step of weather and conduction; diffusivity * interval / cell size^2 must not be over 0.5
        interval: "conduction.interval", SECOND = 0.05, above(0.0);
    }

    /// The rail's steel.
    pub(crate) struct Steel: parameter {
        /// Thermal conductivity of the rail
        conductivity: "material.conductivity", WATT_PER_METRE_KELVIN = Material::PAPER.conductivity,
            above(0.0);
        /// Density of the rail
        density: "material.density", KILOGRAM_PER_CUBIC_METRE = Material::PAPER.density, above(0.0);
        /// Specific heat of the rail
        specific_heat: "material.specific_heat", JOULE_PER_KILOGRAM_KELVIN
            = Material::PAPER.specific_heat, above(0.0);
    }

    /// What both models have.
    pub(crate) struct Common: parameter {
        /// Length of an element along the track; with a rail width of 75 mm 0.1 m gives the
        /// paper's top area of 0.0075 m2
        element_length: "element.length", METRE = 0.1, above(0.0);
        /// Length of the modelled track
        length: "track.length", METRE = 6000.0, above(0.0);
        /// The column of the paper's model.
        column: "", group(Column);
        /// The rail's steel.
        steel: "", group(Steel);
        /// Friction coefficient of wheel on rail
        friction: "friction.coefficient", ONE = Friction::PAPER.coefficient, above(0.0);
        /// Heat transfer coefficient of the running surface to the air
        convection: "surface.convection", WATT_PER_SQUARE_METRE_KELVIN
            = RunningSurface::PAPER.convection, 0.0..;
        /// Temperature of the whole rail at the start, if not in equilibrium with the weather
        temperature: "initial.temperature", KELVIN = 298.15, above(0.0);
        /// Time between two snapshots of the field
        field_interval: "field_interval", SECOND = 10.0, above(0.0);
        /// Share of the friction heat that flows into the rail; one half for equal steels
        partition: "friction.partition", ONE = Friction::PAPER.partition, 0.0..=1.0;
        /// Emissivity of the running surface
        emissivity: "surface.emissivity", ONE = RunningSurface::PAPER.emissivity, 0.0..=1.0;
        /// Share of the sunlight that the running surface absorbs
        absorptivity: "solar.absorptivity", ONE = RunningSurface::PAPER.absorptivity, 0.0..=1.0;
        /// Share of solar.irradiance that arrives at the rail; 1 for an irradiance measured at the ground
        filter: "solar.filter", ONE = Exchange::TYPICAL.filter, 0.0..=1.0;
        /// Chainage at which the modelled track begins
        begin: "track.begin", METRE = 0.0;
        /// Heat model: "energy" (heat that is conserved, in a real section) or "paper" (Bosomworth et al. 2018)
        model: "model", choice(ModelChoice) = ModelChoice::Energy;
        /// Start at the temperature at which sun, convection and radiation balance
        equilibrium: "initial.equilibrium", bool = true;
        /// Folder of the Zarr store for the field of the temperature rise; empty: none is written
        field_file: "field_file", String = "";
        /// What a field that cannot be written does to the run: "stop", or "go_on" without it
        field_failure: "field_failure", choice(FieldFailure) = FieldFailure::Stop;
        /// File with the weather over time, CSV or of EnergyPlus (.epw), instead of the inputs; empty: the inputs
        weather_file: "weather_file", String = "";
    }
}

impl Steel {
    pub(crate) fn material(&self) -> Material {
        let Self { conductivity, density, specific_heat } = *self;
        Material { conductivity, density, specific_heat }
    }
}

impl Common {
    /// The elements along the track; the length must be a whole number of them.
    pub(crate) fn line(&self) -> Result<Line, ModelError> {
        let Self { begin, element_length, length, .. } = *self;
        let elements = whole("track.length", length, "element.length", element_length)?;
        Ok(Line { begin, element_length, elements })
    }
}

/// How many parts of `part` make up `whole`; at least two and, but for rounding, a whole number.
pub(crate) fn whole(
    name: &str,
    whole: f64,
    part_name: &str,
    part: f64,
) -> Result<usize, ModelError> {
    let parts = (whole / part).round();
    if parts >= 2.0 && (parts * part - whole).abs() <= 1e-6 * part {
        return Ok(parts as usize);
    }
    Err(ModelError::new(format!(
        "{name} = {whole} m and {part_name} = {part} m: the first must be the second times a whole \
         number of at least 2"
    )))
}
