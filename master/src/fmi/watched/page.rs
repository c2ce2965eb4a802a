//! The shared memory of a run and its parent: an open file without a name, mapped by both.

use std::fs::File;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::Duration;

use memmap2::{MmapOptions, MmapRaw};

use super::culprit::{Culprit, Record};
use super::labels::Labels;
use super::slot::{Call, Slot};

/// Threads that are watched; those beyond are not.
const THREADS: usize = 512;

/// All that is shared. Every part may be written and read at any time, and all zeros is the state before
/// anything has happened.
#[repr(C)]
struct Content {
    /// 0 while the run goes on; then 1 more than its exit code.
    finished: AtomicU32,
    /// Signal at which the run is to stop; 0 as long as there is none.
    stop: AtomicU32,
    /// Number of whole records.
    records: AtomicU64,
    /// Number of the step that goes on.
    step: AtomicU64,
    /// Bits of the time at which it began, s.
    time: AtomicU64,
    /// Number of slots that are taken.
    threads: AtomicU32,
    /// Bits of the longest times that calls may take, s; 0: any.
    limits: [AtomicU64; 3],
    record: Record,
    slots: [Slot; THREADS],
    labels: Labels,
}

/// Which calls may take so long.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// Those until the first step: loading, instantiation, initialisation.
    Start,
    /// Those of a step.
    Step,
    /// Those after the last step.
    End,
}

impl Limit {
    /// The option of the command line that sets it.
    pub fn option(self) -> &'static str {
        match self {
            Self::Start => "--start-limit",
            Self::Step => "--step-limit",
            Self::End => "--end-limit",
        }
    }
}

/// What a run and its parent share.
pub struct Page {
    map: MmapRaw,
}

impl Page {
    /// A page in `folder`, or where the system has memory for it, and the path at which the child finds
    /// it while this process lives.
    ///
    /// # Errors
    /// When there is no room.
    pub fn create(folder: &Path) -> io::Result<(Self, File, PathBuf)> {
        let (file, path) = shared_file(folder, size_of::<Content>())?;
        Ok((Self::map(&file)?, file, path))
    }

    /// The page that another process has made.
    ///
    /// # Errors
    /// When the file cannot be mapped.
    pub(super) fn open(file: &Path) -> io::Result<Self> {
        Self::map(&File::options().read(true).write(true).open(file)?)
    }

    fn map(file: &File) -> io::Result<Self> {
        MmapOptions::new().len(size_of::<Content>()).map_raw(file).map(|map| Self { map })
    }

    fn content(&self) -> &Content {
        // SAFETY: the map is as long as the content and begins at a page of memory; the content consists
        // of atomics, for which all bits are valid, and nobody cuts the file.
        unsafe { &*self.map.as_ptr().cast::<Content>() }
    }

    /// Says that all has been done that this process had to do, and its exit code.
    pub fn finish(&self, code: u8) {
        self.content().finished.store(1 + u32::from(code), Ordering::Release);
    }

    /// The exit code of a process that has done all it had to do.
    pub fn finished(&self) -> Option<u8> {
        let finished = self.content().finished.load(Ordering::Acquire);
        finished.checked_sub(1).and_then(|code| code.try_into().ok())
    }

    /// Asks the run to stop at its next step because of a signal.
    pub fn request_stop(&self, signal: i32) {
        self.content().stop.store(signal.unsigned_abs(), Ordering::Release);
    }

    /// The signal at which the run is to stop.
    pub fn stop(&self) -> Option<i32> {
        let signal = self.content().stop.load(Ordering::Acquire);
        (signal != 0).then(|| signal.cast_signed())
    }

    /// Notes the step that begins at a time, s.
    pub fn note_step(&self, step: u64, time: f64) {
        self.content().step.store(step, Ordering::Relaxed);
        self.content().time.store(time.to_bits(), Ordering::Relaxed);
    }

    /// The number of the last step that has begun and the time of its begin, s.
    pub fn step(&self) -> (u64, f64) {
        let Content { step, time, .. } = self.content();
        (step.load(Ordering::Relaxed), f64::from_bits(time.load(Ordering::Relaxed)))
    }

    /// Notes that a record is on disk in all tables.
    pub fn note_record(&self) {
        self.content().records.fetch_add(1, Ordering::Release);
    }

    /// Number of records that are on disk in all tables.
    pub fn records(&self) -> u64 {
        self.content().records.load(Ordering::Acquire)
    }

    /// Says how long calls may take, s; 0: as long as they want. It is for the calls in processes of their
    /// own; those of this process are limited by its parent.
    pub fn set_limit(&self, limit: Limit, seconds: f64) {
        self.content().limits[limit as usize].store(seconds.to_bits(), Ordering::Relaxed);
    }

