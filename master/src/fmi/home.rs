//! An instance with a thread of its own, on which it is made, called and freed.
//!
//! It is for FMUs that may be called by one thread only.
//!
//! Every call of such an FMU goes there, also that of the recorder, so that nothing else need know of it.
//! The threads of the run wait meanwhile; the way there and back takes some ten microseconds a call.

use std::sync::Arc;
use std::sync::mpsc::{Sender, channel};
use std::thread::{Builder, JoinHandle};

use super::import::Import;
use super::instance::FmuInstance;
use crate::interface::Interface;
use crate::system::unit::{Unit, UnitError};

/// What is done on the thread.
type Job = Box<dyn FnOnce(&mut FmuInstance) + Send>;

/// An instance on a thread of its own.
pub struct AtHome {
    name: String,
    import: Arc<Import>,
    /// None at the end.
    jobs: Option<Sender<Job>>,
    /// None at the end.
    thread: Option<JoinHandle<()>>,
}

impl AtHome {
    /// Starts the thread, on which `make` makes the instance.
    ///
    /// # Errors
    /// When the FMU refuses, or the system gives no thread.
    pub fn new(
        import: &Arc<Import>,
        name: &str,
        make: impl FnOnce() -> Result<FmuInstance, UnitError> + Send + 'static,
    ) -> Result<Self, UnitError> {
        let (jobs, queue) = channel::<Job>();
        let (made, answer) = channel();
        let work = move || match make() {
            Ok(mut instance) => {
                let _ = made.send(Ok(()));
                queue.iter().for_each(|job| job(&mut instance));
            }
            Err(error) => drop(made.send(Err(error))),
        };
        let thread = Builder::new().name(name.to_owned()).spawn(work);
        let (name, import) = (name.to_owned(), Arc::clone(import));
        let mut home = Self { name, import, jobs: Some(jobs), thread: None };
        home.thread = Some(thread.map_err(|error| home.failed(&error.to_string()))?);
        answer.recv().unwrap_or_else(|_| Err(home.failed(ENDED)))?;
        Ok(home)
    }

    /// Does something on the thread, and gives what comes of it.
    fn ask<T: Send + 'static>(
        &self,
        job: impl FnOnce(&mut FmuInstance) -> Result<T, UnitError> + Send + 'static,
    ) -> Result<T, UnitError> {
        let (done, answer) = channel();
        let job: Job = Box::new(move |instance| drop(done.send(job(instance))));
        if let Some(jobs) = &self.jobs {
            jobs.send(job).map_err(|_| self.failed(ENDED))?;
        }
        answer.recv().unwrap_or_else(|_| Err(self.failed(ENDED)))
    }

    fn failed(&self, reason: &str) -> UnitError {
        UnitError {
            instance: self.name.as_str().into(),
            source_file: self.import.file().into(),
            action: "a call on the thread of its own".into(),
            status: None,
            last_message: Some(reason.into()),
        }
    }
}

/// Why there is no answer.
const ENDED: &str = "the thread has ended";

/// Setting and getting of variables of a type: copies go to the thread and back.
macro_rules! exchange {
    ($($set:ident, $get:ident: $type:ty;)*) => {$(
        fn $set(&mut self, references: &[u32], values: &[$type]) -> Result<(), UnitError> {
            let (references, values) = (references.to_vec(), values.to_vec());
            self.ask(move |instance| instance.$set(&references, &values))
        }

        fn $get(&mut self, references: &[u32], values: &mut [$type]) -> Result<(), UnitError> {
            let (references, mut own) = (references.to_vec(), values.to_vec());
            let got = self.ask(move |instance| instance.$get(&references, &mut own).map(|()| own))?;
            values.copy_from_slice(&got);
            Ok(())
        }
    )*};
}

impl Unit for AtHome {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        self.import.file()
    }

    fn interface(&self) -> &Interface {
        self.import.interface()
    }

    fn set_text(&mut self, reference: u32, value: &str) -> Result<(), UnitError> {
        let value = value.to_owned();
        self.ask(move |instance| instance.set_text(reference, &value))
    }

    fn get_text(&mut self, reference: u32) -> Result<String, UnitError> {
        self.ask(move |instance| instance.get_text(reference))
    }

    exchange! {
        set_reals, get_reals: f64;
        set_integers, get_integers: i32;
        set_booleans, get_booleans: i32;
    }

    fn enter_initialization(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        self.ask(move |instance| instance.enter_initialization(start, stop))
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.ask(Unit::exit_initialization)
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        self.ask(move |instance| instance.step(time, length))
    }

    fn wish_to_end(&self) -> Option<f64> {
        self.ask(|instance| Ok(instance.wish_to_end())).ok().flatten()
    }

    fn keeps_states(&self) -> bool {
        self.ask(|instance| Ok(instance.keeps_states())).unwrap_or(false)
    }

    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        self.ask(Unit::save)
    }

    fn restore(&mut self, saved: &[u8]) -> Result<(), UnitError> {
        let saved = saved.to_vec();
        self.ask(move |instance| instance.restore(&saved))
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        self.ask(Unit::terminate)
    }

    fn take_warnings(&mut self) -> Vec<String> {
        self.ask(|instance| Ok(instance.take_warnings())).unwrap_or_default()
    }
}

impl Drop for AtHome {
    /// The thread frees the instance when nothing more can come.
    fn drop(&mut self) {
        self.jobs = None;
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
    }
}
