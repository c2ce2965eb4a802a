//! What the process of an isolated FMU does.
//!
//! It makes the instance, calls it as it is asked to, and ends with the run.

use std::env;
use std::fs::File;
use std::io::{self, Read};
use std::os::fd::AsFd;
use std::path::Path;
use std::process::ExitCode;
use std::sync::Arc;
use std::thread;
use std::time::Duration;

use rustix::process::{Signal, getpid, kill_process};

use super::mailbox::Mailbox;
use super::message::{Answer, Call, Failure, Given, Instance, Request};
use crate::fmi::import::Import;
use crate::fmi::instance::FmuInstance;
use crate::fmi::library::note_unloading;
use crate::fmi::watched;
use crate::system::unit::{Unit, UnitError};

/// The first argument of such a process.
pub(super) const COMMAND: &str = "isolated-fmu";

/// Time between two looks for a request where none comes: a waking tells of one.
const LOOK: Duration = Duration::from_secs(10);

/// Serves a run until it needs the FMU no more, if this process was started for that.
pub fn serve() -> Option<ExitCode> {
    let mut arguments = env::args_os().skip(1);
    if arguments.next()? != COMMAND {
        return None;
    }
    let (mailbox, page) = (arguments.next()?, arguments.next()?);
    let served = work(Path::new(&mailbox), Path::new(&page));
    Some(if served.is_ok() { ExitCode::SUCCESS } else { ExitCode::FAILURE })
}

fn work(mailbox: &Path, page: &Path) -> io::Result<()> {
    let page = watched::watch(page)?;
    end_with_the_run()?;
    let mailbox = Mailbox::open(&File::options().read(true).write(true).open(mailbox)?)?;
    let mut instance = None;
    loop {
        let Some(request) = mailbox.request(LOOK) else { continue };
        let request = postcard::from_bytes(&request).map_err(io::Error::other)?;
        let is_last = request == Request::Free;
        let answer = carry_out(request, &mut instance);
        if is_last {
            page.finish(0);
        }
        reply(&mailbox, &answer)?;
        if is_last {
            note_unloading();
            return Ok(());
        }
    }
}

/// Closes the standard input to the FMU, and ends this process when the run, which holds the other end,
/// closes it: also in a call without end.
fn end_with_the_run() -> io::Result<()> {
    let mut run = File::from(io::stdin().as_fd().try_clone_to_owned()?);
    rustix::stdio::dup2_stdin(File::open("/dev/null")?)?;
    thread::Builder::new().name("run".to_owned()).spawn(move || {
        let _ = run.read_to_end(&mut vec![]);
        let _ = kill_process(getpid(), Signal::KILL);
    })?;
    Ok(())
}

fn reply(mailbox: &Mailbox, answer: &Answer) -> io::Result<()> {
    let bytes = postcard::to_allocvec(answer).map_err(io::Error::other)?;
    let Err(too_long) = mailbox.reply(&bytes) else { return Ok(()) };
    let failure = Failure {
        action: "the way of what it gave".to_owned(),
        status: None,
        last_message: Some(too_long.to_string()),
    };
    let bytes = postcard::to_allocvec(&Answer { failure: Some(failure), ..Answer::default() });
    mailbox.reply(&bytes.map_err(io::Error::other)?).map_err(io::Error::other)
}

fn carry_out(request: Request, instance: &mut Option<FmuInstance>) -> Answer {
    let mut answer = Answer::default();
    match request {
        Request::Make(wanted) => match make(wanted) {
            Ok(made) => *instance = Some(made),
            Err(failure) => answer.failure = Some(failure),
        },
        Request::Free => *instance = None,
        Request::Calls(calls) => {
            let Some(instance) = instance else { return answer };
            for call in calls {
                match carry_out_call(instance, call) {
                    Ok(given) => answer.given.push(given),
                    Err(error) => {
                        answer.failure = Some(error.into());
                        break;
                    }
                }
            }
        }
    }
    if let Some(instance) = instance {
        answer.wish_to_end = instance.wish_to_end();
        answer.warnings = instance.take_warnings();
    }
    answer
}

fn make(wanted: Instance) -> Result<FmuInstance, Failure> {
    let Instance { file, folder, name, tolerance, retries } = wanted;
    let import = Import::of_folder(file, folder).map_err(|error| Failure {
        action: "reading of the unpacked FMU".to_owned(),
        status: None,
        last_message: Some(error.to_string()),
    })?;
    let instance = FmuInstance::new(&Arc::new(import), &name)?.with_tolerance(tolerance);
    Ok(if retries { instance.retrying() } else { instance })
}

fn carry_out_call(instance: &mut FmuInstance, call: Call) -> Result<Given, UnitError> {
    match call {
        Call::SetReals(references, values) => instance.set_reals(&references, &values)?,
        Call::SetIntegers(references, values) => instance.set_integers(&references, &values)?,
        Call::SetBooleans(references, values) => instance.set_booleans(&references, &values)?,
        Call::SetText(reference, text) => instance.set_text(reference, &text)?,
        Call::GetReals(references) => {
            let mut values = vec![0.0; references.len()];
            instance.get_reals(&references, &mut values)?;
            return Ok(Given::Reals(values));
        }
        Call::GetIntegers(references) => {
            let mut values = vec![0; references.len()];
            instance.get_integers(&references, &mut values)?;
            return Ok(Given::Integers(values));
        }
        Call::GetBooleans(references) => {
            let mut values = vec![0; references.len()];
            instance.get_booleans(&references, &mut values)?;
            return Ok(Given::Integers(values));
        }
        Call::GetText(reference) => return Ok(Given::Text(instance.get_text(reference)?)),
        Call::EnterInitialization(start, stop) => instance.enter_initialization(start, stop)?,
        Call::ExitInitialization => instance.exit_initialization()?,
        Call::Save => return Ok(Given::Saved(instance.save()?)),
        Call::Restore(saved) => instance.restore(&saved)?,
        Call::Step(time, length) => instance.step(time, length)?,
        Call::Terminate => instance.terminate()?,
    }
    Ok(Given::Nothing)
}
