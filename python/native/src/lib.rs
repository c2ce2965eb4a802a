//! The module `hotfoot._native`: the master's open system for Python.
//!
//! | file | part |
//! |---|---|
//! | `lib.rs` | the module and its class |
//! | `model.rs` | a model in Python in place of a component |
//!
//! What people call is `python/hotfoot/_system.py`.

mod model;

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, TryLockError};
use std::thread;
use std::time::Duration;

use files::Setting;
use hotfoot::run::Options;
use hotfoot::run::folder::claim::Claim;
use hotfoot::run::open_system::{OpenSystem, OpenSystemError};
use hotfoot::scenario::Times;
use hotfoot::{Substitute, Substitutes, shipped};
use model::{Model, Raised};
use pyo3::exceptions::{PyRuntimeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

pyo3::import_exception!(hotfoot._shipped, RunError);

/// Steps between two looks whether somebody has pressed Ctrl-C.
const STEPS_PER_LOOK: u64 = 100;
/// Wall time between two looks while the rails are alone.
const LOOK: Duration = Duration::from_millis(20);

/// A variable as Python gets it: name, causality, type, unit, start value, description.
type Row = (String, String, String, Option<String>, Option<String>, String);

/// A system that Python steps.
#[pyclass(module = "hotfoot._native")]
struct NativeSystem {
    system: Mutex<OpenSystem>,
    raised: Raised,
}

#[pymethods]
impl NativeSystem {
    /// `paths` are that of the scenario and that of the folder in which the package is.
    #[new]
    fn new(
        py: Python<'_>,
        paths: (PathBuf, PathBuf),
        settings: Vec<String>,
        times: (Option<f64>, Option<f64>, Option<f64>),
        threads: Option<usize>,
        replace: Vec<(String, Py<PyAny>)>,
        results: Option<(PathBuf, bool)>,
    ) -> PyResult<Self> {
        let settings = settings.iter().map(|setting| setting.parse::<Setting>());
        let settings = settings.collect::<Result<_, _>>().map_err(PyValueError::new_err)?;
        let (duration, step, interval) = times;
        let times = Times { duration, step, interval, ..Times::default() };
        let (path, home) = paths;
        shipped::lies_in(home);
        let (path, fmus) = (shipped::scenario(path), shipped::folder("fmus"));
        let options = Options { threads, fmus, settings, times, quiet: true, ..Options::default() };
        let raised = Raised::default();
        let mut substitutes = Substitutes::new();
        for (name, object) in replace {
            let model = Model::new(object.bind(py), Arc::clone(&raised))?;
            substitutes.insert(name, Box::new(model) as Box<dyn Substitute>);
        }
        let claim = results.map(|(folder, overwrite)| Claim::of(&folder, overwrite)).transpose();
        let claim = claim.map_err(|error| RunError::new_err(error.to_string()))?;
        let opened = py.detach(|| OpenSystem::open(&path, &options, substitutes, claim));
        let system = Mutex::new(opened.map_err(|error| exception(py, &error, &raised))?);
        Ok(Self { system, raised })
    }

    fn step(&self, py: Python<'_>, steps: u64) -> PyResult<()> {
        let (done, all) = self.with(py, |system| Ok(system.steps()))?;
        // What leads beyond the end is refused as a whole.
        let at_once = if steps > all - done { steps } else { STEPS_PER_LOOK };
        let mut left = steps;
        while left > 0 {
            let some = left.min(at_once);
            self.with(py, |system| system.step(some))?;
            py.check_signals()?;
            left -= some;
        }
        Ok(())
    }

    fn records(&self, py: Python<'_>) -> PyResult<bool> {
        self.with(py, |system| Ok(system.records()))
    }

    fn finish(&self, py: Python<'_>) -> PyResult<()> {
        let (stop, mut interrupt) = (AtomicBool::new(false), None);
        let task = |system: &mut OpenSystem| system.finish(|| stop.load(Ordering::Relaxed));
        // Python knows of Ctrl-C on this thread only.
        let finished = py.detach(|| {
            thread::scope(|scope| {
                let finishing = scope.spawn(|| self.locked(task));
                while !finishing.is_finished() {
                    thread::sleep(LOOK);
                    if let Err(error) = Python::attach(|py| py.check_signals()) {
                        stop.store(true, Ordering::Relaxed);
                        interrupt = Some(error);
                    }
                }
                finishing.join()
            })
        });
        let finished = finished.map_err(|_| PyRuntimeError::new_err("the system has panicked"))?;
        finished.map_err(|error| exception(py, &error, &self.raised))?;
        interrupt.map_or(Ok(()), Err)
    }

    fn get(&self, py: Python<'_>, names: Vec<String>) -> PyResult<Vec<f64>> {
        self.with(py, |system| system.get(&names))
    }

    fn set(&self, py: Python<'_>, names: Vec<String>, values: Vec<f64>) -> PyResult<()> {
        self.with(py, |system| system.set(&names, &values))
    }

    fn save<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyBytes>> {
        Ok(PyBytes::new(py, &self.with(py, OpenSystem::save)?))
    }

    fn restore(&self, py: Python<'_>, saved: &[u8]) -> PyResult<()> {
        self.with(py, |system| system.restore(saved))
    }

    /// Time, s, length of a step, s, steps that are done, and number of all steps.
    fn clock(&self, py: Python<'_>) -> PyResult<(f64, f64, u64, u64)> {
        self.with(py, |system| {
            let (done, all) = system.steps();
            Ok((system.time(), system.step_length(), done, all))
        })
    }

    fn components(&self, py: Python<'_>) -> PyResult<Vec<(String, String)>> {
        self.with(py, |system| Ok(system.components()))
    }

    fn variables(&self, py: Python<'_>, component: &str) -> PyResult<Vec<Row>> {
        self.with(py, |system| {
            let variables = system.variables(component)?.into_iter().map(|variable| {
                let kind = format!("{:?}", variable.kind).replace("Text", "String");
                (
                    variable.name.clone(),
                    variable.causality.clone(),
                    kind,
                    variable.unit.clone(),
                    variable.start.clone(),
                    variable.description.clone(),
                )
            });
            Ok(variables.collect())
        })
    }

    fn take_warnings(&self, py: Python<'_>) -> PyResult<Vec<String>> {
        self.with(py, |system| Ok(system.take_warnings()))
    }
}

impl NativeSystem {
    /// Does something with the system while other threads of Python go on.
    fn with<T: Send>(
        &self,
        py: Python<'_>,
        task: impl FnOnce(&mut OpenSystem) -> Result<T, OpenSystemError> + Send,
    ) -> PyResult<T> {
        let done = py.detach(|| self.locked(task));
        done.map_err(|error| exception(py, &error, &self.raised))
    }

    /// Does something with the system, which nobody else uses meanwhile.
    fn locked<T>(
        &self,
        task: impl FnOnce(&mut OpenSystem) -> Result<T, OpenSystemError>,
    ) -> Result<T, OpenSystemError> {
        match self.system.try_lock() {
            Ok(mut system) => task(&mut system),
            Err(TryLockError::Poisoned(poisoned)) => task(&mut poisoned.into_inner()),
            Err(TryLockError::WouldBlock) => Err(OpenSystemError::Request(
                "the system is in a step: neither another thread nor a model in it can use it meanwhile"
                    .to_owned(),
            )),
        }
    }
}

/// An error of the system as an exception; what a model in Python has raised is its cause.
fn exception(py: Python<'_>, error: &OpenSystemError, raised: &Raised) -> PyErr {
    let exception = match error {
        OpenSystemError::Request(sentence) => PyValueError::new_err(sentence.clone()),
        error => RunError::new_err(error.to_string()),
    };
    let cause = raised.lock().ok().and_then(|mut raised| raised.take());
    exception.set_cause(py, cause);
    exception
}

/// The module.
#[pymodule]
mod _native {
    #[pymodule_export]
    use super::NativeSystem;
}
