//! The map of the layout names every package, and no file that does not exist.

use std::path::Path;

use crate::breach::Breach;
use crate::workspace::Workspace;

const MAP: &str = "docs/architecture.md";

/// Packages that the map leaves out, and names on it of files that do not exist.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let map = workspace.text(MAP);
    let mut found = vec![];
    for package in &workspace.packages {
        let folder = package.folder.display().to_string();
        // The cdylib of every model stands on the map once.
        let wrapper = package.folder.ends_with("fmu") && package.folder.starts_with("fmus");
        if !wrapper && !map.contains(&format!("`{folder}`")) {
            found.push(Breach::new(Path::new(MAP), 0, format!("does not name `{folder}`")));
        }
    }
    for (index, line) in map.lines().enumerate() {
        for name in line.split('`').skip(1).step_by(2).filter(|name| is_path(name)) {
            if !workspace.root.join(name).exists() {
                let message = format!("`{name}` does not exist");
                found.push(Breach::new(Path::new(MAP), index + 1, message));
            }
        }
    }
    found
}

/// Whether a name in code marks is a path from the root of the repository.
fn is_path(name: &str) -> bool {
    let plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    let root = ["crates/", "fmus/", "master/", "cli/", "xtask/", "tests/", "docs/", "stock/"];
    name.chars().all(plain) && root.iter().any(|folder| name.starts_with(folder))
}
