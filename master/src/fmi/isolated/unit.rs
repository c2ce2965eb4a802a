//! An instance in a process of its own as a unit.
//!
//! A step costs one request and one answer: what is set goes with the step, and so does the getting of
//! what was got behind the step before. The process makes the same calls in the same order as this one
//! would.

use std::io::Write;
use std::sync::Arc;

use super::death::Death;
use super::message::{Answer, Call, Failure, Given, Instance, Request};
use super::process::{Process, WAITING};
use crate::fmi::binding::known_status;
use crate::fmi::import::Import;
use crate::fmi::messages::Messages;
use crate::fmi::watched::{Label, Limit, calling, label};
use crate::interface::Interface;
use crate::system::unit::{Unit, UnitError};

/// Room for requests and answers: texts, and so many bytes for each variable.
const ROOM: usize = 1 << 20;
const ROOM_OF_VARIABLE: usize = 256;
/// Calls that wait for the next one to take them along.
const MOST_WAITING: usize = 12;

/// An instance in a process of its own.
pub struct Isolated {
    name: String,
    import: Arc<Import>,
    /// Name and file, for the parent of the run.
    label: Label,
    messages: &'static Messages,
    /// None once it has ended.
    process: Option<Process>,
    /// Why it has ended.
    death: Option<UnitError>,
    /// What was set since the last call.
    waiting: Vec<Call>,
    /// Whether a step was begun whose answer is not here yet.
    steps: bool,
    /// What limits the calls at this time.
    limit: Limit,
    foreseen: [Foreseen; 3],
    wish_to_end: Option<f64>,
}

/// What is got first behind each step, of one type.
#[derive(Default)]
struct Foreseen {
    references: Vec<u32>,
    /// What the last step has brought of it.
    given: Option<Given>,
    /// Whether something was got since the last step.
    is_known: bool,
}

/// Numbers of the types in what is foreseen.
const REALS: usize = 0;
const INTEGERS: usize = 1;
const BOOLEANS: usize = 2;
/// The calls that get them.
const GETS: [fn(Vec<u32>) -> Call; 3] = [Call::GetReals, Call::GetIntegers, Call::GetBooleans];

impl Isolated {
    /// Makes an instance in a new process.
    ///
    /// It has a relative tolerance, or none for that which the FMU proposes, and tries a step that the FMU
    /// discards again in parts, or not.
    ///
    /// # Errors
    /// When the FMU refuses, or its process cannot be started or has ended.
    pub fn new(
        import: &Arc<Import>,
        name: &str,
        (tolerance, retries): (Option<f64>, bool),
    ) -> Result<Self, UnitError> {
        let subject = format!("{name} ({})", import.file());
        let mut isolated = Self {
            name: name.to_owned(),
            import: Arc::clone(import),
            label: label(&subject),
            messages: Messages::of(&subject, &import.binary()),
            process: None,
            death: None,
            waiting: vec![],
            steps: false,
            limit: Limit::Start,
            foreseen: Default::default(),
            wish_to_end: None,
        };
        let room = ROOM + ROOM_OF_VARIABLE * import.interface().variables().len();
        let process = Process::start(room).map_err(|error| {
            isolated.error("the start of its process".to_owned(), None, Some(error.to_string()))
        })?;
        isolated.process = Some(process);
        isolated.send(&Request::Make(Instance {
            file: import.file().to_owned(),
            folder: import.folder().to_owned(),
            name: name.to_owned(),
            tolerance,
            retries,
        }))?;
        isolated.receive()?;
        Ok(isolated)
    }

