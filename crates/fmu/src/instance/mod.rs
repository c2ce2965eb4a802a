//! An instance of a model: the state machine of §4.2.4 in safe Rust.
//!
//! | file | part |
//! |---|---|
//! | `mod.rs` | the life of an instance, from being made to being terminated |
//! | `stepping.rs` | the step, and what is checked before and after it |
//! | `exchange.rs` | getting and setting values |
//! | `rules.rs`, `refusal.rs` | which values are admitted when, and what is said of others |
//! | `restore.rs`, `state.rs` | saving an instance, setting it back, serializing |
//! | `interface.rs` | the declaration, checked and made ready |
//! | `logging.rs` | messages on their way to the simulation tool |
//!
//! The C interface calls nothing else, so a test or a master that uses an [`Instance`] directly
//! gets the same results, to the bit, as one that loads the FMU.

mod exchange;
pub(crate) mod interface;
pub(crate) mod logging;
mod refusal;
mod restore;
mod rules;
pub(crate) mod state;
mod stepping;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use interface::Interface;
use logging::{Category, Logger, Sink};
use state::{Experiment, Origin, TIME_TOLERANCE};

use crate::calls::{Call, Phase};
use crate::error::Error;
use crate::model::{Log, Model};
use crate::status::Status;
use crate::variables::{Declaration, Guid, Values};

/// An instance of a model.
///
/// Its calls are those of FMI 2.0 co-simulation, with the same rules. A call that returns an error
/// whose [`status`](Error::status) is [`Status::Error`] takes the instance into [`Phase::Error`],
/// as the standard says; a [`reset`](Self::reset) or a saved state leads out.
pub struct Instance<M: Model> {
    pub(crate) interface: Interface<M>,
    pub(crate) logger: Logger,
    pub(crate) phase: Phase,
    pub(crate) experiment: Option<Experiment>,
    /// Own time: end of the last step, s.
    pub(crate) time: f64,
    pub(crate) values: Values,
    /// The model; none while start values have changed since it was built.
    pub(crate) built: Option<Built<M>>,
    name: String,
    resources: PathBuf,
    /// The same as texts name it.
    resource_folder: Arc<str>,
    /// Kept, so that a step does not allocate one.
    pub(crate) log: Log,
}

/// A model and what it was built from.
pub(crate) struct Built<M> {
    pub(crate) model: M,
    pub(crate) origin: Arc<Origin>,
}

impl<M: Model> Instance<M> {
    /// Makes an instance whose messages go to `sink`.
    ///
    /// The folder `resources` is that of the FMU.
    ///
    /// # Errors
    /// When the name is blank or the interface cannot be formed from the resources.
    pub fn new(resources: &Path, name: &str, sink: Sink) -> Result<Self, Error> {
        if name.trim().is_empty() {
            return Err(Error::BlankName);
        }
        let interface = Interface::new(resources)?;
        Ok(Self {
            values: interface.declaration.start_values().clone(),
            interface,
            logger: Logger::new(sink),
            phase: Phase::Instantiated,
            experiment: None,
            time: 0.0,
            built: None,
            name: name.to_owned(),
            resources: resources.to_owned(),
            resource_folder: resources.to_string_lossy().into(),
            log: Log::default(),
        })
    }

    /// Name of the instance.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The handles of the variables, as the model declared them.
    pub fn signals(&self) -> &M::Signals {
        &self.interface.signals
    }

    /// The variables.
    pub fn declaration(&self) -> &Declaration {
        &self.interface.declaration
    }

    /// Fingerprint of the interface.
    pub fn guid(&self) -> Guid {
        self.interface.guid
    }

    /// Where the instance stands in its life.
    pub fn phase(&self) -> Phase {
        self.phase
    }

    /// End of the last step, s.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// All values as they are.
    ///
    /// In initialization mode the outputs may be those of other start values, as only the getters
    /// compute them.
    pub fn values(&self) -> &Values {
        &self.values
    }

    /// Whether the model gave a warning since this was asked last.
    pub fn take_warned(&mut self) -> bool {
        self.logger.take_warned()
    }

    /// Refuses the GUID of another model description.
    ///
    /// # Errors
    /// When `given` is not the GUID of this interface.
    pub fn check_guid(&self, given: &str) -> Result<(), Error> {
        let own = self.guid().to_string();
        if given.eq_ignore_ascii_case(&own) {
            return Ok(());
        }
        Err(Error::Guid { given: given.to_owned(), identifier: M::IDENTITY.identifier, own })
    }

    /// Switches the messages of the named categories on or off; no name means all.
    ///
    /// # Errors
    /// When a category is unknown.
    pub fn set_debug_logging(&mut self, on: bool, categories: &[&str]) -> Result<(), Error> {
        self.call(Call::SetDebugLogging, |instance| instance.logger.choose(on, categories))
    }

