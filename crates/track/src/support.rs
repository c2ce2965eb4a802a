//! The elastic support of the rails: section `[support]` of a track file.
//!
//! ```toml
//! [support]                            # left out: the rails do not give way
//! lateral_stiffness_n_m = 25e6         # of one rail under one wheel
//! lateral_damping_n_s_m = 50e3
//! vertical_stiffness_n_m = 60e6
//! vertical_damping_n_s_m = 100e3
//! ```

use std::path::Path;

use serde::Deserialize;

use crate::TrackError;

/// Stiffness and damping of one rail under one wheel, across and down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Support {
    /// N/m.
    pub stiffness: [f64; 2],
    /// N s/m.
    pub damping: [f64; 2],
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Section {
    lateral_stiffness_n_m: f64,
    lateral_damping_n_s_m: f64,
    vertical_stiffness_n_m: f64,
    vertical_damping_n_s_m: f64,
}

/// The part of a track file that is read here; the rest is the track's.
#[derive(Deserialize)]
struct TrackFile {
    support: Option<Section>,
}

impl Support {
    /// The support of a track file; none: the rails do not give way.
    ///
    /// # Errors
    /// When the file cannot be read or a value is not possible.
    pub fn from_track_file(file: &Path) -> Result<Option<Self>, TrackError> {
        let name = file.display().to_string();
        let text = std::fs::read_to_string(file)
            .map_err(|source| TrackError::Read { file: name.clone(), source })?;
        Self::from_toml(&text, &name)
    }

    /// The same from the text of a track file.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Option<Self>, TrackError> {
        let file: TrackFile = toml::from_str(text).map_err(|source| TrackError::Syntax {
            file: name.to_owned(),
            source: Box::new(source),
        })?;
        file.support.map(|section| section.checked(name)).transpose()
    }
}

impl Section {
    fn checked(&self, file: &str) -> Result<Support, TrackError> {
        let positive = |key: &str, value: f64, least: f64, wanted: &'static str| match (least
            ..=1e12)
            .contains(&value)
        {
            true => Ok(value),
            false => {
                let key = format!("support.{key}");
                Err(TrackError::Value { file: file.to_owned(), key, value, wanted })
            }
        };
        let stiff = "must be at least 1e5 N/m";
        let damped = "must be at least 1e3 N s/m, as the rail has no mass";
        Ok(Support {
            stiffness: [
                positive("lateral_stiffness_n_m", self.lateral_stiffness_n_m, 1e5, stiff)?,
                positive("vertical_stiffness_n_m", self.vertical_stiffness_n_m, 1e5, stiff)?,
            ],
            damping: [
                positive("lateral_damping_n_s_m", self.lateral_damping_n_s_m, 1e3, damped)?,
                positive("vertical_damping_n_s_m", self.vertical_damping_n_s_m, 1e3, damped)?,
            ],
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const RAIL: &str = "[support]\nlateral_stiffness_n_m = 25e6\nlateral_damping_n_s_m = 50e3\n\
                        vertical_stiffness_n_m = 60e6\nvertical_damping_n_s_m = 100e3";

    #[test]
    fn stiffness_and_damping_are_those_across_and_down() {
        let support = Support::from_toml(RAIL, "t.toml").unwrap();
        let expected = Support { stiffness: [25e6, 60e6], damping: [50e3, 100e3] };
        assert_eq!(support, Some(expected));
    }

    #[test]
    fn a_soft_rail_is_refused_with_its_bound() {
        let text = RAIL.replace("60e6", "60e3");
        let message = Support::from_toml(&text, "t.toml").unwrap_err().to_string();
        let wanted = "support.vertical_stiffness_n_m = 60000: must be at least 1e5 N/m";
        assert!(message.contains(wanted), "{message}");
    }

    #[test]
    fn a_massless_rail_needs_damping() {
        let text = "[support]\nlateral_stiffness_n_m = 25e6\nlateral_damping_n_s_m = 0.0\n\
                    vertical_stiffness_n_m = 60e6\nvertical_damping_n_s_m = 1e5";
        let message = Support::from_toml(text, "t.toml").unwrap_err().to_string();
        assert!(message.contains("support.lateral_damping_n_s_m = 0: must be"), "{message}");
        assert_eq!(Support::from_toml("", "t.toml").unwrap(), None);
    }
}
