//! A system that the caller steps: the units and links of a run, without its recording.
//!
//! What follows the run of a train for its rails, and the rails' fields, are the run's alone.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | opened, stepped, saved and restored |
//! | `error.rs` | why it cannot be opened or stepped |
//! | `signal.rs` | variables by name: got and set |

mod error;
mod signal;

use std::path::Path;

pub use error::OpenSystemError;
use signal::Signals;
use tempfile::TempDir;

use super::checkpoint::{Reached, RunState, from_bytes, to_bytes};
use super::error::RunError;
use super::options::Options;
use super::setup::Setup;
use super::workplace::Workplace;
use super::{is_system, ordered, package, scenario};
use crate::files::file_error::FileError;
use crate::interface::Variable;
use crate::scenario::Value;
use crate::system::substitute::Substitutes;
use crate::system::unit::terminate;
use crate::train::fmus::Folders;

/// The parameter of a rail that names the file of its field.
const FIELD: &str = "field_file";

/// A system whose units are initialised, and which the caller steps.
pub struct OpenSystem {
    setup: Setup,
    workplace: Workplace,
    /// Steps that are done.
    done: u64,
    /// Whether the last of them has failed, so that some units have made it and others not.
    failed: bool,
    signals: Signals,
    /// Where its FMUs are; it goes after the units.
    _folder: TempDir,
}

impl OpenSystem {
    /// Sets up and initialises the scenario, package or FMU at `path`, with some units substituted.
    ///
    /// # Errors
    /// When something is wrong for which its run would not begin.
    pub fn open(
        path: &Path,
        options: &Options,
        mut substitutes: Substitutes,
    ) -> Result<Self, OpenSystemError> {
        let folder = tempfile::tempdir().map_err(FileError::at(path))?;
        let workplace = Workplace::open(options.threads)?;
        let setup = workplace.pool.install(|| {
            let threads = workplace.threads;
            let mut setup = set_up(path, folder.path(), options, threads, &mut substitutes)?;
            if let Some(name) = substitutes.keys().next() {
                let names: Vec<_> = setup.system.units().map(|unit| unit.name()).collect();
                return Err(OpenSystemError::Request(signal::no_component(name, &names)));
            }
            setup.initialize()?;
            Ok(setup)
        })?;
        let signals = Signals::default();
        Ok(Self { setup, workplace, done: 0, failed: false, signals, _folder: folder })
    }

    /// Takes all units through so many steps.
    ///
    /// # Errors
    /// When a unit fails, or the system ends before.
    pub fn step(&mut self, steps: u64) -> Result<(), OpenSystemError> {
        let Self { setup: Setup { system, steps: all, stop, .. }, done, failed, .. } = self;
        if *failed {
            return Err(OpenSystemError::Request(format!(
                "the step from {} s has failed; restore a state that was saved before, or open the system anew",
                system.clock.at(*done)
            )));
        }
        if steps > *all - *done {
            return Err(OpenSystemError::Request(format!(
                "the system ends at {stop} s, which is {} steps from here, and not {steps}; open it with a longer \
                 duration",
                *all - *done
            )));
        }
        self.workplace.pool.install(|| {
            for _ in 0..steps {
                let stepped = system.step(*done);
                let time = system.clock.at(*done);
                stepped.map_err(|source| {
                    *failed = true;
                    OpenSystemError::Step { time, source }
                })?;
                *done += 1;
            }
            Ok(())
        })
    }

    /// Values of variables that are numbers, as `component.variable`, in the units of the variables.
    ///
    /// # Errors
    /// When there is no such variable, or a unit refuses.
    pub fn get(&mut self, names: &[String]) -> Result<Vec<f64>, OpenSystemError> {
        let system = &mut self.setup.system;
        names.iter().map(|name| self.signals.get(system, name)).collect()
    }

    /// Sets inputs that nothing is connected to; they keep their values until they are set again.
    ///
    /// # Errors
    /// When there is no such input, a value cannot be, or a unit refuses; those before it are set then.
    pub fn set(&mut self, names: &[String], values: &[f64]) -> Result<(), OpenSystemError> {
        if names.len() != values.len() {
            return Err(OpenSystemError::Request(format!(
                "{} names and {} values are given; there must be a value for each name",
                names.len(),
                values.len()
            )));
        }
        let system = &mut self.setup.system;
        let mut pairs = names.iter().zip(values);
        pairs.try_for_each(|(name, value)| self.signals.set(system, name, *value))
    }

