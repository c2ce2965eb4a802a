//! `hotfoot pack`: an FMU from a binary and its resources.

use std::path::PathBuf;

use anyhow::Result;
use clap::Args;
use hotfoot::check::reference;
use hotfoot::pack::{self, Binary};

use crate::supervise::command_in_child;
use crate::supervise::limits::Limits;

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
    #[command(flatten)]
    limits: Limits,
}

/// Packs an FMU, in a child process since its binary is called. Gives the exit code.
///
/// # Errors
/// When files are missing, or the model refuses the resources.
pub fn pack(arguments: &PackArguments) -> Result<u8> {
    files::exists(&arguments.binary)?;
    command_in_child(&arguments.limits, || pack_here(arguments))
}

fn pack_here(arguments: &PackArguments) -> Result<()> {
    let folder = tempfile::tempdir()?;
    if let Some(resources) = &arguments.resources {
        pack::copy_folder(resources, folder.path())?;
    }
    if let Some(stock) = &arguments.stock {
        pack::copy_folder(stock, &folder.path().join("stock"))?;
    }
    let is_fmu = arguments.binary.extension().is_some_and(|extension| extension == "fmu");
    let binary = match is_fmu {
        true => Binary::Fmu(&arguments.binary),
        false => Binary::Library(&arguments.binary),
    };
    pack::pack(binary, folder.path(), &arguments.output)?;
    if !arguments.theory.is_empty() {
        pack::add_equations(&arguments.output, &arguments.theory)?;
    }
    if let Some(reference) = &arguments.reference {
        reference::pack(&arguments.output, reference)?;
    }
    Ok(())
}
