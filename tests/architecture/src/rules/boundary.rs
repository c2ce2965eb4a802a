//! Code that is unsafe stands only at the FMI boundary.

use std::path::Path;

use crate::breach::Breach;
use crate::workspace::Workspace;

/// Where unsafe code is allowed: in the export and in the import of FMUs.
const BOUNDARY: [&str; 2] = ["crates/fmu", "master/src/fmi"];

/// Lines outside of the boundary that allow unsafe code.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    // Written in two parts, as this file allows none either.
    let allows = ["allow(unsafe", "_code)"].concat();
    let inside = |path: &Path| BOUNDARY.iter().any(|folder| path.starts_with(folder));
    let outside = workspace.sources().filter(|source| !inside(&source.path));
    // Tests stand for foreign programs, some of which have an allocator of their own.
    let outside = outside.filter(|source| !source.path.starts_with("tests"));
    outside
        .flat_map(|source| {
            let lines = source.text.lines().enumerate();
            let lines = lines.filter(|(_, line)| line.contains(&allows));
            lines.map(|(index, _)| Breach::new(&source.path, index + 1, "allows unsafe code"))
        })
        .collect()
}
