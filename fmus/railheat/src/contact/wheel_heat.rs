//! Heat of friction, and the temperature of each wheel.
//!
//! ```text
//! m c T_w' = (1-ε) P + B - h A (T_w - T_a) - G (T_w - T_r)
//! ```
//!
//! (`docs/theory/railheat/energy.md#eq-18`) with the friction power P, of which the rail gets ε P,
//! the tread brake's heat B, the cooling h A to the air and the conductance G of the contact
//! (`chill.rs`). T_r is the crown's temperature when the conduction was computed last.

use super::chill;
use super::creep_force::Contact;
use super::flash::flash_rise;
use super::material::Material;
use super::wheel::Wheel;

/// What all wheels have in common.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WheelHeat {
    /// Share ε of the friction heat that flows into the rail.
    pub partition: f64,
    /// Heat capacity of a wheel m c, J/K.
    pub capacity: f64,
    /// Cooling of a wheel to the air h A, W/K.
    pub cooling: f64,
    /// Temperature of the wheels above the air at the start, K.
    pub initial_rise: f64,
    /// Share of the perfect contact's conductance, from 0 (no conduction) to 1.
    pub contact_quality: f64,
}

impl WheelHeat {
    /// A wheel of about 350 kg as warm as the air, on a perfect contact of equal steels.
    pub const TYPICAL: Self = Self {
        partition: 0.5,
        capacity: 160e3,
        cooling: 40.0,
        initial_rise: 0.0,
        contact_quality: 1.0,
    };

    /// Conductance of a wheel's contact, W/K.
    pub fn conductance(&self, wheel: &Wheel, material: &Material) -> f64 {
        let Contact { normal_force, a, b } = wheel.contact;
        if normal_force <= 0.0 {
            return 0.0;
        }
        self.contact_quality * chill::conductance(material.penetration(), a, b, wheel.speed)
    }

    /// Highest flash temperature rise of the rail under a wheel, K.
    pub fn flash(&self, wheel: &Wheel, material: &Material) -> f64 {
        if wheel.contact.normal_force <= 0.0 || wheel.speed == 0.0 {
            return 0.0;
        }
        let force = wheel.friction_power / wheel.speed.abs();
        wheel.flash_factor
            * flash_rise(&wheel.contact, force, 1.0, wheel.speed, self.partition, material)
    }

    /// Heat in J that a wheel at `temperature` gets over a time, but for the rail's conduction.
    pub fn gain(&self, wheel: &Wheel, temperature: f64, ambient: f64, time: f64) -> f64 {
        let friction = (1.0 - self.partition) * wheel.friction_power;
        let cooling = self.cooling * (temperature - ambient);
        time * (friction + wheel.brake_power - cooling)
    }
}
