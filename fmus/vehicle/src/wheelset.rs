//! A wheelset's step: its six velocities with the contact forces taken at the end of the step.
//!
//! Creep at low speed is far too stiff for an explicit step (rate 2 f r²/(I v): 1e4/s and more).
//! The forces are f + df, with df = -D J dv linear in the change of the six velocities, D being the
//! secants of the creep law (never negative) and the normal damping, J the rows of the wheels.
//! Then (M + h Jᵀ D J) dv = h (F + Jᵀ f) (eq. 25), a definite system of six.

use contact::{Creepages, Polach};
use nalgebra::Vector3;

use crate::body::{BodyState, RigidBody, Wrench};
use crate::drive::{Drive, DriveStep};
use crate::energy::Account;
use crate::frame::Frame;
use crate::rail::RailMotion;
use crate::six::{self, Six, SixBySix, add, add_outer, dot};
use crate::structure::WheelsetData;
use crate::wheel::{Linearised, Side, Wheel};

/// What a wheel does to its rail, and feels, at the end of a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct WheelOutput {
    /// Creepages; longitudinal positive in traction, lateral and spin of the wheel on the rail.
    pub creepages: Creepages,
    /// Creep force on the wheel along the track, N, positive when it drives the vehicle forward.
    pub longitudinal: f64,
    /// Creep force on the wheel across, in the contact plane, N, positive to the right.
    pub lateral: f64,
    /// Normal force, N.
    pub normal: f64,
    /// Lateral force on the wheel in the plane of the rails, N, positive to the right.
    pub guiding: f64,
    /// Force of the rail on the wheel upwards, square to the plane of the rails, N.
    pub vertical: f64,
    /// Power turned into heat, W.
    pub friction_power: f64,
    /// Semi-axis of the contact in the rolling direction, m.
    pub a: f64,
    /// Semi-axis across, m.
    pub b: f64,
    /// Place on the rail head, m from its top, negative towards the gauge side.
    pub rail_lateral: f64,
    /// Elastic energy of the contact, J.
    pub elastic_energy: f64,
    /// Whether the wheel has left the profiles.
    pub derailed: bool,
}

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
    pub creep: &'a Polach,
    /// Force and moment of suspension, weight, frame and drive.
    pub wrench: Wrench,
    /// Drive and brake.
    pub drive: Drive,
    /// Length of the step, s.
    pub step: f64,
}

