//! A model in Python that stands for a component: a function, or an object with a method `step`.

use std::collections::HashMap;
use std::sync::{Arc, Mutex};

use files::did_you_mean;
use hotfoot::{Substitute, Variables};
use pyo3::exceptions::{PyTypeError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString};

/// The exception that a model has raised, for the cause of the error that is told.
pub type Raised = Arc<Mutex<Option<PyErr>>>;

/// A model in Python.
pub struct Model {
    /// The object, if it is more than a function.
    object: Option<Py<PyAny>>,
    /// What is called in each step.
    step: Py<PyAny>,
    inputs: Vec<Py<PyString>>,
    outputs: HashMap<String, usize>,
    raised: Raised,
}

impl Model {
    /// The model that a Python object is.
    ///
    /// # Errors
    /// When it is neither a function nor has a method `step`.
    pub fn new(object: &Bound<'_, PyAny>, raised: Raised) -> PyResult<Self> {
        let method = object.getattr_opt("step")?;
        let step = method.as_ref().unwrap_or(object);
        if !step.is_callable() {
            return Err(PyTypeError::new_err(format!(
                "{} is no model: it must be a function of time, step and inputs, or an object with such a method \
                 `step`",
                object.repr()?
            )));
        }
        Ok(Self {
            object: method.is_some().then(|| object.clone().unbind()),
            step: step.clone().unbind(),
            inputs: vec![],
            outputs: HashMap::new(),
            raised,
        })
    }

    /// Does something in Python; what it raises is kept, and told in a sentence.
    fn in_python<T>(
        &self,
        task: impl FnOnce(&Self, Python<'_>) -> PyResult<T>,
    ) -> Result<T, String> {
        Python::attach(|py| {
            task(self, py).map_err(|error| {
                let sentence = error.to_string();
                if let Ok(mut raised) = self.raised.lock() {
                    *raised = Some(error);
                }
                sentence
            })
        })
    }

    /// Takes over the outputs that a model has answered: a dict of them, or None.
    fn take(&self, answer: &Bound<'_, PyAny>, outputs: &mut [f64]) -> PyResult<()> {
        if answer.is_none() {
            return Ok(());
        }
        let Ok(answer) = answer.cast::<PyDict>() else {
            return Err(PyTypeError::new_err(format!(
                "the model has answered {}; it must answer a dict of its outputs, or None",
                answer.repr()?
            )));
        };
        for (name, value) in answer {
            let name: String = name.extract()?;
            let Some(&index) = self.outputs.get(&name) else {
                let meant = did_you_mean(&name, self.outputs.keys().map(String::as_str));
                return Err(PyValueError::new_err(format!(
                    "the model has answered `{name}`, which is no output of what it stands for{meant}"
                )));
            };
            let number = value.extract().map_err(|_| {
                PyTypeError::new_err(format!("the model has answered {name} = {value}: no number"))
            })?;
            outputs[index] = number;
        }
        Ok(())
    }

    /// The attributes of the object, which are its state; none of a function or of an object without any.
    fn attributes<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyDict>>> {
        let Some(object) = &self.object else { return Ok(None) };
        let attributes = object.bind(py).getattr_opt("__dict__")?;
        Ok(attributes.map(|attributes| attributes.cast_into::<PyDict>()).transpose()?)
    }
}

impl Substitute for Model {
    fn start(&mut self, time: f64, of: &Variables<'_>, outputs: &mut [f64]) -> Result<(), String> {
        self.outputs = of.outputs.iter().cloned().zip(0..).collect();
        self.inputs = Python::attach(|py| {
            of.inputs.iter().map(|name| PyString::intern(py, name).unbind()).collect()
        });
        self.in_python(|model, py| {
            let Some(object) = &model.object else { return Ok(()) };
            let Some(start) = object.bind(py).getattr_opt("start")? else { return Ok(()) };
            let parameters = PyDict::new(py);
            for (name, value) in &of.parameters {
                parameters.set_item(name, value)?;
            }
            model.take(&start.call1((time, parameters))?, outputs)
        })
    }

    fn step(&mut self, of: (f64, f64), inputs: &[f64], outputs: &mut [f64]) -> Result<(), String> {
        self.in_python(|model, py| {
            let given = PyDict::new(py);
            for (name, value) in model.inputs.iter().zip(inputs) {
                given.set_item(name, value)?;
            }
            let (time, length) = of;
            model.take(&model.step.bind(py).call1((time, length, given))?, outputs)
        })
    }

    fn save(&mut self) -> Result<Vec<u8>, String> {
        self.in_python(|model, py| {
            let Some(attributes) = model.attributes(py)? else { return Ok(vec![]) };
            py.import("pickle")?.call_method1("dumps", (attributes,))?.extract()
        })
    }

    fn restore(&mut self, saved: &[u8]) -> Result<(), String> {
        self.in_python(|model, py| {
            let Some(attributes) = model.attributes(py)? else { return Ok(()) };
            let state = py.import("pickle")?.call_method1("loads", (PyBytes::new(py, saved),))?;
            let state = state.cast_into::<PyDict>()?;
            attributes.clear();
            attributes.update(state.as_mapping())
        })
    }
}
