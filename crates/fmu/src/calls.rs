//! Which call is allowed when: the table of §4.2.4, as data.

use std::fmt;

use crate::variables::{Causality, Variability, Variable};

/// Where an instance stands in its life (the states of §4.2.4).
///
/// The states `stepInProgress` and `stepCanceled` are missing because no step runs
/// asynchronously, and `fatal` because no failure of one instance reaches another.
#[derive(Clone, Copy, Debug, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub enum Phase {
    /// Made, or reset; the start values may be changed.
    Instantiated,
    /// Between `fmi2EnterInitializationMode` and `fmi2ExitInitializationMode`.
    InitializationMode,
    /// Ready for the next step.
    StepComplete,
    /// The last step was discarded; the instance stands at its beginning.
    StepFailed,
    /// After `fmi2Terminate`.
    Terminated,
    /// A call has returned `fmi2Error`: only a reset or a saved state leads on.
    Error,
}

impl fmt::Display for Phase {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Instantiated => "instantiated",
            Self::InitializationMode => "initialization mode",
            Self::StepComplete => "step complete",
            Self::StepFailed => "step failed",
            Self::Terminated => "terminated",
            Self::Error => "error",
        })
    }
}

/// A set of phases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Phases(u8);

impl Phases {
    /// No phase at all.
    pub(crate) const NONE: Self = Self::of(&[]);

    const fn of(phases: &[Phase]) -> Self {
        let mut bits = 0;
        let mut index = 0;
        while index < phases.len() {
            bits |= 1 << phases[index] as u8;
            index += 1;
        }
        Self(bits)
    }

    pub(crate) fn contains(self, phase: Phase) -> bool {
        self.0 & (1 << phase as u8) != 0
    }
}

/// The FMI functions that the phase may forbid, named as in the standard without `fmi2`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the standard describes its functions")]
pub enum Call {
    SetDebugLogging,
    SetupExperiment,
    EnterInitializationMode,
    ExitInitializationMode,
    Terminate,
    Reset,
    GetReal,
    GetInteger,
    GetBoolean,
    GetString,
    SetReal,
    SetInteger,
    SetBoolean,
    SetString,
    GetFMUstate,
    SetFMUstate,
    FreeFMUstate,
    SerializedFMUstateSize,
    SerializeFMUstate,
    DeSerializeFMUstate,
    GetDirectionalDerivative,
    SetRealInputDerivatives,
    GetRealOutputDerivatives,
    DoStep,
    CancelStep,
    GetStatus,
    GetRealStatus,
    GetIntegerStatus,
    GetBooleanStatus,
    GetStringStatus,
}

impl Call {
    /// Whether the standard allows the call in `phase`.
    pub fn allowed_in(self, phase: Phase) -> bool {
        ALLOWED[self as usize].1[phase as usize]
    }
}

impl fmt::Display for Call {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "fmi2{self:?}")
    }
}

const X: bool = true;
const O: bool = false;

/// The table of §4.2.4: `X` where a call is allowed.
///
/// The rows stand in the order of [`Call`], the columns in the order of [`Phase`].
#[rustfmt::skip]
const ALLOWED: [(Call, [bool; 6]); 30] = [
    //                              instantiated
    //                              |  initialization mode
    //                              |  |  step complete
    //                              |  |  |  step failed
    //                              |  |  |  |  terminated
    //                              |  |  |  |  |  error
    (Call::SetDebugLogging,          [X, X, X, X, X, X]),
    (Call::SetupExperiment,          [X, O, O, O, O, O]),
    (Call::EnterInitializationMode,  [X, O, O, O, O, O]),
    (Call::ExitInitializationMode,   [O, X, O, O, O, O]),
    (Call::Terminate,                [O, O, X, X, O, O]),
    (Call::Reset,                    [X, X, X, X, X, X]),
    (Call::GetReal,                  [O, X, X, X, X, X]),
    (Call::GetInteger,               [O, X, X, X, X, X]),
    (Call::GetBoolean,               [O, X, X, X, X, X]),
    (Call::GetString,                [O, X, X, X, X, X]),
    (Call::SetReal,                  [X, X, X, O, O, O]),
    (Call::SetInteger,               [X, X, X, O, O, O]),
    (Call::SetBoolean,               [X, X, X, O, O, O]),
    (Call::SetString,                [X, X, X, O, O, O]),
    (Call::GetFMUstate,              [X, X, X, X, X, X]),
    (Call::SetFMUstate,              [X, X, X, X, X, X]),
    (Call::FreeFMUstate,             [X, X, X, X, X, X]),
    (Call::SerializedFMUstateSize,   [X, X, X, X, X, X]),
    (Call::SerializeFMUstate,        [X, X, X, X, X, X]),
    (Call::DeSerializeFMUstate,      [X, X, X, X, X, X]),
    (Call::GetDirectionalDerivative, [O, X, X, X, X, X]),
    (Call::SetRealInputDerivatives,  [X, X, X, O, O, O]),
    (Call::GetRealOutputDerivatives, [O, O, X, X, X, X]),
    (Call::DoStep,                   [O, O, X, O, O, O]),
    (Call::CancelStep,               [O, O, O, O, O, O]),
    (Call::GetStatus,                [O, O, X, X, X, O]),
    (Call::GetRealStatus,            [O, O, X, X, X, O]),
    (Call::GetIntegerStatus,         [O, O, X, X, X, O]),
    (Call::GetBooleanStatus,         [O, O, X, X, X, O]),
    (Call::GetStringStatus,          [O, O, X, X, X, O]),
];

/// The phases in which a variable may be set (§4.2.4, notes to the rows of `fmi2SetReal` etc.).
///
/// Inputs are taken in *instantiated* too, though note 1 names only variables whose `initial` is
/// exact or approx, and inputs have no `initial` (§2.2.7). They have a start value, which is what
/// is set there; they fell out of the note by an oversight (fmi-standard, issue 369) that FMI 3.0
/// has mended, where inputs are exact. libcosim sets the start values of inputs then, and the
/// Reference FMUs take them.
pub(crate) fn settable(variable: &Variable) -> Phases {
    use Phase::{InitializationMode, Instantiated, StepComplete};
    const FIXED: Phases = Phases::of(&[Instantiated, InitializationMode]);
    const CHANGING: Phases = Phases::of(&[Instantiated, InitializationMode, StepComplete]);
    match (variable.causality, variable.variability) {
        (Causality::Output, _) => Phases::NONE,
        (Causality::Input, _) | (Causality::Parameter, Variability::Tunable) => CHANGING,
        (Causality::Parameter, _) => FIXED,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_in_the_order_of_the_calls() {
        for (index, (call, _)) in ALLOWED.iter().enumerate() {
            assert_eq!(*call as usize, index, "{call}");
        }
    }

    #[test]
    fn a_step_is_allowed_in_step_complete_only() {
        assert!(Call::DoStep.allowed_in(Phase::StepComplete));
        for phase in [Phase::Instantiated, Phase::StepFailed, Phase::Error] {
            assert!(!Call::DoStep.allowed_in(phase), "{phase}");
        }
    }

    #[test]
    fn a_set_of_phases_holds_those_it_was_made_of() {
        let phases = Phases::of(&[Phase::Instantiated, Phase::Error]);
        assert!(phases.contains(Phase::Instantiated) && phases.contains(Phase::Error));
        assert!(!phases.contains(Phase::StepComplete));
    }
}
