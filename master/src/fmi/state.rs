//! The saved state of an instance.

use super::binding::FmuState;

/// The state of an instance before a step.
#[derive(Default)]
pub(super) struct StateSlot(pub(super) Option<FmuState>);
