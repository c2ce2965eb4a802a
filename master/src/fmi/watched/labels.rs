//! The names of instances and files, which stay where they are written as long as the page.

use std::sync::atomic::{AtomicU8, AtomicU32, Ordering};

/// Room for names, bytes: some ten thousand of them.
const ROOM: usize = 1 << 20;
/// Bytes before a name, which hold its length.
const HEAD: usize = 2;

/// A name on the page; 0 is none.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Label(pub(super) u32);

/// The names of a page.
#[repr(C)]
pub(super) struct Labels {
    used: AtomicU32,
    bytes: [AtomicU8; ROOM],
}

impl Labels {
    /// Adds a name; without room for it there is none.
    pub fn add(&self, name: &str) -> Label {
        let bytes = &name.as_bytes()[..name.len().min(usize::from(u16::MAX))];
        let needed = HEAD + bytes.len();
        let begin = self.used.fetch_add(needed as u32, Ordering::Relaxed) as usize;
        let Some(room) = self.bytes.get(begin..begin + needed) else { return Label::default() };
        let length = (bytes.len() as u16).to_ne_bytes();
        for (stored, byte) in room.iter().zip(length.iter().chain(bytes)) {
            stored.store(*byte, Ordering::Relaxed);
        }
        Label(begin as u32 + 1)
    }

    /// The text of a name.
    pub fn text(&self, label: Label) -> String {
        let load = |byte: &AtomicU8| byte.load(Ordering::Relaxed);
        let name = |begin: usize| {
            let head = self.bytes.get(begin..begin + HEAD)?;
            let length = usize::from(u16::from_ne_bytes([load(&head[0]), load(&head[1])]));
            let begin = begin + HEAD;
            let bytes: Vec<u8> = self.bytes.get(begin..begin + length)?.iter().map(load).collect();
            Some(String::from_utf8_lossy(&bytes).into_owned())
        };
        let begin = (label.0 as usize).checked_sub(1);
        begin.and_then(name).unwrap_or_else(|| "an FMU".to_owned())
    }
}
