//! The consist file: the vehicles of a train in order from its head.
//!
//! ```toml
//! [[vehicle]]
//! type = "locomotive-coco-134t"
//! count = 2
//! [[vehicle]]
//! type = "wagon-coco-134t-unpowered"
//! count = 128
//! hand_brake = 0.0             # share of the hand brakes' force that is applied
//! [[vehicle]]
//! type = "locomotive-coco-134t"
//! group = 1                    # remote locomotives with commands of their own; 0: the leading ones
//! ```

use std::path::Path;

use files::{Document, Mistake};
use schemars::{JsonSchema, Schema, schema_for};
use serde::Deserialize;

/// Most vehicles a train may have.
const MOST_VEHICLES: usize = 1000;

/// Most groups of locomotives.
const MOST_GROUPS: usize = 16;

/// The vehicles of a train in order from its head.
#[derive(Clone, Debug, PartialEq)]
pub struct Consist {
    /// Name of each vehicle's type.
    pub types: Vec<String>,
    /// What else each vehicle has.
    pub members: Vec<Member>,
}

/// What a vehicle has in this train.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Member {
    /// Group whose commands it follows; 0 is the leading one.
    pub group: usize,
    /// Share of the hand brake's force that is applied, 0 to 1.
    pub hand_brake: f64,
}

/// The vehicles of a train in order from its head.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct ConsistFile {
    /// Vehicles that are the same and follow one another.
    vehicle: Vec<Block>,
}

/// Vehicles that are the same and follow one another.
#[derive(Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct Block {
    /// Name of the vehicle type in the library.
    r#type: String,
    /// Number of the vehicles.
    #[serde(default = "one")]
    count: usize,
    /// Group of locomotives whose commands they follow; 0 is the leading one.
    #[serde(default)]
    group: usize,
    /// Share of the hand brakes' force that is applied, 0 to 1.
    #[serde(default)]
    hand_brake: f64,
}

fn one() -> usize {
    1
}

impl Consist {
    /// The JSON schema of consist files.
    pub fn schema() -> Schema {
        schema_for!(ConsistFile)
    }

    /// Reads a consist file.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_file(file: &Path) -> Result<Self, Mistake> {
        Self::of(&Document::read(file)?)
    }

    /// Reads the text of a consist file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, Mistake> {
        Self::of(&Document::new(name, text))
    }

    fn of(document: &Document) -> Result<Self, Mistake> {
        let content: ConsistFile = document.parse()?;
        let check = document.check();
        let (mut types, mut members): (Vec<String>, Vec<Member>) = (vec![], vec![]);
        for (i, block) in content.vehicle.into_iter().enumerate() {
            let check = check.element("vehicle", i);
            let possible = (1..=MOST_VEHICLES - types.len()).contains(&block.count);
            let wanted = format!("must be at least 1, and {MOST_VEHICLES} in all at most");
            check.ensure(possible, "count", block.count, &wanted)?;
            check.between("hand_brake", block.hand_brake, 0.0, 1.0)?;
            let wanted = format!("must be less than {MOST_GROUPS}");
            check.ensure(block.group < MOST_GROUPS, "group", block.group, &wanted)?;
            let member = Member { group: block.group, hand_brake: block.hand_brake };
            members.extend(std::iter::repeat_n(member, block.count));
            types.extend(std::iter::repeat_n(block.r#type, block.count));
        }
        match types.is_empty() {
            true => Err(check.refuse("vehicle", "there must be at least one vehicle")),
            false => Ok(Self { types, members }),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_block_stands_for_its_count_of_vehicles() {
        let text = "vehicle = [{ type = 'loco', count = 2 }, { type = 'wagon' }]";
        let consist = Consist::from_toml(text, "consist.toml").unwrap();
        assert_eq!(consist.types, ["loco", "loco", "wagon"]);
    }

    #[test]
    fn a_count_of_zero_is_refused_with_key_and_remedy() {
        let text = "vehicle = [{ type = 'loco' }, { type = 'wagon', count = 0 }]";
        let message = Consist::from_toml(text, "c.toml").unwrap_err().to_string();
        assert!(message.starts_with("c.toml:1:57: vehicle[2].count = 0: must be at least 1"));
    }

    #[test]
    fn a_train_without_vehicles_is_refused() {
        let message = Consist::from_toml("vehicle = []", "c.toml").unwrap_err().to_string();
        assert!(message.contains("at least one vehicle"));
    }
}
