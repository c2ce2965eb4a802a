//! An instance in a process of its own as a unit.
//!
//! A step costs one request and one answer: what is set goes with the step, and so does the getting of
//! what was got behind the step before. The process makes the same calls in the same order as this one
//! would.

use std::sync::Arc;

use super::line::Line;
use super::message::{Call, Given, Instance, Request};
use crate::fmi::import::Import;
use crate::fmi::state::Saved;
use crate::fmi::watched::Limit;
use crate::interface::Interface;
use crate::system::unit::{Unit, UnitError};

/// Calls that wait for the next one to take them along.
const MOST_WAITING: usize = 12;

/// An instance in a process of its own.
pub struct Isolated {
    line: Line,
    /// What was set since the last call.
    waiting: Vec<Call>,
    /// Whether a step was begun whose answer is not here yet.
    steps: bool,
    foreseen: [Foreseen; 3],
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
        let mut line = Line::new(import, name)?;
        line.send(&Request::Make(Instance {
            file: import.file().to_owned(),
            folder: import.folder().to_owned(),
            name: name.to_owned(),
            tolerance,
            retries,
        }))?;
        line.receive()?;
        Ok(Self { line, waiting: vec![], steps: false, foreseen: Default::default() })
    }

    /// Makes the calls that wait and one more, and gives what that one gives.
    fn ask(&mut self, call: Call) -> Result<Given, UnitError> {
        let mut calls = std::mem::take(&mut self.waiting);
        calls.push(call);
        self.line.send(&Request::Calls(calls))?;
        let given = self.line.receive()?.pop();
        given.ok_or_else(|| self.line.error("a call in its process".to_owned(), None, None))
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

    fn saved(&self, bytes: &[u8]) -> Result<Saved, UnitError> {
        postcard::from_bytes(bytes).map_err(|error| self.differs(&error.to_string()))
    }

    fn get_whole(&mut self, kind: usize, from: &[u32], to: &mut [i32]) -> Result<(), UnitError> {
        match self.get(kind, from)? {
            Given::Integers(values) if values.len() == to.len() => to.copy_from_slice(&values),
            _ => return Err(self.line.wrong_answer()),
        }
        Ok(())
    }
}

impl Unit for Isolated {
    fn name(&self) -> &str {
        &self.line.name
    }

    fn source_file(&self) -> &str {
        self.line.import.file()
    }

    fn interface(&self) -> &Interface {
        self.line.import.interface()
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
            _ => Err(self.line.wrong_answer()),
        }
    }

    fn set_reals(&mut self, references: &[u32], values: &[f64]) -> Result<(), UnitError> {
        self.wait_with(Call::SetReals(references.to_vec(), values.to_vec()))
    }

    fn get_reals(&mut self, references: &[u32], values: &mut [f64]) -> Result<(), UnitError> {
        match self.get(REALS, references)? {
            Given::Reals(given) if given.len() == values.len() => values.copy_from_slice(&given),
            _ => return Err(self.line.wrong_answer()),
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
        self.line.limit = Limit::Step;
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
        self.line.send(&Request::Calls(calls))?;
        self.steps = true;
        Ok(())
    }

    fn step(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        if !self.steps {
            self.begin_step(time, length)?;
        }
        self.steps = false;
        let mut given = self.line.receive()?;
        for foreseen in self.foreseen.iter_mut().rev().filter(|own| !own.references.is_empty()) {
            foreseen.given = given.pop();
        }
        Ok(())
    }

    fn wish_to_end(&self) -> Option<f64> {
        self.line.wish_to_end
    }

    fn keeps_states(&self) -> bool {
        let interface = self.interface();
        interface.can_get_and_set_state && interface.can_serialize_state
    }

    /// The same bytes as those of an instance in this process.
    fn save(&mut self) -> Result<Vec<u8>, UnitError> {
        let Given::Saved(bytes) = self.ask(Call::Save)? else {
            return Err(self.line.wrong_answer());
        };
        let mut saved = self.saved(&bytes)?;
        saved.said = saved.said.with_warnings_of(self.line.messages.save());
        Ok(postcard::to_allocvec(&saved).expect("plain data can always be serialized"))
    }

    fn restore(&mut self, bytes: &[u8]) -> Result<(), UnitError> {
        let saved = self.saved(bytes)?;
        self.ask(Call::Restore(bytes.to_vec()))?;
        // The process has told the warnings again.
        self.line.messages.restore(saved.said);
        Ok(())
    }

    fn terminate(&mut self) -> Result<(), UnitError> {
        if std::mem::take(&mut self.steps) {
            // A step that nobody has waited for, because another unit has failed.
            let _ = self.line.receive();
        }
        self.line.limit = Limit::End;
        self.ask(Call::Terminate).map(|_| ())
    }

    fn take_warnings(&mut self) -> Vec<String> {
        self.line.messages.take_warnings()
    }
}

impl Drop for Isolated {
    fn drop(&mut self) {
        if std::mem::take(&mut self.steps) {
            let _ = self.line.receive();
        }
    }
}
