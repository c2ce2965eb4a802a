//! What the program writes to its terminal: answers, sentences, and the message of an error.
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
