//! The memory by which a run asks another process and waits for its answer.

use std::fs::File;
use std::io;
use std::sync::atomic::{AtomicU32, AtomicU64, Ordering};
use std::time::{Duration, Instant};

use memmap2::{MmapOptions, MmapRaw};
use rustix::fs::Timespec;
use rustix::thread::futex;

/// Words that a request or an answer may hold.
pub const WORDS: usize = 8192;
/// Looks at a counter before the thread sleeps: about the time of a short step.
const LOOKS: u32 = 2000;

/// All that is shared. All zeros is the state before the first request.
#[repr(C)]
struct Content {
    /// Number of the last request.
    asked: AtomicU32,
    /// Number of the last request that has an answer.
    answered: AtomicU32,
    /// Number of words that are meant.
    length: AtomicU32,
    words: [AtomicU64; WORDS],
}

/// One side of the memory. Only atomics are shared, so that what the other side writes at the wrong
/// moment is at worst a wrong value.
pub struct Mailbox {
    map: MmapRaw,
}

impl Mailbox {
    /// Gives the file its length and maps it.
    ///
    /// # Errors
    /// When there is no room.
    pub fn create(file: &File) -> io::Result<Self> {
        file.set_len(size_of::<Content>() as u64)?;
        Self::open(file)
    }

    /// Maps the file that the other side has made.
    ///
    /// # Errors
    /// When the file is too short or cannot be mapped.
    pub fn open(file: &File) -> io::Result<Self> {
        if file.metadata()?.len() < size_of::<Content>() as u64 {
            return Err(io::ErrorKind::UnexpectedEof.into());
        }
        MmapOptions::new().len(size_of::<Content>()).map_raw(file).map(|map| Self { map })
    }

    fn content(&self) -> &Content {
        // SAFETY: the map is as long as the content and begins at a page of memory; the content consists
        // of atomics, for which all bits are valid, and nobody cuts the file.
        unsafe { &*self.map.as_ptr().cast::<Content>() }
    }

    /// Asks; the answer is to be awaited before the next request.
    ///
    /// # Panics
    /// When there are more than [`WORDS`] words.
    pub fn ask(&self, words: &[u64]) {
        self.write(words);
        tell(&self.content().asked);
    }

    /// The answer to the last request, or none after `limit`.
    pub fn answer(&self, limit: Duration) -> Option<Vec<u64>> {
        let Content { asked, answered, .. } = self.content();
        let before = asked.load(Ordering::Relaxed).wrapping_sub(1);
        changed(answered, before, limit).then(|| self.read())
    }

    /// The next request, or none after `limit`.
    pub fn request(&self, limit: Duration) -> Option<Vec<u64>> {
        let Content { asked, answered, .. } = self.content();
        changed(asked, answered.load(Ordering::Relaxed), limit).then(|| self.read())
    }

    /// Answers the last request.
    ///
    /// # Panics
    /// When there are more than [`WORDS`] words.
    pub fn reply(&self, words: &[u64]) {
        self.write(words);
        tell(&self.content().answered);
    }

    fn write(&self, words: &[u64]) {
        assert!(words.len() <= WORDS, "{} words, of which {WORDS} have room", words.len());
        let content = self.content();
        content.length.store(words.len() as u32, Ordering::Relaxed);
        for (shared, word) in content.words.iter().zip(words) {
            shared.store(*word, Ordering::Relaxed);
        }
    }

    /// What lies there; a length beyond the room, which only damage can state, is cut.
    fn read(&self) -> Vec<u64> {
        let content = self.content();
        let length = content.length.load(Ordering::Relaxed) as usize;
        content.words.iter().take(length).map(|word| word.load(Ordering::Relaxed)).collect()
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
    use super::*;

    const LONG: Duration = Duration::from_secs(10);

    #[test]
    fn each_request_has_its_answer_and_silence_is_noticed() {
        let file = tempfile::tempfile().unwrap();
        let (master, worker) = (Mailbox::create(&file).unwrap(), Mailbox::open(&file).unwrap());
        let serving = std::thread::spawn(move || {
            for _ in 0..1000 {
                let request = worker.request(LONG).unwrap();
                worker.reply(&request.iter().map(|word| word + 1).collect::<Vec<_>>());
            }
        });
        for number in 0..1000_u64 {
            master.ask(&[number, u64::MAX - 1]);
            assert_eq!(master.answer(LONG).unwrap(), [number + 1, u64::MAX]);
        }
        serving.join().unwrap();
        master.ask(&[0]);
        assert_eq!(master.answer(Duration::from_millis(20)), None);
    }

    #[test]
    fn a_file_that_is_too_short_is_refused() {
        assert!(Mailbox::open(&tempfile::tempfile().unwrap()).is_err());
    }
}
