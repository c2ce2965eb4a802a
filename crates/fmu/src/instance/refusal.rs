//! Why a value is not set, in words.

use crate::calls::Phase;
use crate::error::Error;
use crate::instance::Instance;
use crate::model::Model;
use crate::variables::{Causality, Kind, Variability, Variable};

/// Why the value with a reference is not set.
pub(super) enum Refusal {
    /// There is no such variable.
    Unknown(u32),
    /// The variable cannot be set now.
    NotSettable(u32),
    /// The variable cannot have this value.
    NotAllowed(u32, String),
}

/// Names of the types in messages.
pub(super) const REAL: &str = "Real";
pub(super) const INTEGER: &str = "Integer";
pub(super) const BOOLEAN: &str = "Boolean";
pub(super) const STRING: &str = "String";

impl<M: Model> Instance<M> {
    /// The error that tells of a refusal, of a variable of the type named `kind`.
    #[cold]
    pub(super) fn refused(&self, kind: &'static str, refusal: Refusal) -> Error {
        let variables = self.declaration().variables();
        let mut of_kind = variables.iter().filter(|variable| variable.kind.name() == kind);
        let (Refusal::Unknown(reference)
        | Refusal::NotSettable(reference)
        | Refusal::NotAllowed(reference, _)) = refusal;
        let count = of_kind.clone().count();
        let Some(variable) = of_kind.find(|variable| variable.reference == reference) else {
            return Error::UnknownReference { kind, reference, count };
        };
        match refusal {
            Refusal::NotAllowed(_, value) => variable.not_allowed(value),
            _ => variable.not_settable(self.phase),
        }
    }
}

impl Kind {
    fn name(&self) -> &'static str {
        match self {
            Self::Real { .. } => REAL,
            Self::Integer { .. } => INTEGER,
            Self::Boolean { .. } => BOOLEAN,
            Self::Text { .. } => STRING,
        }
    }
}

impl Variable {
    /// What the variable is.
    fn nature(&self) -> &'static str {
        match (self.causality, self.variability) {
            (Causality::Output, _) => "an output",
            (Causality::Input, _) => "an input",
            (Causality::Parameter, Variability::Tunable) => "a tunable parameter",
            (Causality::Parameter, _) => "a fixed parameter",
        }
    }

    /// The error that the variable may not be set in `phase`.
    fn not_settable(&self, phase: Phase) -> Error {
        Error::NotSettable { variable: self.name.clone(), nature: self.nature(), phase }
    }

    /// The error that the variable cannot have `value`.
    fn not_allowed(&self, value: String) -> Error {
        let is_finite = value.ends_with(|last: char| last.is_ascii_digit());
        let value = match self.kind {
            Kind::Real { unit, .. } if is_finite => unit.after(value),
            _ => value,
        };
        let requirement = self.kind.requirement();
        Error::NotAllowed { variable: self.name.clone(), value, requirement }
    }
}
