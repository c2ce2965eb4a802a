//! `hotfoot stock`: what the rolling-stock library has.

use std::path::PathBuf;

use anyhow::Result;
use clap::{Args, Subcommand};
use hotfoot::shipped;
use tools::rolling_stock::{Entry, entries, named};

use crate::output::{print, print_json, print_table};

/// Arguments of `hotfoot stock`.
#[derive(Args)]
pub struct StockArguments {
    #[command(subcommand)]
    what: What,
    /// Folder of the rolling-stock library; left out: `stock` here, else `stock` beside the folder of the
    /// program
    #[arg(long, global = true)]
    stock: Option<PathBuf>,
    /// Print JSON
    #[arg(long, global = true)]
    json: bool,
}

#[derive(Subcommand)]
enum What {
    /// All vehicles, draft gears, rail sections and profiles with their main figures
    List,
    /// The figures of an entry
    Show {
        /// Name of the entry
        name: String,
    },
    /// Where the figures of an entry are from
    Source {
        /// Name of the entry
        name: String,
    },
}

/// Prints what is asked for.
///
/// # Errors
/// When there is no library or no such entry, or a file of it has a mistake.
pub fn stock(arguments: &StockArguments) -> Result<()> {
    let StockArguments { what, stock, json } = arguments;
    let here = PathBuf::from("stock");
    let or_shipped =
        || if here.join("vehicles").is_dir() { here } else { shipped::folder("stock") };
    let folder = stock.clone().unwrap_or_else(or_shipped);
    let found = match what {
        What::List => entries(&folder)?,
        What::Show { name } | What::Source { name } => named(&folder, name)?,
    };
    match what {
        _ if *json => print_json(&found),
        What::List => list(&found),
        What::Show { .. } => found.iter().try_for_each(show),
        What::Source { .. } => found.iter().try_for_each(source),
    }
}

/// A table for each kind, with a column for each main figure of one of its entries.
fn list(entries: &[Entry]) -> Result<()> {
    for (number, of_kind) in entries.chunk_by(|a, b| a.kind == b.kind).enumerate() {
        let mut names: Vec<&str> = vec![];
        for figure in of_kind.iter().flat_map(|entry| &entry.figures).filter(|f| f.is_main) {
            if !names.contains(&figure.name) {
                names.push(figure.name);
            }
        }
        let heading = [of_kind[0].kind.plural()].into_iter().chain(names.iter().copied());
        let mut rows = vec![heading.map(str::to_owned).collect::<Vec<_>>()];
        rows.extend(of_kind.iter().map(|entry| row(entry, &names)));
        if number > 0 {
            print("")?;
        }
        print_table(&rows)?;
    }
    Ok(())
}

/// The cells of an entry: its name and its figures of these names.
fn row(entry: &Entry, names: &[&str]) -> Vec<String> {
    let text = |name: &&str| {
        let figure = entry.figures.iter().find(|figure| figure.name == *name);
        figure.map_or_else(|| "–".to_owned(), ToString::to_string)
    };
    std::iter::once(entry.name.clone()).chain(names.iter().map(text)).collect()
}

fn show(entry: &Entry) -> Result<()> {
    print(format_args!("{}: {}", entry.name, entry.title))?;
    for figure in &entry.figures {
        print(format_args!("  {:<42} {figure}", figure.name))?;
    }
    match &entry.file {
        Some(file) => print(format_args!("  file {file}")),
        None => Ok(()),
    }
}

fn source(entry: &Entry) -> Result<()> {
    print(format_args!("{}: {}\n{}", entry.name, entry.title, entry.source))
}
