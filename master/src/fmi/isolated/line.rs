//! The line to the process of an instance: requests go out, and answers come in or the reason for none.

use std::io::Write;
use std::sync::Arc;

use super::death::Death;
use super::message::{Answer, Failure, Given, Request};
use super::process::{Process, WAITING};
use crate::fmi::binding::known_status;
use crate::fmi::import::Import;
use crate::fmi::messages::Messages;
use crate::fmi::watched::{Label, Limit, calling, label};
use crate::system::unit::UnitError;

/// Room for requests and answers: texts and states, and so many bytes for each variable. Memory is taken as it
/// is used.
const ROOM: usize = 1 << 26;
const ROOM_OF_VARIABLE: usize = 256;
/// What is tried where no function of the FMU is to be named.
const CALL: &str = "a call in its process";

/// The line to the process of an instance.
pub struct Line {
    pub name: String,
    pub import: Arc<Import>,
    pub messages: &'static Messages,
    /// What limits the calls at this time.
    pub limit: Limit,
    /// The time at which the FMU wants the run to end, s.
    pub wish_to_end: Option<f64>,
    /// Name and file, for the parent of the run.
    label: Label,
    /// None once it has ended.
    process: Option<Process>,
    /// Why it has ended.
    death: Option<UnitError>,
}

impl Line {
    /// A line to a new process.
    ///
    /// # Errors
    /// When the system gives no process.
    pub fn new(import: &Arc<Import>, name: &str) -> Result<Self, UnitError> {
        let subject = format!("{name} ({})", import.file());
        let mut line = Self {
            name: name.to_owned(),
            import: Arc::clone(import),
            messages: Messages::of(&subject, &import.binary()),
            limit: Limit::Start,
            wish_to_end: None,
            label: label(&subject),
            process: None,
            death: None,
        };
        let room = ROOM + ROOM_OF_VARIABLE * import.interface().variables().len();
        let process = Process::start(room).map_err(|error| {
            line.error("the start of its process".to_owned(), None, Some(error.to_string()))
        })?;
        line.process = Some(process);
        Ok(line)
    }

    /// An error of the instance.
    pub fn error(
        &self,
        action: String,
        status: Option<&'static str>,
        message: Option<String>,
    ) -> UnitError {
        let last_message = message.map(|text| self.import.in_words_of_the_user(&text).into());
        UnitError {
            instance: self.name.as_str().into(),
            source_file: self.import.file().into(),
            action: action.into(),
            status,
            last_message,
        }
    }

    /// That of an answer which does not belong to what was asked.
    pub fn wrong_answer(&self) -> UnitError {
        let reason = "it has answered something else than it was asked".to_owned();
        self.error(CALL.to_owned(), None, Some(reason))
    }

    /// Asks; the answer is to be received before the next request.
    ///
    /// # Errors
    /// When the process has ended, or there is no room for the request.
    pub fn send(&mut self, request: &Request) -> Result<(), UnitError> {
        if let Some(death) = &self.death {
            return Err(death.clone());
        }
        let sent = self.process.as_ref().map_or(Ok(()), |process| process.ask(request));
        sent.map_err(|reason| self.error(CALL.to_owned(), None, Some(reason)))
    }

    /// What the calls of the last request have given.
    ///
    /// # Errors
    /// When one has failed, or the process has ended.
    pub fn receive(&mut self) -> Result<Vec<Given>, UnitError> {
        let limit = self.limit;
        let Some(process) = &mut self.process else { return Ok(vec![]) };
        match calling(self.label, WAITING, || process.answer(limit)) {
            Ok(Answer { given, failure, wish_to_end, warnings }) => {
                warnings.into_iter().for_each(|text| self.messages.warn(text));
                self.wish_to_end = wish_to_end;
                failure.map_or(Ok(given), |failure| Err(self.failed(failure)))
            }
            Err(Death { function, reason }) => {
                self.process = None;
                let death = self.error(function, None, Some(reason));
                self.death = Some(death.clone());
                Err(death)
            }
        }
    }

    fn failed(&self, failure: Failure) -> UnitError {
        let Failure { action, status, last_message } = failure;
        self.error(action, status.map(|name| known_status(&name)), last_message)
    }
}

impl Drop for Line {
    /// Frees the instance. What goes wrong at that is told at once, as nobody asks any more.
    fn drop(&mut self) {
        if self.send(&Request::Free).is_err() {
            return;
        }
        let Some(process) = self.process.take() else { return };
        if let Err(Death { function, reason }) = calling(self.label, WAITING, || process.end()) {
            let (name, file) = (&self.name, self.import.file());
            let line =
                format!("warning: {name}: {reason} ({file}: {function}), after all was done");
            let _ = writeln!(std::io::stderr(), "{line}");
        }
    }
}
