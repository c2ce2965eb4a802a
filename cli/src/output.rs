//! What the program writes to its terminal.
//!
//! Neither a reader that goes away nor a full device makes it panic.

use std::fmt::Display;
use std::io::{self, ErrorKind, Write};

use anyhow::{Context, Error, Result};

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

/// Tells a sentence on the terminal, if there still is one.
pub fn tell(sentence: impl Display) {
    let _ = writeln!(io::stderr(), "{sentence}");
}

/// Whether an error is that nobody reads the standard output any more, which is no failure.
pub fn is_closed_pipe(error: &Error) -> bool {
    let mut causes = error.chain().filter_map(|cause| cause.downcast_ref::<io::Error>());
    causes.any(|cause| cause.kind() == ErrorKind::BrokenPipe)
}
