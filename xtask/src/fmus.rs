//! Building and packing the FMUs.

use std::path::{Path, PathBuf};

use anyhow::{Context, Result, bail};

use crate::shell::{cargo, hotfoot, output, run, target};

/// The pages on the vehicle and its contacts, in the order of reading.
const VEHICLE: &[&str] = &[
    "vehicle/README.md",
    "vehicle/frames.md",
    "vehicle/suspension.md",
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
    let packages = MODELS.iter().flat_map(|(model, _)| ["-p".to_owned(), format!("{model}-fmu")]);
    run(cargo().args(["build", "--release", "-p", "cli"]).args(packages))?;
    pack()
}

/// Packs the FMUs from their binaries into `target/fmus`: those that have default resources, with
/// them and the stock library.
pub fn pack() -> Result<()> {
    let folder = target().join("fmus");
    std::fs::create_dir_all(&folder).with_context(|| folder.display().to_string())?;
    for (model, theory) in MODELS {
        let library = format!(
            "release/{}{model}_fmu{}",
            std::env::consts::DLL_PREFIX,
            std::env::consts::DLL_SUFFIX
        );
        let mut pack = hotfoot();
        pack.arg("pack").arg(target().join(library));
        let resources = Path::new("fmus").join(model).join("resources");
        if resources.exists() {
            pack.arg("--resources").arg(resources).args(["--stock", "stock"]);
        }
        for text in theory {
            pack.arg("--theory").arg(Path::new("docs/theory").join(text));
        }
        pack.arg("--reference").arg(format!("fmus/{model}/reference"));
        run(pack.arg("--output").arg(fmu(model)))?;
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
