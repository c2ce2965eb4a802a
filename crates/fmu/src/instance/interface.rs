//! A model's interface, made ready for an instance: checked, and compact where calls are often.

use std::collections::HashSet;
use std::path::Path;

use super::rules::Rules;
use crate::error::Error;
use crate::model::{Model, ModelError};
use crate::variables::{Declaration, Guid, Variable};

/// What an instance knows of its variables.
pub(crate) struct Interface<M: Model> {
    pub(crate) declaration: Declaration,
    pub(crate) signals: M::Signals,
    pub(crate) guid: Guid,
    pub(crate) rules: Rules,
}

impl<M: Model> Interface<M> {
    /// Declares the variables of the model with the files in `resources`.
    pub(crate) fn new(resources: &Path) -> Result<Self, Error> {
        let mut declaration = Declaration::default();
        let signals = M::declare(resources, &mut declaration).map_err(Error::Interface)?;
        check(declaration.variables()).map_err(Error::Interface)?;
        Ok(Self {
            guid: Guid::of(M::IDENTITY.identifier, declaration.variables()),
            rules: Rules::of(declaration.variables()),
            signals,
            declaration,
        })
    }
}

/// Names must be unique, and start values finite and within their bounds (§2.2.7).
fn check(variables: &[Variable]) -> Result<(), ModelError> {
    let mut names = HashSet::new();
    for Variable { name, kind, .. } in variables {
        if !names.insert(name) {
            return Err(ModelError::new(format!("`{name}` is declared twice")));
        }
        if !kind.admits_start() {
            let wanted = kind.requirement();
            return Err(ModelError::new(format!("the start value of `{name}` must be {wanted}")));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::variables::unit;

    fn mass(declaration: &mut Declaration, start: f64) {
        let mass = declaration.real("mass", unit::KILOGRAM, "Mass").within(1.0..);
        let _ = mass.parameter(start);
    }

    #[test]
    fn a_name_that_is_declared_twice_is_refused() {
        let mut declaration = Declaration::default();
        mass(&mut declaration, 2.0);
        mass(&mut declaration, 2.0);
        let error = check(declaration.variables()).unwrap_err();
        assert_eq!(error.to_string(), "`mass` is declared twice");
    }

    #[test]
    fn a_start_value_out_of_bounds_is_refused() {
        for start in [0.0, f64::NAN, f64::INFINITY] {
            let mut declaration = Declaration::default();
            mass(&mut declaration, start);
            let error = check(declaration.variables()).unwrap_err();
            let sentence = "the start value of `mass` must be a finite number, at least 1 kg";
            assert_eq!(error.to_string(), sentence);
        }
    }
}
