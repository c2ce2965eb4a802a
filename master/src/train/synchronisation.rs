//! The scenario's gains as the controllers of the vehicles take them.

use controller::Gains;

use crate::scenario::Synchronisation;

impl From<&Synchronisation> for Gains {
    fn from(file: &Synchronisation) -> Self {
        Self {
            proportional: file.kp_kn_per_m * 1e3,
            integral: file.ki_kn_per_m_s * 1e3,
            derivative: file.kd_kn_s_per_m * 1e3,
            limit: file.limit_kn * 1e3,
        }
    }
}
