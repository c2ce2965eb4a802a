//! The FMU's inputs and outputs.

use fmu::{Declaration, Real, Values, unit};

use crate::creep_force::Contact;
use crate::energy::sun::Sun;
use crate::energy::weather::Weather;
use crate::file::Shape;
use crate::parameters::ParameterSignals;
use crate::parameters_energy::EnergyParameterSignals;
use crate::parameters_site::SiteSignals;
use crate::signals_energy::EnergyOutputSignals;
use crate::wheels::Wheel;

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) shape: Shape,
    pub(crate) parameters: ParameterSignals,
    pub(crate) wheels: Vec<WheelSignals>,
    pub(crate) parameters_energy: EnergyParameterSignals,
    pub(crate) site: SiteSignals,
    weather: WeatherSignals,
    pub(crate) outputs: OutputSignals,
}

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

/// Handles of the highest rise at one depth.
#[derive(Debug)]
pub(crate) struct HighestSignals {
    pub(crate) rise: Real,
    pub(crate) chainage: Real,
}

/// Handles of one probe.
#[derive(Debug)]
pub(crate) struct ProbeSignals {
    /// Surface, the depths of the file, foot.
    pub(crate) rises: Vec<Real>,
    pub(crate) heat: Real,
}

/// Handles of the outputs.
#[derive(Debug)]
pub(crate) struct OutputSignals {
    /// Surface, the depths of the file, foot.
    pub(crate) highest: Vec<HighestSignals>,
    pub(crate) highest_flash: Real,
    pub(crate) untouched: Real,
    pub(crate) probes: Vec<ProbeSignals>,
    pub(crate) stored: Real,
    pub(crate) imposed: Real,
    pub(crate) weather: Real,
    pub(crate) energy: EnergyOutputSignals,
}

impl Signals {
    pub(crate) fn declare(shape: Shape, declaration: &mut Declaration) -> Self {
        let wheels = shape
            .wheelsets
            .iter()
            .enumerate()
            .flat_map(|(vehicle, wheelsets)| (0..*wheelsets).map(move |j| (vehicle + 1, j + 1)))
            .map(|(i, j)| WheelSignals::declare(format!("vehicle[{i}].wheelset[{j}]"), declaration))
            .collect();
        let weather = WeatherSignals::declare(declaration);
        Self {
            parameters: ParameterSignals::declare(declaration),
            parameters_energy: EnergyParameterSignals::declare(declaration),
            site: SiteSignals::declare(declaration),
            outputs: OutputSignals::declare(&shape, declaration),
            wheels,
            weather,
            shape,
        }
    }

    pub(crate) fn weather(&self, values: &Values) -> Weather {
        let WeatherSignals { ambient, irradiance, diffuse, wind, elevation, azimuth } =
            self.weather;
        Weather {
            ambient: values[ambient],
            wind: values[wind],
            direct: values[irradiance],
            diffuse: values[diffuse],
            sun: Sun { elevation: values[elevation], azimuth: values[azimuth] },
        }
    }
}

/// Handles of the inputs of the weather.
#[derive(Clone, Copy, Debug)]
struct WeatherSignals {
    ambient: Real,
    irradiance: Real,
    diffuse: Real,
    wind: Real,
    elevation: Real,
    azimuth: Real,
}

impl WeatherSignals {
    fn declare(declaration: &mut Declaration) -> Self {
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
}

impl WheelSignals {
    fn declare(name: String, declaration: &mut Declaration) -> Self {
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

impl OutputSignals {
    fn declare(shape: &Shape, declaration: &mut Declaration) -> Self {
        let levels = levels(shape);
        let highest = levels
            .iter()
            .map(|(name, place)| HighestSignals {
                rise: declaration
                    .real(
                        format!("highest.{name}.rise"),
                        unit::KELVIN,
                        format!("Highest temperature rise along the track {place}"),
                    )
                    .output(),
                chainage: declaration
                    .real(
                        format!("highest.{name}.chainage"),
                        unit::METRE,
                        format!("Chainage of the highest temperature rise {place}"),
                    )
                    .output(),
            })
            .collect();
        let probes = (1..=shape.probes.len())
            .map(|p| ProbeSignals::declare(p, shape.probes[p - 1], &levels, declaration))
            .collect();
        let energy = EnergyOutputSignals::declare(shape, declaration);
        let mut output = |name: &str, unit, description: &str| {
            declaration.real(name, unit, description).output()
        };
        Self {
            energy,
            highest,
            probes,
            highest_flash: output(
                "highest.flash.rise",
                unit::KELVIN,
                "Highest flash temperature rise of any wheel in the last step",
            ),
            untouched: output(
                "untouched.surface.rise",
                unit::KELVIN,
                "Temperature rise of the surface where no wheel has been",
            ),
            stored: output(
                "energy.stored",
                unit::JOULE,
                "Heat in the modelled rail above the initial state",
            ),
            imposed: output(
                "energy.imposed",
                unit::JOULE,
                "Heat since the start by surface temperatures that wheels imposed; zero in model energy",
            ),
            weather: output(
                "energy.weather",
                unit::JOULE,
                "Heat since the start from the weather, positive into the rail",
            ),
        }
    }
}

impl ProbeSignals {
    fn declare(
        probe: usize,
        chainage: f64,
        levels: &[(String, String)],
        declaration: &mut Declaration,
    ) -> Self {
        let rises = levels
            .iter()
            .map(|(name, place)| {
                let description = format!("Temperature rise at chainage {chainage} m {place}");
                declaration
                    .real(format!("probe[{probe}].{name}.rise"), unit::KELVIN, description)
                    .output()
            })
            .collect();
        let description = format!("Heat above the initial state at chainage {chainage} m");
        let heat = declaration
            .real(format!("probe[{probe}].heat"), unit::JOULE_PER_METRE, description)
            .output();
        Self { rises, heat }
    }
}

/// Name and place in words of each depth that is read: surface, the depths of the file, foot.
fn levels(shape: &Shape) -> Vec<(String, String)> {
    let depths = shape.depths.iter().enumerate().map(|(k, depth)| {
        let millimetres = depth * 1000.0;
        (format!("depth[{}]", k + 1), format!("{millimetres} mm below the running surface"))
    });
    std::iter::once(("surface".to_owned(), "at the surface".to_owned()))
        .chain(depths)
        .chain([("foot".to_owned(), "at the foot".to_owned())])
        .collect()
}
