//! The FMU's inputs: what each wheel does, and the weather.

use fmu::{Declaration, Real, Values, unit};

use crate::contact::{Contact, Wheel};
use crate::weather::{Sun, Weather};

/// Handles of the inputs of one wheel.
#[derive(Debug)]
pub(crate) struct WheelSignals {
    /// `vehicle[i].wheelset[j]`
    pub(crate) name: String,
    position: Real,
    speed: Real,
    creepage: Real,
    normal_force: Real,
    a: Real,
    b: Real,
    friction_power: Real,
    lateral_position: Real,
    brake_power: Real,
}

/// Handles of the inputs of the weather.
#[derive(Debug)]
pub(crate) struct WeatherSignals {
    ambient: Real,
    irradiance: Real,
    diffuse: Real,
    wind: Real,
    elevation: Real,
    azimuth: Real,
}

impl WeatherSignals {
    pub(crate) fn declare(declaration: &mut Declaration) -> Self {
        let mut not_negative = |name: &str, unit, description: &str, start: f64| {
            declaration.real(name, unit, description).min(0.0).input(start)
        };
        let ambient = not_negative(
            "ambient.temperature",
            unit::KELVIN,
            "Temperature of the air; in model paper of the sky too",
            298.15,
        );
        let irradiance = not_negative(
            "solar.irradiance",
            unit::WATT_PER_SQUARE_METRE,
            "Irradiance of a surface that faces the sun, before the filter; the start value is the \
             solar constant of the paper",
            1366.0,
        );
        let diffuse = not_negative(
            "solar.diffuse",
            unit::WATT_PER_SQUARE_METRE,
            "Diffuse irradiance of a horizontal surface; ignored by model paper",
            0.0,
        );
        let wind = not_negative(
            "wind.speed",
            unit::METRE_PER_SECOND,
            "Wind speed; ignored by model paper",
            0.0,
        );
        let mut angle = |name: &str, description: &str, start: f64| {
            declaration.real(name, unit::RADIAN, description).input(start)
        };
        let elevation = angle(
            "solar.elevation",
            "Elevation of the sun; ignored by model paper, whose sun stands straight above, as the \
             start value says",
            std::f64::consts::FRAC_PI_2,
        );
        let azimuth = angle(
            "solar.azimuth",
            "Azimuth of the sun from north over east; ignored by model paper",
            0.0,
        );
        Self { ambient, irradiance, diffuse, wind, elevation, azimuth }
    }

    pub(crate) fn read(&self, values: &Values) -> Weather {
        Weather {
            ambient: values[self.ambient],
            wind: values[self.wind],
            direct: values[self.irradiance],
            diffuse: values[self.diffuse],
            sun: Sun { elevation: values[self.elevation], azimuth: values[self.azimuth] },
        }
    }
}

impl WheelSignals {
    pub(crate) fn declare(name: String, declaration: &mut Declaration) -> Self {
        declaration.terminal(name.clone(), "wheel", "A wheel on the rail");
        let mut input = |signal: &str, unit, description: &str| {
            declaration.real(format!("{name}.{signal}"), unit, description).input(0.0)
        };
        let signals = Self {
            position: input("position", unit::METRE, "Chainage of the wheel"),
            speed: input("speed", unit::METRE_PER_SECOND, "Running speed of the wheel"),
            creepage: input(
                "creepage.longitudinal",
                unit::ONE,
                "Longitudinal creepage (wheel - rail) / speed, positive in traction",
            ),
            normal_force: input("force.normal", unit::NEWTON, "Normal force of the contact"),
            a: input("contact.a", unit::METRE, "Semi-axis of the contact along the rail"),
            b: input("contact.b", unit::METRE, "Semi-axis of the contact across the rail"),
            friction_power: input(
                "friction_power",
                unit::WATT,
                "Friction power of the contact, longitudinal, lateral and spin; used by model energy",
            ),
            lateral_position: input(
                "contact.lateral_position",
                unit::METRE,
                "Place of the contact on the rail head, to the right; used by model energy",
            ),
            brake_power: input(
                "brake_power",
                unit::WATT,
                "Tread brake heat into the wheel; used by model energy",
            ),
            name: String::new(),
        };
        Self { name, ..signals }
    }

    pub(crate) fn read(&self, values: &Values) -> Wheel {
        Wheel {
            position: values[self.position],
            speed: values[self.speed],
            creepage: values[self.creepage],
            contact: Contact {
                normal_force: values[self.normal_force],
                a: values[self.a],
                b: values[self.b],
            },
            friction_power: values[self.friction_power],
            lateral_position: values[self.lateral_position],
            brake_power: values[self.brake_power],
        }
    }
}
