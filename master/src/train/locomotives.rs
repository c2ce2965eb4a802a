//! Which vehicles of a train are locomotives, whether they pull or coast: by their files.

use std::path::PathBuf;

use crate::scenario::Scenario;

/// The table of a vehicle's file that only those with traction have.
const TRACTION: &str = "traction";

/// The list of what a vehicle's file leaves out of the one that it extends.
const WITHOUT: &str = "without";

/// Vehicles that extend one another in a row, at most; the models refuse more.
const LONGEST_CHAIN: usize = 16;

/// Numbers from one, from the head of the train, of the vehicles with traction.
pub fn locomotives(scenario: &Scenario) -> Vec<usize> {
    let file_of = |kind: &str| scenario.vehicle_file(kind);
    let groups = scenario.train.vehicles.iter();
    let of_group = |group: &crate::scenario::VehicleGroup| {
        std::iter::repeat_n(has_traction(file_of, &group.kind), group.count)
    };
    let numbered = (1..).zip(groups.flat_map(of_group));
    numbered.filter(|(_, has_traction)| *has_traction).map(|(number, _)| number).collect()
}

/// Whether a vehicle type, or one that it extends, has traction. A file that cannot be read is answered
/// by the models.
fn has_traction(file_of: impl Fn(&str) -> PathBuf, kind: &str) -> bool {
    let mut kind = kind.to_owned();
    for _ in 0..LONGEST_CHAIN {
        let text = std::fs::read_to_string(file_of(&kind)).unwrap_or_default();
        let Ok(table) = text.parse::<toml::Table>() else { return false };
        if table.contains_key(TRACTION) {
            return true;
        }
        let without = table.get(WITHOUT).and_then(toml::Value::as_array);
        if without.is_some_and(|list| list.iter().any(|name| name.as_str() == Some(TRACTION))) {
            return false;
        }
        let Some(extends) = table.get("extends").and_then(toml::Value::as_str) else {
            return false;
        };
        extends.clone_into(&mut kind);
    }
    false
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_vehicle_has_traction_if_its_file_or_one_that_it_extends_says_so() {
        let folder = tempfile::tempdir().unwrap();
        for (kind, text) in [
            ("diesel", "[traction]\npower_kw = 3207.0\n"),
            ("diesel-air", "extends = \"diesel\"\n"),
            ("diesel-towed", "extends = \"diesel-air\"\nwithout = [\"traction\"]\n"),
            ("wagon-27.5t", "mass_kg = 27500.0\n"),
            ("circle", "extends = \"circle\"\n"),
        ] {
            std::fs::write(folder.path().join(format!("{kind}.toml")), text).unwrap();
        }
        let file_of = |kind: &str| folder.path().join(kind).with_added_extension("toml");
        let found = |kind| has_traction(file_of, kind);
        assert!(found("diesel") && found("diesel-air"));
        assert!(
            !found("diesel-towed")
                && !found("wagon-27.5t")
                && !found("circle")
                && !found("missing")
        );
    }
}
