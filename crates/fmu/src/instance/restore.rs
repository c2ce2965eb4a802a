//! Saving an instance and setting it back (§2.1.8).

use std::sync::Arc;

use crate::calls::Call;
use crate::error::Error;
use crate::instance::state::{SavedModel, SavedState};
use crate::instance::{Built, Instance};
use crate::model::Model;

impl<M: Model> Instance<M> {
    /// Saves the instance.
    ///
    /// # Errors
    /// When the phase forbids it.
    pub fn save(&mut self) -> Result<SavedState<M>, Error> {
        self.call(Call::GetFMUstate, |instance| {
            Ok(SavedState {
                guid: instance.guid(),
                phase: instance.phase,
                experiment: instance.experiment,
                time: instance.time,
                values: instance.values.clone(),
                model: instance.built.as_ref().map(SavedModel::of),
                resources: Arc::clone(&instance.resource_folder),
            })
        })
    }

    /// Saves the instance into a state that is there already, reusing its memory.
    ///
    /// # Errors
    /// When the phase forbids it.
    pub fn save_into(&mut self, state: &mut SavedState<M>) -> Result<(), Error> {
        self.call(Call::GetFMUstate, |instance| {
            state.guid = instance.guid();
            state.phase = instance.phase;
            state.experiment = instance.experiment;
            state.time = instance.time;
            state.resources = Arc::clone(&instance.resource_folder);
            state.values.clone_from(&instance.values);
            match (&mut state.model, &instance.built) {
                (Some(saved), Some(built)) => {
                    saved.origin = Arc::clone(&built.origin);
                    saved.state.clone_from(&built.model.state());
                }
                (saved, built) => *saved = built.as_ref().map(SavedModel::of),
            }
            Ok(())
        })
    }

    /// Sets the instance into a saved state, which may be that of another instance.
    ///
    /// # Errors
    /// When the state is one of another interface, or the model cannot be built as it was.
    pub fn restore(&mut self, state: &SavedState<M>) -> Result<(), Error> {
        self.call(Call::SetFMUstate, |instance| {
            instance.check_state(state)?;
            instance.restore_model(state.model.as_ref())?;
            instance.values.clone_from(&state.values);
            instance.experiment = state.experiment;
            instance.time = state.time;
            instance.phase = state.phase;
            Ok(())
        })
    }

    /// Reads a state from bytes.
    ///
    /// # Errors
    /// When the bytes are damaged or come from another interface.
    pub fn deserialize_state(&mut self, bytes: &[u8]) -> Result<SavedState<M>, Error> {
        self.call(Call::DeSerializeFMUstate, |instance| {
            let mut state = SavedState::from_bytes(bytes, instance.guid())?;
            state.move_resources(&instance.resource_folder);
            instance.check_state(&state)?;
            instance.check_values(&state)?;
            Ok(state)
        })
    }

    fn check_state(&self, state: &SavedState<M>) -> Result<(), Error> {
        if state.guid != self.guid() {
            return Err(Error::ForeignState(state.guid.to_string()));
        }
        if !state.values.has_shape_of(&self.values) {
            let sentence = "the numbers of its values are wrong";
            return Err(Error::DamagedState(sentence.to_owned()));
        }
        Ok(())
    }

    /// What comes as bytes may hold what no setter admits.
    fn check_values(&self, state: &SavedState<M>) -> Result<(), Error> {
        let origin = state.model.as_ref().map(|model| &model.origin.values);
        let rules = &self.interface.rules;
        if [&state.values].into_iter().chain(origin).all(|values| rules.admit(values)) {
            return Ok(());
        }
        Err(Error::DamagedState("a value is not one that can be set".to_owned()))
    }

    /// Sets the model into a saved state, and builds it before if there is none that fits.
    fn restore_model(&mut self, saved: Option<&SavedModel<M>>) -> Result<(), Error> {
        let Some(SavedModel { origin, state }) = saved else {
            self.built = None;
            return Ok(());
        };
        let mut built = match self.built.take() {
            Some(built) if Arc::ptr_eq(&built.origin, origin) || built.origin == *origin => built,
            _ => {
                let (model, _) = self.build(origin)?;
                let origin = Arc::clone(origin);
                Built { model, origin }
            }
        };
        built.model.restore(state.clone());
        self.built = Some(built);
        Ok(())
    }
}

impl<M: Model> SavedModel<M> {
    fn of(built: &Built<M>) -> Self {
        Self { origin: Arc::clone(&built.origin), state: built.model.state().into_owned() }
    }
}
