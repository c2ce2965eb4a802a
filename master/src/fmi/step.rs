//! The step of an FMU, and what each status of `fmi2DoStep` means (FMI 2.0 §2.1.3, §4.2.2).

use std::time::{Duration, Instant};

use numerics::seconds;

use super::binding::{
    DISCARD, DO_STEP_STATUS, LAST_SUCCESSFUL_TIME, OK, PENDING, Status, TERMINATED, WARNING,
};
use super::instance::FmuInstance;
use crate::system::unit::UnitError;

/// Wall time after which an FMU that steps in the background is given up.
const LONGEST_WAIT: Duration = Duration::from_secs(60);
/// Wall time between two questions whether such a step has ended.
const WAIT: Duration = Duration::from_micros(50);
/// A discarded step is tried again in two, four, … up to so many parts.
const MOST_PARTS: u32 = 16;

/// What became of a step.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Outcome {
    Done,
    Discarded,
}

/// A step in a sentence.
fn of_step(time: f64, length: f64) -> String {
    format!(" from {} s by {} s", seconds(time), seconds(length))
}

impl FmuInstance {
    /// Takes the instance from `time` over `length`, s. A step that the FMU discards is done in
    /// parts if that was asked for and the FMU allows it.
    pub(super) fn step_or_retry(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        if self.retries {
            self.keep()?;
        }
        match self.do_step(time, length)? {
            Outcome::Done => Ok(()),
            Outcome::Discarded if self.wants_to_end() => {
                let reached = self.last_successful_time();
                // A time outside of the step is none that it has come to.
                let reached = reached.filter(|t| (time..=time + length).contains(t));
                self.wish_to_end = Some(reached.unwrap_or(time));
                Err(self.discarded(time, length, ""))
            }
            Outcome::Discarded if self.retries => self.retry(time, length),
            Outcome::Discarded => Err(self.discarded(time, length, "")),
        }
    }

    fn retry(&mut self, time: f64, length: f64) -> Result<(), UnitError> {
        let mut parts = 2;
        while parts <= MOST_PARTS {
            self.go_back()?;
            if self.step_in_parts(time, length, parts)? == Outcome::Done {
                return Ok(());
            }
            parts *= 2;
        }
        Err(self.discarded(time, length, ", also in 16 parts"))
    }

    fn step_in_parts(&mut self, time: f64, length: f64, parts: u32) -> Result<Outcome, UnitError> {
        let part = length / f64::from(parts);
        for i in 0..parts {
            if self.do_step(time + f64::from(i) * part, part)? == Outcome::Discarded {
                return Ok(Outcome::Discarded);
            }
        }
        Ok(Outcome::Done)
    }

    fn do_step(&mut self, time: f64, length: f64) -> Result<Outcome, UnitError> {
        let detail = |_: &Self| of_step(time, length);
        self.messages.reached(time);
        let mut status = self.status_of(
            c"fmi2DoStep",
            // SAFETY: the instance is alive.
            |f, c| unsafe { (f.do_step)(c, time, length, 1) },
            detail,
        )?;
        if status == PENDING {
            status = self.wait()?;
        }
        if matches!(status, OK | WARNING) {
            self.messages.reached(time + length);
        }
        match status {
            OK => Ok(Outcome::Done),
            WARNING => {
                self.note_warning(&format!("fmi2DoStep{}", detail(self)));
                Ok(Outcome::Done)
            }
            DISCARD => Ok(Outcome::Discarded),
            status => Err(self.failed(c"fmi2DoStep", detail, status)),
        }
    }

    /// Waits for a step that runs in the background, though its FMU was given no function to tell
    /// the end: it is asked, for a bounded time.
    fn wait(&mut self) -> Result<Status, UnitError> {
        let begin = Instant::now();
        loop {
            let mut of_step = PENDING;
            let answer = self.status_of(
                c"fmi2GetStatus",
                // SAFETY: the instance is alive, and there is room for one status.
                |f, c| unsafe { (f.get_status)(c, DO_STEP_STATUS, &raw mut of_step) },
                |_| " of a pending fmi2DoStep".to_owned(),
            )?;
            if answer != OK {
                return Err(self.failed(c"fmi2GetStatus", |_| " of a pending step".into(), answer));
            }
            if of_step != PENDING {
                return Ok(of_step);
            }
            if begin.elapsed() > LONGEST_WAIT {
                // SAFETY: the instance is alive.
                let _ = self.status_of(
                    c"fmi2CancelStep",
                    |f, c| unsafe { (f.cancel_step)(c) },
                    |_| String::new(),
                )?;
                let detail = |_: &Self| ", pending for more than 60 s,".to_owned();
                return Err(self.failed(c"fmi2DoStep", detail, PENDING));
            }
            std::thread::sleep(WAIT);
        }
    }

    /// The error of a step that was not done, with the time until which it came.
    fn discarded(&mut self, time: f64, length: f64, tried: &str) -> UnitError {
        let reached = match self.last_successful_time() {
            Some(reached) => format!(", done until {} s,", seconds(reached)),
            None => String::new(),
        };
        let detail = |_: &Self| format!("{}{tried}{reached}", of_step(time, length));
        self.failed(c"fmi2DoStep", detail, DISCARD)
    }

    /// The time until which a discarded step came, if the FMU says so.
    fn last_successful_time(&mut self) -> Option<f64> {
        let mut time = f64::NAN;
        let status = self.status_of(
            c"fmi2GetRealStatus",
            // SAFETY: the instance is alive after fmi2Discard, and the FMU writes one number.
            |f, c| unsafe { (f.get_real_status)(c, LAST_SUCCESSFUL_TIME, &raw mut time) },
            |_| String::new(),
        );
        (status == Ok(OK) && time.is_finite()).then_some(time)
    }

    /// Whether the FMU has discarded a step to end the simulation.
    fn wants_to_end(&mut self) -> bool {
        let mut terminated = 0;
        let status = self.status_of(
            c"fmi2GetBooleanStatus",
            // SAFETY: the instance is alive after fmi2Discard, and the FMU writes one number.
            |f, c| unsafe { (f.get_boolean_status)(c, TERMINATED, &raw mut terminated) },
            |_| String::new(),
        );
        status == Ok(OK) && terminated != 0
    }
}