    /// How long calls may take.
    pub fn limit(&self, limit: Limit) -> Option<Duration> {
        let bits = self.content().limits[limit as usize].load(Ordering::Relaxed);
        let limit = Duration::try_from_secs_f64(f64::from_bits(bits));
        limit.ok().filter(|limit| !limit.is_zero())
    }

    /// Who has ended the process, if it was one of its threads.
    pub fn culprit(&self) -> Option<Culprit> {
        self.content().record.culprit()
    }

    /// The calls that go on.
    pub fn calls(&self) -> Vec<Call> {
        let taken = self.content().threads.load(Ordering::Acquire) as usize;
        let slots = self.content().slots.iter().enumerate().take(taken);
        let call = |(thread, slot): (usize, &Slot)| {
            let (counter, label, function) = slot.read()?;
            Some(Call { thread, counter, function, subject: self.labels().text(label) })
        };
        slots.filter_map(call).collect()
    }

    pub(super) fn record(&self) -> &Record {
        &self.content().record
    }

    pub(super) fn labels(&self) -> &Labels {
        &self.content().labels
    }

    /// A slot for a thread, with its number; none where too many have one.
    pub(super) fn take_slot(&self) -> Option<(usize, &Slot)> {
        let number = self.content().threads.fetch_add(1, Ordering::AcqRel) as usize;
        self.content().slots.get(number).map(|slot| (number, slot))
    }
}

/// Memory of so many bytes as a file, which nobody can cut while it is mapped.
///
/// The child opens it under the path of this process's descriptor.
///
/// # Errors
/// When the system gives none.
#[cfg(target_os = "linux")]
pub(in crate::fmi) fn shared_file(_: &Path, length: usize) -> io::Result<(File, PathBuf)> {
    use std::os::fd::AsRawFd;

    use rustix::fs::{MemfdFlags, SealFlags, fcntl_add_seals, memfd_create};
    let flags = MemfdFlags::CLOEXEC | MemfdFlags::ALLOW_SEALING;
    let file = File::from(memfd_create("hotfoot", flags)?);
    file.set_len(length as u64)?;
    fcntl_add_seals(&file, SealFlags::SHRINK | SealFlags::GROW)?;
    let path = format!("/proc/{}/fd/{}", std::process::id(), file.as_raw_fd());
    Ok((file, path.into()))
}

/// A file of so many bytes in the folder.
#[cfg(not(target_os = "linux"))]
fn shared_file(folder: &Path, length: usize) -> io::Result<(File, PathBuf)> {
    let path = folder.join("page");
    let file = File::options().read(true).write(true).create_new(true).open(&path)?;
    file.set_len(length as u64)?;
    Ok((file, path))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fmi::watched::labels::Label;

    fn page() -> Page {
        let folder = tempfile::tempdir().unwrap();
        Page::create(folder.path()).unwrap().0
    }

    #[test]
    fn what_one_process_writes_another_reads() {
        let folder = tempfile::tempdir().unwrap();
        let (parent, _file, path) = Page::create(folder.path()).unwrap();
        let child = Page::open(&path).unwrap();
        assert_eq!((parent.finished(), child.stop(), parent.records()), (None, None, 0));
        child.note_step(7, 0.25);
        child.note_record();
        parent.request_stop(15);
        assert_eq!((parent.step(), parent.records(), child.stop()), ((7, 0.25), 1, Some(15)));
        child.finish(0);
        assert_eq!(parent.finished(), Some(0));
    }

    #[test]
    fn a_call_is_seen_while_it_goes_on() {
        let page = page();
        let (number, slot) = page.take_slot().unwrap();
        let label = page.labels().add("vehicle[2] (wagon.fmu)");
        assert!(page.calls().is_empty());
        for counter in [1, 3] {
            slot.begin(label, c"fmi2DoStep");
            let [call] = &page.calls()[..] else { panic!("there is one call") };
            assert_eq!((call.thread, call.counter), (number, counter));
            assert_eq!((&*call.function, &*call.subject), ("fmi2DoStep", "vehicle[2] (wagon.fmu)"));
            slot.end();
            assert!(page.calls().is_empty());
        }
    }

    /// More threads and names than there is room for are left out, not written elsewhere.
    #[test]
    fn what_has_no_room_is_not_noted() {
        let page = page();
        let taken = (0..THREADS + 10).filter(|_| page.take_slot().is_some());
        assert_eq!(taken.count(), THREADS);
        assert!(page.calls().is_empty());
        let long = "x".repeat(60_000);
        let labels: Vec<_> = (0..20).map(|_| page.labels().add(&long)).collect();
        assert_eq!(page.labels().text(labels[16]), long);
        assert_eq!((labels[17], &*page.labels().text(labels[17])), (Label::default(), "an FMU"));
    }
}
