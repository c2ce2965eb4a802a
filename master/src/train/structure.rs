//! From a scenario to the structure of its system: FMUs are packed for the consist and imported, and
//! their instances get their parameters, their schedule, and what flows between them.

use std::collections::{BTreeMap, HashMap};
use std::path::Path;
use std::sync::Arc;

use ::controller::Gains;

use super::controller::{self, ControllerUnit};
use super::error::PrepareError;
use super::fmus::{Folders, check_fmu};
use super::follow;
use super::layout::{Layout, VehicleHolder};
use super::limits::limit;
use super::resources;
use super::roles::{self, Names, Role};
use super::wiring::connections;
use crate::fmi::{self, Import, Manner, Origins, homes, with_resource_paths};
use crate::interface::Interface;
use crate::scenario::{Scenario, Scheme};
use crate::system::checks::Checks;
use crate::system::clock::Clock;
use crate::system::compile::compile;
use crate::system::start::StartError;
use crate::system::step::System;
use crate::system::structure::{Component, Home, Parameter, Schedule, Structure, Value};
use crate::system::substitute::{self, Substitutes};
use crate::system::unit::{Unit, terminate};

/// File of the controller's FMU.
const CONTROLLER_FMU: &str = "synchronisation.fmu";

/// Step where the structure names none, s.
const DEFAULT_STEP: f64 = 1e-3;

/// The stages of a step in the sequential scheme (docs/user-guide, "The step").
const STAGES: [&str; 3] = ["train", "vehicles", "rail"];
const TRAIN_STAGE: usize = 0;
const VEHICLE_STAGE: usize = 1;
pub(super) const RAIL_STAGE: usize = 2;

/// The system of a scenario before it is run.
pub struct TrainSystem {
    /// Its components and what flows between them.
    pub structure: Structure,
    /// Who is what in it.
    pub layout: Layout,
    /// The FMUs by their files.
    imports: BTreeMap<String, Arc<Import>>,
    retries: bool,
    checks: Checks,
}

/// Packs and imports the FMUs of a scenario and connects their instances.
///
/// # Errors
/// When an FMU is missing, damaged or unfit.
pub fn of_scenario(scenario: &Scenario, folders: &Folders) -> Result<TrainSystem, PrepareError> {
    let stages: &[&str] = match scenario.scheme {
        Scheme::Sequential => &STAGES,
        Scheme::Jacobi => &["components"],
    };
    let mut builder = Builder {
        scenario,
        folders,
        structure: Structure {
            name: "train".to_owned(),
            start: Some(0.0),
            stop: Some(scenario.duration_s),
            step: Some(scenario.step_s),
            tolerance: scenario.fmus.tolerance,
            stages: stages.iter().map(|stage| (*stage).to_owned()).collect(),
            ..Structure::default()
        },
        layout: Layout { count: scenario.vehicle_count(), ..Layout::default() },
        imports: BTreeMap::new(),
    };
    builder.train()?;
    if !scenario.train_alone {
        builder.vehicles()?;
    }
    if let Some(heat) = &scenario.heat {
        builder.rails(heat)?;
    }
    builder.controllers()?;
    let Builder { mut structure, layout, imports, .. } = builder;
    let of_controllers = controller::interface();
    let interface = |component: &'_ Component| {
        let import = imports.get(&component.source);
        import.map_or(&of_controllers, |import| import.interface())
    };
    let interfaces: HashMap<&str, &Interface> =
        structure.components.iter().map(|c| (c.name.as_str(), interface(c))).collect();
    structure.connections = connections(&layout, &interfaces);
    let isolated = &scenario.fmus.isolated;
    let is_fmu = |component: &Component| imports.contains_key(&component.source);
    homes::isolate(&mut structure.components, isolated, is_fmu).map_err(PrepareError::Component)?;
    structure.notes = homes::load(&mut structure.components, |own| imports.get(&own.source))?;
    let (retries, checks) =
        (scenario.fmus.retry_discarded_steps, scenario.checks.unwrap_or_default());
    Ok(TrainSystem { structure, layout, imports, retries, checks })
}

/// Makes the components of a scenario.
pub(super) struct Builder<'a> {
    pub(super) scenario: &'a Scenario,
    pub(super) folders: &'a Folders,
    pub(super) structure: Structure,
    pub(super) layout: Layout,
    imports: BTreeMap<String, Arc<Import>>,
}

