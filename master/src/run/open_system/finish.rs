//! The results of an open system, completed as those of a run.

use std::mem;

use numerics::seconds;

use super::{Folder, OpenSystem, OpenSystemError};
use crate::run::after::FailedStep;
use crate::run::folder::claim::release;
use crate::run::perform::complete;
use crate::run::stop::{Early, INTERRUPT, Stopped};
use crate::run::write_report;

impl OpenSystem {
    /// Whether it has results that are not complete yet.
    pub fn records(&self) -> bool {
        matches!(self.folder, Folder::Results(_)) && !self.finished
    }

    /// Completes the results with their report, after what follows the run for the rails.
    ///
    /// That follows only where all steps are done; `stop` says whether the user wants it to end before.
    ///
    /// # Errors
    /// When it records nothing, has ended already, a rail fails, or a file cannot be written.
    pub fn finish(&mut self, stop: impl Fn() -> bool + Sync) -> Result<(), OpenSystemError> {
        self.check_open()?;
        if !self.records() {
            return Err(OpenSystemError::Request(
                "the system records nothing; open it with a folder of results".to_owned(),
            ));
        }
        let Self { setup, started, workplace, done, early, .. } = self;
        let time = setup.system.clock.at(*done);
        let outcome = match early.take() {
            Some(early) => Ok(Some(early)),
            None if *done < setup.steps => Ok(Some(Early::Left { time })),
            None => workplace.pool.install(|| {
                let mut stopped = |_, time| stop().then_some(Stopped { signal: INTERRUPT, time });
                started.continue_rails(setup, None, &mut stopped)
            }),
        };
        self.complete(outcome)
    }

    /// Completes the results, whose run has ended so.
    pub(super) fn complete(
        &mut self,
        outcome: Result<Option<Early>, FailedStep>,
    ) -> Result<(), OpenSystemError> {
        let Self { setup, started, workplace, set, folder, finished, .. } = self;
        *finished = true;
        let since = |(name, time): (&String, &f64)| format!("{name} (from {} s)", seconds(*time));
        if !set.is_empty() {
            let inputs = set.iter().map(since).collect::<Vec<_>>().join(", ");
            let sentence = format!("the program that stepped the system has set {inputs}");
            setup.manifest.warnings.push(sentence);
        }
        let recorder = mem::take(&mut started.recorder);
        let done = workplace.pool.install(|| complete(setup, folder.path(), recorder, outcome));
        let reported = write_report(&mut setup.manifest, folder.path());
        release(folder.path());
        done?;
        reported?;
        Ok(())
    }
}
