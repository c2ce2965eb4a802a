//! The part of the track whose rail is modelled.

use super::file::Scenario;
use super::heat::Heat;

/// Part of the track whose rail is modelled, m.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Extent {
    /// Chainage at which it begins.
    pub begin: f64,
    /// Its length.
    pub length: f64,
}

/// Longest vehicle that is thought of where the scenario leaves the extent of the rail open, m.
const LONGEST_VEHICLE: f64 = 30.0;
/// Largest mean acceleration that is thought of there, m/s².
const LARGEST_ACCELERATION: f64 = 0.1;

impl Extent {
    /// What the scenario says, or from behind the tail to as far as the train may come.
    pub fn of(scenario: &Scenario, heat: &Heat) -> Self {
        let train = &scenario.train;
        let head = train.leading_vehicle_position_m;
        let behind = scenario.vehicle_count() as f64 * LONGEST_VEHICLE;
        let duration = scenario.duration_s;
        let ahead = LONGEST_VEHICLE
            + train.speed_m_per_s * duration
            + LARGEST_ACCELERATION * duration * duration / 2.0;
        let begin = heat.begin_m.unwrap_or(head - behind);
        let length = heat.length_m.unwrap_or_else(|| (head + ahead - begin).ceil());
        Self { begin, length }
    }
}
