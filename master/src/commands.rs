//! The commands of the program `hotfoot`.

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use clap::Args;
use miette::{IntoDiagnostic, Result, miette};

use crate::check::reference;
use crate::files::archive;
use crate::fmi::pack::{self, Binary};
use crate::run::{self, Options};
use crate::run::{expected, workplace};
use crate::scenario::Times;
use crate::ssp::{self, SystemOptions};
use crate::{recording, report, scenario, supervise};

/// Arguments of `hotfoot run`.
#[derive(Args)]
pub struct RunArguments {
    /// Scenario: its folder or file; or an SSP package of any FMUs
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
    /// Simulated time in place of the scenario's or package's, s
    #[arg(long)]
    duration: Option<f64>,
    /// Step of the exchange in place of the scenario's or package's, s
    #[arg(long)]
    step: Option<f64>,
    /// Time between two records in place of the scenario's, s; of an SSP package, left out: 0.1
    #[arg(long)]
    interval: Option<f64>,
    /// Show no progress
    #[arg(long)]
    quiet: bool,
}

/// Arguments of `hotfoot export-ssp`.
#[derive(Args)]
pub struct ExportArguments {
    /// Scenario: its folder or file
    scenario: PathBuf,
    /// Package to write; left out: named as the scenario's folder, in the current folder
    #[arg(long, short)]
    output: Option<PathBuf>,
    /// Folder of Hotfoot's own FMUs; left out: `fmus` beside the folder of the program
    #[arg(long)]
    fmus: Option<PathBuf>,
}

/// Arguments of `hotfoot pack`.
#[derive(Args)]
pub struct PackArguments {
    /// Shared library, or an FMU that was packed before
    binary: PathBuf,
    /// Folder with the resources, where the model needs any
    #[arg(long)]
    resources: Option<PathBuf>,
    /// Rolling-stock library that is put into the resources as `stock`
    #[arg(long)]
    stock: Option<PathBuf>,
    /// Folder with the experiment whose result the FMU shall carry as a self-test
    #[arg(long)]
    reference: Option<PathBuf>,
    /// Text in Markdown with equations, for the documentation; several follow one another
    #[arg(long)]
    theory: Vec<PathBuf>,
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

/// Runs a scenario in a child process, tells where the results are, and the main figures.
///
/// # Errors
/// When the scenario is wrong, a unit fails or crashes.
pub fn run(arguments: &RunArguments) -> Result<()> {
    if supervise::is_child() {
        return run_here(arguments);
    }
    let results =
        arguments.results.clone().unwrap_or_else(|| workplace::new_results(&arguments.scenario));
    let further = match arguments.results {
        Some(_) => vec![],
        None => vec!["--results".into(), results.clone().into_os_string()],
    };
    supervise::in_child(&further, || {
        let series = results.join("series");
        if !series.exists() {
            return Err(miette!("an FMU has crashed the run before anything was recorded"));
        }
        recording::complete(&series).into_diagnostic()?;
        Err(miette!(
            "an FMU has crashed the run; the results until then are in {}",
            results.display()
        ))
    })
}

fn run_here(arguments: &RunArguments) -> Result<()> {
    if arguments.scenario.extension().is_some_and(|extension| extension == "ssp") {
        return run_system(arguments);
    }
    let options = Options {
        threads: arguments.threads,
        results: arguments.results.clone(),
        fmus: arguments.fmus.clone().unwrap_or_else(default_fmus),
        times: Times {
            duration: arguments.duration,
            step: arguments.step,
            interval: arguments.interval,
        },
        quiet: arguments.quiet,
    };
    let finished = run::run(&arguments.scenario, &options)?;
    println!("{finished}");
    Ok(())
}

fn run_system(arguments: &RunArguments) -> Result<()> {
    let options = SystemOptions {
        threads: arguments.threads,
        results: arguments.results.clone(),
        duration: arguments.duration,
        step: arguments.step,
        interval: arguments.interval,
        quiet: arguments.quiet,
    };
    println!("{}", ssp::run(&arguments.scenario, &options)?);
    Ok(())
}

/// Writes a scenario's train as an SSP package, and tells what is in it.
///
/// # Errors
/// When the scenario is wrong, a unit fails, or the package cannot be written.
pub fn export_ssp(arguments: &ExportArguments) -> Result<()> {
    let fmus = arguments.fmus.clone().unwrap_or_else(default_fmus);
    let name = || workplace::scenario_name(&arguments.scenario);
    let target = arguments.output.clone().unwrap_or_else(|| format!("{}.ssp", name()).into());
    let exported = ssp::export(&arguments.scenario, &fmus, &target)?;
    println!(
        "{}: {} components, {} connections",
        target.display(),
        exported.components,
        exported.connections
    );
    for difference in exported.differences {
        println!("note: {difference}");
    }
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

/// Says how the figures of a run compare with those expected of its scenario.
///
/// # Errors
/// When a file cannot be read, or a figure differs.
pub fn expect(results: &Path, expected: &Path) -> Result<()> {
    let comparisons = expected::compare(results, expected).into_diagnostic()?;
    comparisons.iter().for_each(|comparison| println!("{comparison}"));
    match comparisons.iter().filter(|comparison| !comparison.agrees()).count() {
        0 => Ok(()),
        count => Err(miette!("{count} of {} figures differ", comparisons.len())),
    }
}

/// Packs an FMU.
///
/// # Errors
/// When files are missing, or the model refuses the resources.
pub fn pack(arguments: &PackArguments) -> Result<()> {
    let folder = tempfile::tempdir().into_diagnostic()?;
    if let Some(resources) = &arguments.resources {
        pack::copy_folder(resources, folder.path()).into_diagnostic()?;
    }
    if let Some(stock) = &arguments.stock {
        pack::copy_folder(stock, &folder.path().join("stock")).into_diagnostic()?;
    }
    let is_fmu = arguments.binary.extension().is_some_and(|extension| extension == "fmu");
    let binary = match is_fmu {
        true => Binary::Fmu(&arguments.binary),
        false => Binary::Library(&arguments.binary),
    };
    pack::pack(binary, folder.path(), &arguments.output).into_diagnostic()?;
    if !arguments.theory.is_empty() {
        pack::add_equations(&arguments.output, &arguments.theory).into_diagnostic()?;
    }
    match &arguments.reference {
        Some(reference) => reference::pack(&arguments.output, reference).into_diagnostic(),
        None => Ok(()),
    }
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
