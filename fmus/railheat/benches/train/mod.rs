//! The train that benches and the foot study share: 130 six-axle vehicles at 60 km/h.

use railheat::contact::{Contact, Wheel};

/// Vehicles of the train.
pub const VEHICLES: usize = 130;

/// 60 km/h.
pub const SPEED: f64 = 16.67;

/// Places of a vehicle's wheels before its middle, m.
const OFFSETS: [f64; 6] = [7.2, 5.4, 3.6, -3.6, -5.4, -7.2];

/// All wheels on one rail, with the leading wheel at a chainage; `more` fills in what each does, by the
/// number of its vehicle.
pub fn wheels(leading: f64, more: impl Fn(usize, Wheel) -> Wheel) -> Vec<Wheel> {
    let wheel = |index: usize| {
        let (vehicle, wheel) = (index / OFFSETS.len(), index % OFFSETS.len());
        let wheel = Wheel {
            position: leading - 20.0 * vehicle as f64 + OFFSETS[wheel] - OFFSETS[0],
            speed: SPEED,
            contact: Contact { normal_force: 109_500.0, a: 0.0063, b: 0.0063 },
            ..Wheel::default()
        };
        more(vehicle, wheel)
    };
    (0..OFFSETS.len() * VEHICLES).map(wheel).collect()
}
