//! The components of the rails that a scenario heats, with their parameters.

use numerics::constants::RAIL_LATERAL_POSITION;

use super::error::PrepareError;
use super::layout::RailHolder;
use super::parameters::parameter;
use super::resources;
use super::roles::tables::SIDES;
use super::roles::{self, Names, Role};
use super::structure::{Builder, RAIL_STAGE, check_role};
use crate::fmi::{Import, Origins};
use crate::interface::Interface;
use crate::scenario::{Extent, Heat, Scenario};
use crate::system::step::System;
use crate::system::structure::{Home, Parameter, Schedule, Value};
use crate::system::unit::UnitError;

/// Distance of each rail to the right of the track's middle on standard gauge, m.
const LATERAL_POSITION: [f64; 2] = [-RAIL_LATERAL_POSITION, RAIL_LATERAL_POSITION];

impl Builder<'_> {
    /// A component for each heated rail.
    pub(super) fn rails(&mut self, heat: &Heat) -> Result<(), PrepareError> {
        let wheelsets: Vec<usize> =
            self.layout.vehicles.iter().map(|vehicle| vehicle.wheelsets).collect();
        let import = match &self.scenario.fmus.railheat {
            Some(file) => Import::unpack(file, Origins::default())?,
            None => self.folders.packed("railheat", "rail", |folder| {
                resources::write_railheat(self.scenario, heat, &wheelsets, folder)
            })?,
        };
        let sides = heat.rail.sides();
        check_role(&import, &roles::railheat(&wheelsets), &Names::new(), Role::Railheat)?;
        let every = heat.step_s.map_or(1, |step| (step / self.scenario.step_s).round() as u64);
        for &side in sides {
            let component = match sides {
                [_] => "rail".to_owned(),
                _ => format!("rail[{}]", SIDES[side]),
            };
            let parameters = self.rail_parameters(heat, side, &import)?;
            let fmus = &self.scenario.fmus;
            let home = fmus.railheat.as_ref().map_or(Home::AnyThread, |_| fmus.home());
            let schedule = Schedule { stage: RAIL_STAGE, every, home };
            self.add(&component, &import, parameters, schedule);
            self.layout.rails.push(RailHolder { component, side });
        }
        Ok(())
    }

    /// The scenario's values for parameters that the rail's FMU has; its extent is set so that no
    /// wheel leaves it, unless the scenario says otherwise.
    fn rail_parameters(
        &self,
        heat: &Heat,
        side: usize,
        import: &Import,
    ) -> Result<Vec<Parameter>, PrepareError> {
        let extent = Extent::of(self.scenario, heat);
        let real = |name, value| Parameter::new(name, Value::Real(value));
        let text = |name, value: &str| Parameter::new(name, Value::Text(value.to_owned()));
        let field_file = self.folders.results.join(field_file(heat, side));
        let field_file = text("field_file", &field_file.to_string_lossy());
        let mut parameters = vec![
            real(BEGIN, extent.begin),
            real(LENGTH, extent.length),
            real("field_interval", heat.field_interval_s),
            real(THRESHOLD, 1e-3 * heat.detection_threshold_mk),
            real("rail.lateral_position", LATERAL_POSITION[side]),
            Parameter { local: true, ..field_file },
            text("field_failure", heat.field_failure.word()),
            text("model", &heat.model),
        ];
        parameters.retain(|parameter| import.interface().variable(&parameter.name).is_some());
        for (name, value) in &heat.parameters {
            parameters.push(parameter(
                import,
                &self.scenario.check().section("heat.parameters"),
                name,
                value,
            )?);
        }
        Ok(parameters)
    }
}

/// Parameters of a rail that its report tells.
const BEGIN: &str = "track.begin";
const LENGTH: &str = "track.length";
const THRESHOLD: &str = "detection.threshold";

/// Name of the store with the field of a rail.
pub fn field_file(heat: &Heat, side: usize) -> String {
    match heat.rail.sides() {
        [_] => "rail.zarr".to_owned(),
        _ => format!("rail-{}.zarr", SIDES[side]),
    }
}

/// What a rail's unit has in fact: its parameters may stand under their own names in
/// `heat.parameters`, which override those of the scenario's keys.
#[derive(Debug, Clone, PartialEq)]
pub struct RailInForce {
    /// Part of the track.
    pub extent: Extent,
    /// Rise of the foot that a camera can see, K.
    pub detection_threshold: f64,
    /// Heat model.
    pub model: String,
}

impl RailInForce {
    /// Reads it back from the unit after the initialisation; what the unit does not know is as the
    /// scenario says.
    ///
    /// # Errors
    /// When the unit does not give a parameter that it has.
    pub fn of(
        system: &mut System,
        component: &str,
        scenario: &Scenario,
        heat: &Heat,
    ) -> Result<Self, UnitError> {
        let mut in_force = Self {
            extent: Extent::of(scenario, heat),
            detection_threshold: 1e-3 * heat.detection_threshold_mk,
            model: heat.model.clone(),
        };
        let Some(number) = system.number(component) else { return Ok(in_force) };
        let unit = system.parts[number].unit.as_mut();
        let reference = |interface: &Interface, name| interface.variable(name).map(|v| v.reference);
        for (name, value) in [
            (BEGIN, &mut in_force.extent.begin),
            (LENGTH, &mut in_force.extent.length),
            (THRESHOLD, &mut in_force.detection_threshold),
        ] {
            if let Some(reference) = reference(unit.interface(), name) {
                unit.get_reals(&[reference], std::slice::from_mut(value))?;
            }
        }
        if let Some(reference) = reference(unit.interface(), "model") {
            in_force.model = unit.get_text(reference)?;
        }
        Ok(in_force)
    }
}
