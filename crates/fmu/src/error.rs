//! Why a call did not succeed, in sentences for the user.

use numerics::seconds;

use crate::calls::{Call, Phase};
use crate::model::ModelError;

/// Why a call did not succeed; the FMU logs the sentence and returns the [`status`](Self::status).
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum Error {
    /// The state of the instance forbids the call.
    #[error("{call} is not allowed in the state \"{phase}\"")]
    Forbidden {
        /// The call.
        call: Call,
        /// The state.
        phase: Phase,
    },

    /// The instance has no name.
    #[error("the instance needs a name that is not blank")]
    BlankName,

    /// The environment wants another kind of FMU.
    #[error("this FMU is one for co-simulation (fmuType 1) only")]
    NotCoSimulation,

    /// The model description is not the one of this binary.
    #[error(
        "the GUID {given} does not fit: this modelDescription.xml is stale or belongs to another \
         FMU (the binary {identifier} has {own})"
    )]
    Guid {
        /// GUID that the environment gave.
        given: String,
        /// The model's identifier.
        identifier: &'static str,
        /// GUID of the interface.
        own: String,
    },

    /// The resource location is not a folder on this machine.
    #[error("the resource location `{location}` {problem}")]
    ResourceLocation {
        /// URI that the environment gave.
        location: String,
        /// What is wrong with it.
        problem: &'static str,
    },

    /// The model could not declare its variables, or declared them wrongly.
    #[error("the interface cannot be formed: {0}")]
    Interface(ModelError),

    /// The model refuses its start values.
    #[error("the initialization failed: {0}")]
    Initialization(ModelError),

    /// The model failed within a step.
    #[error("the step from {} s over {} s failed: {source}", seconds(*start), seconds(*length))]
    Step {
        /// Time at which the step began, s.
        start: f64,
        /// Length of the step, s.
        length: f64,
        /// What the model says.
        source: ModelError,
    },

    /// The model failed to complete its files.
    #[error("the termination failed: {0}")]
    Termination(ModelError),

    /// An output is not a number.
    #[error("the output `{variable}` became {value} at {} s", seconds(*time))]
    NotFinite {
        /// The output.
        variable: String,
        /// Its value: NaN or infinite.
        value: f64,
        /// Time, s.
        time: f64,
    },

    /// No variable has the value reference.
    #[error("there is no {kind} variable with value reference {reference}; there are {count}")]
    UnknownReference {
        /// Type of the variable.
        kind: &'static str,
        /// The value reference.
        reference: u32,
        /// Number of variables of the type; references count from zero.
        count: usize,
    },

    /// The variable may not be set now.
    #[error("`{variable}` may not be set in the state \"{phase}\": it is {nature}")]
    NotSettable {
        /// The variable.
        variable: String,
        /// What it is, such as "an output".
        nature: &'static str,
        /// The state.
        phase: Phase,
    },

    /// The value is not allowed.
    #[error("`{variable}` cannot be {value}: it must be {requirement}")]
    NotAllowed {
        /// The variable.
        variable: String,
        /// The value with its unit.
        value: String,
        /// What is allowed.
        requirement: String,
    },

    /// The number of values is not that of the value references.
    #[error("{references} value references came with {values} values")]
    Lengths {
        /// Number of value references.
        references: usize,
        /// Number of values.
        values: usize,
    },

    /// Start and stop time make no sense.
    #[error("the experiment from {start} s to {stop} s has no finite length greater than zero")]
    Experiment {
        /// Start time, s.
        start: f64,
        /// Stop time, s; infinite if there is none.
        stop: f64,
    },

    /// `fmi2SetupExperiment` was left out.
    #[error("fmi2SetupExperiment must be called before fmi2EnterInitializationMode")]
    NoExperiment,

    /// A step has no length.
    #[error("the communication step size must be greater than zero and finite, not {0} s")]
    StepSize(f64),

    /// A step does not begin where the last one ended; all digits, since the gap may be small.
    #[error("the step begins at {given} s, but the FMU stands at {own} s")]
    CommunicationPoint {
        /// Time at which the environment wants the step to begin, s.
        given: f64,
        /// Time of the instance, s.
        own: f64,
    },

    /// A step goes beyond the end of the experiment; all digits, since it may be by little.
    #[error("the step would end at {end} s, after the stop time {stop} s")]
    BeyondStopTime {
        /// End of the step, s.
        end: f64,
        /// Stop time, s.
        stop: f64,
    },

    /// The saved state belongs to another interface.
    #[error("the FMU state was saved by an FMU with another interface or version ({0})")]
    ForeignState(String),

    /// The bytes are not a saved state.
    #[error("the bytes are not a serialized FMU state: {0}")]
    DamagedState(String),

    /// The buffer is too small for the saved state.
    #[error("the FMU state needs {needed} bytes, the buffer has {given}")]
    SmallBuffer {
        /// Size that is needed.
        needed: usize,
        /// Size of the buffer.
        given: usize,
    },

    /// The FMU does not offer what is called, and its model description says so.
    #[error("{call} is not offered: modelDescription.xml has {flag}")]
    NotOffered {
        /// The call.
        call: Call,
        /// The attribute that says so, with its value.
        flag: &'static str,
    },

    /// The status is that of an asynchronous step or of an unknown kind.
    #[error("{call} knows nothing of status kind {kind}: no step runs asynchronously")]
    NoStatus {
        /// The call.
        call: Call,
        /// Number of the kind in `fmi2StatusKind`.
        kind: i32,
    },

    /// A log category is not among those of the model description.
    #[error("the log category `{0}` is not one of those in modelDescription.xml")]
    UnknownCategory(String),

    /// A pointer is missing.
    #[error("the argument `{0}` is a null pointer")]
    NullArgument(&'static str),

    /// A text is not UTF-8.
    #[error("the argument `{0}` is not UTF-8")]
    NotUtf8(&'static str),

    /// A programming error; the instance has lost its model.
    #[error("{call} met a programming error: {message}")]
    Panic {
        /// The call.
        call: Call,
        /// Message of the panic.
        message: String,
    },

    /// A programming error before there was an instance.
    #[error("the declaration of the interface met a programming error: {0}")]
    PanicInDeclaration(String),
}
