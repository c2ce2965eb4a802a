//! A system that the caller steps: the units and links of a run.
//!
//! With a folder of results it leaves there what the run would leave. Without one it records nothing, and can go
//! back to a state that was saved.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | opened and stepped |
//! | `state.rs` | saved and restored |
//! | `finish.rs` | its results, completed |
//! | `error.rs` | why it cannot be opened or stepped |
//! | `signal.rs` | variables by name: got and set |

mod error;
mod finish;
mod signal;
mod state;

use std::collections::BTreeMap;
use std::path::Path;

pub use error::OpenSystemError;
use numerics::seconds;
use signal::Signals;
use tempfile::TempDir;

use super::checkpoint::Beginning;
use super::error::RunError;
use super::folder::claim::Claim;
use super::options::Options;
use super::perform::{Started, start};
use super::setup::Setup;
use super::stop::Early;
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
    started: Started,
    /// Steps that are done.
    done: u64,
    /// Whether the last of them has failed, so that some units have made it and others not.
    failed: bool,
    /// Why it ends before its time, if one of its units wants that.
    early: Option<Early>,
    /// Whether its units are terminated.
    finished: bool,
    signals: Signals,
    /// Inputs that were set, with the time at which that was first, s.
    set: BTreeMap<String, f64>,
    /// Warnings that the caller has taken.
    taken: usize,
    folder: Folder,
}

/// Where the FMUs of a system are, and its results if it has any; it goes after the units.
enum Folder {
    /// It goes with the system.
    Temporary(TempDir),
    /// That of its results, which the caller has claimed for it.
    Results(Claim),
}

impl Folder {
    fn path(&self) -> &Path {
        match self {
            Self::Temporary(folder) => folder.path(),
            Self::Results(claim) => claim.folder(),
        }
    }
}

impl OpenSystem {
    /// Sets up and initialises the scenario, package or FMU at `path`, with some units substituted.
    ///
    /// It records into the folder of `results`, if there is one.
    ///
    /// # Errors
    /// When something is wrong for which its run would not begin; the folder is as it was then.
    pub fn open(
        path: &Path,
        options: &Options,
        mut substitutes: Substitutes,
        results: Option<Claim>,
    ) -> Result<Self, OpenSystemError> {
        let folder = match results {
            Some(claim) => Folder::Results(claim),
            None => Folder::Temporary(tempfile::tempdir().map_err(FileError::at(path))?),
        };
        let workplace = Workplace::open(options.threads)?;
        let names: Vec<_> = substitutes.keys().cloned().collect();
        let opened = workplace.pool.install(|| {
            let mut setup = set_up(path, &folder, options, workplace.threads, &mut substitutes)?;
            if let Some(name) = substitutes.keys().next() {
                let names: Vec<_> = setup.system.units().map(|unit| unit.name()).collect();
                return Err(OpenSystemError::Request(signal::no_component(name, &names)));
            }
            let stood = |name| format!("{name} was a model of the program that stepped the system");
            setup.manifest.warnings.extend(names.iter().map(stood));
            let started = match &folder {
                Folder::Results(claim) => {
                    start(&mut setup, claim.folder(), true, &mut Beginning::default())?
                }
                Folder::Temporary(_) => {
                    setup.rails.forget_tapes();
                    setup.initialize()?;
                    Started::unrecorded(&setup)
                }
            };
            Ok((setup, started))
        });
        match (opened, folder) {
            (Ok((setup, started)), folder) => Ok(Self {
                setup,
                workplace,
                started,
                done: 0,
                failed: false,
                early: None,
                finished: false,
                signals: Signals::default(),
                set: BTreeMap::new(),
                taken: 0,
                folder,
            }),
            (Err(error), folder) => {
                if let Folder::Results(claim) = folder {
                    claim.undo();
                }
                Err(error)
            }
        }
    }

    /// Takes all units through so many steps.
    ///
    /// # Errors
    /// When a unit fails, or the system ends before. What was recorded until then is completed if a unit fails.
    pub fn step(&mut self, steps: u64) -> Result<(), OpenSystemError> {
        self.check_open()?;
        let Self { setup, started, done, failed, .. } = self;
        if *failed {
            return Err(OpenSystemError::Request(format!(
                "the step from {} s has failed; restore a state that was saved before, or open the system anew",
                seconds(setup.system.clock.at(*done))
            )));
        }
        if steps > setup.steps - *done {
            return Err(OpenSystemError::Request(format!(
                "the system ends at {} s, which is {} steps from here, and not {steps}; open it with a longer \
                 duration",
                seconds(setup.stop),
                setup.steps - *done
            )));
        }
        let until = *done + steps;
        let stepped = self.workplace.pool.install(|| started.step(setup, (done, until), None));
        *failed = !matches!(stepped, Ok(None));
        match stepped {
            Ok(None) => Ok(()),
            Ok(Some(early)) => {
                let sentence = early.to_string();
                self.early = Some(early);
                Err(OpenSystemError::Early(sentence))
            }
            Err(step) if self.records() => self.complete(Err(step)),
            Err(step) => Err(OpenSystemError::Step { time: step.time, source: step.source.into() }),
        }
    }

    /// Refuses what terminated units cannot do.
    fn check_open(&self) -> Result<(), OpenSystemError> {
        match self.finished {
            false => Ok(()),
            true => Err(OpenSystemError::Request(format!(
                "the system has ended, and its results are in {}; open it anew",
                self.folder.path().display()
            ))),
        }
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
        self.check_open()?;
        let Self { setup: Setup { system, .. }, signals, set, done, .. } = self;
        names.iter().zip(values).try_for_each(|(name, value)| {
            signals.set(system, name, *value)?;
            set.entry(name.clone()).or_insert_with(|| system.clock.at(*done));
            Ok(())
        })
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
        let Self { setup: Setup { manifest, system, .. }, taken, .. } = self;
        manifest.warnings.extend(system.take_warnings());
        let new = manifest.warnings[*taken..].to_vec();
        *taken = manifest.warnings.len();
        new
    }
}

impl Drop for OpenSystem {
    fn drop(&mut self) {
        if !self.finished {
            // FMI wants it before they are freed; nobody is there any more to be told.
            let _ = terminate(self.setup.system.units_mut());
        }
    }
}

/// Sets up what is at a path.
///
/// Without results there are no fields of the rails either, which would not follow a state that is restored.
fn set_up(
    path: &Path,
    folder: &Folder,
    options: &Options,
    threads: usize,
    substitutes: &mut Substitutes,
) -> Result<Setup, RunError> {
    if is_system(path) {
        RunError::check_no_settings(&options.settings)?;
        let written = path.display().to_string();
        return package::setup((path, &written), folder.path(), options, threads, substitutes);
    }
    let (mut scenario, file, text) = ordered(path, options)?;
    // The caller saves the states.
    scenario.record.checkpoint_s = None;
    let has_fields = matches!(folder, Folder::Results(_));
    if let (Some(heat), None, false) = (&mut scenario.heat, &scenario.fmus.railheat, has_fields) {
        heat.parameters.insert(FIELD.to_owned(), Value::Text(String::new()));
    }
    let folders = Folders { fmus: options.fmus.clone(), results: folder.path().to_owned() };
    scenario::setup(scenario, (&file, text), &folders, threads, substitutes)
}
