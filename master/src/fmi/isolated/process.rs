//! The process of an isolated FMU, seen from the run: started, asked, and ended.

use std::ffi::CStr;
use std::fs::File;
use std::io;
use std::os::unix::process::CommandExt;
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::time::Duration;

use super::death::Death;
use super::mailbox::Mailbox;
use super::message::{Answer, Request};
use super::worker::COMMAND;
use crate::fmi::watched::{self, Limit, Page, shared_file};

/// What a thread of the run does, as its parent sees it, while it waits for such a process.
///
/// The run limits the calls of the process, so its parent does not limit the waiting.
pub const WAITING: &CStr = c"a call in its own process";

/// Time between two looks whether the process still lives, while it gives no answer.
const LOOK: Duration = Duration::from_millis(20);
/// Time between two looks whether it has ended, when it was asked to.
const LOOK_FOR_END: Duration = Duration::from_millis(1);

/// The process of an FMU.
pub struct Process {
    child: Child,
    mailbox: Mailbox,
    /// What it calls.
    page: Page,
    /// The memory of both, under whose numbers the process finds them.
    _files: [File; 2],
}

impl Process {
    /// Starts a process with room for requests and answers of so many bytes.
    ///
    /// # Errors
    /// When the system gives no memory or no process.
    pub fn start(room: usize) -> io::Result<Self> {
        let (page, page_file, page_path) = Page::create(Path::new(""))?;
        let (file, path) = shared_file(Path::new(""), Mailbox::length(room))?;
        let mailbox = Mailbox::open(&file)?;
        let mut command = Command::new(std::env::current_exe()?);
        command.arg(COMMAND).args([&path, &page_path]).stdin(Stdio::piped());
        // What a terminal sends to the run is no matter of the FMU: the run ends it.
        command.process_group(0);
        Ok(Self { child: command.spawn()?, mailbox, page, _files: [page_file, file] })
    }

    /// Asks; the answer is to be awaited before the next request.
    ///
    /// # Errors
    /// When there is no room for the request.
    pub fn ask(&self, request: &Request) -> Result<(), String> {
        let bytes = postcard::to_allocvec(request).map_err(|error| error.to_string())?;
        self.mailbox.ask(&bytes).map_err(|error| error.to_string())
    }

    /// The answer. A process that gives none within the limit is ended.
    ///
    /// # Errors
    /// When the process has ended.
    pub fn answer(&mut self, limit: Limit) -> Result<Answer, Death> {
        let longest = watched::own().and_then(|page| page.limit(limit));
        // A computer that sleeps meanwhile makes nothing overdue.
        let mut waited = Duration::ZERO;
        loop {
            if let Some(bytes) = self.mailbox.answer(LOOK) {
                return postcard::from_bytes(&bytes).map_err(|_| self.kill(Death::senseless));
            }
            waited += LOOK;
            if let Some(status) = self.status() {
                // It may have answered just before.
                let bytes = self.mailbox.answer(Duration::ZERO);
                let answer = bytes.and_then(|bytes| postcard::from_bytes(&bytes).ok());
                return answer.ok_or_else(|| Death::of(&self.page, status));
            }
            if let Some(longest) = longest.filter(|longest| waited >= *longest) {
                return Err(self.kill(|page| Death::overdue(page, longest, limit)));
            }
        }
    }

    /// Waits until a process that was asked to free its instance has ended.
    ///
    /// # Errors
    /// When it does not end in order.
    pub fn end(mut self) -> Result<(), Death> {
        self.answer(Limit::End)?;
        let longest = watched::own().and_then(|page| page.limit(Limit::End));
        let mut waited = Duration::ZERO;
        loop {
            if let Some(status) = self.status() {
                return if status.success() { Ok(()) } else { Err(Death::of(&self.page, status)) };
            }
            if let Some(longest) = longest.filter(|longest| waited >= *longest) {
                return Err(self.kill(|page| Death::overdue(page, longest, Limit::End)));
            }
            std::thread::sleep(LOOK_FOR_END);
            waited += LOOK_FOR_END;
        }
    }

    /// Its status, if it has ended.
    fn status(&mut self) -> Option<ExitStatus> {
        self.child.try_wait().ok().flatten()
    }

    /// Ends the process, and gives what is told of it as it was before.
    fn kill(&mut self, death: impl FnOnce(&Page) -> Death) -> Death {
        let death = death(&self.page);
        let _ = self.child.kill();
        let _ = self.child.wait();
        death
    }
}

impl Drop for Process {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}
