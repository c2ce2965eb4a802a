//! The FMU's parameters: declared, read and checked.

use fmu::{Boolean, Declaration, ModelError, Real, Text, Values, unit};

use super::bounds::{not_negative, positive, share, whole, wrong};
use crate::contact::{Friction, Material};
use crate::line::Line;
use crate::paper::{Grid, Parameters, RunningSurface};
use crate::weather::Weather;

/// Most cells of the whole rail: 0.8 GB.
const MOST_CELLS: f64 = 1e8;

/// Handles of the parameters.
#[derive(Debug)]
pub(crate) struct ParameterSignals {
    pub(crate) model: Text,
    pub(crate) begin: Real,
    pub(crate) length: Real,
    pub(crate) element_length: Real,
    height: Real,
    width: Real,
    cell_size: Real,
    conduction_interval: Real,
    pub(crate) conductivity: Real,
    pub(crate) density: Real,
    pub(crate) specific_heat: Real,
    friction: Real,
    pub(crate) partition: Real,
    pub(crate) convection: Real,
    pub(crate) emissivity: Real,
    pub(crate) absorptivity: Real,
    pub(crate) filter: Real,
    pub(crate) equilibrium: Boolean,
    pub(crate) temperature: Real,
    pub(crate) field_file: Text,
    pub(crate) field_failure: Text,
    pub(crate) weather_file: Text,
    pub(crate) field_interval: Real,
}

impl ParameterSignals {
    pub(crate) fn declare(declaration: &mut Declaration) -> Self {
        let mut real = |name: &str, unit, description: &str, start: f64| {
            declaration.real(name, unit, description).min(0.0).parameter(start)
        };
        let element_length = real(
            "element.length",
            unit::METRE,
            "Length of an element along the track; with a rail width of 75 mm 0.1 m gives the \
             paper's top area of 0.0075 m2",
            0.1,
        );
        let length = real("track.length", unit::METRE, "Length of the modelled track", 6000.0);
        let height = real(
            "rail.height",
            unit::METRE,
            "Height of the rail, a whole number of cells; AS 60 kg rail",
            0.170,
        );
        let width = real(
            "rail.width",
            unit::METRE,
            "Width of the column that conducts heat; scales the energies only",
            0.075,
        );
        let cell_size = real(
            "cell.size",
            unit::METRE,
            "Size of a cell over the depth; the heat that a wheel puts in is proportional to it \
             (known defect of the paper's model)",
            0.005,
        );
        let conduction_interval = real(
            "conduction.interval",
            unit::SECOND,
            "Step of weather and conduction; diffusivity * interval / cell size^2 must not be over 0.5",
            0.05,
        );
        let conductivity = real(
            "material.conductivity",
            unit::WATT_PER_METRE_KELVIN,
            "Thermal conductivity of the rail",
            Material::PAPER.conductivity,
        );
        let density = real(
            "material.density",
            unit::KILOGRAM_PER_CUBIC_METRE,
            "Density of the rail",
            Material::PAPER.density,
        );
        let specific_heat = real(
            "material.specific_heat",
            unit::JOULE_PER_KILOGRAM_KELVIN,
            "Specific heat of the rail",
            Material::PAPER.specific_heat,
        );
        let friction = real(
            "friction.coefficient",
            unit::ONE,
            "Friction coefficient of wheel on rail",
            Friction::PAPER.coefficient,
        );
        let convection = real(
            "surface.convection",
            unit::WATT_PER_SQUARE_METRE_KELVIN,
            "Heat transfer coefficient of the running surface to the air",
            RunningSurface::PAPER.convection,
        );
        let temperature = real(
            "initial.temperature",
            unit::KELVIN,
            "Temperature of the whole rail at the start, if not in equilibrium with the weather",
            298.15,
        );
        let field_interval =
            real("field_interval", unit::SECOND, "Time between two snapshots of the field", 10.0);
        let mut share = |name: &str, description: &str, start: f64| {
            declaration.real(name, unit::ONE, description).min(0.0).max(1.0).parameter(start)
        };
        let partition = share(
            "friction.partition",
            "Share of the friction heat that flows into the rail; one half for equal steels",
            Friction::PAPER.partition,
        );
        let emissivity = share(
            "surface.emissivity",
            "Emissivity of the running surface",
            RunningSurface::PAPER.emissivity,
        );
        let absorptivity = share(
            "solar.absorptivity",
            "Share of the sunlight that the running surface absorbs",
            RunningSurface::PAPER.absorptivity,
        );
        let filter = share(
            "solar.filter",
            "Share of solar.irradiance that arrives at the rail; 1 for an irradiance measured at the ground",
            RunningSurface::PAPER.filter,
        );
        let begin = declaration
            .real("track.begin", unit::METRE, "Chainage at which the modelled track begins")
            .parameter(0.0);
        Self {
            model: declaration.text_parameter(
                "model",
                "Heat model: \"paper\" (Bosomworth et al. 2018) or \"energy\" (heat that is conserved, in a real section)",
                "paper",
            ),
            equilibrium: declaration.boolean_parameter(
                "initial.equilibrium",
                "Start at the temperature at which sun, convection and radiation balance",
                true,
            ),
            field_file: declaration.text_parameter(
                "field_file",
                "Folder of the Zarr store for the field of the temperature rise; empty: none is written",
                "",
            ),
            field_failure: declaration.text_parameter(
                "field_failure",
                "What a field that cannot be written does to the run: \"stop\", or \"go_on\" without it",
                "stop",
            ),
            weather_file: declaration.text_parameter(
                "weather_file",
                "CSV file with the weather over time, instead of the inputs; empty: the inputs",
                "",
            ),
            begin,
            length,
            element_length,
            height,
            width,
            cell_size,
            conduction_interval,
            conductivity,
            density,
            specific_heat,
            friction,
            partition,
            convection,
            emissivity,
            absorptivity,
            filter,
            temperature,
            field_interval,
        }
    }

