//! Which call is allowed when.

use std::ffi::c_void;
use std::ptr;

use fmu::Status;

use crate::fmi2::*;
use crate::tool::Fmu;

/// An instance in the state with this letter: those of the table below.
pub fn in_state(letter: char) -> Fmu {
    match letter {
        'I' => Fmu::new(),
        'M' => Fmu::initializing(),
        'C' => Fmu::running(),
        'F' => {
            let fmu = Fmu::running();
            assert_eq!(fmu.do_step(0.0, 2.0), Status::Discard);
            fmu
        }
        'T' => {
            let fmu = Fmu::running();
            assert_eq!(fmu.terminate(), Status::Ok);
            fmu
        }
        'E' => {
            let fmu = Fmu::troubled("error");
            assert_eq!(fmu.do_step(0.0, 0.1), Status::Error);
            fmu
        }
        _ => unreachable!("no such state: {letter}"),
    }
}

/// Makes the call by this name with arguments that do no harm.
fn call(name: &str, fmu: &Fmu) {
    let c = fmu.component;
    let mut state: *mut c_void = ptr::null_mut();
    let (mut integer, mut real, mut size) = (0, 0.0, 0);
    let mut text = ptr::null();
    // SAFETY: the component lives, arrays are empty, and the rest is on the stack.
    unsafe {
        match name {
            "fmi2SetDebugLogging" => fmi2SetDebugLogging(c, 1, 0, ptr::null()),
            "fmi2SetupExperiment" => fmi2SetupExperiment(c, 0, 0.0, 0.0, 0, 0.0),
            "fmi2EnterInitializationMode" => fmi2EnterInitializationMode(c),
            "fmi2ExitInitializationMode" => fmi2ExitInitializationMode(c),
            "fmi2Terminate" => fmi2Terminate(c),
            "fmi2Reset" => fmi2Reset(c),
            "fmi2GetReal" => fmi2GetReal(c, ptr::null(), 0, ptr::null_mut()),
            "fmi2GetInteger" => fmi2GetInteger(c, ptr::null(), 0, ptr::null_mut()),
            "fmi2GetBoolean" => fmi2GetBoolean(c, ptr::null(), 0, ptr::null_mut()),
            "fmi2GetString" => fmi2GetString(c, ptr::null(), 0, ptr::null_mut()),
            "fmi2SetReal" => fmi2SetReal(c, ptr::null(), 0, ptr::null()),
            "fmi2SetInteger" => fmi2SetInteger(c, ptr::null(), 0, ptr::null()),
            "fmi2SetBoolean" => fmi2SetBoolean(c, ptr::null(), 0, ptr::null()),
            "fmi2SetString" => fmi2SetString(c, ptr::null(), 0, ptr::null()),
            "fmi2GetFMUstate" => {
                let status = fmi2GetFMUstate(c, &mut state);
                fmi2FreeFMUstate(c, &mut state);
                status
            }
            "fmi2SetFMUstate" => fmi2SetFMUstate(c, state),
            "fmi2FreeFMUstate" => fmi2FreeFMUstate(c, &mut state),
            "fmi2SerializedFMUstateSize" => fmi2SerializedFMUstateSize(c, state, &mut size),
            "fmi2SerializeFMUstate" => fmi2SerializeFMUstate(c, state, ptr::null_mut(), 0),
            "fmi2DeSerializeFMUstate" => fmi2DeSerializeFMUstate(c, ptr::null(), 0, &mut state),
            "fmi2GetDirectionalDerivative" => {
                let (none, to) = (ptr::null(), ptr::null_mut());
                fmi2GetDirectionalDerivative(c, none, 0, none, 0, ptr::null(), to)
            }
            "fmi2SetRealInputDerivatives" => {
                fmi2SetRealInputDerivatives(c, ptr::null(), 0, ptr::null(), ptr::null())
            }
            "fmi2GetRealOutputDerivatives" => {
                fmi2GetRealOutputDerivatives(c, ptr::null(), 0, ptr::null(), ptr::null_mut())
            }
            "fmi2DoStep" => fmi2DoStep(c, 0.0, 0.1, 1),
            "fmi2CancelStep" => fmi2CancelStep(c),
            "fmi2GetStatus" => fmi2GetStatus(c, 0, &mut integer),
            "fmi2GetRealStatus" => fmi2GetRealStatus(c, 2, &mut real),
            "fmi2GetIntegerStatus" => fmi2GetIntegerStatus(c, 0, &mut integer),
            "fmi2GetBooleanStatus" => fmi2GetBooleanStatus(c, 3, &mut integer),
            "fmi2GetStringStatus" => fmi2GetStringStatus(c, 1, &mut text),
            _ => unreachable!("no such function: {name}"),
        }
    };
}

/// The table of §4.2.4 once more, from the standard: each function with the states in which it
/// may be called: Instantiated, initialization Mode, step Complete, step Failed, Terminated,
/// Error.
const TABLE: [(&str, &str); 30] = [
    ("fmi2SetDebugLogging", "IMCFTE"),
    ("fmi2SetupExperiment", "I"),
    ("fmi2EnterInitializationMode", "I"),
    ("fmi2ExitInitializationMode", "M"),
    ("fmi2Terminate", "CF"),
    ("fmi2Reset", "IMCFTE"),
    ("fmi2GetReal", "MCFTE"),
    ("fmi2GetInteger", "MCFTE"),
    ("fmi2GetBoolean", "MCFTE"),
    ("fmi2GetString", "MCFTE"),
    ("fmi2SetReal", "IMC"),
    ("fmi2SetInteger", "IMC"),
    ("fmi2SetBoolean", "IMC"),
    ("fmi2SetString", "IMC"),
    ("fmi2GetFMUstate", "IMCFTE"),
    ("fmi2SetFMUstate", "IMCFTE"),
    ("fmi2FreeFMUstate", "IMCFTE"),
    ("fmi2SerializedFMUstateSize", "IMCFTE"),
    ("fmi2SerializeFMUstate", "IMCFTE"),
    ("fmi2DeSerializeFMUstate", "IMCFTE"),
    ("fmi2GetDirectionalDerivative", "MCFTE"),
    ("fmi2SetRealInputDerivatives", "IMC"),
    ("fmi2GetRealOutputDerivatives", "CFTE"),
    ("fmi2DoStep", "C"),
    ("fmi2CancelStep", ""),
    ("fmi2GetStatus", "CFT"),
    ("fmi2GetRealStatus", "CFT"),
    ("fmi2GetIntegerStatus", "CFT"),
    ("fmi2GetBooleanStatus", "CFT"),
    ("fmi2GetStringStatus", "CFT"),
];

#[test]
fn calls_are_allowed_as_the_table_of_the_standard_says() {
    for (name, states) in TABLE {
        for letter in "IMCFTE".chars() {
            let fmu = in_state(letter);
            fmu.messages();
            call(name, &fmu);
            let forbidden = format!("{name} is not allowed in the state");
            let messages = fmu.messages();
            let was_forbidden = messages.iter().any(|message| message.text.contains(&forbidden));
            assert_eq!(was_forbidden, !states.contains(letter), "{name} {letter} {messages:?}");
        }
    }
}
