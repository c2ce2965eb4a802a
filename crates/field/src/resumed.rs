//! Goes on with a field that is there.

use std::path::Path;

use crate::error::FieldError;
use crate::reader::FieldReader;
use crate::writer::FieldWriter;

impl FieldWriter {
    /// Goes on with the field at `path` behind its first `snapshots`; those that follow are removed.
    ///
    /// # Errors
    /// When there is no rail field, it has fewer snapshots, or it cannot be written.
    pub fn resume(path: &Path, snapshots: usize) -> Result<Self, FieldError> {
        let reader = FieldReader::open(path)?;
        let times = reader.times().get(..snapshots).ok_or_else(|| FieldError::TooShort {
            path: path.to_owned(),
            found: reader.times().len(),
            wanted: snapshots,
        })?;
        let writer = Self::after(path, reader.axes(), times)?;
        writer.cut()?;
        Ok(writer)
    }
}
