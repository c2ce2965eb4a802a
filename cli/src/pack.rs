//! `hotfoot pack`: an FMU from a binary and its resources.

use std::path::PathBuf;

use clap::Args;
use hotfoot::check::reference;
use hotfoot::pack::{self, Binary};
use miette::{IntoDiagnostic, Result};

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
