//! Where the FMUs of a structure are called, and the loading of those that run in this process.

use std::collections::BTreeMap;
use std::sync::Arc;

use super::import::{Import, ImportError};
use crate::system::structure::{Component, Home};

/// Stands for all components where those that are to be isolated are named.
const ALL: &str = "all";

/// Puts the components of these names into processes of their own, or all if one is `all`.
///
/// `is_fmu` tells which components are FMUs.
///
/// # Errors
/// A sentence if there is no such FMU.
pub fn isolate(
    components: &mut [Component],
    names: &[String],
    is_fmu: impl Fn(&Component) -> bool,
) -> Result<(), String> {
    let fmus = || components.iter().filter(|component| is_fmu(component));
    for name in names {
        if name != ALL && !fmus().any(|component| component.name == *name) {
            let known: Vec<_> = fmus().map(|component| component.name.as_str()).collect();
            let known = known.join(", ");
            return Err(format!(
                "--isolate {name}: there is no such FMU; there are {known}, and all"
            ));
        }
    }
    for component in components.iter_mut().filter(|component| is_fmu(component)) {
        if names.iter().any(|name| name == ALL || *name == component.name) {
            component.schedule.home = Home::OwnProcess;
        }
    }
    Ok(())
}

/// Loads the FMUs that run in this process.
///
/// Of one that allows one instance a process each runs in its own where there are several. Gives what the
/// user should know, in sentences.
///
/// # Errors
/// When a binary cannot be loaded.
pub fn load<'i>(
    components: &mut [Component],
    import: impl Fn(&Component) -> Option<&'i Arc<Import>>,
) -> Result<Vec<String>, ImportError> {
    let mut here: BTreeMap<&str, (&Import, Vec<&mut Component>)> = BTreeMap::new();
    for component in components {
        let Some(import) = import(component) else { continue };
        if component.schedule.home != Home::OwnProcess {
            let (_, instances) = here.entry(import.file()).or_insert((import, vec![]));
            instances.push(component);
        }
    }
    let mut notes = vec![];
    for (file, (import, instances)) in here {
        if !import.interface().once_per_process || instances.len() == 1 {
            import.load()?;
            continue;
        }
        notes.push(format!(
            "{file} allows only one instance in a process (canBeInstantiatedOnlyOncePerProcess): its {} \
             instances run in processes of their own",
            instances.len()
        ));
        for component in instances {
            component.schedule.home = Home::OwnProcess;
        }
    }
    Ok(notes)
}
