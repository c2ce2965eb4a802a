//! What a run and the process of an FMU tell each other.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::system::unit::UnitError;

/// What the run asks.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub enum Request {
    /// Make the instance: the first one.
    Make(Instance),
    /// Call it, until a call fails.
    Calls(Vec<Call>),
    /// Free it: the last one.
    Free,
}

/// An instance that is to be made.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Instance {
    /// The FMU, as messages call it.
    pub file: String,
    /// The folder in which it is unpacked.
    pub folder: PathBuf,
    /// Its name.
    pub name: String,
    /// Relative tolerance; none: what the FMU proposes.
    pub tolerance: Option<f64>,
    /// Whether a step that it discards is tried again in parts.
    pub retries: bool,
}

/// A call of the instance, as those of [`Unit`](crate::system::unit::Unit).
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub enum Call {
    SetReals(Vec<u32>, Vec<f64>),
    SetIntegers(Vec<u32>, Vec<i32>),
    SetBooleans(Vec<u32>, Vec<i32>),
    SetText(u32, String),
    GetReals(Vec<u32>),
    GetIntegers(Vec<u32>),
    GetBooleans(Vec<u32>),
    GetText(u32),
    EnterInitialization(f64, f64),
    ExitInitialization,
    Step(f64, f64),
    Save,
    Restore(#[serde(with = "serde_bytes")] Vec<u8>),
    Terminate,
}

/// What a call has given.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub enum Given {
    Nothing,
    Reals(Vec<f64>),
    Integers(Vec<i32>),
    Text(String),
    Saved(#[serde(with = "serde_bytes")] Vec<u8>),
}

/// What the process answers.
#[derive(Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Answer {
    /// What each call has given that succeeded, in their order.
    pub given: Vec<Given>,
    /// Why the next one did not.
    pub failure: Option<Failure>,
    /// The time at which the FMU wants the run to end, s.
    pub wish_to_end: Option<f64>,
    /// What it has warned of since the answer before.
    pub warnings: Vec<String>,
}

/// A [`UnitError`] without what the run knows itself.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub struct Failure {
    /// What was tried.
    pub action: String,
    /// Name of the FMI status.
    pub status: Option<String>,
    /// The last message.
    pub last_message: Option<String>,
}

impl From<UnitError> for Failure {
    fn from(error: UnitError) -> Self {
        Self {
            action: error.action.into(),
            status: error.status.map(str::to_owned),
            last_message: error.last_message.map(Into::into),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Numbers come as they are, to the bit, also those that are none.
    #[test]
    fn what_is_told_arrives() {
        let quiet = f64::from_bits(0x7ff8_0000_dead_beef);
        let values = [0.1, -0.0, f64::NEG_INFINITY, quiet];
        let request = Request::Calls(vec![
            Call::SetReals(vec![0, u32::MAX, 7, 8], values.to_vec()),
            Call::SetText(3, "Züge".to_owned()),
            Call::Step(1.0, 1e-3),
        ]);
        let bytes = postcard::to_allocvec(&request).unwrap();
        let Ok(Request::Calls(calls)) = postcard::from_bytes(&bytes) else { panic!("{bytes:?}") };
        let [Call::SetReals(references, arrived), text, step] = &calls[..] else {
            panic!("{calls:?}")
        };
        assert_eq!(references, &[0, u32::MAX, 7, 8]);
        assert!(arrived.iter().zip(values).all(|(a, b)| a.to_bits() == b.to_bits()), "{arrived:?}");
        assert_eq!(*text, Call::SetText(3, "Züge".to_owned()));
        assert_eq!(*step, Call::Step(1.0, 1e-3));
    }
}
