//! The inputs: what each wheel does, and the weather.

use std::f64::consts::FRAC_PI_2;

use fmu::ModelError;

use crate::contact::{Contact, Wheel};
use crate::weather::{Sun, Weather};

fmu::variables! {
    /// What a wheel does.
    #[derive(Copy)]
    pub(crate) struct WheelInputs: input {
        /// Chainage of the wheel
        position: "position", METRE = 0.0;
        /// Running speed of the wheel
        speed: "speed", METRE_PER_SECOND = 0.0;
        /// Longitudinal creepage (wheel - rail) / speed, positive in traction
        creepage: "creepage.longitudinal", ONE = 0.0;
        /// Normal force of the contact
        normal_force: "force.normal", NEWTON = 0.0;
        /// Semi-axis of the contact along the rail
        a: "contact.a", METRE = 0.0;
        /// Semi-axis of the contact across the rail
        b: "contact.b", METRE = 0.0;
        /// Highest flash temperature by that of the same friction power spread as the pressure; used by
        /// model energy
        flash_factor: "contact.flash_factor", ONE = 1.0;
        /// Friction power of the contact, longitudinal, lateral and spin; used by model energy
        friction_power: "friction_power", WATT = 0.0;
        /// Place of the contact on the rail head, to the field side; used by model energy
        lateral_position: "contact.lateral_position", METRE = 0.0;
        /// Tread brake heat into the wheel; used by model energy
        brake_power: "brake_power", WATT = 0.0;
    }

    /// The weather, in the bounds that a weather file has too.
    ///
    /// The start values are a calm night under clouds as warm as the air, in which nothing but the wheels
    /// heats or cools a rail that starts at the temperature of the air.
    #[derive(Copy)]
    pub(crate) struct WeatherInputs: input {
        /// Temperature of the air; in model paper of the sky too
        ambient: "ambient.temperature", KELVIN = 298.15, 183.15..=338.15;
        /// Irradiance of a surface that faces the sun, before the filter
        irradiance: "solar.irradiance", WATT_PER_SQUARE_METRE = 0.0, 0.0..=1500.0;
        /// Diffuse irradiance of a horizontal surface; ignored by model paper
        diffuse: "solar.diffuse", WATT_PER_SQUARE_METRE = 0.0, 0.0..=1000.0;
        /// Wind speed; ignored by model paper
        wind: "wind.speed", METRE_PER_SECOND = 0.0, 0.0..=115.0;
        /// Elevation of the sun; ignored by model paper, whose sun stands straight above, as the
        /// start value says
        elevation: "solar.elevation", RADIAN = FRAC_PI_2;
        /// Azimuth of the sun from north over east; ignored by model paper
        azimuth: "solar.azimuth", RADIAN = 0.0;
    }
}

impl WheelInputs {
    /// The wheel of this name; a loaded one must have a contact.
    pub(crate) fn wheel(self, name: &str) -> Result<Wheel, ModelError> {
        let Self { normal_force, a, b, .. } = self;
        if normal_force > 0.0 && !(a > 0.0 && b > 0.0) {
            return Err(ModelError::new(format!(
                "{name}: contact.a = {a} m, contact.b = {b} m: must be greater than zero while the \
                 normal force is ({normal_force} N)"
            )));
        }
        Ok(Wheel {
            position: self.position,
            speed: self.speed,
            creepage: self.creepage,
            contact: Contact { normal_force, a, b },
            friction_power: self.friction_power,
            flash_factor: self.flash_factor,
            lateral_position: self.lateral_position,
            brake_power: self.brake_power,
        })
    }
}

impl From<WeatherInputs> for Weather {
    fn from(inputs: WeatherInputs) -> Self {
        let WeatherInputs { ambient, irradiance, diffuse, wind, elevation, azimuth } = inputs;
        let sun = Sun { elevation, azimuth };
        Self { ambient, wind, direct: irradiance, diffuse, sky: None, sun }
    }
}
