//! The state of an instance, for saving: what `fmi2FMUstate` points to (§2.1.8).

use std::sync::Arc;

use serde::{Deserialize, Serialize};

use crate::calls::Phase;
use crate::error::Error;
use crate::model::Model;
use crate::variables::{Guid, Values};

/// Relative difference of two times that count as equal: to the greater of time and step.
///
/// Masters compute `k·h` in several ways, which differ by some units of the last
/// digit (1e-16); a step left out at 1 ms is noticed up to 1e6 s.
pub(super) const TIME_TOLERANCE: f64 = 1e-9;

/// Start and stop time, as `fmi2SetupExperiment` gives them.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Experiment {
    /// Time at which the simulation begins, s.
    pub(crate) start: f64,
    /// Time that no step may pass, s.
    pub(crate) stop: Option<f64>,
}

/// What a model was built from. Instances and states share it, as it never changes.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
pub(crate) struct Origin {
    /// The values from which the model was initialised.
    pub(crate) values: Values,
    /// Time at which the simulation began, s.
    pub(crate) start_time: f64,
}

/// A saved instance, into which any instance of the same interface can be set.
///
/// Stepping on from it gives the same bits as stepping on from the moment of saving.
#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
pub struct SavedState<M: Model> {
    pub(crate) guid: Guid,
    pub(crate) phase: Phase,
    pub(crate) experiment: Option<Experiment>,
    pub(crate) time: f64,
    pub(crate) values: Values,
    pub(crate) model: Option<SavedModel<M>>,
    /// Where the resources of the instance were, in which texts may name files.
    pub(crate) resources: Arc<str>,
}

/// A saved model: its state, and how to build it anew if the instance has none that fits.
#[derive(Serialize, Deserialize)]
#[serde(bound = "")]
pub(crate) struct SavedModel<M: Model> {
    pub(crate) origin: Arc<Origin>,
    pub(crate) state: M::State,
}

/// Stands before a serialized state: who wrote it.
#[derive(Debug, PartialEq, Serialize, Deserialize)]
struct Header<'a> {
    identifier: &'a str,
    version: &'a str,
    guid: Guid,
}

impl<'a> Header<'a> {
    fn of<M: Model>(guid: Guid) -> Self {
        Self { identifier: M::IDENTITY.identifier, version: env!("CARGO_PKG_VERSION"), guid }
    }
}

impl<M: Model> SavedState<M> {
    /// Number of bytes that [`to_bytes`](Self::to_bytes) gives.
    pub fn serialized_size(&self) -> usize {
        let size = postcard::ser_flavors::Size::default();
        postcard::serialize_with_flavor(&(Header::of::<M>(self.guid), self), size)
            .expect("a state is plain data, which can always be serialized")
    }

    /// The state as bytes.
    pub fn to_bytes(&self) -> Vec<u8> {
        postcard::to_allocvec(&(Header::of::<M>(self.guid), self))
            .expect("a state is plain data, which can always be serialized")
    }

    /// Lets all texts that name files in the FMU's resources name them where these are now: another
    /// program, or the same one at another time, unpacks the FMU elsewhere.
    pub(crate) fn move_resources(&mut self, now: &Arc<str>) {
        let before = std::mem::replace(&mut self.resources, Arc::clone(now));
        if before == *now || before.is_empty() {
            return;
        }
        // Nobody else has the origin yet of a state that was just read.
        let origin = self.model.as_mut().and_then(|model| Arc::get_mut(&mut model.origin));
        let values = [&mut self.values].into_iter().chain(origin.map(|origin| &mut origin.values));
        for text in values.flat_map(|values| &mut values.texts) {
            let inside = text.strip_prefix(&*before).filter(|rest| rest.starts_with(['/', '\\']));
            if let Some(inside) = inside {
                *text = format!("{now}{inside}");
            }
        }
    }

    /// Reads a state of the interface `guid`.
    pub(crate) fn from_bytes(bytes: &[u8], guid: Guid) -> Result<Self, Error> {
        let damaged = |error: postcard::Error| Error::DamagedState(error.to_string());
        let (header, rest) = postcard::take_from_bytes::<Header>(bytes).map_err(damaged)?;
        if header != Header::of::<M>(guid) {
            let Header { identifier, version, guid } = header;
            let writer = format!("{identifier} {version} {guid}");
            return Err(Error::ForeignState(writer));
        }
        postcard::from_bytes(rest).map_err(damaged)
    }
}
