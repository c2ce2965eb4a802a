//! The elastic support of the rails: section `[support]` of a track file.
//!
//! ```toml
//! [support]                            # left out: the rails do not give way
//! lateral_stiffness_n_m = 25e6         # of one rail under one wheel
//! lateral_damping_n_s_m = 50e3
//! vertical_stiffness_n_m = 60e6
//! vertical_damping_n_s_m = 100e3
//! ```

use files::{Check, Mistake};
use schemars::JsonSchema;
use serde::Deserialize;

/// Stiffness and damping of one rail under one wheel, across and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// N/m.
    pub stiffness: [f64; 2],
    /// N s/m.
    pub damping: [f64; 2],
}

/// The section as it stands in the file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct Section {
    /// Lateral stiffness of a rail under a wheel, N/m.
    lateral_stiffness_n_m: f64,
    /// Lateral damping, N s/m.
    lateral_damping_n_s_m: f64,
    /// Vertical stiffness, N/m.
    vertical_stiffness_n_m: f64,
    /// Vertical damping, N s/m.
    vertical_damping_n_s_m: f64,
}

impl Section {
    /// The support, if its values are possible.
    pub fn compile(&self, check: &Check) -> Result<Support, Mistake> {
        let at_least = |key: &str, value: f64, least: f64, wanted: &str| {
            check.ensure((least..=1e12).contains(&value), key, value, wanted)?;
            Ok(value)
        };
        let stiff = "must be at least 1e5 N/m";
        let damped = "must be at least 1e3 N s/m, as the rail has no mass";
        Ok(Support {
            stiffness: [
                at_least("lateral_stiffness_n_m", self.lateral_stiffness_n_m, 1e5, stiff)?,
                at_least("vertical_stiffness_n_m", self.vertical_stiffness_n_m, 1e5, stiff)?,
            ],
            damping: [
                at_least("lateral_damping_n_s_m", self.lateral_damping_n_s_m, 1e3, damped)?,
                at_least("vertical_damping_n_s_m", self.vertical_damping_n_s_m, 1e3, damped)?,
            ],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TrackFile;

    const RAIL: &str = "[support]\nlateral_stiffness_n_m = 25e6\nlateral_damping_n_s_m = 50e3\n\
                        vertical_stiffness_n_m = 60e6\nvertical_damping_n_s_m = 100e3";

    #[test]
    fn stiffness_and_damping_are_those_across_and_down() {
        let support = TrackFile::new(RAIL, "t.toml").unwrap().support().unwrap();
        let expected = Support { stiffness: [25e6, 60e6], damping: [50e3, 100e3] };
        assert_eq!(support, Some(expected));
    }

    #[test]
    fn a_soft_rail_is_refused_with_its_bound() {
        let text = RAIL.replace("60e6", "60e3");
        let message = TrackFile::new(&text, "t.toml").unwrap().support().unwrap_err().to_string();
        let wanted = "support.vertical_stiffness_n_m = 60e3: must be at least 1e5 N/m";
        assert!(message.contains(wanted), "{message}");
    }

    #[test]
    fn a_massless_rail_needs_damping() {
        let text = "[support]\nlateral_stiffness_n_m = 25e6\nlateral_damping_n_s_m = 0.0\n\
                    vertical_stiffness_n_m = 60e6\nvertical_damping_n_s_m = 1e5";
        let message = TrackFile::new(text, "t.toml").unwrap().support().unwrap_err().to_string();
        assert!(
            message.contains("t.toml:3:25: support.lateral_damping_n_s_m = 0.0: must be"),
            "{message}"
        );
        assert_eq!(TrackFile::new("", "t.toml").unwrap().support().unwrap(), None);
    }
}
