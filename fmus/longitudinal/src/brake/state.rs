//! What changes in the brakes of a vehicle.

use serde::{Deserialize, Serialize};

use crate::brake::ecp::EcpState;

/// What changes in the brakes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct BrakeState {
    /// Cylinder pressure as a fraction of that at full service.
    pub cylinder: f64,
    /// Cylinder pressure of the locomotive brake as a fraction of its greatest.
    pub locomotive_cylinder: f64,
    /// State of the cable's valve.
    pub ecp: EcpState,
    /// Command whose change of pressure has arrived along the pipe.
    pub pressure_command: f64,
    /// Number of changes of that command that have arrived.
    pub arrivals: u64,
    /// Air that the reservoir has given and not got back, as a share of that of a full service.
    pub spent: f64,
    /// What the pipe has lost by leakage since the last change of its command, as such a share.
    pub leaked: f64,
    /// Whether the cylinder empties, as it does without graduated release until it is empty.
    pub releasing: bool,
}

impl BrakeState {
    /// Brakes that have followed the commands for long.
    pub fn settled(train_brake: f64, locomotive_brake: f64) -> Self {
        Self {
            cylinder: train_brake,
            locomotive_cylinder: locomotive_brake,
            ecp: EcpState::settled(train_brake),
            pressure_command: train_brake,
            spent: train_brake,
            ..Self::default()
        }
    }
}
