//! What is wrong with a scenario: bounds of its values, and what one key demands of another.

use std::borrow::Cow;
use std::collections::BTreeSet;

use files::{Check, Mistake, did_you_mean};
use garde::Validate;

use super::extent::Extent;
use super::file::{Scenario, VehicleGroup};
use super::fmus::OnFailure;

/// Checks the bounds of all values and what one key demands of another.
pub fn check(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    if let Err(report) = scenario.validate()
        && let Some((path, error)) = report.iter().next()
    {
        return Err(check.wrong(&from_one(&path.to_string()), in_words(error.message())));
    }
    check_vehicles(scenario, check)?;
    check_failures(scenario, check)?;
    check_train_alone(scenario, check)?;
    check_probes(scenario, check)?;
    check_times(scenario, check)
}

/// The key of the bounds' library, which counts from zero, as one that counts from one.
fn from_one(path: &str) -> String {
    let mut parts = path.split('[');
    let mut key = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (index, rest) = part.split_once(']').unwrap_or((part, ""));
        match index.parse::<usize>() {
            Ok(index) => key += &format!("[{}]{rest}", index + 1),
            Err(_) => key += &format!("[{part}"),
        }
    }
    key
}

/// The sentence of the bounds' library about what is wrong, as one about what is right.
fn in_words(message: &str) -> Cow<'_, str> {
    for (wrong, right) in [
        ("lower than ", "must be at least "),
        ("greater than ", "must be at most "),
        ("length is lower than 1", "must not be empty"),
    ] {
        if let Some(bound) = message.strip_prefix(wrong) {
            return format!("{right}{bound}").into();
        }
    }
    message.into()
}

/// Numbers of vehicles lie in the train, and each has one FMU.
fn check_vehicles(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    let count = scenario.vehicle_count();
    let behind = format!("is behind the tail: the train has {count} vehicles");
    let mut replaced = BTreeSet::new();
    for (i, other) in scenario.fmus.vehicle_at.iter().enumerate() {
        let check = check.element("fmus.vehicle_at", i);
        check.ensure(other.vehicle <= count, "vehicle", other.vehicle, &behind)?;
        let again = !replaced.insert(other.vehicle);
        check.ensure(
            !again,
            "vehicle",
            other.vehicle,
            "has an FMU already; leave one of them out",
        )?;
        if other.file.is_none() && !other.names.is_empty() {
            return Err(check.refuse("names", "names belong to an FMU; name its file, too"));
        }
    }
    for (i, number) in scenario.record.wheels_of.iter().enumerate() {
        let key = format!("record.wheels_of[{}]", i + 1);
        check.ensure(*number <= count, &key, number, &behind)?;
    }
    Ok(())
}

/// What shall outlive a failure has a process of its own.
fn check_failures(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    let fmus = &scenario.fmus;
    let wanted = "a vehicle can follow the train only if its FMU has a process of its own; add isolate = \
                  \"process\"";
    let isolated =
        fmus.isolate.is_some() || fmus.vehicle_at.iter().any(|own| own.isolate.is_some());
    check.ensure(isolated || !fmus.on_failure.follows(), "fmus.on_failure", "follow", wanted)?;
    for (i, own) in fmus.vehicle_at.iter().enumerate() {
        let check = check.element("fmus.vehicle_at", i);
        let isolated = fmus.isolate.is_some() || own.isolate.is_some();
        let follows = own.on_failure.is_some_and(OnFailure::follows);
        check.ensure(isolated || !follows, "on_failure", "follow", wanted)?;
    }
    Ok(())
}

fn check_train_alone(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    if !scenario.train_alone {
        return Ok(());
    }
    let wanted = "the rail is heated by wheels; leave [heat] out, or train_alone";
    check.ensure(scenario.heat.is_none(), "train_alone", true, wanted)?;
    let fmus = &scenario.fmus;
    let wanted = "a train alone has no vehicle FMUs; leave fmus.vehicle and fmus.vehicle_at out, or \
                  train_alone";
    let none = fmus.vehicle.is_none() && fmus.vehicle_at.is_empty();
    check.ensure(none, "train_alone", true, wanted)?;
    let wanted = "a train alone has no vehicle FMUs whose outputs could be recorded; leave record.outputs \
                  out, or train_alone";
    check.ensure(scenario.record.outputs.is_empty(), "train_alone", true, wanted)
}

