//! Getting and setting the values of an instance's variables (§2.1.7).

use super::refusal::{BOOLEAN, INTEGER, REAL, Refusal, STRING};
use super::rules::Rule;
use crate::calls::{Call, Phase};
use crate::error::Error;
use crate::instance::Instance;
use crate::model::Model;

macro_rules! getters {
    ($($(#[$doc:meta])* $name:ident, $call:ident, $store:ident, $kind:ident: $value:ty;)*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// When the phase forbids it or a value reference is unknown; in initialization mode
        /// also when the model refuses its start values.
        pub fn $name(
            &mut self,
            references: &[u32],
        ) -> Result<impl ExactSizeIterator<Item = $value>, Error> {
            self.call(Call::$call, |instance| {
                check_references($kind, references, instance.values.$store.len())?;
                instance.make_readable()
            })?;
            let values = &self.values.$store;
            Ok(references.iter().map(move |&reference| values[reference as usize].clone()))
        }
    )*};
}

macro_rules! setters {
    ($($(#[$doc:meta])* $name:ident, $call:ident, $store:ident, $kind:ident: $value:ty;)*) => {$(
        $(#[$doc])*
        ///
        /// # Errors
        /// When the phase forbids it, a value reference is unknown, the variable cannot be set
        /// now, or a value is out of its variable's bounds.
        pub fn $name(
            &mut self,
            references: &[u32],
            values: impl IntoIterator<Item = $value, IntoIter: ExactSizeIterator>,
        ) -> Result<(), Error> {
            self.call(Call::$call, |instance| {
                let (phase, rules) = (instance.phase, &instance.interface.rules.$store);
                let values = check_lengths(references, values)?;
                let store = &mut instance.values.$store;
                let changed = write(store, rules, phase, references, values)
                    .map_err(|refusal| instance.refused($kind, refusal))?;
                instance.note_start_values(changed);
                Ok(())
            })
        }
    )*};
}

impl<M: Model> Instance<M> {
    getters! {
        /// Gets the values of Real variables.
        get_real, GetReal, reals, REAL: f64;
        /// Gets the values of Integer variables.
        get_integer, GetInteger, integers, INTEGER: i32;
        /// Gets the values of Boolean variables.
        get_boolean, GetBoolean, booleans, BOOLEAN: bool;
        /// Gets the values of String variables.
        get_string, GetString, texts, STRING: String;
    }

    setters! {
        /// Sets the values of Real variables.
        set_real, SetReal, reals, REAL: f64;
        /// Sets the values of Integer variables.
        set_integer, SetInteger, integers, INTEGER: i32;
        /// Sets the values of Boolean variables.
        set_boolean, SetBoolean, booleans, BOOLEAN: bool;
    }

    /// Sets the values of String variables.
    ///
    /// # Errors
    /// When the phase forbids it, a value reference is unknown, the variable cannot be set now, or
    /// a text is none of its variable's choices.
    pub fn set_string<'v>(
        &mut self,
        references: &[u32],
        values: impl IntoIterator<Item = &'v str, IntoIter: ExactSizeIterator>,
    ) -> Result<(), Error> {
        self.call(Call::SetString, |instance| {
            let values = check_lengths(references, values)?;
            let mut changed = false;
            for (&reference, value) in references.iter().zip(values) {
                let refused = match instance.interface.rules.texts.get(reference as usize) {
                    None => Some(Refusal::Unknown(reference)),
                    Some(rule) if !rule.settable.contains(instance.phase) => {
                        Some(Refusal::NotSettable(reference))
                    }
                    Some(rule) if !rule.admits(value) => {
                        Some(Refusal::NotAllowed(reference, format!("\"{value}\"")))
                    }
                    Some(_) => None,
                };
                if let Some(refusal) = refused {
                    return Err(instance.refused(STRING, refusal));
                }
                let stored = &mut instance.values.texts[reference as usize];
                changed |= stored != value;
                value.clone_into(stored);
            }
            instance.note_start_values(changed);
            Ok(())
        })
    }

    /// In initialization mode the outputs follow the start values.
    fn make_readable(&mut self) -> Result<(), Error> {
        match self.phase {
            Phase::InitializationMode => self.initialize(),
            _ => Ok(()),
        }
    }

    /// Drops a model that was built from other start values.
    ///
    /// One that was built from the same is kept, so that a tool that sets all inputs again and
    /// again until they settle does not wait each time.
    fn note_start_values(&mut self, changed: bool) {
        if changed && matches!(self.phase, Phase::Instantiated | Phase::InitializationMode) {
            self.built = None;
        }
    }
}

fn check_references(kind: &'static str, references: &[u32], count: usize) -> Result<(), Error> {
    // Without an early end the loop is one of vector instructions.
    match references.iter().copied().reduce(u32::max) {
        Some(reference) if reference as usize >= count => {
            Err(Error::UnknownReference { kind, reference, count })
        }
        _ => Ok(()),
    }
}

fn check_lengths<V>(references: &[u32], values: V) -> Result<V::IntoIter, Error>
where
    V: IntoIterator<IntoIter: ExactSizeIterator>,
{
    let values = values.into_iter();
    if values.len() == references.len() {
        return Ok(values);
    }
    Err(Error::Lengths { references: references.len(), values: values.len() })
}

/// Writes values that their rules admit, and tells whether one of them is new.
fn write<T: PartialOrd + Copy + ToString>(
    store: &mut [T],
    rules: &[Rule<T>],
    phase: Phase,
    references: &[u32],
    values: impl Iterator<Item = T>,
) -> Result<bool, Refusal> {
    let mut changed = false;
    for (&reference, value) in references.iter().zip(values) {
        let index = reference as usize;
        let (Some(rule), Some(stored)) = (rules.get(index), store.get_mut(index)) else {
            return Err(Refusal::Unknown(reference));
        };
        if !rule.settable.contains(phase) {
            return Err(Refusal::NotSettable(reference));
        }
        if !rule.admits(&value) {
            return Err(Refusal::NotAllowed(reference, value.to_string()));
        }
        changed |= *stored != value;
        *stored = value;
    }
    Ok(changed)
}
