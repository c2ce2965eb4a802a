//! What the child does before its command.
//!
//! It lets its parent watch it, closes the standard input to FMUs, and stops when it is to stop or its parent has gone.

use std::env;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::OnceLock;

use hotfoot::run::folder::claim::{Claim, release};
use hotfoot::watched::{self, Page};

use super::temporary;

/// Number of the parent, in the environment of the child.
const PARENT: &str = "HOTFOOT_PARENT";
/// File of the page that is shared.
const PAGE: &str = "HOTFOOT_PAGE";
/// Folder of the results, which the parent has claimed.
const RESULTS: &str = "HOTFOOT_RESULTS";
/// The temporary folder, where the system's functions find it too.
const TEMPORARY: &str = "TMPDIR";

/// This process as a child.
pub struct Child {
    page: &'static Page,
    parent: u32,
    temporary: PathBuf,
    results: Option<Claim>,
    _lock: Option<File>,
}

static CHILD: OnceLock<Child> = OnceLock::new();

/// Hands over to a child what it must know.
pub fn describe(command: &mut Command, page: &Path, temporary: &Path, results: Option<&Path>) {
    command.env(PARENT, std::process::id().to_string()).env(PAGE, page).env(TEMPORARY, temporary);
    if let Some(results) = results {
        command.env(RESULTS, results);
    }
}

/// This process as a child, if it is one.
pub fn own() -> Option<&'static Child> {
    CHILD.get()
}

/// Makes this process a child, if it was started as one; otherwise it is a parent.
///
/// # Errors
/// When it was started as one, but its parent has gone.
pub fn begin() -> Result<(), &'static str> {
    let parent = env::var(PARENT).ok().and_then(|number| number.parse::<u32>().ok());
    let (Some(parent), Some(page)) = (parent, env::var_os(PAGE)) else { return Ok(()) };
    // A program that an FMU starts has this environment too.
    if parent_id().is_some_and(|other| other != parent) && Path::new(&page).exists() {
        return Ok(());
    }
    let gone = "the parent of this process has gone";
    let page = watched::watch(Path::new(&page)).map_err(|_| gone)?;
    let temporary = env::temp_dir();
    let results = env::var_os(RESULTS).map(|folder| Claim::join(Path::new(&folder)));
    let child = Child {
        page,
        parent,
        results: results.transpose().map_err(|_| gone)?,
        _lock: temporary::join(&temporary).ok(),
        temporary,
    };
    let child = CHILD.get_or_init(|| child);
    #[cfg(unix)]
    unix::begin(child).map_err(|_| gone)?;
    Ok(())
}

#[cfg(unix)]
fn parent_id() -> Option<u32> {
    Some(std::os::unix::process::parent_id())
}

#[cfg(not(unix))]
fn parent_id() -> Option<u32> {
    None
}

impl Child {
    /// The folder of the results, which this process shares with its parent.
    pub fn results(&self) -> Option<&Path> {
        self.results.as_ref().map(Claim::folder)
    }

    /// Notes that all is done, with an exit code; what still happens cannot make it undone.
    pub fn finish(&self, code: u8) {
        self.page.finish(code);
        if self.is_orphan() {
            self.remove_temporary();
            self.leave_results();
        }
    }

    /// Whether the parent has gone.
    fn is_orphan(&self) -> bool {
        parent_id().is_some_and(|parent| parent != self.parent)
    }

    /// Removes the temporary folder, as the parent does it.
    fn remove_temporary(&self) {
        temporary::remove(&self.temporary);
    }

    /// Leaves the folder of the results, as the parent does it.
    fn leave_results(&self) {
        match (&self.results, self.page.records()) {
            (Some(claim), 0) => claim.abandon(),
            (Some(claim), _) => release(claim.folder()),
            (None, _) => {}
        }
    }
}

#[cfg(unix)]
mod unix {
    use std::fs::File;
    use std::io::{self, Read};
    use std::os::fd::AsFd;
    use std::thread;

    use hotfoot::run::PARENT_GONE;
    use rustix::process::{Signal, getpid, kill_process};
    use signal_hook::consts::{SIGXCPU, SIGXFSZ};
    use signal_hook::iterator::Signals;

    use super::Child;
    use crate::supervise::watch::{GRACE, ending};

    /// Handles signals, closes the standard input to FMUs, and watches the parent.
    pub fn begin(child: &'static Child) -> io::Result<()> {
        let mut signals = Signals::new(ending().chain([SIGXCPU, SIGXFSZ]))?;
        let named = |name: &str| thread::Builder::new().name(name.to_owned());
        named("signals").spawn(move || {
            // A file that may not grow is an error of the one who writes it.
            for signal in signals.forever().filter(|&signal| signal != SIGXFSZ) {
                let signal = if child.is_orphan() { PARENT_GONE } else { signal };
                child.page.request_stop(signal);
            }
        })?;
        #[cfg(target_os = "linux")]
        rustix::process::set_parent_process_death_signal(Some(Signal::TERM))?;
        // The parent holds the other end of the standard input, which closes when the parent ends.
        let mut parent = File::from(io::stdin().as_fd().try_clone_to_owned()?);
        rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
        named("parent").spawn(move || {
            let _ = parent.read_to_end(&mut vec![]);
            end_alone(child);
        })?;
        Ok(())
    }

    /// Ends a process whose parent has gone: in order, if it has recorded something and comes to its next
    /// step soon.
    fn end_alone(child: &Child) {
        child.page.request_stop(PARENT_GONE);
        match child.page.records() {
            0 => child.leave_results(),
            // If it does not come to its end, `hotfoot report` completes what it leaves.
            _ => thread::sleep(GRACE),
        }
        child.remove_temporary();
        let _ = kill_process(getpid(), Signal::KILL);
    }
}
