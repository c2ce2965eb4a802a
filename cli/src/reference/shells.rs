//! `hotfoot completions` and `hotfoot man`: what shells and manuals need of the commands.

use std::fs;
use std::path::Path;

use anyhow::{Context, Result};
use clap::{Args, Command};
use clap_complete::Shell;

use crate::output::{print, write};

/// Arguments of `hotfoot completions`.
#[derive(Args)]
pub struct CompletionsArguments {
    /// Shell
    shell: Shell,
}

/// Prints what a shell needs to complete the commands and options.
///
/// # Errors
/// When it cannot be written.
pub fn completions(arguments: &CompletionsArguments, command: &mut Command) -> Result<()> {
    let mut text = vec![];
    clap_complete::generate(arguments.shell, command, "hotfoot", &mut text);
    write(String::from_utf8_lossy(&text))
}

/// Writes a manual page for the program and for each of its commands into a folder.
///
/// # Errors
/// When the folder or a page cannot be written.
pub fn man(folder: &Path, command: Command) -> Result<()> {
    fs::create_dir_all(folder).with_context(|| folder.display().to_string())?;
    clap_mangen::generate_to(command.name("hotfoot"), folder)
        .with_context(|| folder.display().to_string())?;
    print(format_args!("man -l {}", folder.join("hotfoot.1").display()))
}
