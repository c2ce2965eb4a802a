//! Who may depend on whom.

use std::collections::BTreeSet;
use std::path::Path;

use crate::breach::Breach;
use crate::workspace::{Package, Workspace};

/// Packages that compute: they know nothing of results, threads and terminals.
pub const PHYSICS: &[&str] = &[
    "crates/numerics",
    "crates/track",
    "crates/contact",
    "crates/stock",
    "crates/controller",
    "fmus/vehicle",
    "fmus/longitudinal",
    "fmus/railheat",
    "fmus/synchronisation",
];

const MODELS: &[&str] = &["vehicle", "longitudinal", "railheat", "synchronisation"];

/// What stands around a run, and reads and writes its files.
const OUTSIDE: &[&str] = &[
    "hotfoot",
    "cli",
    "tools",
    "arrow",
    "arrow-array",
    "arrow-schema",
    "clap",
    "indicatif",
    "parquet",
    "rayon",
    "zarrs",
    "zip",
];

/// A line of the table: these packages do not depend on those, and why.
struct Forbidden {
    packages: &'static [&'static str],
    dependencies: &'static [&'static [&'static str]],
    reason: &'static str,
}

const FORBIDDEN: &[Forbidden] = &[
    Forbidden {
        packages: PHYSICS,
        dependencies: &[OUTSIDE],
        reason: "physics knows nothing of the master, of results, threads and terminals",
    },
    Forbidden {
        packages: &["master"],
        dependencies: &[MODELS, &["contact", "stock", "fmu", "tools", "cli"]],
        reason: "the master knows FMUs only by their interface",
    },
    Forbidden {
        packages: &["master"],
        dependencies: &[&["clap", "zarrs"]],
        reason: "the library reads no command line, and only crates/field knows Zarr",
    },
    Forbidden {
        packages: &["crates/tools"],
        dependencies: &[&["hotfoot", "cli"]],
        reason: "the engineering commands ask the models and are no part of a run",
    },
    Forbidden {
        packages: &["python/native"],
        dependencies: &[MODELS, &["cli", "tools", "field", "track", "stock", "contact"]],
        reason: "Python gets the master's open system and nothing else",
    },
    Forbidden {
        packages: &["crates/fmu"],
        dependencies: &[&["track", "stock", "contact", "field", "controller"], OUTSIDE],
        reason: "the export of FMUs knows no trains",
    },
    Forbidden {
        packages: &["crates/files", "crates/validation", "crates/field", "crates/numerics"],
        dependencies: &[MODELS, &["contact", "stock", "track", "hotfoot", "tools"]],
        reason: "a package that all may use stands below them",
    },
];

/// Dependencies that the table forbids.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    workspace.packages.iter().flat_map(forbidden).collect()
}

fn forbidden(package: &Package) -> Vec<Breach> {
    let manifest = package.folder.join("Cargo.toml");
    let has = dependencies(package);
    let mut found = vec![];
    for rule in FORBIDDEN
        .iter()
        .filter(|rule| rule.packages.iter().any(|folder| Path::new(folder) == package.folder))
    {
        for name in rule.dependencies.iter().copied().flatten().filter(|name| has.contains(**name))
        {
            let message = format!("depends on {name}, but {}", rule.reason);
            found.push(Breach::new(&manifest, 0, message));
        }
    }
    found
}

/// Names of what a package needs to be built, not of what its tests need.
fn dependencies(package: &Package) -> BTreeSet<&str> {
    let table = package.manifest.get("dependencies").and_then(|value| value.as_table());
    table.into_iter().flat_map(|table| table.keys()).map(String::as_str).collect()
}
