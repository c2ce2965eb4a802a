//! What the program writes to its terminal: answers, sentences, and the message of an error.
//!
//! Neither a reader that goes away nor a full device makes it panic.

use std::fmt::{self, Display};
use std::io::{self, ErrorKind, Write};

use anyhow::{Context, Error, Result};
use serde::Serialize;

/// Prints a text and a new line to the standard output.
///
/// # Errors
/// When it cannot be written.
pub fn print(text: impl Display) -> Result<()> {
    write(format_args!("{text}\n"))
}

/// Prints a text that ends its own lines.
///
/// # Errors
/// When it cannot be written.
pub fn write(text: impl Display) -> Result<()> {
    let mut output = io::stdout().lock();
    let written = write!(output, "{text}").and_then(|()| output.flush());
    written.context("the standard output cannot be written")
}

/// Prints rows of which the first has the names of the columns.
///
/// # Errors
/// When they cannot be written.
pub fn print_table<R: AsRef<[String]>>(rows: &[R]) -> Result<()> {
    let columns = rows.first().map_or(0, |row| row.as_ref().len());
    let width = |column: usize| rows.iter().map(|row| row.as_ref()[column].chars().count()).max();
    let widths: Vec<usize> = (0..columns).map(|column| width(column).unwrap_or(0)).collect();
    for row in rows {
        let cells = row.as_ref().iter().zip(&widths).map(|(cell, width)| format!("{cell:<width$}"));
        print(cells.collect::<Vec<_>>().join("  ").trim_end())?;
    }
    Ok(())
}

/// Prints a value as JSON, in lines.
///
/// # Errors
/// When it cannot be written.
pub fn print_json(value: &impl Serialize) -> Result<()> {
    print(serde_json::to_string_pretty(value)?)
}

/// Tells a sentence on the terminal, if there still is one.
pub fn tell(sentence: impl Display) {
    let _ = writeln!(io::stderr(), "{sentence}");
}

/// An error whose sentence is told already.
#[derive(Debug)]
pub struct Reported;

impl Display for Reported {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("it is told already")
    }
}

impl std::error::Error for Reported {}

/// Whether an error is that nobody reads the standard output any more, which is no failure.
pub fn is_closed_pipe(error: &Error) -> bool {
    let mut causes = error.chain().filter_map(|cause| cause.downcast_ref::<io::Error>());
    causes.any(|cause| cause.kind() == ErrorKind::BrokenPipe)
}

/// The sentence of an error and those of what has caused it. Many an error repeats its cause in its own
/// sentence; such a cause is left out.
pub fn message(error: &Error) -> String {
    let mut message = String::new();
    for cause in error.chain().map(|cause| cause.to_string()) {
        let cause = cause.trim();
        match message.is_empty() {
            true => cause.clone_into(&mut message),
            false if message.contains(cause) => {}
            false => message = format!("{message}: {cause}"),
        }
    }
    message
}

#[cfg(test)]
mod tests {
    use anyhow::anyhow;

    use super::*;

    #[test]
    fn a_cause_that_the_error_repeats_comes_once() {
        let twice = anyhow!("no such folder").context("train.fmu: no such folder");
        assert_eq!(message(&twice), "train.fmu: no such folder");
    }

    #[test]
    fn a_cause_that_the_error_keeps_to_itself_comes_behind_it() {
        let own = anyhow!("no such folder\n").context("the FMU cannot be packed").context("export");
        assert_eq!(message(&own), "export: the FMU cannot be packed: no such folder");
    }
}
