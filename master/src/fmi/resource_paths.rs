//! Texts that name files in an FMU's own resources.

use std::path::Path;
use std::sync::Arc;

use super::import::Import;
use crate::system::structure::{Component, Parameter, Structure, Value};

/// The structure with paths instead of texts that name a file in the resources of their FMU, as an FMU
/// takes a path that begins nowhere for one from the folder in which the program runs.
pub fn with_resource_paths<'i>(
    structure: &Structure,
    import: impl Fn(&Component) -> Option<&'i Arc<Import>>,
) -> Structure {
    let mut structure = structure.clone();
    for component in &mut structure.components {
        let Some(import) = import(component) else { continue };
        for Parameter { value, .. } in &mut component.parameters {
            let Value::Text(text) = value else { continue };
            let file = import.resources().join(Path::new(text.as_str()));
            if !text.is_empty() && file.is_file() {
                *text = file.display().to_string();
            }
        }
    }
    structure
}
