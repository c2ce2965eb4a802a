//! Whether vehicles stand on both rails where a train starts.
//!
//! ```text
//! a = v² κ - g φ,    a vehicle tips over at |a| = g b/h
//! ```
//!
//! with the speed v, the curvature κ and the cant angle φ under the vehicle's middle, half the distance b of the
//! contacts, and the height h of its centre of mass: the balance of moments about the outer rail. A body
//! that leans on its springs tips over earlier, so that what is refused here has no balance.

use std::path::Path;

use files::{Check, Mistake};
use numerics::constants::{RAIL_LATERAL_POSITION, STANDARD_GRAVITY};
use stock::{Library, Multibody};
use track::{TrackFile, TrackPoint};

/// Key of the scenario with the speed at the start.
const SPEED: &str = "train.speed_m_per_s";

/// Where and how fast a train starts.
#[derive(Clone, Copy, Debug)]
pub struct Start {
    /// Chainage of the middle of the leading vehicle, m.
    pub position: f64,
    /// Speed, m/s.
    pub speed: f64,
}

impl Start {
    /// Refuses a speed at which a vehicle would tip over where it starts.
    ///
    /// `vehicles` are the files of its types with their numbers, from the head; `check` answers for the scenario.
    ///
    /// # Errors
    /// When a vehicle would tip over, or a file cannot be read.
    pub fn check(
        &self,
        vehicles: &[(&Path, usize)],
        stock: &Path,
        track: &Path,
        check: &Check,
    ) -> Result<(), Mistake> {
        let (library, track) = (Library::open(stock)?, TrackFile::read(track)?.track()?);
        let (mut number, mut front) = (0, None);
        for (file, count) in vehicles {
            let vehicle = library.vehicle_from_file(file)?;
            let limit = vehicle.multibody.as_ref().map(tipping);
            for _ in 0..*count {
                number += 1;
                let middle = front.map_or(self.position, |front| front - 0.5 * vehicle.length_m);
                front = Some(middle - 0.5 * vehicle.length_m);
                let under = track.at(middle, &mut 0);
                let left = unbalanced(self.speed, &under);
                let Some(limit) = limit.filter(|limit| left.abs() > *limit) else { continue };
                let wanted = format!(
                    "too fast where vehicle {number} ({}) starts, at chainage {middle:.1} m in a curve of R {:.0} m: \
                     cant leaves a lateral acceleration of {:.2} m/s², and it tips over at {limit:.2} m/s², \
                     which is {:.1} m/s there; lower the speed, or start on gentler track \
                     (train.leading_vehicle_position_m, or radius and cant in the track file)",
                    vehicle.name,
                    under.curvature.recip().abs(),
                    left.abs(),
                    highest_speed(limit, &under),
                );
                return Err(check.error(SPEED, self.speed, wanted));
            }
        }
        Ok(())
    }
}

/// Lateral acceleration that the cant does not balance, to the left in a right-hand curve that is fast, m/s².
fn unbalanced(speed: f64, under: &TrackPoint) -> f64 {
    speed * speed * under.curvature - STANDARD_GRAVITY * under.cant_angle
}

/// The speed at which the lateral acceleration that is left comes to a limit in m/s², m/s.
fn highest_speed(limit: f64, under: &TrackPoint) -> f64 {
    let cant = STANDARD_GRAVITY * under.cant_angle * under.curvature.signum();
    ((limit + cant) / under.curvature.abs()).max(0.0).sqrt()
}

/// Lateral acceleration at which a rigid vehicle tips over, m/s².
fn tipping(vehicle: &Multibody) -> f64 {
    let bodies = vehicle.body.iter().map(|body| (body.mass_kg, body.height_m));
    let wheelsets = vehicle.wheelset.iter().map(|set| (set.mass_kg, set.wheel_radius_m));
    let (mut mass, mut moment) = (0.0, 0.0);
    for (of_one, height) in bodies.chain(wheelsets) {
        mass += of_one;
        moment += of_one * height;
    }
    STANDARD_GRAVITY * RAIL_LATERAL_POSITION * mass / moment
}

#[cfg(test)]
mod tests {
    use super::*;

    /// On R 300 m with a cant angle of 0.05: 20 m/s are 1.333 - 0.490 m/s², to the other side too.
    #[test]
    fn analytic_what_the_cant_leaves() {
        let right =
            TrackPoint { curvature: 1.0 / 300.0, cant_angle: 0.05, ..TrackPoint::default() };
        let left = TrackPoint { curvature: -right.curvature, cant_angle: -0.05, ..right };
        let expected = 400.0 / 300.0 - 0.05 * STANDARD_GRAVITY;
        for (under, sign) in [(right, 1.0), (left, -1.0)] {
            assert!((unbalanced(20.0, &under) - sign * expected).abs() < 1e-12);
            assert!((highest_speed(expected, &under) - 20.0).abs() < 1e-12);
        }
    }
}
