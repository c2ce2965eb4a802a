//! The Python package: as it is installed, and packed as a wheel.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::fmus;
use crate::python::{self, Environment};
use crate::shell::{cargo, run, target};

/// The oldest Linux that the wheel is for.
const PLATFORM: &str = "x86_64-unknown-linux-gnu";
/// Its C library.
const GLIBC: &str = "2.28";

/// The environment with zig, which links for an old C library, and with what packs wheels.
const TOOLS: Environment =
    Environment { folder: "wheel-tools", requirements: "python/wheel/requirements.txt" };

/// Folder in which the package lies as it is installed, for tests and scripts.
fn staged() -> PathBuf {
    target().join("package")
}

/// Lays the package out from what `cargo build --release` and the packing of the FMUs have made.
pub fn stage() -> Result<()> {
    lay_out(&target().join("release"), &target().join("fmus"), &staged())
}

/// Lays the package out, and calls a script that reads these results by it.
pub fn read_by(script: &str, results: &Path) -> Result<()> {
    stage()?;
    run(Command::new(python::TESTS.interpreter()?)
        .arg(script)
        .arg(results)
        .env("PYTHONPATH", staged()))
}

/// Builds the wheel into `target/wheel` and gives its path.
pub fn wheel() -> Result<PathBuf> {
    let python = TOOLS.interpreter()?;
    let packages = ["cli".to_owned(), "hotfoot-python".to_owned()].into_iter();
    let packages = packages.chain(fmus::packages()).flat_map(|name| ["-p".to_owned(), name]);
    // Cargo finds its command zigbuild beside the interpreter, and that finds zig as its package.
    let tools = python.parent().context("an interpreter has a folder")?;
    let path = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(
        std::iter::once(std::path::absolute(tools)?).chain(std::env::split_paths(&path)),
    )?;
    run(cargo()
        .args(["zigbuild", "--release", "--target", &format!("{PLATFORM}.{GLIBC}")])
        .args(packages)
        .env("PATH", path)
        .env("CARGO_PROFILE_RELEASE_STRIP", "symbols"))?;
    let (binaries, folder) = (target().join(PLATFORM).join("release"), target().join("wheel"));
    let (content, fmus) = (folder.join("content"), folder.join("fmus"));
    fmus::pack(&binaries, &fmus)?;
    lay_out(&binaries, &fmus, &content)?;
    describe(&content)?;
    for old in fs::read_dir(&folder)? {
        let old = old?.path();
        if old.extension().is_some_and(|extension| extension == "whl") {
            fs::remove_file(old)?;
        }
    }
    run(Command::new(python)
        .args(["-m", "wheel", "pack"])
        .arg(&content)
        .arg("--dest-dir")
        .arg(&folder))?;
    let wheel = folder.join(format!("{}-{}.whl", name_and_version(), tag()));
    let size = fs::metadata(&wheel).with_context(|| wheel.display().to_string())?.len();
    println!("{}: {:.1} MB", wheel.display(), size as f64 / 1e6);
    Ok(wheel)
}

/// Builds the wheel and tries it in an environment of its own, in which there is no Rust.
pub fn test_wheel() -> Result<()> {
    let wheel = std::path::absolute(wheel()?)?;
    let python = python::TESTS.interpreter()?;
    run(Command::new(python)
        .args(["-m", "pytest", "-q", "-s", "tests/wheel"])
        .env("HOTFOOT_WHEEL", wheel))
}

/// Lays the package out in a folder, with program, module and FMUs from these folders.
fn lay_out(binaries: &Path, fmus: &Path, folder: &Path) -> Result<()> {
    if folder.exists() {
        fs::remove_dir_all(folder).with_context(|| folder.display().to_string())?;
    }
    let package = folder.join("hotfoot");
    copy(Path::new("python/hotfoot"), &package)?;
    for name in ["stock", "scenarios"] {
        copy(Path::new(name), &package.join(name))?;
    }
    copy(fmus, &package.join("fmus"))?;
    let program = format!("hotfoot{}", std::env::consts::EXE_SUFFIX);
    let (prefix, suffix) = (std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
    let module = format!("{prefix}hotfoot_python{suffix}");
    copy(&binaries.join(&program), &package.join("bin").join(program))?;
    copy(&binaries.join(module), &package.join("_native.abi3.so"))
}

/// What a wheel says of itself: `python/wheel` with the version, and the script that starts the program.
fn describe(content: &Path) -> Result<()> {
    let version = env!("CARGO_PKG_VERSION");
    let information = content.join(format!("{}.dist-info", name_and_version()));
    for name in ["METADATA", "WHEEL"] {
        let text = fs::read_to_string(Path::new("python/wheel").join(name))?;
        let text = text.replace("@VERSION@", version).replace("@TAG@", &tag());
        write(&information.join(name), &text)?;
    }
    for name in ["LICENSE-APACHE", "LICENSE-MIT"] {
        copy(Path::new(name), &information.join("licenses").join(name))?;
    }
    let scripts = content.join(format!("{}.data/scripts", name_and_version()));
    copy(Path::new("python/wheel/hotfoot"), &scripts.join("hotfoot"))
}

fn name_and_version() -> String {
    format!("hotfoot-{}", env!("CARGO_PKG_VERSION"))
}

/// The Pythons and machines that the wheel is for.
///
/// The Python is that of pyo3's feature `abi3-py311`: zarr 3, whose format the fields have, runs on no older one.
fn tag() -> String {
    format!("cp311-abi3-manylinux_{}_x86_64", GLIBC.replace('.', "_"))
}

fn write(file: &Path, text: &str) -> Result<()> {
    fs::create_dir_all(file.parent().context("a file has a folder")?)?;
    fs::write(file, text).with_context(|| file.display().to_string())
}

/// Copies a file or a folder, without what Python has compiled.
fn copy(from: &Path, to: &Path) -> Result<()> {
    if from.file_name().is_some_and(|name| name == "__pycache__") {
        return Ok(());
    }
    if from.is_dir() {
        fs::create_dir_all(to)?;
        for entry in fs::read_dir(from)? {
            let entry = entry?;
            copy(&entry.path(), &to.join(entry.file_name()))?;
        }
        return Ok(());
    }
    fs::create_dir_all(to.parent().context("a file has a folder")?)?;
    fs::copy(from, to).map(|_| ()).with_context(|| from.display().to_string())
}
