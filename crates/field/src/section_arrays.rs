//! The sections of a store: those at places, and the one where the foot is warmest.

use std::path::Path;

use crate::axes::{SectionRises, Sections};
use crate::error::FieldError;
use crate::layout::{self, StoredArray};

/// The arrays that grow with each snapshot.
pub(crate) struct SectionArrays {
    /// At places, if there are any.
    kept: Option<StoredArray>,
    warmest: StoredArray,
    warmest_chainage: StoredArray,
    /// Number of values of a snapshot at the places, and of one section.
    values: [usize; 2],
}

impl SectionArrays {
    /// The arrays of a store at `path`, still without a snapshot.
    pub fn new(path: &Path, sections: &Sections) -> Result<Self, FieldError> {
        let kept = match sections.chainage.is_empty() {
            true => None,
            false => Some(layout::section_rise(path, sections)?),
        };
        Ok(Self {
            kept,
            warmest: layout::warmest_rise(path, sections)?,
            warmest_chainage: layout::warmest_chainage(path)?,
            values: [sections.values(), sections.y.len()],
        })
    }

    /// All of them.
    pub fn all(&self) -> impl Iterator<Item = &StoredArray> {
        self.kept.iter().chain([&self.warmest, &self.warmest_chainage])
    }

    /// All of them, to be changed.
    pub fn all_mut(&mut self) -> impl Iterator<Item = &mut StoredArray> {
        self.kept.iter_mut().chain([&mut self.warmest, &mut self.warmest_chainage])
    }

    /// The number of values of each kind that a snapshot must have.
    pub fn values(&self) -> [usize; 2] {
        self.values
    }

    /// Stores the snapshot of this number.
    pub fn store(&self, path: &Path, n: u64, rises: &SectionRises) -> Result<(), FieldError> {
        if let Some(kept) = &self.kept {
            layout::store_chunk(path, kept, &[n, 0, 0], &rises.kept)?;
        }
        layout::store_chunk(path, &self.warmest_chainage, &[n], &[rises.warmest_chainage])?;
        layout::store_chunk(path, &self.warmest, &[n, 0], &rises.warmest)
    }
}
