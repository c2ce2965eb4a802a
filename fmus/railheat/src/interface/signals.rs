//! The handles of all variables.

use fmu::{Declaration, Handles, Values, Variables};

use super::inputs::{WeatherInputs, WheelInputs};
use super::outputs::Outputs;
use super::parameters::common::Common;
use super::parameters::energy::EnergyParameters;
use super::parameters::other_model::AllParameters;
use super::parameters::site::SiteParameters;
use super::shape::Shape;

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) shape: Shape,
    /// Names of the wheels, such as `vehicle[1].wheelset[2]`.
    pub(crate) wheel_names: Vec<String>,
    pub(crate) wheels: Vec<Handles<WheelInputs>>,
    pub(crate) weather: Handles<WeatherInputs>,
    pub(crate) common: Handles<Common>,
    pub(crate) energy: Handles<EnergyParameters>,
    pub(crate) site: Handles<SiteParameters>,
    pub(crate) outputs: Outputs,
    /// The values before anything is set.
    pub(crate) start: Values,
}

impl Signals {
    pub(crate) fn declare(shape: Shape, declaration: &mut Declaration) -> Self {
        let wheel_names: Vec<String> = (1..)
            .zip(&shape.wheelsets)
            .flat_map(|(i, count)| (1..=*count).map(move |j| format!("vehicle[{i}].wheelset[{j}]")))
            .collect();
        let wheels = wheel_names.iter().map(|name| {
            declaration.terminal(name.clone(), "wheel", "A wheel on the rail");
            WheelInputs::declare(declaration, name.as_str())
        });
        let wheels = wheels.collect();
        let weather = WeatherInputs::declare(declaration, "");
        let common = Common::declare(declaration, "");
        let energy = EnergyParameters::declare(declaration, "");
        let site = SiteParameters::declare(declaration, "");
        let outputs = Outputs::declare(&shape, declaration);
        let start = declaration.start_values().clone();
        Self { shape, wheel_names, wheels, weather, common, energy, site, outputs, start }
    }

    /// The parameters as they are set.
    pub(crate) fn parameters(&self, values: &Values) -> AllParameters {
        AllParameters {
            common: Common::read(&self.common, values),
            energy: EnergyParameters::read(&self.energy, values),
            site: SiteParameters::read(&self.site, values),
        }
    }
}
