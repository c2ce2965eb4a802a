//! Where the wall time of a run went, by parts of the step and by units.

use numerics::seconds;
use serde::Serialize;

use super::provenance::{Provenance, UnitFacts};
use super::quantity::with_unit;

/// Units that have a row; the others share one.
const MOST_ROWS: usize = 12;

/// The tables of wall times.
#[derive(Debug, Default, PartialEq, Serialize)]
pub(super) struct WallTimes<'p> {
    parts: Vec<PartRow<'p>>,
    units: Vec<UnitRow<'p>>,
    /// The other units in words; empty if all have a row.
    others: String,
}

#[derive(Debug, PartialEq, Serialize)]
struct PartRow<'p> {
    name: &'p str,
    total: String,
    share: String,
}

#[derive(Debug, PartialEq, Serialize)]
struct UnitRow<'p> {
    name: &'p str,
    fmu: &'p str,
    total: String,
    share: String,
    slowest: String,
    slowest_at: f64,
    message: &'p str,
}

/// The tables: units with a message first, then those that took longest.
pub(super) fn wall_times(provenance: &Provenance) -> WallTimes<'_> {
    let share = |part: f64, all: f64| format!("{:.1} %", 100.0 * part / all.max(f64::MIN_POSITIVE));
    let of_parts: f64 = provenance.wall_time_of.iter().map(|part| part.seconds).sum();
    let of_units: f64 = provenance.unit.iter().map(|unit| unit.wall_time_s).sum();
    let parts = provenance.wall_time_of.iter().map(|part| PartRow {
        name: &part.part,
        total: with_unit(part.seconds, "s"),
        share: share(part.seconds, of_parts),
    });
    let mut timed: Vec<&UnitFacts> = provenance.unit.iter().collect();
    timed.retain(|unit| unit.wall_time_s > 0.0 || unit.last_message.is_some());
    timed.sort_by(|a, b| {
        let first = b.last_message.is_some().cmp(&a.last_message.is_some());
        first.then(b.wall_time_s.total_cmp(&a.wall_time_s))
    });
    let others = timed.split_off(timed.len().min(MOST_ROWS));
    let row = |unit: &&'_ UnitFacts| {
        let total = unit.wall_time_s;
        (with_unit(total, "s"), share(total, of_units), with_unit(unit.slowest_step_s, "s"))
    };
    let units = timed.iter().map(|unit| {
        let (total, share, slowest) = row(unit);
        UnitRow {
            name: &unit.name,
            fmu: &unit.fmu,
            total,
            share,
            slowest,
            slowest_at: seconds(unit.slowest_at_s),
            message: unit.last_message.as_deref().unwrap_or(""),
        }
    });
    let units = units.collect();
    let rest: f64 = others.iter().map(|unit| unit.wall_time_s).sum();
    let others = match others.len() {
        0 => String::new(),
        count => {
            let (total, share) = (with_unit(rest, "s"), share(rest, of_units));
            format!("{count} further units took {total} together, {share}.")
        }
    };
    WallTimes { parts: parts.collect(), units, others }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_unit_with_a_message_stands_first_and_the_rest_together() {
        let unit = |number: usize| UnitFacts {
            name: format!("vehicle[{number}]"),
            wall_time_s: 1.0,
            last_message: (number == 20).then(|| "warned".to_owned()),
            ..UnitFacts::default()
        };
        let provenance = Provenance { unit: (1..=20).map(unit).collect(), ..Provenance::default() };
        let times = wall_times(&provenance);
        assert_eq!((times.units[0].name, times.units[0].message), ("vehicle[20]", "warned"));
        assert_eq!(times.units[1].share, "5.0 %");
        assert_eq!(times.others, "8 further units took 8.00 s together, 40.0 %.");
        assert_eq!(wall_times(&Provenance::default()), WallTimes::default());
    }
}