    /// All that the system needs to go on from here, bit for bit.
    ///
    /// # Errors
    /// When a unit cannot be saved.
    pub fn save(&mut self) -> Result<Vec<u8>, OpenSystemError> {
        let Self { setup: Setup { system, .. }, workplace, done, .. } = self;
        if let Some(unit) = system.units().find(|unit| !unit.keeps_states()) {
            return Err(OpenSystemError::Request(format!(
                "{} ({}) cannot be saved, which would take canGetAndSetFMUstate and canSerializeFMUstate",
                unit.name(),
                unit.source_file()
            )));
        }
        let parts = workplace.pool.install(|| system.save())?;
        Ok(to_bytes(&RunState {
            reached: Reached::Run(*done),
            time: system.clock.at(*done),
            times: system.times.clone(),
            parts,
            tables: vec![],
            tapes: vec![],
            fmus: vec![],
        }))
    }

    /// Goes on from where this system, or another one of the same components, was saved.
    ///
    /// # Errors
    /// When it was saved by a system of other components, or is damaged.
    pub fn restore(&mut self, saved: &[u8]) -> Result<(), OpenSystemError> {
        let wrong = |reason: &str| {
            OpenSystemError::Request(format!("this is no state of such a system: {reason}"))
        };
        let state: RunState = from_bytes(saved).map_err(|reason| wrong(&reason))?;
        let Self { setup: Setup { system, steps, .. }, workplace, done, failed, .. } = self;
        let (Reached::Run(reached), true) =
            (state.reached, state.parts.len() == system.parts.len())
        else {
            return Err(wrong("it has other components"));
        };
        if reached > *steps {
            return Err(wrong(&format!("it is at {} s, and this one ends before", state.time)));
        }
        // Some units may have taken it when another refuses.
        *failed = true;
        workplace.pool.install(|| system.restore(state.parts))?;
        (*done, *failed) = (reached, false);
        Ok(())
    }

    /// Time to which the system has come, s.
    pub fn time(&self) -> f64 {
        self.setup.system.clock.at(self.done)
    }

    /// Length of a step, s.
    pub fn step_length(&self) -> f64 {
        self.setup.system.clock.length
    }

    /// Steps that are done, and how many there are.
    pub fn steps(&self) -> (u64, u64) {
        (self.done, self.setup.steps)
    }

    /// Names of the components with the files that they come from.
    pub fn components(&self) -> Vec<(String, String)> {
        let units = self.setup.system.units();
        units.map(|unit| (unit.name().to_owned(), unit.source_file().to_owned())).collect()
    }

    /// The variables of a component.
    ///
    /// # Errors
    /// When there is no such component.
    pub fn variables(&self, component: &str) -> Result<Vec<&Variable>, OpenSystemError> {
        let system = &self.setup.system;
        let Some(number) = system.number(component) else {
            let names: Vec<_> = system.units().map(|unit| unit.name()).collect();
            return Err(OpenSystemError::Request(signal::no_component(component, &names)));
        };
        Ok(system.parts[number].unit.interface().variables())
    }

    /// Takes what the run would warn of, in sentences.
    pub fn take_warnings(&mut self) -> Vec<String> {
        let mut warnings = std::mem::take(&mut self.setup.manifest.warnings);
        warnings.extend(self.setup.system.take_warnings());
        warnings
    }
}

impl Drop for OpenSystem {
    fn drop(&mut self) {
        // FMI wants it before they are freed; nobody is there any more to be told.
        let _ = terminate(self.setup.system.units_mut());
    }
}

/// Sets up what is at a path, without fields of the rails, which would not follow a state that is restored.
fn set_up(
    path: &Path,
    folder: &Path,
    options: &Options,
    threads: usize,
    substitutes: &mut Substitutes,
) -> Result<Setup, RunError> {
    if is_system(path) {
        RunError::check_no_settings(&options.settings)?;
        let written = path.display().to_string();
        return package::setup((path, &written), folder, options, threads, substitutes);
    }
    let (mut scenario, file, text) = ordered(path, options)?;
    if let (Some(heat), None) = (&mut scenario.heat, &scenario.fmus.railheat) {
        heat.parameters.insert(FIELD.to_owned(), Value::Text(String::new()));
    }
    let folders = Folders { fmus: options.fmus.clone(), results: folder.to_owned() };
    scenario::setup(scenario, (&file, text), &folders, threads, substitutes)
}