impl Builder<'_> {
    /// Adds a component that is an instance of an FMU.
    pub(super) fn add(
        &mut self,
        name: &str,
        import: &Arc<Import>,
        parameters: Vec<Parameter>,
        schedule: Schedule,
    ) {
        let source = import.file().to_owned();
        self.imports.insert(source.clone(), Arc::clone(import));
        self.component(name, source, parameters, schedule);
    }

    fn component(
        &mut self,
        name: &str,
        source: String,
        parameters: Vec<Parameter>,
        schedule: Schedule,
    ) {
        // Where all values are exchanged at once there is one stage.
        let stage = schedule.stage.min(self.structure.stages.len() - 1);
        let schedule = Schedule { stage, ..schedule };
        let name = name.to_owned();
        let connectors = vec![];
        self.structure.components.push(Component {
            name,
            source,
            connectors,
            parameters,
            schedule,
        });
    }

    fn train(&mut self) -> Result<(), PrepareError> {
        let import = match &self.scenario.fmus.longitudinal {
            Some(file) => Import::unpack(file, Origins::default())?,
            None => self.folders.packed("longitudinal", "train", |folder| {
                resources::write_longitudinal(self.scenario, folder)
            })?,
        };
        let groups = roles::longitudinal(self.layout.count);
        check_role(&import, &groups, &Names::new(), Role::Longitudinal)?;
        let train = &self.scenario.train;
        let position = train.leading_vehicle_position_m;
        let mut parameters =
            start_values(import.interface(), &Names::new(), position, train.speed_m_per_s);
        if let Some(couplers) = train.couplers {
            parameters.push(Parameter::new("initial.couplers", Value::Integer(couplers as i32)));
        }
        if let Some(wind) = &train.wind {
            let direction = wind.direction_deg.to_radians();
            parameters.push(Parameter::new("wind.speed", Value::Real(wind.speed_m_per_s)));
            parameters.push(Parameter::new("wind.direction", Value::Real(direction)));
        }
        self.layout.train = "train".to_owned();
        let fmus = &self.scenario.fmus;
        let home = fmus.longitudinal.as_ref().map_or(Home::AnyThread, |_| fmus.home());
        let schedule = Schedule { stage: TRAIN_STAGE, home, ..Schedule::default() };
        self.add("train", &import, parameters, schedule);
        Ok(())
    }

    /// Adds a vehicle that a component of its own holds.
    ///
    /// Its FMU is called at this home, and it follows the train if that fails, or not.
    pub(super) fn vehicle(
        &mut self,
        import: &Arc<Import>,
        names: &Names,
        parameters: Vec<Parameter>,
        (home, follows): (Home, bool),
    ) -> Result<(), PrepareError> {
        let wheelsets = roles::wheelset_count(import.interface(), names);
        check_role(import, &roles::vehicle(wheelsets), names, Role::Vehicle)?;
        let number = self.layout.vehicles.len() + 1;
        let component = format!("vehicle[{number}]");
        let schedule = Schedule { stage: VEHICLE_STAGE, home, ..Schedule::default() };
        self.add(&component, import, parameters, schedule);
        self.layout.vehicles.push(VehicleHolder {
            component,
            prefix: String::new(),
            names: names.clone(),
            wheelsets,
            follows,
            controller: format!("controller[{number}]"),
        });
        Ok(())
    }

    /// A controller for each vehicle.
    fn controllers(&mut self) -> Result<(), PrepareError> {
        let file = self.folders.fmus.join(CONTROLLER_FMU);
        if !self.layout.vehicles.is_empty() {
            check_fmu(&file)?;
        }
        let parameters = controller::parameters(&Gains::from(&self.scenario.synchronisation));
        let source = file.display().to_string();
        let names: Vec<_> = self.layout.vehicles.iter().map(|v| v.controller.clone()).collect();
        for name in names {
            let schedule = Schedule { stage: TRAIN_STAGE, ..Schedule::default() };
            self.component(&name, source.clone(), parameters.clone(), schedule);
        }
        Ok(())
    }
}

/// Position and speed at the start, in the units of an FMU that has them.
pub(super) fn start_values(
    interface: &Interface,
    names: &Names,
    position: f64,
    velocity: f64,
) -> Vec<Parameter> {
    let values = roles::tables::START.iter().zip([position, velocity]);
    let parameter = |(variable, value): (&roles::RoleVariable, f64)| {
        let found = roles::find(interface, "", variable, "parameter", names);
        let (name, conversion) = found.ok().flatten()?;
        Some(Parameter::new(&name, Value::Real(conversion.inverse().apply(value))))
    };
    values.filter_map(parameter).collect()
}

