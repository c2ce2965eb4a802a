//! The FMU's outputs that `model = "energy"` writes; they stay zero in `model = "paper"`.

use fmu::{Declaration, Real, Values, unit};

use super::shape::Shape;
use crate::contact::{MEAN_OVER_PEAK, Wheel};
use crate::energy::{EnergyModel, Finding, Sources};
use crate::heat_model::HeatModel;

/// Value of a time or place that there is not yet.
const NOT_YET: f64 = -1.0;

/// Handles of the outputs.
#[derive(Debug)]
pub(crate) struct EnergyOutputSignals {
    sources: SourceSignals,
    error: Real,
    present: FindingSignals,
    highest: FindingSignals,
    detected: FindingSignals,
    from_train: FindingSignals,
    highest_from_train: FindingSignals,
    mean_flash: Real,
    hottest_wheel: Real,
    probes: Vec<ProbeSignals>,
}

/// Handles of heat by source.
#[derive(Debug)]
struct SourceSignals {
    friction: Real,
    chill: Real,
    bending: Real,
    /// Declared elsewhere for the whole rail.
    weather: Option<Real>,
}

/// Handles of a rise of the foot with place and time.
#[derive(Debug)]
struct FindingSignals {
    rise: Real,
    chainage: Real,
    time: Real,
}

#[derive(Debug)]
struct ProbeSignals {
    sources: SourceSignals,
    thermoelastic: Real,
}

impl EnergyOutputSignals {
    pub(crate) fn declare(shape: &Shape, declaration: &mut Declaration) -> Self {
        let probes = (1..=shape.probes.len())
            .map(|p| {
                let prefix = format!("probe[{p}].heat");
                ProbeSignals {
                    sources: SourceSignals::per_metre(&prefix, declaration),
                    thermoelastic: declaration
                        .real(
                            format!("probe[{p}].foot.thermoelastic"),
                            unit::KELVIN,
                            "Reversible temperature change of the foot by bending under the wheels",
                        )
                        .output(),
                }
            })
            .collect();
        let sources = SourceSignals::of_rail(declaration);
        let finding = FindingSignals::declare;
        Self {
            probes,
            sources,
            present: finding("foot.present", "The foot's highest rise now", declaration),
            highest: finding("foot.highest", "The foot's highest rise so far", declaration),
            detected: finding(
                "foot.detection",
                "The foot's rise when it first reached detection.threshold (-1: not yet)",
                declaration,
            ),
            from_train: finding(
                "camera.train",
                "The foot's rise under the last wheel, as a camera on the train sees it",
                declaration,
            ),
            highest_from_train: finding(
                "camera.train.highest",
                "The highest rise of the foot that a camera on the train has seen",
                declaration,
            ),
            error: declaration
                .real("energy.error", unit::JOULE, "Heat that is stored but did not come in")
                .output(),
            mean_flash: declaration
                .real(
                    "highest.flash.mean",
                    unit::KELVIN,
                    "Mean over the contact of the highest flash temperature rise in the last step",
                )
                .output(),
            hottest_wheel: declaration
                .real("highest.wheel.temperature", unit::KELVIN, "Temperature of the hottest wheel")
                .output(),
        }
    }

    pub(crate) fn write(
        &self,
        model: &EnergyModel,
        wheels: &[Wheel],
        probes: &[usize],
        values: &mut Values,
    ) {
        let ledger = model.ledger();
        self.sources.write(&ledger.sources, values);
        values[self.error] = ledger.error();
        let answer = model.answer();
        self.present.write(Some(answer.present), values);
        self.highest.write(Some(answer.highest), values);
        self.detected.write(answer.detected, values);
        self.from_train.write(Some(answer.from_train), values);
        self.highest_from_train.write(Some(answer.highest_from_train), values);
        values[self.mean_flash] = MEAN_OVER_PEAK * model.highest_flash();
        let temperatures = model.wheel_temperatures().iter().copied();
        values[self.hottest_wheel] = temperatures.fold(0.0, f64::max);
        for (handles, &element) in self.probes.iter().zip(probes) {
            handles.sources.write(&model.sources_per_metre(element), values);
            let chainage = model.parameters().line.chainage(element);
            values[handles.thermoelastic] = model.thermoelastic(chainage, wheels);
        }
    }
}

impl SourceSignals {
    fn of_rail(declaration: &mut Declaration) -> Self {
        let mut output = |name: &str, description: &str| {
            declaration.real(name, unit::JOULE, description).output()
        };
        Self {
            friction: output("energy.friction", "Heat since the start by friction of the wheels"),
            chill: output("energy.chill", "Heat since the start by conduction from the wheels"),
            bending: output("energy.bending", "Heat since the start by hysteresis of bending"),
            weather: None,
        }
    }

    fn per_metre(prefix: &str, declaration: &mut Declaration) -> Self {
        let mut output = |name: &str, description: &str| {
            let name = format!("{prefix}.{name}");
            declaration.real(name, unit::JOULE_PER_METRE, description).output()
        };
        Self {
            friction: output("friction", "Heat by friction of the wheels"),
            chill: output("chill", "Heat by conduction from the wheels"),
            bending: output("bending", "Heat by hysteresis of bending"),
            weather: Some(output("weather", "Heat from the weather, positive into the rail")),
        }
    }

    fn write(&self, sources: &Sources, values: &mut Values) {
        values[self.friction] = sources.friction;
        values[self.chill] = sources.chill;
        values[self.bending] = sources.bending;
        if let Some(weather) = self.weather {
            values[weather] = sources.weather;
        }
    }
}

impl FindingSignals {
    fn declare(name: &str, what: &str, declaration: &mut Declaration) -> Self {
        let mut output = |part: &str, unit, description: String| {
            declaration.real(format!("{name}.{part}"), unit, description).output()
        };
        Self {
            rise: output("rise", unit::KELVIN, format!("{what}, over untouched rail")),
            chainage: output("chainage", unit::METRE, format!("{what}: where")),
            time: output("time", unit::SECOND, format!("{what}: when")),
        }
    }

    fn write(&self, finding: Option<Finding>, values: &mut Values) {
        let finding = finding.unwrap_or(Finding { rise: 0.0, chainage: NOT_YET, time: NOT_YET });
        values[self.rise] = finding.rise;
        values[self.chainage] = finding.chainage;
        values[self.time] = finding.time;
    }
}