    fn error(
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

    fn send(&mut self, request: &Request) -> Result<(), UnitError> {
        if let Some(death) = &self.death {
            return Err(death.clone());
        }
        let sent = self.process.as_ref().map_or(Ok(()), |process| process.ask(request));
        sent.map_err(|reason| self.error("a call in its process".to_owned(), None, Some(reason)))
    }

    fn receive(&mut self) -> Result<Vec<Given>, UnitError> {
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

    /// Makes the calls that wait and one more, and gives what that one gives.
    fn ask(&mut self, call: Call) -> Result<Given, UnitError> {
        let mut calls = std::mem::take(&mut self.waiting);
        calls.push(call);
        self.send(&Request::Calls(calls))?;
        let given = self.receive()?.pop();
        given.ok_or_else(|| self.error("a call in its process".to_owned(), None, None))
    }

    /// Lets a call that gives nothing wait for the next one.
    fn wait_with(&mut self, call: Call) -> Result<(), UnitError> {
        if self.waiting.len() >= MOST_WAITING {
            self.ask(call)?;
        } else {
            self.waiting.push(call);
        }
        Ok(())
    }

    /// Gets variables of a type: from what the step has brought, if they are the ones foreseen.
    fn get(&mut self, kind: usize, references: &[u32]) -> Result<Given, UnitError> {
        let foreseen = &mut self.foreseen[kind];
        let is_first = !std::mem::replace(&mut foreseen.is_known, true);
        if is_first && self.waiting.is_empty() && foreseen.references == references {
            if let Some(given) = foreseen.given.take() {
                return Ok(given);
            }
        } else if is_first {
            foreseen.references = references.to_vec();
        }
        self.ask(GETS[kind](references.to_vec()))
    }

    fn wrong_answer(&self) -> UnitError {
        let reason = "it has answered something else than it was asked".to_owned();
        self.error("a call in its process".to_owned(), None, Some(reason))
    }

    fn get_whole(&mut self, kind: usize, from: &[u32], to: &mut [i32]) -> Result<(), UnitError> {
        match self.get(kind, from)? {
            Given::Integers(values) if values.len() == to.len() => to.copy_from_slice(&values),
            _ => return Err(self.wrong_answer()),
        }
        Ok(())
    }
}

impl Unit for Isolated {
    fn name(&self) -> &str {
        &self.name
    }

    fn source_file(&self) -> &str {
        self.import.file()
    }

    fn interface(&self) -> &Interface {
        self.import.interface()
    }

    fn is_separate(&self) -> bool {
        true
    }

    fn set_text(&mut self, reference: u32, text: &str) -> Result<(), UnitError> {
        self.wait_with(Call::SetText(reference, text.to_owned()))
    }

    fn get_text(&mut self, reference: u32) -> Result<String, UnitError> {
        match self.ask(Call::GetText(reference))? {
            Given::Text(text) => Ok(text),
            _ => Err(self.wrong_answer()),
        }
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        self.wait_with(Call::SetReals(references.to_vec(), values.to_vec()))
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        match self.get(REALS, references)? {
            Given::Reals(given) if given.len() == values.len() => values.copy_from_slice(&given),
            _ => return Err(self.wrong_answer()),
        }
        Ok(())
    }

    fn set_integers(&mut self, references: &[u32], values: &[i32]) -> Result<(), UnitError> {
        self.wait_with(Call::SetIntegers(references.to_vec(), values.to_vec()))
    }

    fn get_integers(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        self.get_whole(INTEGERS, references, values)
    }

    fn set_booleans(&mut self, references: &[u32], values: &[i32]) -> Result<(), UnitError> {
        self.wait_with(Call::SetBooleans(references.to_vec(), values.to_vec()))
    }

    fn get_booleans(&mut self, references: &[u32], values: &mut [i32]) -> Result<(), UnitError> {
        self.get_whole(BOOLEANS, references, values)
    }

    fn enter_initialization(&mut self, start: f64, stop: f64) -> Result<(), UnitError> {
        self.ask(Call::EnterInitialization(start, stop)).map(|_| ())
    }

    fn exit_initialization(&mut self) -> Result<(), UnitError> {
        self.ask(Call::ExitInitialization)?;
        self.limit = Limit::Step;
        Ok(())
    }

    fn begin_step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        let mut calls = std::mem::take(&mut self.waiting);
        calls.push(Call::Step(time, length));
        for (foreseen, get) in self.foreseen.iter_mut().zip(GETS) {
            // What was not got behind the last step is not foreseen any more.
            if !foreseen.is_known {
                foreseen.references.clear();
            }
            if !foreseen.references.is_empty() {
                calls.push(get(foreseen.references.clone()));
            }
            (foreseen.given, foreseen.is_known) = (None, false);
        }
        self.send(&Request::Calls(calls))?;
        self.steps = true;
        Ok(())
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        if !self.steps {
            self.begin_step(time, length)?;
        }
        self.steps = false;
        let mut given = self.receive()?;
        for foreseen in self.foreseen.iter_mut().rev().filter(|own| !own.references.is_empty()) {
            foreseen.given = given.pop();
        }
        Ok(())
    }

    fn wish_to_end(&self) -> Option<f64> {
        self.wish_to_end
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        if std::mem::take(&mut self.steps) {
            // A step that nobody has waited for, because another unit has failed.
            let _ = self.receive();
        }
        self.limit = Limit::End;
        self.ask(Call::Terminate).map(|_| ())
    }

    fn take_warnings(&mut self) -> Vec<String> {
        self.messages.take_warnings()
    }
}

impl Drop for Isolated {
    /// Frees the instance. What goes wrong at that is told at once, as nobody asks any more.
    fn drop(&mut self) {
        if std::mem::take(&mut self.steps) {
            let _ = self.receive();
        }
        if self.send(&Request::Free).is_err() {
            return;
        }
        let Some(process) = self.process.take() else { return };
        if let Err(Death { function, reason }) = process.end() {
            let (name, file) = (&self.name, self.import.file());
            let line =
                format!("warning: {name}: {reason} ({file}: {function}), after all was done");
            let _ = writeln!(std::io::stderr(), "{line}");
        }
    }
}
