//! `railheat.toml`: the wheels and probes that shape the interface.
//!
//! ```toml
//! wheelsets_per_vehicle = [6, 6, 6]   # in order from the head of the train
//! depths_mm = [20.0, 60.0]            # below the running surface; read at probes and along the rail
//!
//! [[probe]]                           # as many as wanted; may be left out
//! chainage_m = 650.0
//! ```

use std::path::Path;

use serde::Deserialize;

/// Name of the file in the FMU's resources folder.
pub const FILE_NAME: &str = "railheat.toml";

/// Why the file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// The file cannot be read.
    #[error(
        "rail heat file {file}: {source}; it must name the wheelsets of each vehicle, such as \
             `wheelsets_per_vehicle = [6, 6]`"
    )]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The file is not TOML, or has an unknown key or a wrong type.
    #[error("rail heat file {file}: {source}")]
    Syntax {
        /// File name.
        file: String,
        /// Reason, with line and caret.
        source: Box<toml::de::Error>,
    },
    /// A value is not possible.
    #[error("rail heat file {file}: {key} = {value}: {wanted}")]
    Value {
        /// File name.
        file: String,
        /// Key with its number, counted from one.
        key: String,
        /// Value found.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
}

/// What shapes the interface.
#[derive(Clone, Debug, PartialEq)]
pub struct Shape {
    /// Number of wheelsets of each vehicle.
    pub wheelsets: Vec<usize>,
    /// Depths at which the rise is read, m.
    pub depths: Vec<f64>,
    /// Chainages of the probes, m.
    pub probes: Vec<f64>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Content {
    wheelsets_per_vehicle: Vec<usize>,
    #[serde(default)]
    depths_mm: Vec<f64>,
    #[serde(default)]
    probe: Vec<Probe>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Probe {
    chainage_m: f64,
}

impl Shape {
    /// Reads `railheat.toml` from the FMU's resources folder.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_resources(resources: &Path) -> Result<Self, FileError> {
        let file = resources.join(FILE_NAME);
        let name = file.display().to_string();
        match std::fs::read_to_string(&file) {
            Ok(text) => Self::from_toml(&text, &name),
            Err(source) => Err(FileError::Read { file: name, source }),
        }
    }

    /// Reads the text of the file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value in it is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, FileError> {
        let content: Content = toml::from_str(text).map_err(|source| FileError::Syntax {
            file: name.to_owned(),
            source: Box::new(source),
        })?;
        for (index, depth) in content.depths_mm.iter().enumerate() {
            check(name, format!("depths_mm[{}]", index + 1), *depth, *depth > 0.0)?;
        }
        for (index, probe) in content.probe.iter().enumerate() {
            check(name, format!("probe[{}].chainage_m", index + 1), probe.chainage_m, true)?;
        }
        Ok(Self {
            wheelsets: content.wheelsets_per_vehicle,
            depths: content.depths_mm.iter().map(|depth| depth / 1000.0).collect(),
            probes: content.probe.iter().map(|probe| probe.chainage_m).collect(),
        })
    }
}

fn check(file: &str, key: String, value: f64, allowed: bool) -> Result<(), FileError> {
    if allowed && value.is_finite() {
        return Ok(());
    }
    Err(FileError::Value {
        file: file.to_owned(),
        key,
        value,
        wanted: if value.is_finite() {
            "must be greater than zero"
        } else {
            "must be a finite number"
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_gives_its_shape() {
        let text =
            "wheelsets_per_vehicle = [6, 4]\ndepths_mm = [20]\n[[probe]]\nchainage_m = 650.0";
        let shape = Shape::from_toml(text, "railheat.toml").unwrap();
        assert_eq!(shape.wheelsets, [6, 4]);
        assert_eq!(shape.depths, [0.02]);
        assert_eq!(shape.probes, [650.0]);
    }

    #[test]
    fn errors_name_file_key_and_value() {
        let error = |text: &str| Shape::from_toml(text, "railheat.toml").unwrap_err().to_string();
        let depth = error("wheelsets_per_vehicle = [6]\ndepths_mm = [20.0, -1.0]");
        assert_eq!(
            depth,
            "rail heat file railheat.toml: depths_mm[2] = -1: must be greater than zero"
        );
        let typo = error("wheelsets_per_vehicle = [6]\nprobes = 3");
        assert!(typo.contains("railheat.toml") && typo.contains("probes"), "{typo}");
        let missing = Shape::from_resources(Path::new("/nowhere")).unwrap_err().to_string();
        assert!(missing.contains("/nowhere/railheat.toml"), "{missing}");
    }
}