/// Refuses an FMU that lacks what its role needs, before anything is run; tells all that is missing.
pub(super) fn check_role(
    import: &Import,
    groups: &[roles::Group],
    names: &Names,
    role: Role,
) -> Result<(), PrepareError> {
    let problems = roles::problems(import.interface(), groups, names);
    match problems.is_empty() {
        true => Ok(()),
        false => {
            Err(PrepareError::Unfit { file: import.file().to_owned(), role: role.name(), problems })
        }
    }
}

impl TrainSystem {
    /// The variables of the FMUs by their files, those of the controllers too.
    ///
    /// # Errors
    /// When the FMU of the controllers cannot be read.
    pub fn interfaces(&self) -> Result<HashMap<String, Interface>, PrepareError> {
        let mut interfaces = HashMap::new();
        for Component { source, .. } in &self.structure.components {
            if !interfaces.contains_key(source) {
                let interface = match self.imports.get(source) {
                    Some(import) => import.interface().clone(),
                    None => Import::interface_of(Path::new(source))?,
                };
                interfaces.insert(source.clone(), interface);
            }
        }
        Ok(interfaces)
    }

    /// The train alone, to ask it where its vehicles are at the start. It is not run any further.
    ///
    /// # Errors
    /// When the train refuses its parameters.
    pub fn probe(&self) -> Result<System, PrepareError> {
        let is_train = |component: &&Component| component.name == self.layout.train;
        let components = self.structure.components.iter().filter(is_train).cloned().collect();
        let structure = Structure { components, ..Structure::default() };
        self.compile(&structure, &mut Substitutes::new())
    }

    /// Sets the vehicles to where the train has them at its start, as `probe` tells.
    ///
    /// # Errors
    /// When the train cannot be initialised.
    pub fn set_vehicle_starts(&mut self, mut probe: System) -> Result<(), StartError> {
        if self.layout.vehicles.is_empty() {
            return Ok(());
        }
        let layout = &self.layout;
        let mut motion = |number| {
            ["position", "velocity"].map(|name| layout.tap_train(&mut probe, number, name))
        };
        let taps: Vec<_> = (1..=layout.vehicles.len()).map(&mut motion).collect();
        let stop = self.structure.stop.unwrap_or(f64::INFINITY);
        probe.initialize(|_| stop)?;
        for (vehicle, motion) in layout.vehicles.iter().zip(taps) {
            let [position, velocity] = motion.map(|tap| tap.map_or(0.0, |tap| probe.value(&tap)));
            let components = &mut self.structure.components;
            let Some(component) = components.iter_mut().find(|c| c.name == vehicle.component)
            else {
                continue;
            };
            let Some(import) = self.imports.get(&component.source) else { continue };
            let values = start_values(import.interface(), &vehicle.names, position, velocity);
            component.parameters.extend(values);
        }
        Ok(terminate(probe.units_mut())?)
    }

    /// The system that runs, with the units that are substituted.
    ///
    /// # Errors
    /// When a unit refuses its parameters, or the units cannot be connected.
    pub fn system(&self, substitutes: &mut Substitutes) -> Result<System, PrepareError> {
        self.compile(&self.structure, substitutes)
    }

    fn compile(
        &self,
        structure: &Structure,
        substitutes: &mut Substitutes,
    ) -> Result<System, PrepareError> {
        let Structure { start, step, .. } = &self.structure;
        let clock = Clock { start: start.unwrap_or(0.0), length: step.unwrap_or(DEFAULT_STEP) };
        let unit = |component: &Component| -> Result<Box<dyn Unit>, PrepareError> {
            let Component { name, source, schedule, .. } = component;
            let Some(import) = self.imports.get(source) else {
                return Ok(Box::new(ControllerUnit::new(name, source)));
            };
            let (retries, home) = (self.retries, schedule.home);
            let manner = Manner { retries, home, tolerance: self.structure.tolerance };
            Ok(follow::following(&self.layout, structure, fmi::unit(import, name, manner)?))
        };
        let components = structure.components.iter();
        let mut units = components.map(unit).collect::<Result<Vec<_>, _>>()?;
        substitute::replace(&mut units, substitutes);
        let import = |component: &Component| self.imports.get(&component.source);
        let mut structure = with_resource_paths(structure, import);
        follow::connect(&self.layout, &mut structure, &units);
        let mut system = compile(&structure, units, clock)?;
        system.set_checks(self.checks);
        limit(&self.layout, &mut system);
        Ok(system)
    }
}
