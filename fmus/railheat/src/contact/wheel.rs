//! What a wheel does.

use super::creep_force::Contact;

/// What a wheel does during a step.
#[derive(Clone, Copy, Debug, PartialEq)]
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
    /// Highest flash temperature by that of the same power spread over the contact as the pressure: 1
    /// where all of it slips, more where a part sticks.
    pub flash_factor: f64,
    /// Lateral position of the contact on the head, from its middle to the field side, m.
    pub lateral_position: f64,
    /// Heat of the tread brake into the wheel, W.
    pub brake_power: f64,
}

/// A wheel that does nothing; where it slips at all, it slips everywhere.
impl Default for Wheel {
    fn default() -> Self {
        Self {
            position: 0.0,
            speed: 0.0,
            creepage: 0.0,
            contact: Contact::default(),
            friction_power: 0.0,
            flash_factor: 1.0,
            lateral_position: 0.0,
            brake_power: 0.0,
        }
    }
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
