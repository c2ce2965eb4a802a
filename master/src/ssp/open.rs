//! From a structure to the FMUs of its package, ready to run.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::error::SspError;
use super::package::path_of;
use crate::fmi::{self, Import, Manner, Origins, homes, with_resource_paths};
use crate::system::clock::Clock;
use crate::system::compile::{CompileError, compile};
use crate::system::step::System;
use crate::system::structure::{Component, Structure};
use crate::system::substitute::{self, Substitutes};
use crate::system::unit::Unit;

/// The FMUs of a structure by the `source` of their components.
pub type Imports = BTreeMap<String, Arc<Import>>;

/// Instantiates the FMUs of a structure that are not substituted, sets their parameters, and links
/// them; `file` is the package's name for messages.
///
/// # Errors
/// When an FMU cannot be used, or the structure does not fit the FMUs.
pub fn open(
    structure: &Structure,
    imports: &Imports,
    file: &str,
    clock: Clock,
    substitutes: &mut Substitutes,
) -> Result<System, SspError> {
    let structure = with_resource_paths(structure, |component| imports.get(&component.source));
    let unit = |component: &Component| -> Result<Box<dyn Unit>, SspError> {
        let import = &imports[&component.source];
        let (home, tolerance) = (component.schedule.home, structure.tolerance);
        let manner = Manner { home, tolerance, ..Manner::default() };
        Ok(fmi::unit(import, &component.name, manner)?)
    };
    let mut units = structure.components.iter().map(unit).collect::<Result<Vec<_>, _>>()?;
    substitute::replace(&mut units, substitutes);
    compile(&structure, units, clock).map_err(|error| match error {
        CompileError::Unit(error) => error.into(),
        CompileError::Unfit(problems) => SspError::Unfit { file: file.to_owned(), problems },
    })
}

/// Every FMU once, however many components use it, without running its code.
///
/// `package` is the folder of the unpacked package.
///
/// # Errors
/// When one is missing or cannot be used.
pub fn imports(structure: &Structure, package: &Path, file: &str) -> Result<Imports, SspError> {
    let unfit = |problem| SspError::Unfit { file: file.to_owned(), problems: vec![problem] };
    let mut sources: BTreeMap<PathBuf, Vec<&str>> = BTreeMap::new();
    for Component { source, .. } in &structure.components {
        let path = path_of(package, source);
        let path = path.ok_or_else(|| {
            unfit(format!("source=\"{source}\" must be a path inside of the package"))
        })?;
        sources.entry(path).or_default().push(source);
    }
    let mut imports = Imports::new();
    for (path, sources) in sources {
        let import = Import::unpack(&path, Origins::default())?;
        for source in sources {
            imports.insert(source.to_owned(), Arc::clone(&import));
        }
    }
    Ok(imports)
}

/// Loads the FMUs that run in this process.
///
/// Those of components in `isolated` and those that need it run in processes of their own.
///
/// # Errors
/// When there is no component of that name, or an FMU cannot be loaded.
pub fn settle(
    structure: &mut Structure,
    imports: &Imports,
    isolated: &[String],
    file: &str,
) -> Result<(), SspError> {
    let Structure { components, notes, .. } = structure;
    let unfit = |problem| SspError::Unfit { file: file.to_owned(), problems: vec![problem] };
    homes::isolate(components, isolated, |_| true).map_err(unfit)?;
    notes.extend(homes::load(components, |component| imports.get(&component.source))?);
    Ok(())
}

/// Takes the start values out of a structure for which there are no variables, which SSP 1.0 wants
/// ignored, and says so.
pub fn leave_out_unmatched(structure: &mut Structure, imports: &Imports) {
    let Structure { components, notes, .. } = structure;
    for Component { name, source, parameters, .. } in components {
        let interface = imports[source].interface();
        parameters.retain(|parameter| {
            let known = interface.variable(&parameter.name).is_some();
            if !known {
                notes.push(format!(
                    "'{name}.{}' has a start value, but {source} has no such variable; it is ignored",
                    parameter.name
                ));
            }
            known
        });
    }
}
