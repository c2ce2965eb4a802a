//! From a structure to the FMUs of its package, ready to run.

use std::collections::BTreeMap;
use std::path::{Component as PathPart, Path};
use std::sync::Arc;

use percent_encoding::percent_decode_str;

use super::error::SspError;
use crate::fmi::{self, Import, Manner, with_resource_paths};
use crate::system::clock::Clock;
use crate::system::compile::{CompileError, compile};
use crate::system::step::System;
use crate::system::structure::{Component, Structure};
use crate::system::unit::Unit;

/// Instantiates the FMUs of a structure, sets their parameters, and links them.
///
/// `package` is the folder of the unpacked package, `file` its name for messages.
///
/// # Errors
/// When an FMU cannot be used, or the structure does not fit the FMUs.
pub fn open(
    structure: &Structure,
    package: &Path,
    file: &str,
    clock: Clock,
) -> Result<System, SspError> {
    let imports = imports(structure, package, file)?;
    let structure =
        with_resource_paths(structure, |component| imports.get(component.source.as_str()));
    let unit = |component: &Component| -> Result<Box<dyn Unit>, SspError> {
        let import = &imports[component.source.as_str()];
        let same_thread = component.schedule.same_thread;
        let manner = Manner { same_thread, ..Manner::default() };
        Ok(fmi::unit(import, &component.name, manner)?)
    };
    let units = structure.components.iter().map(unit).collect::<Result<_, _>>()?;
    compile(&structure, units, clock).map_err(|error| match error {
        CompileError::Unit(error) => error.into(),
        CompileError::Unfit(problems) => SspError::Unfit { file: file.to_owned(), problems },
    })
}

/// Every FMU once, however many components use it.
fn imports<'s>(
    structure: &'s Structure,
    package: &Path,
    file: &str,
) -> Result<BTreeMap<&'s str, Arc<Import>>, SspError> {
    let unfit = |problem| SspError::Unfit { file: file.to_owned(), problems: vec![problem] };
    let mut counts: BTreeMap<&str, usize> = BTreeMap::new();
    for component in &structure.components {
        *counts.entry(&component.source).or_default() += 1;
    }
    let mut imports = BTreeMap::new();
    for (source, count) in counts {
        let path = percent_decode_str(source).decode_utf8_lossy().into_owned();
        let inside = Path::new(&path).components().all(|part| matches!(part, PathPart::Normal(_)));
        if !inside {
            return Err(unfit(format!("source=\"{source}\" must be a path inside of the package")));
        }
        let import = Import::open(&package.join(path))?;
        if import.interface().once_per_process && count > 1 {
            return Err(unfit(format!(
                "{source} allows only one instance in a process \
                 (canBeInstantiatedOnlyOncePerProcess), but {count} components use it"
            )));
        }
        imports.insert(source, import);
    }
    Ok(imports)
}