/// Probes lie on the modelled rail.
fn check_probes(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    let Some(heat) = &scenario.heat else { return Ok(()) };
    let Extent { begin, length } = Extent::of(scenario, heat);
    let end = begin + length;
    let wanted = format!(
        "must lie on the modelled rail, from {begin} m to {end} m (heat.begin_m, heat.length_m)"
    );
    // Its own parameters may move the rail.
    let is_moved =
        ["track.begin", "track.length"].iter().any(|name| heat.parameters.contains_key(*name));
    for (i, probe) in heat.probe.iter().enumerate() {
        let chainage = probe.chainage_m;
        let possible = is_moved || (begin..=end).contains(&chainage);
        check.element("heat.probe", i).ensure(possible, "chainage_m", chainage, &wanted)?;
    }
    Ok(())
}

/// The types of the vehicles are in the scenario's library, whose path is absolute, or have files.
///
/// Their files have names of their own.
pub fn check_types(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    let folder = scenario.stock.join("vehicles");
    let wanted = "is no rolling-stock library: it has no folder `vehicles`";
    check.ensure(folder.is_dir(), "stock", scenario.stock.display(), wanted)?;
    let mut known: Vec<String> = std::fs::read_dir(&folder)
        .into_iter()
        .flatten()
        .filter_map(|file| Some(file.ok()?.file_name().to_str()?.strip_suffix(".toml")?.to_owned()))
        .collect();
    known.sort();
    for (i, group) in scenario.train.vehicles.iter().enumerate() {
        if let Some(file) = &group.file {
            let is_other =
                |other: &VehicleGroup| other.kind == group.kind && other.file != group.file;
            let is_taken =
                known.contains(&group.kind) || scenario.train.vehicles.iter().any(is_other);
            let wanted =
                "the stock library or another vehicle of the train has this name; rename the file";
            let check = check.element("train.vehicles", i);
            check.ensure(!is_taken, "type", file.display(), wanted)?;
            continue;
        }
        let meant = did_you_mean(&group.kind, known.iter().map(String::as_str));
        let wanted = format!("there is no vehicle of this name in {}{meant}", folder.display());
        let check = check.element("train.vehicles", i);
        check.ensure(
            known.contains(&group.kind),
            "type",
            format!("\"{}\"", group.kind),
            &wanted,
        )?;
    }
    Ok(())
}

/// Steps and intervals fit into each other.
fn check_times(scenario: &Scenario, check: &Check) -> Result<(), Mistake> {
    let step = scenario.step_s;
    let multiple = |key: &str, time: f64| {
        let wanted = format!("must be a multiple of step_s = {step} s");
        check.ensure(is_multiple(time, step), key, time, &wanted)
    };
    if let Some(heat) = &scenario.heat {
        if let Some(step) = heat.step_s {
            multiple("heat.step_s", step)?;
        }
        let headway = heat.trains.headway_minutes;
        let follows = heat.trains.count <= 1 || headway * 60.0 >= scenario.duration_s;
        let wanted = format!(
            "{headway} min are less than duration_s = {} s; a train follows when the one before it has run",
            scenario.duration_s
        );
        check.ensure(follows, "heat.trains.headway_minutes", headway, &wanted)?;
    }
    multiple("record.interval_s", scenario.record.interval_s)
}

/// Whether `value` is `step` times a whole number from one.
fn is_multiple(value: f64, step: f64) -> bool {
    let times = (value / step).round();
    times >= 1.0 && (times * step - value).abs() <= 1e-9 * value
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn keys_count_from_one() {
        assert_eq!(from_one("train.vehicles[0].count"), "train.vehicles[1].count");
        assert_eq!(from_one("record.heat_maps_at_s[9]"), "record.heat_maps_at_s[10]");
        assert_eq!(from_one("step_s"), "step_s");
    }

    #[test]
    fn bounds_are_told_as_what_is_right() {
        assert_eq!(in_words("lower than 0.001"), "must be at least 0.001");
        assert_eq!(in_words("greater than 60"), "must be at most 60");
        assert_eq!(in_words("length is lower than 1"), "must not be empty");
        assert_eq!(in_words("something else"), "something else");
    }
}
