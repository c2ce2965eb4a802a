//! The page of the roles, from their tables: what an FMU needs to fill one.

use std::fmt::Write;

use super::Role;
use super::tables::{
    RAIL_INPUT, START, TRAIN_OUTPUT, VEHICLE_INPUT, VEHICLE_OUTPUT, WHEEL, WHEELSET,
};
use super::variable::RoleVariable;
use crate::system::structure::Sampling;

/// Role, causality, prefix of the names, and variables.
const SECTIONS: [(Role, &str, &str, &[RoleVariable]); 8] = [
    (Role::Longitudinal, "parameter", "", START),
    (Role::Longitudinal, "output", "vehicle[i].", TRAIN_OUTPUT),
    (Role::Vehicle, "parameter", "", START),
    (Role::Vehicle, "input", "", VEHICLE_INPUT),
    (Role::Vehicle, "output", "", VEHICLE_OUTPUT),
    (Role::Vehicle, "output", "wheelset[j].", WHEELSET),
    (Role::Vehicle, "output", "wheelset[j].left.", WHEEL),
    (Role::Railheat, "input", "vehicle[i].wheelset[j].", RAIL_INPUT),
];

/// A table in Markdown with a row for each variable of each role.
///
/// The right wheels have the names of the left ones and are not listed.
pub fn page() -> String {
    let mut page = String::from(
        "| role | causality | variable | unit | needed | between steps of a slower unit |\n\
         |---|---|---|---|---|---|\n",
    );
    for (role, causality, prefix, variables) in SECTIONS {
        for RoleVariable { name, unit, required, sampling, .. } in variables {
            let needed = if *required { "required" } else { "optional" };
            let between = match sampling {
                _ if causality != "input" => "",
                Sampling::Mean => "mean",
                Sampling::Sum => "sum",
                Sampling::Last => "last value",
            };
            let (role, unit) = (role.name(), unit.symbol);
            let row = format!(
                "| `{role}` | {causality} | `{prefix}{name}` | {unit} | {needed} | {between} |"
            );
            let _ = writeln!(page, "{row}");
        }
    }
    page
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The README beside the published interfaces holds the page as it is.
    #[test]
    fn golden_the_published_page_is_that_of_the_tables() {
        let file = concat!(env!("CARGO_MANIFEST_DIR"), "/../modelDescription/README.md");
        let text = std::fs::read_to_string(file).unwrap();
        let page = page();
        assert!(text.contains(&page), "{file} does not hold this table:\n{page}");
    }
}
