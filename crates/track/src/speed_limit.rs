//! Speed limits along the track: `[[speed_limit]]` of a track file.
//!
//! ```toml
//! [[speed_limit]]                      # left out: none
//! from_m = 1000.0                      # from this chainage
//! to_m = 1500.0                        # to this one
//! speed_m_per_s = 16.7                 # of any part of the train; of several limits the lowest holds
//! ```
//!
//! They change nothing of what a train does: drivers keep to files of their own. Reports show them.

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Greatest speed that a limit may have, m/s.
const GREATEST: f64 = 150.0;

/// A speed limit on a part of the track.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SpeedLimit {
    /// Chainage at which it begins, m.
    pub from_m: f64,
    /// Chainage at which it ends, m.
    pub to_m: f64,
    /// Highest speed, m/s.
    pub speed_m_per_s: f64,
}

impl SpeedLimit {
    /// Refuses what a limit cannot be.
    pub(crate) fn check(&self, check: &Check) -> Result<(), Mistake> {
        let Self { from_m, to_m, speed_m_per_s } = *self;
        check.ensure(
            from_m.is_finite(),
            "from_m",
            from_m,
            "must be a finite chainage in metres",
        )?;
        let wanted = format!("must be a chainage beyond from_m = {from_m} m");
        check.ensure(to_m.is_finite() && to_m > from_m, "to_m", to_m, &wanted)?;
        let possible = speed_m_per_s > 0.0 && speed_m_per_s <= GREATEST;
        let wanted = format!("must be greater than 0 and at most {GREATEST} m/s");
        check.ensure(possible, "speed_m_per_s", speed_m_per_s, &wanted)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TrackFile;

    fn limits(text: &str) -> Result<Vec<SpeedLimit>, Mistake> {
        let file = TrackFile::new(text, "t.toml")?;
        file.track()?;
        Ok(file.speed_limits().to_vec())
    }

    #[test]
    fn limits_are_those_of_the_file() {
        let text = "[[speed_limit]]\nfrom_m = -5\nto_m = 100\nspeed_m_per_s = 16.7\n";
        let wanted = SpeedLimit { from_m: -5.0, to_m: 100.0, speed_m_per_s: 16.7 };
        assert_eq!(limits(text).unwrap(), [wanted]);
        assert_eq!(limits("start_m = 0.0").unwrap(), []);
    }

    #[test]
    fn wrong_limits_are_refused_with_line_key_value_and_remedy() {
        for (text, wanted) in [
            (
                "[[speed_limit]]\nfrom_m = 100\nto_m = 100\nspeed_m_per_s = 10\n",
                "t.toml:3:8: speed_limit[1].to_m = 100: must be a chainage beyond from_m = 100 m",
            ),
            (
                "[[speed_limit]]\nfrom_m = 0\nto_m = 100\nspeed_m_per_s = 0\n",
                "t.toml:4:17: speed_limit[1].speed_m_per_s = 0: must be greater than 0 and at most 150 m/s",
            ),
            (
                "[[speed_limit]]\nfrom_m = nan\nto_m = 100\nspeed_m_per_s = 9\n",
                "t.toml:2:10: speed_limit[1].from_m = nan: must be a finite chainage in metres",
            ),
        ] {
            let message = limits(text).unwrap_err().to_string();
            assert!(message.starts_with(wanted), "{message}");
        }
        let missing = limits("[[speed_limit]]\nfrom_m = 0\n").unwrap_err().to_string();
        assert!(missing.contains("to_m"), "{missing}");
    }
}
