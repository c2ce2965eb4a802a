//! What makes no sense is refused in words.

use fmu::ModelError;

use super::bounds::wrong;
use crate::contact::Wheel;
use crate::line::Line;
use crate::weather::{BOUNDS, Weather};

/// Refuses weather that there is not, within the bounds of a weather file.
pub(crate) fn weather(weather: &Weather) -> Result<(), ModelError> {
    let Weather { ambient, wind, direct, diffuse, sun } = *weather;
    let [(coldest, warmest), of_wind, of_direct, of_diffuse, ..] = BOUNDS;
    for (name, value, (low, high)) in [
        ("ambient.temperature", ambient, (coldest + 273.15, warmest + 273.15)),
        ("wind.speed", wind, of_wind),
        ("solar.irradiance", direct, of_direct),
        ("solar.diffuse", diffuse, of_diffuse),
    ] {
        if !(low..=high).contains(&value) {
            return Err(wrong(name, value, &format!("must lie between {low} and {high}")));
        }
    }
    for (name, value) in [("solar.elevation", sun.elevation), ("solar.azimuth", sun.azimuth)] {
        if !value.is_finite() {
            return Err(wrong(name, value, "must be a finite number"));
        }
    }
    Ok(())
}

/// Refuses inputs of a wheel that make no sense.
pub(crate) fn wheel(wheel: &Wheel, name: &str) -> Result<(), ModelError> {
    let contact = &wheel.contact;
    let heat = [wheel.friction_power, wheel.brake_power, wheel.lateral_position];
    if !heat.iter().all(|value| value.is_finite()) {
        return Err(ModelError::new(format!(
            "{name}: friction_power {} W, brake_power {} W and contact.lateral_position {} m must \
             be finite numbers",
            wheel.friction_power, wheel.brake_power, wheel.lateral_position
        )));
    }
    let all = [wheel.position, wheel.speed, wheel.creepage, contact.normal_force];
    if !all.iter().all(|value| value.is_finite()) {
        return Err(ModelError::new(format!(
            "{name}: position {} m, speed {} m/s, longitudinal creepage {} and normal force {} N \
             must be finite numbers",
            wheel.position, wheel.speed, wheel.creepage, contact.normal_force
        )));
    }
    if contact.normal_force > 0.0 && !(contact.a > 0.0 && contact.b > 0.0) {
        return Err(ModelError::new(format!(
            "{name}: contact.a = {} m, contact.b = {} m: must be greater than zero while the \
             normal force is ({} N)",
            contact.a, contact.b, contact.normal_force
        )));
    }
    Ok(())
}

/// The element in which each probe lies.
pub(crate) fn probe_elements(probes: &[f64], line: &Line) -> Result<Vec<usize>, ModelError> {
    let element = |&chainage: &f64| {
        line.element(chainage).ok_or_else(|| {
            ModelError::new(format!(
                "probe at chainage_m = {chainage}: must lie on the modelled track from {} m to {} m",
                line.begin,
                line.end()
            ))
        })
    };
    probes.iter().map(element).collect()
}
