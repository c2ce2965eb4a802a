//! What a wheel does.

use super::creep_force::Contact;

/// What a wheel does during a step.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Wheel {
    /// Chainage at the end of the step, m.
    pub position: f64,
    /// Running speed, m/s.
    pub speed: f64,
    /// Longitudinal creepage (wheel - rail) / speed.
    pub creepage: f64,
    /// Contact with the rail.
    pub contact: Contact,
    /// Friction power of the contact, W.
    pub friction_power: f64,
    /// Lateral position of the contact on the head, from its middle to the field side, m.
    pub lateral_position: f64,
    /// Heat of the tread brake into the wheel, W.
    pub brake_power: f64,
}

impl Wheel {
    /// Whether the wheel neither runs nor carries, so that there is none now.
    ///
    /// So it is before the train has come and between two trains. A wheel that is there again comes with its speed, and has the
    /// temperature that wheels have at the start.
    pub fn is_absent(&self) -> bool {
        self.speed == 0.0 && self.contact.normal_force == 0.0
    }

    /// Where the wheel is for the next step, if it is there, m.
    pub fn present_position(&self) -> Option<f64> {
        (!self.is_absent()).then_some(self.position)
    }
}
