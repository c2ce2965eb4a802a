//! What is wrong with a scenario: bounds of its values, and what one key demands of another.

use std::collections::BTreeSet;

use garde::Validate;

use super::file::Scenario;
use super::fmus::VehicleReplacement;

/// A key whose value is wrong, and why.
pub struct Wrong {
    /// The key, such as `train.vehicles[0].count`.
    pub key: String,
    /// What is wrong and what would be right.
    pub message: String,
}

/// Checks the bounds of all values and what one key demands of another.
pub fn check(scenario: &Scenario) -> Result<(), Wrong> {
    if let Err(report) = scenario.validate()
        && let Some((path, error)) = report.iter().next()
    {
        return Err(Wrong { key: path.to_string(), message: error.to_string() });
    }
    check_across_keys(scenario).map_err(|(key, message)| Wrong { key: key.to_owned(), message })
}

/// Rules that concern more than one key.
fn check_across_keys(scenario: &Scenario) -> Result<(), (&'static str, String)> {
    let count = scenario.vehicle_count();
    if let Some(replaced) = scenario.fmus.vehicle_at.iter().find(|v| v.place > count) {
        let message =
            format!("place {} is behind the tail: the train has {count} vehicles", replaced.place);
        return Err(("fmus.vehicle_at", message));
    }
    let places = scenario.fmus.vehicle_at.iter().map(|replaced| replaced.place);
    if let Some(place) = first_twice(places) {
        let message = format!("there are two FMUs for place {place}; leave one of them out");
        return Err(("fmus.vehicle_at", message));
    }
    let named = |other: &&VehicleReplacement| other.file.is_none() && !other.names.is_empty();
    if let Some(other) = scenario.fmus.vehicle_at.iter().find(named) {
        let message = format!("place {}: names belong to an FMU; name its file, too", other.place);
        return Err(("fmus.vehicle_at", message));
    }
    if let Some(place) = scenario.record.wheels_of.iter().find(|&&place| place > count) {
        let message = format!("{place} is behind the tail: the train has {count} vehicles");
        return Err(("record.wheels_of", message));
    }
    if scenario.train_alone && scenario.heat.is_some() {
        let message = "the rail is heated by wheels; leave [heat] out, or train_alone".to_owned();
        return Err(("train_alone", message));
    }
    if scenario.train_alone
        && (scenario.fmus.vehicle.is_some() || !scenario.fmus.vehicle_at.is_empty())
    {
        let message = "a train alone has no vehicle FMUs; leave fmus.vehicle and fmus.vehicle_at out, \
                       or train_alone";
        return Err(("train_alone", message.to_owned()));
    }
    if let Some(step) = scenario.heat.as_ref().and_then(|heat| heat.step_s)
        && !is_multiple(step, scenario.step_s)
    {
        let message = not_a_multiple(step, scenario.step_s);
        return Err(("heat.step_s", message));
    }
    if let Some(heat) = &scenario.heat
        && heat.trains.count > 1
        && heat.trains.headway_minutes * 60.0 < scenario.duration_s
    {
        let message = format!(
            "{} min are less than duration_s = {} s; a train follows when the one before it has run",
            heat.trains.headway_minutes, scenario.duration_s
        );
        return Err(("heat.trains.headway_minutes", message));
    }
    if !is_multiple(scenario.record.interval_s, scenario.step_s) {
        let message = not_a_multiple(scenario.record.interval_s, scenario.step_s);
        return Err(("record.interval_s", message));
    }
    Ok(())
}

/// The first number that was there before.
fn first_twice(numbers: impl Iterator<Item = usize>) -> Option<usize> {
    let mut seen = BTreeSet::new();
    numbers.into_iter().find(|number| !seen.insert(*number))
}

fn not_a_multiple(value: f64, step: f64) -> String {
    format!("{value} s is not a multiple of step_s = {step} s")
}

/// Whether `value` is `step` times a whole number from one.
fn is_multiple(value: f64, step: f64) -> bool {
    let times = (value / step).round();
    times >= 1.0 && (times * step - value).abs() <= 1e-9 * value
}
