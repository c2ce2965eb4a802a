//! Runs a command in a child of this program, so that an FMU that crashes it ends the child only.
//!
//! What was recorded is then completed, and the user gets a message.

use std::ffi::OsString;
use std::io::Read;
use std::process::{Command, ExitStatus, Stdio};

use anyhow::Result;

/// Set in the environment of the child.
const CHILD: &str = "HOTFOOT_CHILD";

/// Whether this is the child. Its crashes then say which FMU was at work, and it ends with its
/// parent.
pub fn is_child() -> bool {
    let child = std::env::var_os(CHILD).is_some();
    if child {
        hotfoot::watch_crashes();
        end_with_parent();
    }
    child
}

/// The parent holds the other end of the standard input, which closes when the parent ends.
fn end_with_parent() {
    std::thread::spawn(|| {
        let _ = std::io::stdin().read_to_end(&mut vec![]);
        std::process::exit(1);
    });
}

/// Runs this program again with the same and `further` arguments; calls `after_crash` if it crashes.
///
/// # Errors
/// When the child cannot be started, and what `after_crash` says. A child that ends with an error
/// has said why, so this program ends at once with the same code.
pub fn in_child(further: &[OsString], after_crash: impl FnOnce() -> Result<()>) -> Result<()> {
    let program = std::env::current_exe()?;
    let mut child = Command::new(program)
        .args(std::env::args_os().skip(1))
        .args(further)
        .env(CHILD, "1")
        .stdin(Stdio::piped())
        .spawn()?;
    // `wait` closes the standard input, at which the child would end.
    let input = child.stdin.take();
    let status = child.wait()?;
    drop(input);
    match status {
        status if status.success() => Ok(()),
        status if crashed(status) => after_crash(),
        status => std::process::exit(status.code().unwrap_or(1)),
    }
}

/// Whether a program was ended by a signal, or on Windows by an exception.
fn crashed(status: ExitStatus) -> bool {
    status.code().is_none_or(|code| !(0..=255).contains(&code))
}
