//! The outputs.

use fmu::{Declaration, Handles, Scope, Values, Variables};

use super::chosen_model::ChosenModel;
use super::shape::Shape;
use crate::contact::{MEAN_OVER_PEAK, Wheel};
use crate::energy::{EnergyModel, Finding, Sources};
use crate::heat_model::HeatModel;
use crate::line::Highest;

/// Value of a time or chainage that there is not yet.
const NOT_YET: f64 = -1.0;

fmu::variables! {
    /// The highest rise at one level.
    #[derive(Copy)]
    struct HighestOutputs: output {
        /// Highest temperature rise along the track {}
        rise: "rise", KELVIN;
        /// Chainage of the highest temperature rise {}
        chainage: "chainage", METRE;
    }

    /// The rise at one level of a probe.
    #[derive(Copy)]
    struct LevelOutputs: output {
        /// Temperature rise at {}
        rise: "rise", KELVIN;
    }

    /// The heat at a probe.
    #[derive(Copy)]
    struct HeatOutputs: output {
        /// Heat above the initial state at {}
        heat: "heat", JOULE_PER_METRE;
    }

    /// The heat by source at a probe.
    #[derive(Copy)]
    struct SourceOutputs: output {
        /// Heat by friction of the wheels
        friction: "friction", JOULE_PER_METRE;
        /// Heat by conduction from the wheels
        chill: "chill", JOULE_PER_METRE;
        /// Heat by hysteresis of bending
        bending: "bending", JOULE_PER_METRE;
        /// Heat from the weather, positive into the rail
        weather: "weather", JOULE_PER_METRE;
    }

    /// What only `model = "energy"` writes for a probe.
    #[derive(Copy)]
    struct EnergyProbeOutputs: output {
        /// Heat by source.
        heat: "heat", group(SourceOutputs);
        /// Reversible temperature change of the foot by bending under the wheels
        thermoelastic: "foot.thermoelastic", KELVIN;
    }

    /// A rise of the foot with its chainage and time.
    #[derive(Copy)]
    struct FindingOutputs: output {
        /// {}, over untouched rail
        rise: "rise", KELVIN;
        /// {}: where
        chainage: "chainage", METRE;
        /// {}: when
        time: "time", SECOND;
    }

    /// What only `model = "energy"` writes; zero in `model = "paper"`.
    #[derive(Copy)]
    struct EnergyOutputs: output {
        /// Heat since the start by friction of the wheels
        friction: "energy.friction", JOULE;
        /// Heat since the start by conduction from the wheels
        chill: "energy.chill", JOULE;
        /// Heat since the start by hysteresis of bending
        bending: "energy.bending", JOULE;
        /// Now.
        present: "foot.present", group(FindingOutputs) = "The foot's highest rise now";
        /// So far.
        highest: "foot.highest", group(FindingOutputs) = "The foot's highest rise so far";
        /// At the threshold.
        detected: "foot.detection", group(FindingOutputs)
            = "The foot's rise when it first reached detection.threshold (-1: not yet)";
        /// From the train.
        from_train: "camera.train", group(FindingOutputs)
            = "The foot's rise under the last wheel, as a camera on the train sees it";
        /// The highest from the train.
        highest_from_train: "camera.train.highest", group(FindingOutputs)
            = "The highest rise of the foot that a camera on the train has seen";
        /// Heat that is stored but did not come in
        error: "energy.error", JOULE;
        /// Mean over the contact of the highest flash temperature rise in the last step
        mean_flash: "highest.flash.mean", KELVIN;
        /// Temperature of the hottest wheel
        hottest_wheel: "highest.wheel.temperature", KELVIN;
    }

    /// What both models write of the whole rail.
    #[derive(Copy)]
    struct RailOutputs: output {
        /// Highest flash temperature rise of any wheel in the last step
        highest_flash: "highest.flash.rise", KELVIN;
        /// Temperature rise of the surface where no wheel has been
        untouched: "untouched.surface.rise", KELVIN;
        /// Heat in the modelled rail above the initial state
        stored: "energy.stored", JOULE;
        /// Heat since the start by surface temperatures that wheels imposed; zero in model energy
        imposed: "energy.imposed", JOULE;
        /// Heat since the start from the weather, positive into the rail
        weather: "energy.weather", JOULE;
    }
}

/// Handles of the outputs.
#[derive(Debug)]
pub(crate) struct Outputs {
    /// Surface, the depths of the file, foot.
    highest: Vec<Handles<HighestOutputs>>,
    probes: Vec<ProbeHandles>,
    energy_probes: Vec<Handles<EnergyProbeOutputs>>,
    energy: Handles<EnergyOutputs>,
    rail: Handles<RailOutputs>,
}

/// Handles of one probe.
#[derive(Debug)]
struct ProbeHandles {
    /// Surface, the depths of the file, foot.
    levels: Vec<Handles<LevelOutputs>>,
    heat: Handles<HeatOutputs>,
}

