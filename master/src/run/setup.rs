//! A run that is ready to be initialised: of a scenario's train, or of a package.

use std::collections::BTreeSet;
use std::path::Path;

use super::after::Rails;
use super::checkpoint::{Beginning, CheckpointError, Checkpoints, Reached, RunState};
use super::chosen_outputs::ChosenOutputs;
use super::error::RunError;
use super::live::LiveFigures;
use super::manifest::Manifest;
use super::observe_error::ObserveError;
use super::progress::Progress;
use super::recorder::Recorder;
use super::train_tables;
use crate::scenario::Scenario;
use crate::system::parallel;
use crate::system::start::StartError;
use crate::system::step::System;
use crate::train::layout::Layout;
use crate::train::rails::RailInForce;
use crate::train::wheels_outside::wheels_outside;

/// A run that is ready to be initialised.
pub struct Setup {
    /// The units.
    pub system: System,
    /// What the stages of a step are called.
    pub stages: Vec<String>,
    /// Number of steps.
    pub steps: u64,
    /// When the run ends, s.
    pub stop: f64,
    /// What is run.
    pub subject: Subject,
    /// The rails of a train; none in another system.
    pub rails: Rails,
    /// What made the results.
    pub manifest: Manifest,
    /// Whether the first record is there.
    pub recorded: bool,
}

/// What is run.
pub enum Subject {
    /// The train of a scenario.
    Train(Box<Scenario>, Layout),
    /// Any other system, and what of it is recorded every so many steps.
    Package(u64, ChosenOutputs),
}

impl Setup {
    /// The names of the stages with the number of units that step in them on threads.
    pub fn stages_with_units(&self) -> Vec<(String, usize)> {
        let count = |stage| {
            let units = self.system.parts.iter().filter(|part| part.stage == stage);
            units.filter(|part| !part.unit.is_brief()).count()
        };
        self.stages.iter().cloned().zip((0..).map(count)).collect()
    }

    /// The time to which the rails come in the run of the train, s.
    pub fn rails_run(&self) -> f64 {
        self.rails.time(&self.system, self.steps)
    }

    /// When all ends that the rails go through, s.
    pub fn rails_end(&self) -> f64 {
        self.rails.traffic.end(self.rails_run())
    }

    /// Initialises the units.
    ///
    /// # Errors
    /// When one refuses, or the initial values do not settle.
    pub fn initialize(&mut self) -> Result<(), RunError> {
        let (stop, rails_end) = (self.stop, self.rails_end());
        let Self { system, rails, subject, .. } = self;
        let done = system.initialize(|part| if rails.contain(part) { rails_end } else { stop });
        done.map_err(RunError::from).map_err(|error| match subject {
            Subject::Train(scenario, _) => error.at_key(scenario).of_start(scenario),
            Subject::Package(..) => error,
        })
    }

    /// Begins the series in `folder`.
    ///
    /// # Errors
    /// When the folder cannot be written, or the scenario names outputs that are not there.
    pub fn recorder(&mut self, folder: &Path) -> Result<Recorder, ObserveError> {
        match &self.subject {
            Subject::Train(scenario, layout) => {
                train_tables::recorder(scenario, layout, &mut self.system, folder)
            }
            Subject::Package(every, chosen) => {
                Recorder::of_components(&self.system, (*every, chosen), folder)
            }
        }
    }

    /// What is shown while running.
    pub fn live_figures(&mut self) -> LiveFigures {
        match &self.subject {
            Subject::Train(_, layout) => LiveFigures::of(layout, &mut self.system),
            Subject::Package(..) => LiveFigures::default(),
        }
    }

    /// Lets the run write no checkpoints, and says so, if there are units that cannot be saved.
    ///
    /// # Errors
    /// When the folder of the checkpoints cannot be removed.
    pub fn check_states(&mut self, beginning: &mut Beginning) -> Result<(), CheckpointError> {
        let Some(checkpoints) = &mut beginning.checkpoints else { return Ok(()) };
        let unable = self.system.units().filter(|unit| !unit.keeps_states());
        let files: BTreeSet<_> = unable.map(|unit| unit.source_file()).collect();
        if files.is_empty() {
            checkpoints.fmus = self.manifest.digests();
            return beginning.check_fmus(&self.manifest.digests());
        }
        let files = files.into_iter().collect::<Vec<_>>().join(", ");
        let sentence = format!(
            "no checkpoints are written: {files} cannot save its state for another program, which would              take canGetAndSetFMUstate and canSerializeFMUstate"
        );
        beginning.notes.push(sentence.clone());
        self.manifest.warnings.push(sentence);
        beginning.checkpoints.take().map_or(Ok(()), Checkpoints::remove)
    }

    /// Lets the initialised units begin at the start, which is recorded, or go on from a saved state.
    ///
    /// Gives what is done already.
    ///
    /// # Errors
    /// When a unit refuses, or a file cannot be written.
    pub fn begin(
        &mut self,
        saved: Option<RunState>,
        recorder: &mut Recorder,
        progress: &mut Progress,
    ) -> Result<Reached, RunError> {
        let Self { system, rails, recorded, .. } = self;
        let Some(saved) = saved else {
            // The observed outputs as they are at the start.
            let start = system.clock.start;
            parallel::for_each(&mut system.parts, |part| part.take_outputs(start))
                .map_err(StartError::from)?;
            recorder.observe(0, system)?;
            *recorded = true;
            return Ok(Reached::Run(0));
        };
        let RunState { reached, time, times, parts, tables, tapes, .. } = saved;
        system.restore(parts).map_err(CheckpointError::from)?;
        system.times = times;
        rails.resume(&tapes, system).map_err(CheckpointError::from)?;
        recorder.resume(tables)?;
        *recorded = true;
        let done = match reached {
            Reached::Run(done) => done,
            Reached::After(..) => self.steps,
        };
        progress.continue_from(done, time);
        Ok(reached)
    }

    /// Adds to the manifest what the units say of themselves after the initialisation, and what can be
    /// foreseen, in sentences.
    ///
    /// # Errors
    /// When a unit does not give what it has.
    pub fn describe(&mut self) -> Result<(), RunError> {
        let Self { system, subject: Subject::Train(scenario, layout), manifest, .. } = self else {
            return Ok(());
        };
        let Some(run) = &mut manifest.run else { return Ok(()) };
        let (Some(rail), Some(heat), Some(facts)) =
            (layout.rails.first(), &scenario.heat, &mut run.rails)
        else {
            return Ok(());
        };
        let in_force = RailInForce::of(system, &rail.component, scenario, heat);
        let in_force = in_force.map_err(StartError::from)?;
        facts.length_m = in_force.extent.length;
        facts.detection_threshold_k = in_force.detection_threshold;
        facts.model = in_force.model;
        run.notes = wheels_outside(layout, system, in_force.extent, scenario.duration_s);
        Ok(())
    }
}