    /// Says when the simulation begins and, if that is known, ends, s.
    ///
    /// # Errors
    /// When a time is not finite or the stop time is not after the start.
    pub fn setup_experiment(&mut self, start: f64, stop: Option<f64>) -> Result<(), Error> {
        self.call(Call::SetupExperiment, |instance| {
            let end_is_right = stop.is_none_or(|stop| stop.is_finite() && stop > start);
            if !(start.is_finite() && end_is_right) {
                let stop = stop.unwrap_or(f64::INFINITY);
                return Err(Error::Experiment { start, stop });
            }
            instance.experiment = Some(Experiment { start, stop });
            instance.time = start;
            Ok(())
        })
    }

    /// Begins the initialization.
    ///
    /// # Errors
    /// When the experiment was not set up.
    pub fn enter_initialization_mode(&mut self) -> Result<(), Error> {
        self.call(Call::EnterInitializationMode, |instance| {
            instance.experiment.ok_or(Error::NoExperiment)?;
            instance.phase = Phase::InitializationMode;
            Ok(())
        })
    }

    /// Ends the initialization: the outputs have their initial values.
    ///
    /// # Errors
    /// When the model refuses its start values.
    pub fn exit_initialization_mode(&mut self) -> Result<(), Error> {
        self.call(Call::ExitInitializationMode, |instance| {
            instance.initialize()?;
            instance.phase = Phase::StepComplete;
            Ok(())
        })
    }

    /// Ends the simulation.
    ///
    /// # Errors
    /// When the model cannot complete its files.
    pub fn terminate(&mut self) -> Result<(), Error> {
        self.call(Call::Terminate, |instance| {
            if let Some(built) = &mut instance.built {
                let result = built.model.terminate(&mut instance.log);
                instance.logger.drain(&mut instance.log);
                result.map_err(Error::Termination)?;
            }
            instance.phase = Phase::Terminated;
            Ok(())
        })
    }

    /// Leads back to where the instance was when it was made.
    ///
    /// # Errors
    /// None; the result is that of all calls.
    pub fn reset(&mut self) -> Result<(), Error> {
        self.call(Call::Reset, |instance| {
            let start = instance.interface.declaration.start_values();
            instance.values.clone_from(start);
            instance.built = None;
            instance.experiment = None;
            instance.time = 0.0;
            instance.phase = Phase::Instantiated;
            Ok(())
        })
    }

    /// Does a call if the phase allows it; an error becomes the phase.
    pub(crate) fn call<T>(
        &mut self,
        call: Call,
        body: impl FnOnce(&mut Self) -> Result<T, Error>,
    ) -> Result<T, Error> {
        let result = self.check(call).and_then(|()| body(self));
        if let Err(error) = &result {
            self.note(error);
        }
        result
    }

    /// Whether the phase allows a call.
    pub(crate) fn check(&self, call: Call) -> Result<(), Error> {
        let phase = self.phase;
        if call.allowed_in(phase) { Ok(()) } else { Err(Error::Forbidden { call, phase }) }
    }

    /// Refuses a call that the FMU does not offer, as the `flag` of its description says.
    pub(crate) fn refuse(&mut self, call: Call, flag: &'static str) -> Result<(), Error> {
        self.call(call, |_| Err(Error::NotOffered { call, flag }))
    }

    /// Tells the user of an error.
    pub(crate) fn report(&mut self, error: &Error) {
        self.note(error);
        let category = Category::of(error.status());
        self.logger.message(category, &error.to_string());
    }

    /// An error that ends the simulation becomes the phase.
    fn note(&mut self, error: &Error) {
        if error.status() == Status::Error {
            self.phase = Phase::Error;
        }
    }

    /// Drops the model after a panic, and gives the error that says why.
    pub(crate) fn drop_model(&mut self, call: Call, message: String) -> Error {
        self.logger.drain(&mut self.log);
        self.built = None;
        self.phase = Phase::Error;
        Error::Panic { call, message }
    }

    /// Builds the model if start values have changed since it was built.
    pub(crate) fn initialize(&mut self) -> Result<(), Error> {
        if self.built.is_some() {
            return Ok(());
        }
        let origin = Arc::new(Origin { values: self.values.clone(), start_time: self.time });
        let (model, values) = self.build(&origin)?;
        if let Some(stop) = self.experiment.and_then(|experiment| experiment.stop) {
            // Tools announce a little more than they need.
            model
                .check_until(stop - 2.0 * TIME_TOLERANCE * stop.abs())
                .map_err(Error::Initialization)?;
        }
        self.values = values;
        self.check_finite(origin.start_time)?;
        self.built = Some(Built { model, origin });
        Ok(())
    }

    /// Builds a model, and gives it with its initial values.
    pub(crate) fn build(&mut self, origin: &Origin) -> Result<(M, Values), Error> {
        let mut values = origin.values.clone();
        let model = M::initialize(
            &self.interface.signals,
            &mut values,
            &self.resources,
            origin.start_time,
            &mut self.log,
        );
        self.logger.drain(&mut self.log);
        Ok((model.map_err(Error::Initialization)?, values))
    }
}
