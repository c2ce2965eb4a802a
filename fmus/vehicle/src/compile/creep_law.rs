//! The creep law that a vehicle file chooses.

use contact::{
    CreepLaw, ExactRolling, FallingFriction, Friction, FrictionByTemperature, ModifiedFastsim,
    Polach, Reduction,
};
use stock::CreepLawKind;

/// Pairs of strips, and elements of each, of FASTSIM on line unless the file says otherwise.
const DIVISION: (usize, usize) = (5, 20);

/// Temperature of wheel and rail unless the file says otherwise, °C.
const BULK_TEMPERATURE: f64 = 20.0;

/// The law with its parameters; the first exact rolling of a process unpacks the table.
pub(super) fn compiled(creep: &stock::CreepLaw) -> CreepLaw {
    let friction = friction(creep);
    let reduction = Reduction {
        initial: creep.initial_slope.unwrap_or(Reduction::NONE.initial),
        remaining: creep.remaining_slope.unwrap_or(Reduction::NONE.remaining),
        fall: creep.slope_fall.unwrap_or(Reduction::NONE.fall),
    };
    match creep.law {
        CreepLawKind::ExactRolling => {
            CreepLaw::ExactRolling(ExactRolling::new(reduction, friction))
        }
        CreepLawKind::FastsimOnLine => {
            let pairs = creep.strip_pairs.unwrap_or(DIVISION.0);
            let elements = creep.elements.unwrap_or(DIVISION.1);
            CreepLaw::Fastsim(ModifiedFastsim::on_line(reduction, friction, pairs, elements))
        }
        CreepLawKind::Polach => CreepLaw::Polach(Polach {
            adhesion_factor: creep.adhesion_factor.unwrap_or(1.0),
            slip_factor: creep.slip_factor.unwrap_or(1.0),
            friction,
        }),
        CreepLawKind::ShenHedrickElkins => CreepLaw::ShenHedrickElkins(friction),
        CreepLawKind::KalkerLinear => CreepLaw::KalkerLinear,
    }
}

/// Friction by slip velocity or by temperature.
fn friction(creep: &stock::CreepLaw) -> Friction {
    match creep.temperature_range_k {
        Some(range) => Friction::ByTemperature(FrictionByTemperature {
            reference_coefficient: creep.friction,
            limit_ratio: creep.limit_ratio,
            reference_temperature: creep.reference_temperature_c.unwrap_or(0.0),
            range,
            bulk_temperature: creep.bulk_temperature_c.unwrap_or(BULK_TEMPERATURE),
        }),
        None => Friction::Falling(FallingFriction {
            static_coefficient: creep.friction,
            limit_ratio: creep.limit_ratio,
            decay: creep.decay_s_m.unwrap_or(0.0),
        }),
    }
}
