//! Building and packing the FMUs.

use std::path::{Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result, bail};

use crate::shell::{cargo, hotfoot, output, run, target};

/// The pages on the vehicle and its contacts, in the order of reading.
const VEHICLE: &[&str] = &[
    "vehicle/README.md",
    "vehicle/frames.md",
    "vehicle/suspension.md",
    "vehicle/profiles.md",
    "vehicle/contact-geometry.md",
    "vehicle/hertz.md",
    "vehicle/creep.md",
    "vehicle/wheel.md",
    "vehicle/rails.md",
    "vehicle/step.md",
    "vehicle/start.md",
    "vehicle/outputs.md",
    "vehicle/linear.md",
];

/// The models that become FMUs, with their equations in `docs/theory`.
const MODELS: [(&str, &[&str]); 4] = [
    ("vehicle", VEHICLE),
    ("longitudinal", &["longitudinal.md"]),
    ("railheat", &["railheat/README.md", "railheat/paper.md", "railheat/energy.md"]),
    ("synchronisation", &["synchronisation.md"]),
];

/// Builds the program and the FMUs' binaries in release, and packs the FMUs.
pub fn build() -> Result<()> {
    let packages = packages().flat_map(|name| ["-p".to_owned(), name]);
    run(cargo().args(["build", "--release", "-p", "cli"]).args(packages))?;
    pack_built()
}

/// Names of the packages whose libraries are the FMUs' binaries.
pub fn packages() -> impl Iterator<Item = String> {
    MODELS.iter().map(|(model, _)| format!("{model}-fmu"))
}

/// Packs the FMUs into `target/fmus`, with rolling stock and scenarios beside them, where the program
/// looks for all three.
pub fn pack_built() -> Result<()> {
    for name in ["stock", "scenarios"] {
        beside(name)?;
    }
    pack(&target().join("release"), &target().join("fmus"))
}

/// Lets a folder of the repository be found in `target` too.
fn beside(name: &str) -> Result<()> {
    let link = target().join(name);
    if cfg!(unix) && !link.exists() {
        let _ = std::fs::remove_file(&link);
        #[cfg(unix)]
        std::os::unix::fs::symlink(std::path::absolute(name)?, &link)
            .with_context(|| link.display().to_string())?;
    }
    Ok(())
}

/// Packs the FMUs with the program and from the libraries in `binaries` into a folder: those that have
/// default resources, with them and the stock library.
pub fn pack(binaries: &Path, folder: &Path) -> Result<()> {
    std::fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    for (model, theory) in MODELS {
        let library =
            format!("{}{model}_fmu{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
        let mut pack = Command::new(binaries.join("hotfoot"));
        pack.arg("pack").arg(binaries.join(library));
        let resources = Path::new("fmus").join(model).join("resources");
        if resources.exists() {
            pack.arg("--resources").arg(resources).args(["--stock", "stock"]);
        }
        for text in theory {
            pack.arg("--theory").arg(Path::new("docs/theory").join(text));
        }
        pack.arg("--reference").arg(format!("fmus/{model}/reference"));
        run(pack.arg("--output").arg(folder.join(format!("{model}.fmu"))))?;
    }
    Ok(())
}

/// Path of a packed FMU.
pub fn fmu(model: &str) -> PathBuf {
    target().join(format!("fmus/{model}.fmu"))
}

/// Writes the model descriptions of the packed FMUs into `modelDescription`.
pub fn write_model_descriptions() -> Result<()> {
    for (model, _) in MODELS {
        let file = published(model);
        std::fs::write(&file, model_description(model)?)
            .with_context(|| file.display().to_string())?;
    }
    Ok(())
}

/// Fails if a published model description differs from that of the packed FMU.
pub fn check_model_descriptions() -> Result<()> {
    for (model, _) in MODELS {
        let file = published(model);
        let text = std::fs::read_to_string(&file).with_context(|| file.display().to_string())?;
        if text != model_description(model)? {
            bail!(
                "{} is not current: run `cargo xtask model-descriptions` and commit the result",
                file.display()
            );
        }
    }
    Ok(())
}

fn published(model: &str) -> PathBuf {
    format!("modelDescription/{model}.xml").into()
}

fn model_description(model: &str) -> Result<String> {
    output(hotfoot().args(["interface", "--xml"]).arg(fmu(model)))
}
