//! The GUID: a fingerprint of the interface, so that a stale model description is noticed.

use std::fmt;

use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

use super::variable::{Causality, Initial, Kind, Variability, Variable};

/// The first 128 bits of the SHA-256 of an interface.
///
/// Names, value references, types, causalities, units, bounds and start values go into it;
/// descriptions do not, since correcting one changes nothing for who uses the FMU.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Guid([u8; 16]);

/// What of a variable goes into the GUID.
#[derive(Serialize)]
struct Fingerprint<'a>(&'a str, u32, Causality, Variability, Option<Initial>, &'a Kind);

impl Guid {
    /// The GUID of the interface with these variables.
    pub(crate) fn of(identifier: &str, variables: &[Variable]) -> Self {
        let fingerprints: Vec<_> = variables.iter().map(fingerprint).collect();
        let bytes = postcard::to_allocvec(&(identifier, fingerprints))
            .expect("plain data can always be serialized");
        let hash = Sha256::digest(bytes);
        Self(std::array::from_fn(|index| hash[index]))
    }
}

fn fingerprint(variable: &Variable) -> Fingerprint<'_> {
    Fingerprint(
        &variable.name,
        variable.reference,
        variable.causality,
        variable.variability,
        variable.initial,
        &variable.kind,
    )
}

impl fmt::Display for Guid {
    /// Writes `{xxxxxxxx-xxxx-xxxx-xxxx-xxxxxxxxxxxx}`.
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("{")?;
        for (index, byte) in self.0.iter().enumerate() {
            if matches!(index, 4 | 6 | 8 | 10) {
                formatter.write_str("-")?;
            }
            write!(formatter, "{byte:02x}")?;
        }
        formatter.write_str("}")
    }
}

#[cfg(test)]
mod tests {
    use super::super::declaration::Declaration;
    use super::super::unit;
    use super::*;

    fn guid(name: &str, description: &str, start: f64) -> Guid {
        let mut declaration = Declaration::default();
        let _ = declaration.real(name, unit::KILOGRAM, description).parameter(start);
        Guid::of("model", declaration.variables())
    }

    #[test]
    fn a_guid_has_the_usual_form() {
        let text = guid("mass", "Mass", 1.0).to_string();
        let groups: Vec<usize> = text.split('-').map(str::len).collect();
        assert_eq!(groups, [9, 4, 4, 4, 13], "{text}");
    }

    #[test]
    fn the_interface_decides_and_descriptions_do_not() {
        let original = guid("mass", "Mass", 1.0);
        assert_eq!(original, guid("mass", "Mass of the car", 1.0));
        assert_ne!(original, guid("weight", "Mass", 1.0));
        assert_ne!(original, guid("mass", "Mass", 2.0));
    }
}
