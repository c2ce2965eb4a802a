//! A wheelset's step: its six velocities with the contact forces taken at the end of the step.
//!
//! Creep at low speed is far too stiff for an explicit step (rate 2 f r²/(I v): 1e4/s and more).
//! The forces are f + df, with df = -D J dv linear in the change of the six velocities, D being what
//! counts of the creep law's secants (`slip_mobility.rs`, never negative) and the normal damping, J
//! the rows of the contacts.
//! Then (M + h Jᵀ D J) dv = h (F + Jᵀ f) (eq. 25), a definite system of six.

use contact::CreepLaw;
use nalgebra::Vector3;

use crate::body::Frame;
use crate::body::{BodyState, RigidBody, Wrench};
use crate::contact::WheelMotion;
use crate::contact::WheelOutput;
use crate::contact::six::{self, Six, SixBySix};
use crate::contact::{Side, Wheel};
use crate::dynamics::drive::{Drive, DriveStep};
use crate::energy::Account;
use crate::structure::WheelsetData;
use crate::track::RailMotion;

/// A wheelset in its frame with what acts on it besides the rails.
pub struct WheelsetStep<'a> {
    /// The wheelset.
    pub data: &'a WheelsetData,
    /// Its body.
    pub body: &'a RigidBody,
    /// Track at its chainage.
    pub frame: &'a Frame,
    /// Left and right rail.
    pub rails: [RailMotion; 2],
    /// Creep law with the friction of now.
    pub creep: &'a CreepLaw,
    /// Force and moment of suspension, weight, frame and drive.
    pub wrench: Wrench,
    /// Drive and brake.
    pub drive: Drive,
    /// Length of the step, s.
    pub step: f64,
}

impl WheelsetStep<'_> {
    /// Changes the velocities of `state` and the outputs of both wheels; gives the brake's torque, N m.
    pub fn run(
        &self,
        state: &mut BodyState,
        outputs: &mut [WheelOutput; 2],
        account: &mut Account,
    ) -> f64 {
        let before = six::join(&state.velocity, &state.angular_velocity);
        let carrier = self.frame_velocities(state);
        let against = difference(&before, &carrier);
        let mut wheels = [Wheel::default(), Wheel::default()];
        let sides = Side::BOTH.into_iter().zip(&self.rails).zip(&self.data.tables);
        for (wheel, ((side, rail), table)) in wheels.iter_mut().zip(sides) {
            let motion = WheelMotion {
                side,
                data: &self.data.wheel,
                state: &rail.seen_from(state),
                velocities: &rail.against(&against),
                speed: state.velocity.x,
                turning: self.frame.rotation.z,
            };
            wheel.touch(table, &motion, self.creep);
            for patch in wheel.patches_mut() {
                self.data.slip_mobility.reduce(&mut patch.forces.creep, self.step);
            }
        }

        let drive = self.drive.linearised(before[4]);
        let change = self.solve(&wheels, &drive);

        let after: Six = std::array::from_fn(|i| before[i] + change[i]);
        (state.velocity, state.angular_velocity) = six::split(&after);
        for (output, wheel) in outputs.iter_mut().zip(&wheels) {
            let heat = output.update(wheel, &change, after[0]);
            account.friction_heat += self.step * heat.friction;
            account.contact_heat += self.step * heat.damping;
        }
        let brake = drive.brake_torque(change[4]);
        self.drive.account(brake, before[4] + 0.5 * change[4], self.step, account);
        brake
    }

    /// Velocities of a wheelset that only follows a twisted track.
    fn frame_velocities(&self, state: &BodyState) -> Six {
        let roll = self.frame.rotation.x * state.velocity.x;
        let below = state.position.z - self.body.height;
        [0.0, -roll * below, roll * state.position.y, roll, 0.0, 0.0]
    }

    /// Change of the six velocities (eq. 25).
    fn solve(&self, wheels: &[Wheel; 2], drive: &DriveStep) -> Six {
        let (mass, inertia) = (self.body.mass, &self.body.inertia);
        let diagonal = [mass, mass, mass, inertia.x, inertia.y, inertia.z];
        let mut matrix: SixBySix = [[0.0; 6]; 6];
        for i in 0..6 {
            matrix[i][i] = diagonal[i];
        }
        let mut right = six::join(&self.wrench.force, &self.wrench.moment);
        right[4] += drive.torque;
        matrix[4][4] += self.step * drive.damping;
        for patch in wheels.iter().flat_map(Wheel::patches) {
            patch.rows.add(&patch.forces, self.step, &mut matrix, &mut right);
        }
        right.iter_mut().for_each(|value| *value *= self.step);
        six::solve(&mut matrix, &mut right);
        right
    }
}

fn difference(a: &Six, b: &Six) -> Six {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Angular velocity about y of a wheelset of `radius` that rolls at `speed`, rad/s.
pub fn rolling(speed: f64, radius: f64) -> Vector3<f64> {
    Vector3::new(0.0, -speed / radius, 0.0)
}
