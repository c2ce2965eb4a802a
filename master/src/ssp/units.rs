//! Units of measurement and linear transformations as SSP files state them.

use std::collections::HashMap;

use roxmltree::Node;

use super::error::SspError;
use super::xml::{XmlFile, child, children, listed};
use crate::interface::si::{Dimension, Linear, SiUnit};

/// The linear transformation of a connection or of a mapping.
///
/// # Errors
/// When there is a transformation of another kind, or its numbers are none.
pub fn transformation(file: &XmlFile<'_>, node: Node<'_, '_>) -> Result<Linear, SspError> {
    let other = node.children().find(|child| {
        let name = child.tag_name().name();
        name.ends_with("MappingTransformation")
    });
    if let Some(other) = other {
        let message = format!(
            "{} is not supported; Hotfoot knows LinearTransformation",
            other.tag_name().name()
        );
        return Err(file.wrong(other, message));
    }
    let Some(linear) = child(node, "LinearTransformation") else {
        return Ok(Linear::IDENTITY);
    };
    Ok(Linear {
        factor: file.value(linear, "factor")?.unwrap_or(1.0),
        offset: file.value(linear, "offset")?.unwrap_or(0.0),
    })
}

/// The units that a structure or parameter set defines.
///
/// # Errors
/// When an attribute is wrong.
pub fn units(file: &XmlFile<'_>, root: Node<'_, '_>) -> Result<HashMap<String, SiUnit>, SspError> {
    let mut units = HashMap::new();
    for unit in listed(root, "Units", "Unit") {
        let Some(base) = children(unit, "BaseUnit").next() else { continue };
        let mut exponents = [0; 7];
        for (exponent, symbol) in exponents.iter_mut().zip(["kg", "m", "s", "A", "K", "mol", "cd"])
        {
            *exponent = file.value(base, symbol)?.unwrap_or(0);
        }
        let to_base = Linear {
            factor: file.value(base, "factor")?.unwrap_or(1.0),
            offset: file.value(base, "offset")?.unwrap_or(0.0),
        };
        if !to_base.factor.is_normal() {
            return Err(file.wrong(base, "the factor of a unit must not be zero"));
        }
        let si = SiUnit { dimension: Dimension(exponents), to_base };
        units.insert(file.required(unit, "name")?.to_owned(), si);
    }
    Ok(units)
}