    /// The constants of the model, with the depths in m at which the highest rise is looked for.
    pub(crate) fn read(
        &self,
        values: &Values,
        weather: &Weather,
        depths: &[f64],
    ) -> Result<Parameters, ModelError> {
        let grid = self.grid(values)?;
        let surface = RunningSurface {
            convection: not_negative("surface.convection", values[self.convection])?,
            emissivity: share("surface.emissivity", values[self.emissivity])?,
            absorptivity: share("solar.absorptivity", values[self.absorptivity])?,
            filter: share("solar.filter", values[self.filter])?,
        };
        Ok(Parameters {
            depths: depths.to_vec(),
            width: positive("rail.width", values[self.width])?,
            conduction_interval: positive("conduction.interval", values[self.conduction_interval])?,
            material: self.material(values)?,
            friction: Friction {
                coefficient: positive("friction.coefficient", values[self.friction])?,
                partition: share("friction.partition", values[self.partition])?,
            },
            initial_temperature: if values[self.equilibrium] {
                surface.equilibrium(weather)
            } else {
                positive("initial.temperature", values[self.temperature])?
            },
            surface,
            grid,
        })
    }

    /// The rail's steel.
    pub(crate) fn material(&self, values: &Values) -> Result<Material, ModelError> {
        Ok(Material {
            conductivity: positive("material.conductivity", values[self.conductivity])?,
            density: positive("material.density", values[self.density])?,
            specific_heat: positive("material.specific_heat", values[self.specific_heat])?,
        })
    }

    fn grid(&self, values: &Values) -> Result<Grid, ModelError> {
        let element_length = positive("element.length", values[self.element_length])?;
        let cell_size = positive("cell.size", values[self.cell_size])?;
        let elements =
            whole("track.length", values[self.length], "element.length", element_length)?;
        let cells = whole("rail.height", values[self.height], "cell.size", cell_size)?;
        if elements * cells > MOST_CELLS {
            return Err(ModelError::new(format!(
                "the grid has {elements} elements of {cells} cells, more than {MOST_CELLS} in all; \
                 choose a shorter track.length, longer elements or larger cells"
            )));
        }
        if !values[self.begin].is_finite() {
            return Err(wrong("track.begin", values[self.begin], "must be a finite number"));
        }
        Ok(Grid {
            line: Line { begin: values[self.begin], element_length, elements: elements as usize },
            cell_size,
            cells: cells as usize,
        })
    }
}
