//! What a physical model must offer to become an FMU.

use std::borrow::Cow;
use std::path::Path;

use serde::Serialize;
use serde::de::DeserializeOwned;

use crate::variables::{Declaration, Values};

/// Who a model is: the attributes at the root of its model description.
#[derive(Clone, Copy, Debug)]
pub struct Identity {
    /// Name for people (`modelName`).
    pub name: &'static str,
    /// C identifier (`modelIdentifier`): file name of the binary.
    pub identifier: &'static str,
    /// One sentence on what is modelled.
    pub description: &'static str,
    /// Step that users should begin with, s.
    pub default_step: f64,
}

/// Why a model cannot go on, in a sentence for the user.
///
/// The sentence names the file, key or variable, its value, and what would be right. The FMU logs
/// it and answers `fmi2Error`.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{sentence}")]
pub struct ModelError {
    sentence: String,
    step_too_long: bool,
}

impl ModelError {
    /// An error with the sentence that the user reads.
    pub fn new(sentence: impl Into<String>) -> Self {
        Self { sentence: sentence.into(), step_too_long: false }
    }

    /// A step that is too long for the model, which could do a shorter one.
    ///
    /// The FMU answers `fmi2Discard`. The model and its outputs must be as before the step.
    pub fn step_too_long(sentence: impl Into<String>) -> Self {
        Self { sentence: sentence.into(), step_too_long: true }
    }

    /// Wraps an error of the physics, with its message as the sentence.
    pub fn from_error(error: impl std::error::Error) -> Self {
        Self::new(error.to_string())
    }

    pub(crate) fn is_step_too_long(&self) -> bool {
        self.step_too_long
    }
}

/// A step's interval of time, s.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// Time at which the step begins.
    pub start: f64,
    /// Length of the step, greater than zero.
    pub length: f64,
}

/// How grave a message is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LogLevel {
    /// Worth knowing.
    Event,
    /// The result may be wrong.
    Warning,
}

/// Takes the messages of a model; they reach the simulation tool's logger after the call.
#[derive(Debug, Default)]
pub struct Log {
    messages: Vec<(LogLevel, String)>,
}

impl Log {
    /// Tells the user something worth knowing.
    pub fn event(&mut self, message: impl Into<String>) {
        self.messages.push((LogLevel::Event, message.into()));
    }

    /// Tells the user that the result may be wrong.
    pub fn warning(&mut self, message: impl Into<String>) {
        self.messages.push((LogLevel::Warning, message.into()));
    }

    /// Takes the messages out.
    pub fn drain(&mut self) -> impl Iterator<Item = (LogLevel, String)> + '_ {
        self.messages.drain(..)
    }
}

/// A physical model with its FMI interface.
///
/// The order of calls is: [`declare`](Self::declare) at `fmi2Instantiate`,
/// [`initialize`](Self::initialize) in initialization mode as often as start values have got other
/// values since, then [`step`](Self::step) again and again. When a saved state goes into an instance
/// whose model was built from other start values, the model is built anew from those of the
/// state before [`restore`](Self::restore). A model is never asked for an output: it
/// writes all outputs into `values` when it is initialised and at the end of each step.
pub trait Model: Send + Sized + 'static {
    /// Who the model is.
    const IDENTITY: Identity;

    /// The handles of the declared variables.
    type Signals: Send + Sync + 'static;

    /// All that changes in a step and is not in the outputs: what an FMU state saves.
    ///
    /// What is computed once from parameters, as tables are, does not belong to it.
    type State: Clone + Serialize + DeserializeOwned + Send + 'static;

    /// Declares the variables. Their number may depend on files in the FMU's `resources` folder.
    ///
    /// # Errors
    /// When a file that shapes the interface is missing or wrong.
    fn declare(
        resources: &Path,
        declaration: &mut Declaration,
    ) -> Result<Self::Signals, ModelError>;

    /// Builds the model from its parameters and start values, and writes the initial outputs.
    ///
    /// # Errors
    /// When a parameter, or a file that one names, is wrong.
    fn initialize(
        signals: &Self::Signals,
        values: &mut Values,
        resources: &Path,
        start_time: f64,
        log: &mut Log,
    ) -> Result<Self, ModelError>;

    /// Refuses a run until `stop_time`, s, that is bound to fail.
    ///
    /// An example is a file of measurements that ends before. The FMU asks once the model is
    /// initialised, if the simulation tool says when it will stop.
    ///
    /// # Errors
    /// When the run would fail.
    fn check_until(&self, _stop_time: f64) -> Result<(), ModelError> {
        Ok(())
    }

    /// Steps the model over the interval and writes the outputs at its end.
    ///
    /// The inputs in `values` are constant over the interval.
    ///
    /// # Errors
    /// When no result can be given that makes sense.
    fn step(
        &mut self,
        signals: &Self::Signals,
        values: &mut Values,
        interval: Interval,
        log: &mut Log,
    ) -> Result<(), ModelError>;

    /// The state, for saving: borrowed, or put together for the purpose.
    fn state(&self) -> Cow<'_, Self::State>;

    /// Puts a saved state back; stepping on gives the same bits as before.
    fn restore(&mut self, state: Self::State);

    /// Completes what the model writes to files, at the end of the run.
    ///
    /// # Errors
    /// When a file cannot be completed.
    fn terminate(&mut self, _log: &mut Log) -> Result<(), ModelError> {
        Ok(())
    }
}
