//! Who may depend on whom (docs/architecture.md).

use std::collections::BTreeSet;
use std::path::Path;

use hotfoot_tests::root;

/// Dependencies of a package as its manifest lists them.
fn dependencies(package: &str) -> BTreeSet<String> {
    let manifest = root().join(package).join("Cargo.toml");
    let text = std::fs::read_to_string(&manifest).unwrap();
    let table: toml::Table = text.parse().unwrap();
    let dependencies = table.get("dependencies").and_then(|value| value.as_table());
    dependencies.map(|table| table.keys().cloned().collect()).unwrap_or_default()
}

fn source_files(folder: &Path, found: &mut Vec<std::path::PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            source_files(&path, found);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
}

const PHYSICS: [&str; 10] = [
    "crates/numerics",
    "crates/track",
    "crates/contact",
    "crates/files",
    "crates/stock",
    "fmus/vehicle",
    "fmus/longitudinal",
    "fmus/railheat",
    "fmus/synchronisation",
    "crates/controller",
];

/// The other packages.
const OTHERS: [&str; 7] =
    ["cli", "crates/fmu", "crates/field", "crates/tools", "master", "tests", "xtask"];

#[test]
fn physics_does_not_know_the_master_nor_its_tools() {
    let forbidden = ["hotfoot", "rayon", "arrow", "parquet", "clap", "indicatif", "zarrs", "zip"];
    for package in PHYSICS {
        let dependencies = dependencies(package);
        for name in forbidden {
            assert!(!dependencies.contains(name), "{package} depends on {name}");
        }
    }
}

#[test]
fn the_master_knows_no_model() {
    let dependencies = dependencies("master");
    for model in [
        "vehicle",
        "longitudinal",
        "railheat",
        "synchronisation",
        "contact",
        "stock",
        "fmu",
        "tools",
        "cli",
        "clap",
    ] {
        assert!(!dependencies.contains(model), "the master depends on {model}");
    }
}

/// The engineering commands ask the models; they are no part of a run, and only the program uses them.
#[test]
fn the_tools_know_no_master_and_only_the_program_knows_them() {
    assert!(!dependencies("crates/tools").contains("hotfoot"));
    for package in ["master", "crates/fmu"].iter().chain(&PHYSICS) {
        for program in ["tools", "cli"] {
            assert!(!dependencies(package).contains(program), "{package} knows {program}");
        }
    }
}

#[test]
fn the_fmu_crate_knows_no_trains() {
    let dependencies = dependencies("crates/fmu");
    for name in ["track", "stock", "contact", "field", "numerics"] {
        assert!(!dependencies.contains(name), "crates/fmu depends on {name}");
    }
}

#[test]
fn only_the_field_crate_knows_zarr() {
    for package in ["master", "crates/fmu"].iter().chain(&PHYSICS) {
        assert!(!dependencies(package).contains("zarrs"), "{package} depends on zarrs");
    }
}

/// Code that is unsafe stands only at the FMI boundary: in crates/fmu, and in the importer.
#[test]
fn only_the_fmi_boundary_allows_unsafe_code() {
    let mut files = vec![];
    for folder in ["cli", "crates", "fmus", "master", "xtask"] {
        source_files(&root().join(folder), &mut files);
    }
    for file in files {
        let place = file.strip_prefix(root()).unwrap();
        let boundary = place.starts_with("crates/fmu") || place.starts_with("master/src/fmi");
        let text = std::fs::read_to_string(&file).unwrap();
        let allows = text.contains("allow(unsafe_code)");
        assert!(boundary || !allows, "{} allows unsafe code", place.display());
    }
}

/// The loop stays short enough to read on one screen, and files short enough to hold in the head.
#[test]
fn files_stay_short() {
    let mut files = vec![];
    for folder in ["cli", "crates", "fmus", "master", "xtask", "tests"] {
        source_files(&root().join(folder), &mut files);
    }
    for file in files {
        let text = std::fs::read_to_string(&file).unwrap();
        let code = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or(&text);
        let lines = code.lines().count();
        assert!(lines <= 500, "{} has {lines} lines without tests", file.display());
    }
}

/// The map of the layout in docs/architecture.md names every package.
#[test]
fn the_map_names_every_package() {
    let map = std::fs::read_to_string(root().join("docs/architecture.md")).unwrap();
    for package in PHYSICS.iter().chain(&OTHERS) {
        assert!(
            map.contains(&format!("`{package}`")),
            "docs/architecture.md does not name {package}"
        );
    }
}

/// Cargo builds no test program of a target with `test = false` and runs no examples of a library with
/// `doctest = false`, which saves time where there are none.
#[test]
fn no_test_stands_where_none_is_run() {
    let of_models = ["vehicle", "longitudinal", "railheat", "synchronisation"];
    let of_models = of_models.map(|model| format!("fmus/{model}/fmu"));
    let packages = PHYSICS.iter().chain(&OTHERS).map(|package| (*package).to_owned());
    for package in packages.chain(of_models) {
        let folder = root().join(&package);
        let manifest = std::fs::read_to_string(folder.join("Cargo.toml")).unwrap();
        let manifest: toml::Table = manifest.parse().unwrap();
        let runs =
            |target: &toml::Value, what| target.get(what).is_none_or(|key| key != &false.into());
        let path = |target: &toml::Value| {
            let path = target.get("path").and_then(|path| path.as_str());
            folder.join(path.unwrap_or("src/lib.rs"))
        };
        for program in manifest.get("bin").into_iter().flat_map(|bins| bins.as_array().unwrap()) {
            assert!(runs(program, "test") || !has_test(&path(program)), "{package}: {program}");
        }
        let Some(library) = manifest.get("lib") else { continue };
        let mut files = vec![];
        source_files(path(library).parent().unwrap(), &mut files);
        for file in files {
            assert!(runs(library, "test") || !has_test(&file), "{}", file.display());
            assert!(runs(library, "doctest") || !has_example(&file), "{}", file.display());
        }
    }
}

fn has_test(file: &Path) -> bool {
    let text = std::fs::read_to_string(file).unwrap();
    text.lines().any(|line| line.trim() == "#[test]")
}

/// Whether a doc comment has a code block without a language, which is Rust.
fn has_example(file: &Path) -> bool {
    let text = std::fs::read_to_string(file).unwrap();
    let comments = text.lines().filter_map(|line| {
        let line = line.trim();
        line.strip_prefix("//!").or(line.strip_prefix("///"))
    });
    let mut fences = comments.map(str::trim).filter(|line| line.starts_with("```"));
    // Every other fence closes a block.
    let begins = std::iter::from_fn(|| {
        let begin = fences.next();
        fences.next();
        begin
    });
    begins.into_iter().any(|begin| begin == "```")
}
