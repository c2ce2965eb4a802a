//! A run that is ready to be initialised: of a scenario's train, or of a package.

use std::path::Path;

use super::after::Rails;
use super::error::RunError;
use super::live::LiveFigures;
use super::manifest::Manifest;
use super::observe_error::ObserveError;
use super::recorder::Recorder;
use super::train_tables;
use crate::scenario::Scenario;
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
    /// Any other system, recorded every so many steps.
    Package(u64),
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

    /// Begins the series in `folder`.
    ///
    /// # Errors
    /// When the folder cannot be written, or the scenario names outputs that are not there.
    pub fn recorder(&mut self, folder: &Path) -> Result<Recorder, ObserveError> {
        match &self.subject {
            Subject::Train(scenario, layout) => {
                train_tables::recorder(scenario, layout, &mut self.system, folder)
            }
            Subject::Package(every) => Recorder::of_components(&self.system, *every, folder),
        }
    }

    /// What is shown while running.
    pub fn live_figures(&mut self) -> LiveFigures {
        match &self.subject {
            Subject::Train(_, layout) => LiveFigures::of(layout, &mut self.system),
            Subject::Package(_) => LiveFigures::default(),
        }
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
        let in_force = in_force.map_err(crate::system::start::StartError::from)?;
        facts.length_m = in_force.extent.length;
        facts.detection_threshold_k = in_force.detection_threshold;
        facts.model = in_force.model;
        run.notes = wheels_outside(layout, system, in_force.extent, scenario.duration_s);
        Ok(())
    }
}
