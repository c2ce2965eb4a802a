//! The memory by which a run asks another process and waits for its answer.

use std::fs::File;
use std::io;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use memmap2::{MmapOptions, MmapRaw};
use rustix::fs::Timespec;
use rustix::thread::futex;

/// Bytes of a word.
const WORD: usize = size_of::<u64>();
/// Looks at a counter before the thread sleeps: about the time of a short step.
const LOOKS: u32 = 2000;

/// What stands before the bytes of a request or an answer. All zeros is the state before the first request.
#[repr(C)]
struct Head {
    /// Number of the last request.
    asked: AtomicU32,
    /// Number of the last request that has an answer.
    answered: AtomicU32,
    /// Number of bytes that are meant.
    length: AtomicU64,
}

/// A request or an answer is longer than the memory.
#[derive(Debug, PartialEq, Eq, thiserror::Error)]
#[error("{length} bytes are more than the {room} that are shared with the process of the FMU")]
pub struct TooLong {
    length: usize,
    room: usize,
}

/// One side of the memory. Only atomics are shared, so that what the other side writes at the wrong
/// moment is at worst a wrong value.
pub struct Mailbox {
    map: MmapRaw,
}

impl Mailbox {
    /// Bytes of memory that requests and answers of so many bytes need.
    pub const fn length(room: usize) -> usize {
        size_of::<Head>() + room.next_multiple_of(WORD)
    }

    /// Maps the memory, of which all is zero at first.
    ///
    /// # Errors
    /// When the file is too short or cannot be mapped.
    pub fn open(file: &File) -> io::Result<Self> {
        let length = usize::try_from(file.metadata()?.len()).unwrap_or(0);
        if length < size_of::<Head>() {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        MmapOptions::new().len(length).map_raw(file).map(|map| Self { map })
    }

    fn head(&self) -> &Head {
        // SAFETY: the map is at least as long as the head and begins at a page of memory; the head consists
        // of atomics, for which all bits are valid, and the file cannot be cut.
        unsafe { &*self.map.as_ptr().cast::<Head>() }
    }

    fn words(&self) -> &[AtomicU64] {
        let count = (self.map.len() - size_of::<Head>()) / WORD;
        // SAFETY: so many words lie behind the head, whose length is a multiple of theirs; for atomics all
        // bits are valid, and the file cannot be cut.
        unsafe {
            let begin = self.map.as_ptr().add(size_of::<Head>()).cast::<AtomicU64>();
            std::slice::from_raw_parts(begin, count)
        }
    }

    /// Asks; the answer is to be awaited before the next request.
    ///
    /// # Errors
    /// When there is no room for it.
    pub fn ask(&self, bytes: &[u8]) -> Result<(), TooLong> {
        self.write(bytes)?;
        tell(&self.head().asked);
        Ok(())
    }

    /// The answer to the last request, or none after `limit`.
    pub fn answer(&self, limit: Duration) -> Option<Vec<u8>> {
        let Head { asked, answered, .. } = self.head();
        let before = asked.load(Ordering::Relaxed).wrapping_sub(1);
        changed(answered, before, limit).then(|| self.read())
    }

    /// The next request, or none after `limit`.
    pub fn request(&self, limit: Duration) -> Option<Vec<u8>> {
        let Head { asked, answered, .. } = self.head();
        changed(asked, answered.load(Ordering::Relaxed), limit).then(|| self.read())
    }

    /// Answers the last request.
    ///
    /// # Errors
    /// When there is no room for it.
    pub fn reply(&self, bytes: &[u8]) -> Result<(), TooLong> {
        self.write(bytes)?;
        tell(&self.head().answered);
        Ok(())
    }

    fn write(&self, bytes: &[u8]) -> Result<(), TooLong> {
        let words = self.words();
        let (length, room) = (bytes.len(), words.len() * WORD);
        if length > room {
            return Err(TooLong { length, room });
        }
        self.head().length.store(length as u64, Ordering::Relaxed);
        for (shared, chunk) in words.iter().zip(bytes.chunks(WORD)) {
            let mut word = [0; WORD];
            word[..chunk.len()].copy_from_slice(chunk);
            shared.store(u64::from_ne_bytes(word), Ordering::Relaxed);
        }
        Ok(())
    }

    /// What lies there; a length beyond the room, which only damage can state, is cut.
    fn read(&self) -> Vec<u8> {
        let words = self.words();
        let stated = usize::try_from(self.head().length.load(Ordering::Relaxed));
        let length = stated.unwrap_or(usize::MAX).min(words.len() * WORD);
        let shared = &words[..length.div_ceil(WORD)];
        let bytes = shared.iter().flat_map(|word| word.load(Ordering::Relaxed).to_ne_bytes());
        bytes.take(length).collect()
    }
}

/// Counts one further and wakes the other side.
fn tell(counter: &AtomicU32) {
    counter.fetch_add(1, Ordering::Release);
    // A side that does not sleep needs no waking.
    let _ = futex::wake(counter, futex::Flags::empty(), 1);
}

/// Whether the counter leaves `old` within `limit`.
fn changed(counter: &AtomicU32, old: u32, limit: Duration) -> bool {
    let differs = || counter.load(Ordering::Acquire) != old;
    for _ in 0..LOOKS {
        if differs() {
            return true;
        }
        std::hint::spin_loop();
    }
    let end = Instant::now() + limit;
    while !differs() {
        let left = end.saturating_duration_since(Instant::now());
        let Ok(timeout) = Timespec::try_from(left) else { return false };
        if left.is_zero() {
            return false;
        }
        // Woken, changed before or interrupted: the counter says which.
        let _ = futex::wait(counter, futex::Flags::empty(), old, Some(&timeout));
    }
    true
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::fmi::watched::shared_file;

    const LONG: Duration = Duration::from_secs(10);

    #[test]
    fn each_request_has_its_answer_and_silence_is_noticed() {
        let (file, _) = shared_file(Path::new(""), Mailbox::length(100)).unwrap();
        let (master, worker) = (Mailbox::open(&file).unwrap(), Mailbox::open(&file).unwrap());
        let serving = std::thread::spawn(move || {
            for _ in 0..1000 {
                let mut request = worker.request(LONG).unwrap();
                request.reverse();
                worker.reply(&request).unwrap();
            }
        });
        for number in 0..1000_u16 {
            let text: Vec<u8> = (0..number % 101).map(|byte| byte as u8).collect();
            master.ask(&text).unwrap();
            let answer = master.answer(LONG).unwrap();
            assert!(answer.iter().rev().eq(&text), "{number}");
        }
        serving.join().unwrap();
        master.ask(&[0]).unwrap();
        assert_eq!(master.answer(Duration::from_millis(20)), None);
    }

    #[test]
    fn what_has_no_room_is_refused() {
        let (file, _) = shared_file(Path::new(""), Mailbox::length(16)).unwrap();
        let mailbox = Mailbox::open(&file).unwrap();
        assert_eq!(mailbox.ask(&[1; 17]), Err(TooLong { length: 17, room: 16 }));
        assert!(mailbox.ask(&[1; 16]).is_ok());
        assert!(file.set_len(0).is_err(), "the memory was cut while it was mapped");
        assert!(Mailbox::open(&tempfile::tempfile().unwrap()).is_err());
    }
}
