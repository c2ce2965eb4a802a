//! Where the train exceeds a speed limit of the track file.

use numerics::constants::KILOMETRES_PER_HOUR;
use numerics::seconds;
use track::SpeedLimit;

use super::facts::RunFacts;
use crate::recording::{KeyValue, RecordingError, SeriesReader};

/// Faster by less than this share of the limit is rounding.
const ROUNDING: f64 = 1e-6;

/// A sentence for each limit that the train exceeds while a part of it is there.
pub(super) fn exceeded(
    facts: &RunFacts,
    vehicles: &SeriesReader,
) -> Result<Vec<String>, RecordingError> {
    let limits = &facts.track.speed_limit;
    if limits.is_empty() {
        return Ok(vec![]);
    }
    let read = |name: &str, vehicle: usize| {
        let number = i32::try_from(vehicle).unwrap_or(i32::MAX);
        vehicles.read(name, &[("vehicle", KeyValue::Integer(number))])
    };
    let (time, speed) = (read("time", 1)?, read("velocity", 1)?);
    let (head, tail) = (read("position", 1)?, read("position", facts.vehicles)?);
    let sentence = |limit: &SpeedLimit| {
        let SpeedLimit { from_m, to_m, speed_m_per_s } = *limit;
        let is_there = |record: &usize| {
            head[*record].max(tail[*record]) > from_m && head[*record].min(tail[*record]) < to_m
        };
        let records = (0..time.len()).filter(is_there).filter(|&record| speed[record].is_finite());
        let fastest = records.max_by(|&a, &b| speed[a].abs().total_cmp(&speed[b].abs()))?;
        let reached = speed[fastest].abs();
        (reached > speed_m_per_s * (1.0 + ROUNDING)).then(|| {
            format!(
                "the train exceeds the speed limit of {:.1} km/h from chainage {from_m} m to {to_m} m: a part of \
                 it is there at {:.1} km/h, at {} s, its leading vehicle at chainage {:.1} m",
                speed_m_per_s * KILOMETRES_PER_HOUR,
                reached * KILOMETRES_PER_HOUR,
                seconds(time[fastest]),
                head[fastest]
            )
        })
    };
    Ok(limits.iter().filter_map(sentence).collect())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::TrackFacts;
    use crate::report::invented::{SPEED, facts, write_run};
    use crate::report::results::Results;

    /// Ten vehicles with 20 m between them at a constant speed: the head passes 100 m, the tail 20 m.
    #[test]
    fn a_limit_holds_for_every_part_of_the_train() {
        let limit =
            |from_m, to_m, share: f64| SpeedLimit { from_m, to_m, speed_m_per_s: share * SPEED };
        let track = TrackFacts {
            speed_limit: vec![
                limit(50.0, 60.0, 0.5),
                limit(50.0, 60.0, 1.0),
                limit(1e5, 2e5, 0.5),
                limit(-60.0, -50.0, 0.9),
            ],
            ..TrackFacts::default()
        };
        let facts = RunFacts { track, ..facts() };
        let folder = tempfile::tempdir().unwrap();
        write_run(folder.path(), &facts);
        let results = Results::open(folder.path()).unwrap();
        let sentences = exceeded(&facts, &results.vehicles).unwrap();
        let [head, tail] = sentences.as_slice() else { panic!("{sentences:?}") };
        assert!(head.contains("from chainage 50 m to 60 m: a part of it is there at"), "{head}");
        assert!(tail.contains("from chainage -60 m to -50 m"), "{tail}");
    }
}
