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

use files::{Document, Mistake};
use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;

/// Name of the file in the FMU's resources folder.
pub const FILE_NAME: &str = "railheat.toml";

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

/// Wheels and probes of a rail's FMU.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Content {
    /// Number of wheelsets of each vehicle, in order from the head of the train.
    wheelsets_per_vehicle: Vec<usize>,
    /// Depths below the running surface at which the rise is an output, mm.
    #[serde(default)]
    depths_mm: Vec<f64>,
    /// Where temperatures are outputs.
    #[serde(default)]
    probe: Vec<Probe>,
}

/// Where temperatures are outputs.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Probe {
    /// Chainage, m.
    chainage_m: f64,
}

impl Shape {
    /// The JSON schema of the file.
    pub fn schema() -> Schema {
        schema_for!(Content)
    }

    /// Reads `railheat.toml` from the FMU's resources folder.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_resources(resources: &Path) -> Result<Self, Mistake> {
        let document = Document::read(&resources.join(FILE_NAME)).map_err(|mistake| {
            let hint = "it must name the wheelsets of each vehicle, such as \
                        `wheelsets_per_vehicle = [6, 6]`";
            Mistake { sentence: format!("{}; {hint}", mistake.sentence), ..mistake }
        })?;
        Self::of(&document)
    }

    /// Reads the text of the file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value in it is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, Mistake> {
        Self::of(&Document::new(name, text))
    }

    fn of(document: &Document) -> Result<Self, Mistake> {
        let content: Content = document.parse()?;
        let check = document.check();
        for (index, depth) in content.depths_mm.iter().enumerate() {
            check.positive(&format!("depths_mm[{}]", index + 1), *depth)?;
        }
        for (index, probe) in content.probe.iter().enumerate() {
            let check = check.element("probe", index);
            let finite = probe.chainage_m.is_finite();
            check.ensure(finite, "chainage_m", probe.chainage_m, "must be a finite number")?;
        }
        Ok(Self {
            wheelsets: content.wheelsets_per_vehicle,
            depths: content.depths_mm.iter().map(|depth| depth / 1000.0).collect(),
            probes: content.probe.iter().map(|probe| probe.chainage_m).collect(),
        })
    }
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
        let expected = "railheat.toml:2:20: depths_mm[2] = -1.0: must be greater than zero";
        assert!(depth.starts_with(expected), "{depth}");
        let typo = error("wheelsets_per_vehicle = [6]\nprobes = 3");
        assert!(typo.contains("railheat.toml") && typo.contains("probes"), "{typo}");
        let missing = Shape::from_resources(Path::new("/nowhere")).unwrap_err().to_string();
        assert!(missing.contains("/nowhere/railheat.toml"), "{missing}");
    }
}
