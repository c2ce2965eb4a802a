//! The commands of the program `hotfoot`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use miette::{IntoDiagnostic, Result, miette};

use crate::fmi::Import;
use crate::pack::{self, Binary};
use crate::roles::{self, Role};
use crate::run::{self, Options};
use crate::{archive, report, scenario};

/// Arguments of `hotfoot run`.
#[derive(Args)]
pub struct RunArguments {
    /// Scenario: its folder or file
    scenario: PathBuf,
    /// Threads for the vehicles; left out: all cores
    #[arg(long)]
    threads: Option<usize>,
    /// Folder of the results; left out: a new one in `results`
    #[arg(long)]
    results: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
    /// Simulated time in place of the scenario's, s
    #[arg(long)]
    duration: Option<f64>,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

/// Arguments of `hotfoot pack`.
#[derive(Args)]
pub struct PackArguments {
    /// Shared library, or an FMU that was packed before
    binary: PathBuf,
    /// Folder with the resources
    #[arg(long)]
    resources: PathBuf,
    /// Rolling-stock library that is put into the resources as `stock`
    #[arg(long)]
    stock: Option<PathBuf>,
    /// FMU to write
    #[arg(long, short)]
    output: PathBuf,
}

/// Arguments that a command of the program `hotfoot-tools` gets as they are, `--help` too.
#[derive(Args)]
pub struct ToolArguments {
    #[arg(trailing_var_arg = true, allow_hyphen_values = true, value_name = "ARGUMENTS")]
    arguments: Vec<OsString>,
}

/// Runs a scenario, tells where the results are, and the main figures.
///
/// # Errors
/// When the scenario is wrong or a unit fails.
pub fn run(arguments: &RunArguments) -> Result<()> {
    let options = Options {
        threads: arguments.threads,
        results: arguments.results.clone(),
        fmus: arguments.fmus.clone().unwrap_or_else(default_fmus),
        duration: arguments.duration,
        quiet: arguments.quiet,
    };
    let finished = run::run(&arguments.scenario, &options)?;
    println!("{finished}");
    Ok(())
}

/// `fmus` beside the folder of the program: `target/fmus` for `target/release/hotfoot`.
fn default_fmus() -> PathBuf {
    let program = std::env::current_exe().unwrap_or_default();
    let folder = program.parent().and_then(Path::parent).unwrap_or(Path::new("."));
    folder.join("fmus")
}

/// Makes the report of a results folder again.
///
/// # Errors
/// When the folder is not one that a run has written.
pub fn report(results: &Path) -> Result<()> {
    let (file, _) = report::write(results).into_diagnostic()?;
    println!("{}", file.display());
    Ok(())
}

/// Says whether an FMU can fill a role.
///
/// # Errors
/// When the FMU cannot be read, or lacks something.
pub fn check(fmu: &Path, role: Role) -> Result<()> {
    let import = Import::open(fmu).into_diagnostic()?;
    let problems = roles::missing(import.interface(), role);
    if !problems.is_empty() {
        return Err(miette!(
            "{} cannot be used as {role:?}:\n{}",
            fmu.display(),
            problems.join("\n")
        ));
    }
    println!("{} can be used as {role:?}", fmu.display());
    Ok(())
}

/// Packs an FMU.
///
/// # Errors
/// When files are missing, or the model refuses the resources.
pub fn pack(arguments: &PackArguments) -> Result<()> {
    let folder = tempfile::tempdir().into_diagnostic()?;
    pack::copy_folder(&arguments.resources, folder.path()).into_diagnostic()?;
    if let Some(stock) = &arguments.stock {
        pack::copy_folder(stock, &folder.path().join("stock")).into_diagnostic()?;
    }
    let is_fmu = arguments.binary.extension().is_some_and(|extension| extension == "fmu");
    let binary = match is_fmu {
        true => Binary::Fmu(&arguments.binary),
        false => Binary::Library(&arguments.binary),
    };
    pack::pack(binary, folder.path(), &arguments.output).into_diagnostic()
}

/// Lists the variables of an FMU, or prints its model description.
///
/// # Errors
/// When the FMU cannot be read.
pub fn interface(fmu: &Path, xml: bool) -> Result<()> {
    let folder = tempfile::tempdir().into_diagnostic()?;
    archive::unpack(fmu, folder.path()).into_diagnostic()?;
    let file = folder.path().join("modelDescription.xml");
    let text = std::fs::read_to_string(file).into_diagnostic()?;
    if xml {
        print!("{text}");
        return Ok(());
    }
    let interface = crate::Interface::from_xml(&text).into_diagnostic()?;
    for variable in interface.variables() {
        let unit = variable.unit.as_deref().unwrap_or("");
        println!("{:<9} {:<52} {unit}", variable.causality, variable.name);
    }
    Ok(())
}

/// Prints the JSON schema of scenario files.
///
/// # Errors
/// Never in practice.
pub fn schema() -> Result<()> {
    let schema = schemars::schema_for!(scenario::Scenario);
    println!("{}", serde_json::to_string_pretty(&schema).into_diagnostic()?);
    Ok(())
}

/// Runs a command of the program `hotfoot-tools`, which stands beside this one: it knows the models
/// that the master does not know. Ends this program with the status of that one.
///
/// # Errors
/// When the program cannot be started.
pub fn tool(command: &str, arguments: &ToolArguments) -> Result<()> {
    let name = format!("hotfoot-tools{}", std::env::consts::EXE_SUFFIX);
    let program = std::env::current_exe().unwrap_or_default().with_file_name(name);
    let status = Command::new(&program).arg(command).args(&arguments.arguments).status();
    let status = status.map_err(|error| {
        let program = program.display();
        miette!("`hotfoot {command}` needs the program {program}, which cannot be started: {error}")
    })?;
    std::process::exit(status.code().unwrap_or(1))
}
