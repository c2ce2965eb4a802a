//! The FMU's variables, and its outputs.

use fmu::{Declaration, Real, unit};

use super::parameters::ParameterSignals;
use super::parameters_energy::EnergyParameterSignals;
use super::parameters_site::SiteSignals;
use super::shape::Shape;
use super::signals_energy::EnergyOutputSignals;
use super::signals_inputs::{WeatherSignals, WheelSignals};

/// Handles of all variables.
#[derive(Debug)]
pub struct Signals {
    pub(crate) shape: Shape,
    pub(crate) parameters: ParameterSignals,
    pub(crate) wheels: Vec<WheelSignals>,
    pub(crate) parameters_energy: EnergyParameterSignals,
    pub(crate) site: SiteSignals,
    pub(crate) weather: WeatherSignals,
    pub(crate) outputs: OutputSignals,
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