impl Outputs {
    pub(crate) fn declare(shape: &Shape, declaration: &mut Declaration) -> Self {
        let levels = levels(shape);
        let highest = levels.iter().map(|(name, depth)| {
            let scope = Scope::from(format!("highest.{name}")).about(depth);
            HighestOutputs::declare(declaration, scope)
        });
        Self {
            highest: highest.collect(),
            probes: (1..)
                .zip(&shape.probes)
                .map(|(p, chainage)| ProbeHandles::declare(p, *chainage, &levels, declaration))
                .collect(),
            energy_probes: (1..=shape.probes.len())
                .map(|p| EnergyProbeOutputs::declare(declaration, format!("probe[{p}]")))
                .collect(),
            energy: EnergyOutputs::declare(declaration, ""),
            rail: RailOutputs::declare(declaration, ""),
        }
    }

    /// Writes what the model says now; `probes` are the elements of the probes.
    pub(crate) fn write(
        &self,
        model: &ChosenModel,
        wheels: &[Wheel],
        probes: &[usize],
        values: &mut Values,
    ) {
        for (handles, &Highest { rise, chainage }) in self.highest.iter().zip(model.highest()) {
            HighestOutputs { rise, chainage }.write(handles, values);
        }
        for (handles, &element) in self.probes.iter().zip(probes) {
            for (level, handles) in handles.levels.iter().enumerate() {
                LevelOutputs { rise: model.rise(element, level) }.write(handles, values);
            }
            HeatOutputs { heat: model.heat_per_metre(element) }.write(&handles.heat, values);
        }
        RailOutputs::of(model).write(&self.rail, values);
        if let ChosenModel::Energy(model) = model {
            EnergyOutputs::of(model).write(&self.energy, values);
            for (handles, &element) in self.energy_probes.iter().zip(probes) {
                EnergyProbeOutputs::of(model, element, wheels).write(handles, values);
            }
        }
    }
}

impl ProbeHandles {
    fn declare(
        probe: usize,
        chainage: f64,
        levels: &[(String, String)],
        declaration: &mut Declaration,
    ) -> Self {
        let levels = levels.iter().map(|(name, depth)| {
            let scope = Scope::from(format!("probe[{probe}].{name}"))
                .about(&format!("chainage {chainage} m {depth}"));
            LevelOutputs::declare(declaration, scope)
        });
        let levels = levels.collect();
        let scope = Scope::from(format!("probe[{probe}]")).about(&format!("chainage {chainage} m"));
        Self { levels, heat: HeatOutputs::declare(declaration, scope) }
    }
}

impl RailOutputs {
    fn of(model: &ChosenModel) -> Self {
        let (stored, imposed, weather) = match model {
            ChosenModel::Paper(model) => {
                let audit = model.audit();
                (audit.stored, audit.imposed, audit.weather)
            }
            ChosenModel::Energy(model) => {
                let ledger = model.ledger();
                (ledger.stored, 0.0, ledger.sources.weather)
            }
        };
        Self {
            highest_flash: model.highest_flash(),
            untouched: model.untouched_surface(),
            stored,
            imposed,
            weather,
        }
    }
}

impl EnergyOutputs {
    fn of(model: &EnergyModel) -> Self {
        let (ledger, answer) = (model.ledger(), model.answer());
        let Sources { friction, chill, bending, .. } = ledger.sources;
        let not_yet = Finding { rise: 0.0, chainage: NOT_YET, time: NOT_YET };
        Self {
            friction,
            chill,
            bending,
            present: answer.present.into(),
            highest: answer.highest.into(),
            detected: answer.detected.unwrap_or(not_yet).into(),
            from_train: answer.from_train.into(),
            highest_from_train: answer.highest_from_train.into(),
            error: ledger.error(),
            mean_flash: MEAN_OVER_PEAK * model.highest_flash(),
            hottest_wheel: model.wheel_temperatures().iter().copied().fold(0.0, f64::max),
        }
    }
}

impl EnergyProbeOutputs {
    fn of(model: &EnergyModel, element: usize, wheels: &[Wheel]) -> Self {
        let Sources { friction, chill, bending, weather } = model.sources_per_metre(element);
        let chainage = model.line().chainage(element);
        Self {
            heat: SourceOutputs { friction, chill, bending, weather },
            thermoelastic: model.thermoelastic(chainage, wheels),
        }
    }
}

impl From<Finding> for FindingOutputs {
    fn from(Finding { rise, chainage, time }: Finding) -> Self {
        Self { rise, chainage, time }
    }
}

/// Name and depth in words of each level: surface, the depths of the file, foot.
fn levels(shape: &Shape) -> Vec<(String, String)> {
    let depths = shape.depths.iter().enumerate().map(|(k, depth)| {
        let millimetres = depth * 1000.0;
        (format!("depth[{}]", k + 1), format!("{millimetres} mm below the running surface"))
    });
    std::iter::once(("surface".to_owned(), "on the crown, within 15 mm of its middle".to_owned()))
        .chain(depths)
        .chain([("foot".to_owned(), "at the foot".to_owned())])
        .collect()
}
