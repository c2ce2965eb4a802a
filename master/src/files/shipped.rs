//! What is shipped: folders `fmus`, `stock` and `scenarios` beside the folder of the program.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

static HOME: OnceLock<PathBuf> = OnceLock::new();

/// Lets what is shipped lie in this folder, for programs that lie elsewhere; the first call counts.
pub fn lies_in(folder: PathBuf) {
    let _ = HOME.set(folder);
}

/// The shipped folder of that name, which may not be there.
pub fn folder(name: &str) -> PathBuf {
    HOME.get_or_init(beside_the_program).join(name)
}

/// The path of a scenario: as it is, or of the shipped one that is meant if nothing is there.
pub fn scenario(path: PathBuf) -> PathBuf {
    let shipped = folder("scenarios").join(&path);
    if !path.exists() && shipped.exists() { shipped } else { path }
}

/// The folder that holds the folder of the program.
fn beside_the_program() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    program.parent().and_then(Path::parent).unwrap_or(Path::new(".")).to_owned()
}