impl WheelsetStep<'_> {
    /// Changes the velocities of `state`; gives the outputs of both wheels and the torque with
    /// which the brake holds the wheelset.
    pub fn run(&self, state: &mut BodyState, account: &mut Account) -> ([WheelOutput; 2], f64) {
        let wheel = |side, rail: &RailMotion| {
            Wheel::new(side, &self.data.wheel, &self.data.table, &rail.seen_from(state))
        };
        let wheels = [wheel(Side::Left, &self.rails[0]), wheel(Side::Right, &self.rails[1])];
        let before = six::join(&state.velocity, &state.angular_velocity);
        let carrier = self.frame_velocities(state);
        let against = difference(&before, &carrier);
        let speed = state.velocity.x;
        let contacts = [0, 1].map(|i| {
            let against = self.rails[i].against(&against);
            wheels[i].forces(&self.data.wheel, self.creep, &against, speed)
        });

        let drive = self.drive.linearised(before[4]);
        let change = self.solve(&wheels, &contacts, &drive);

        let after: Six = std::array::from_fn(|i| before[i] + change[i]);
        (state.velocity, state.angular_velocity) = six::split(&after);
        let end = difference(&after, &carrier);
        let mut output = |i: usize| {
            let motion = Motion { change, after: self.rails[i].against(&end), speed: after[0] };
            self.output(&wheels[i], &contacts[i], &motion, account)
        };
        let outputs = [output(0), output(1)];
        let brake = drive.brake_torque(change[4]);
        self.drive.account(brake, before[4] + 0.5 * change[4], self.step, account);
        (outputs, brake)
    }

    /// Velocities of a wheelset that only follows a twisted track.
    fn frame_velocities(&self, state: &BodyState) -> Six {
        let roll = self.frame.rotation.x * state.velocity.x;
        let below = state.position.z - self.body.height;
        [0.0, -roll * below, roll * state.position.y, roll, 0.0, 0.0]
    }

    /// Change of the six velocities (eq. 25).
    fn solve(&self, wheels: &[Wheel; 2], contacts: &[Linearised; 2], drive: &DriveStep) -> Six {
        let (mass, inertia) = (self.body.mass, &self.body.inertia);
        let diagonal = [mass, mass, mass, inertia.x, inertia.y, inertia.z];
        let mut matrix: SixBySix = [[0.0; 6]; 6];
        for i in 0..6 {
            matrix[i][i] = diagonal[i];
        }
        let mut right = six::join(&self.wrench.force, &self.wrench.moment);
        right[4] += drive.torque;
        matrix[4][4] += self.step * drive.damping;
        for (wheel, contact) in wheels.iter().zip(contacts) {
            let creep = self.step * contact.creep.damping;
            add_outer(&mut matrix, creep, &wheel.longitudinal);
            add_outer(&mut matrix, creep, &wheel.lateral);
            add_outer(&mut matrix, self.step * contact.normal_damping, &wheel.normal);
            add(&mut right, contact.creep.longitudinal, &wheel.longitudinal);
            add(&mut right, contact.creep.lateral, &wheel.lateral);
            add(&mut right, contact.creep.spin_moment, wheel.spin_row());
            add(&mut right, -contact.normal, &wheel.normal);
        }
        right.iter_mut().for_each(|value| *value *= self.step);
        six::solve(&mut matrix, &mut right);
        right
    }

    fn output(
        &self,
        wheel: &Wheel,
        contact: &Linearised,
        motion: &Motion,
        account: &mut Account,
    ) -> WheelOutput {
        let Motion { change, after, speed } = motion;
        let creep = &contact.creep;
        let longitudinal = creep.longitudinal - creep.damping * dot(&wheel.longitudinal, change);
        let lateral = creep.lateral - creep.damping * dot(&wheel.lateral, change);
        let approach = contact.normal_damping * dot(&wheel.normal, change);
        let normal = contact.normal + approach;

        let heat = |velocities: &Six| {
            let slip = wheel.slip(velocities);
            -longitudinal * slip.longitudinal
                - lateral * slip.lateral
                - creep.spin_moment * slip.spin
        };
        let middle: Six = std::array::from_fn(|i| after[i] - 0.5 * change[i]);
        account.friction_heat += self.step * heat(&middle);
        let damping_force = normal - wheel.elastic_force();
        if contact.normal > 0.0 {
            account.contact_heat += self.step * damping_force * dot(&wheel.normal, &middle);
        }

        let mut creepages = wheel.slip(after).creepages(*speed);
        creepages.longitudinal = -creepages.longitudinal;
        WheelOutput {
            creepages,
            longitudinal,
            lateral,
            normal,
            guiding: wheel.across(lateral, normal),
            vertical: wheel.upwards(lateral, normal),
            friction_power: heat(after),
            a: contact.a,
            b: contact.b,
            rail_lateral: wheel.rail_lateral(),
            elastic_energy: wheel.elastic_energy(),
            derailed: wheel.derailed(),
        }
    }
}

/// How a wheelset moves in a step.
struct Motion {
    change: Six,
    /// Velocities at the end, against the track's frame.
    after: Six,
    /// Speed of travel at the end, m/s.
    speed: f64,
}

fn difference(a: &Six, b: &Six) -> Six {
    std::array::from_fn(|i| a[i] - b[i])
}

/// Angular velocity about y of a wheelset of `radius` that rolls at `speed`, rad/s.
pub fn rolling(speed: f64, radius: f64) -> Vector3<f64> {
    Vector3::new(0.0, -speed / radius, 0.0)
}
