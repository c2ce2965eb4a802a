//! The files of a reference result inside of an FMU.

use std::path::{Path, PathBuf};

use roxmltree::Document;

use super::experiment::Experiment;
use super::table::Table;
use super::{ReferenceError, run};
use crate::files::archive;
use crate::files::file_error::FileError;
use crate::fmi::{Import, read_interface};

/// Folder inside of an FMU.
const FOLDER: &str = "extra/org.fmi-standard.fmi-ls-ref";
/// Lists the files.
const MANIFEST: &str = "fmi-ls-manifest.xml";
/// Experiment: in the FMU, and in the folder that it is packed from.
const EXPERIMENT: &str = "experiment.toml";
/// Inputs, likewise.
const INPUTS: &str = "in.csv";
/// Result.
const RESULT: &str = "ref.csv";

/// The reference result of an FMU.
#[derive(Debug)]
pub struct Reference {
    /// How it was made.
    pub experiment: Experiment,
    /// The inputs over time.
    pub inputs: Table,
    /// The outputs over time.
    pub result: Table,
    /// Signals of the result that the FMU does not have, as where it is of another version of FMI.
    pub left_out: Vec<String>,
}

impl Reference {
    /// Reads the reference result of an FMU.
    ///
    /// # Errors
    /// When the FMU has no reference result, or a file of it cannot be read.
    pub fn of(fmu: &Path) -> Result<Self, ReferenceError> {
        let folder = tempfile::tempdir().map_err(FileError::at(fmu))?;
        archive::unpack(fmu, folder.path()).map_err(|error| ReferenceError::content(fmu, error))?;
        let files = folder.path().join(FOLDER);
        let manifest = files.join(MANIFEST);
        let text =
            std::fs::read_to_string(&manifest).map_err(|_| ReferenceError::None(fmu.to_owned()))?;
        let document =
            Document::parse(&text).map_err(|error| ReferenceError::content(&manifest, error))?;
        let file = |role: &str| -> Option<PathBuf> {
            let mut related = document.descendants().filter(|node| node.has_tag_name("Related"));
            let found = related.find(|related| related.attribute("role") == Some(role))?;
            // Only the name counts: a manifest must not lead out of its folder.
            Some(files.join(Path::new(found.attribute("source")?).file_name()?))
        };
        let result = file("result").ok_or_else(|| ReferenceError::None(fmu.to_owned()))?;
        let interface = read_interface(folder.path(), &fmu.display().to_string())?;
        let mut result = Table::read(&result, &interface)?;
        let inputs = file("input")
            .map_or_else(|| Ok(Table::default()), |file| Table::read(&file, &interface))?;
        if let Some(file) = file("experiment") {
            let experiment = Experiment::read(&file)?;
            return Ok(Self { experiment, inputs, result, left_out: vec![] });
        }
        let known = |name: &str| interface.variable(name).is_some();
        let left_out = result.names().into_iter().filter(|name| !known(name)).collect();
        result.retain(|signal| known(&signal.name));
        let experiment =
            Experiment::of_result(&result.names(), &result.times, interface.experiment.step);
        let too_short = || ReferenceError::content(fmu, "the result has fewer than two rows");
        Ok(Self { experiment: experiment.ok_or_else(too_short)?, inputs, result, left_out })
    }
}

/// Runs an FMU that was packed and adds the result to it; `folder` has the experiment and the
/// inputs.
///
/// # Errors
/// When a file is missing or wrong, or the FMU fails.
pub fn pack(fmu: &Path, folder: &Path) -> Result<(), ReferenceError> {
    let experiment = Experiment::read(&folder.join(EXPERIMENT))?;
    let import = Import::open(fmu)?;
    let inputs = Table::read(&folder.join(INPUTS), import.interface())?;
    let result = run::run(&import, &experiment, &inputs)?;

    let content = tempfile::tempdir().map_err(FileError::at(fmu))?;
    let packing = |error: archive::ArchiveError| ReferenceError::content(fmu, error);
    archive::unpack(fmu, content.path()).map_err(packing)?;
    let files = content.path().join(FOLDER);
    std::fs::create_dir_all(&files).map_err(FileError::at(&files))?;
    for name in [EXPERIMENT, INPUTS] {
        let from = folder.join(name);
        std::fs::copy(&from, files.join(name)).map_err(FileError::at(&from))?;
    }
    result.write(&files.join(RESULT))?;
    std::fs::write(files.join(MANIFEST), manifest()).map_err(FileError::at(&files))?;
    archive::pack(content.path(), fmu).map_err(packing)
}

/// The manifest, as FMI-LS-REF 1.0.0-alpha.1 has it.
fn manifest() -> String {
    let related = [
        ("application/toml", EXPERIMENT, "experiment", "Times, step, tolerance and start values"),
        ("text/csv", INPUTS, "input", "Inputs over time, linear between rows"),
        ("text/csv", RESULT, "result", "Outputs of the experiment"),
    ];
    let lines = related.map(|(kind, source, role, description)| {
        format!(
            "  <Related type=\"{kind}\" source=\"{source}\" role=\"{role}\" \
             description=\"{description}\"/>\n"
        )
    });
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiReferences xmlns:fmi-ls=\"http://fmi-standard.org/fmi-ls-manifest\" \
         fmi-ls:fmi-ls-name=\"org.fmi-standard.fmi-ls-ref\" \
         fmi-ls:fmi-ls-version=\"1.0.0-alpha.1\">\n{}</fmiReferences>\n",
        lines.concat()
    )
}
