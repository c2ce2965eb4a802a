//! Runs a command in a child of this program, whose calls of FMUs are watched.
//!
//! So an FMU that crashes, ends its process or never returns costs the child only, and this program says who was at fault.
//!
//! | file | part |
//! |---|---|
//! | `child.rs` | what the child does before its command |
//! | `watch.rs` | waits for the end of the child, hands signals on, ends calls that take too long |
//! | `limits.rs` | how long a call may take |
//! | `blame.rs` | why the child has ended |
//! | `resources.rs` | what the system says of memory and processor time |
//! | `temporary.rs` | the temporary folder, which goes with the child |

mod blame;
pub mod child;
pub mod limits;
mod resources;
pub mod temporary;
mod watch;

use std::io::{self, IsTerminal};
use std::path::Path;
use std::process::{Child, Command, Stdio};

use anyhow::{Context, Result};
use hotfoot::watched::Page;

use blame::Death;
pub use blame::{Blame, exit_code};
use limits::Limits;
use resources::Resources;
use temporary::Temporary;
use watch::{Signals, Watch};

use crate::output::tell;

/// How the child has ended.
#[derive(Debug)]
pub struct End {
    /// Its exit code, if it has done all it had to do. Nothing else is success.
    pub finished: Option<u8>,
    /// Why it has ended without that, or what was wrong after it.
    pub blame: Option<Blame>,
    /// Number of whole records that it has left.
    pub records: u64,
}

/// Runs this program again with the same arguments, in the folder `results` if it is a run.
///
/// # Errors
/// When the child cannot be started or watched.
pub fn in_child(limits: &Limits, results: Option<&Path>) -> Result<End> {
    // From here on a signal is no end of this program.
    let signals = Signals::new().context("signals cannot be handled")?;
    let temporary = Temporary::new()?;
    let (page, file, path) =
        Page::create(temporary.path()).context("there is no memory to share with a child")?;
    limits.tell(&page);
    let before = Resources::now();
    let mut child = start(&path, temporary.path(), results)
        .context("this program cannot be started again as a child")?;
    // The child ends when this closes.
    let input = child.stdin.take();
    let watch = Watch { page: &page, limits };
    let (status, ended) = watch.until_end(&mut child, &signals)?;
    drop((input, file));
    let finished = page.finished();
    if finished.is_none() && io::stderr().is_terminal() {
        // Below the progress bar.
        tell("");
    }
    let death = Death { status, ended, page: &page, before: &before };
    let blame = death.blame(temporary.path(), finished);
    Ok(End { finished, blame, records: page.records() })
}

/// Does the work of a command that records nothing in a child of this program, and gives its exit code:
/// the parent starts the child, which does it.
///
/// # Errors
/// When the work fails, or the child ends before it has done all it had to do.
pub fn command_in_child(limits: &Limits, work: impl FnOnce() -> Result<()>) -> Result<u8> {
    if child::own().is_some() {
        return work().map(|()| 0);
    }
    let End { finished, blame, .. } = in_child(limits, None)?;
    match (finished, blame) {
        (Some(code), blame) => {
            blame.iter().for_each(Blame::warn);
            Ok(code)
        }
        (None, Some(blame)) if blame.interrupted.is_some() => Ok(blame.tell()),
        (None, blame) => Err(anyhow::anyhow!(blame.unwrap_or_default().sentence)),
    }
}

fn start(page: &Path, temporary: &Path, results: Option<&Path>) -> io::Result<Child> {
    let mut command = Command::new(std::env::current_exe()?);
    command.args(std::env::args_os().skip(1)).stdin(Stdio::piped());
    child::describe(&mut command, page, temporary, results);
    command.spawn()
}
