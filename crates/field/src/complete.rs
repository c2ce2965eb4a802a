//! Completes a field whose writer was killed.

use std::path::Path;

use crate::error::FieldError;
use crate::layout::{self, TEMPERATURE_RISE, TIME};
use crate::reader::{of_dimensions, open};

/// Gives a field whose writer was killed the same number of times and snapshots: within an append, the
/// time becomes visible before its snapshot, and both before the group's copy of their metadata.
///
/// # Errors
/// When there is no rail field at the path, or it cannot be written.
pub fn complete(path: &Path) -> Result<(), FieldError> {
    let store = layout::store(path)?;
    let rise = of_dimensions(path, open(path, &store, TEMPERATURE_RISE)?, 3)?;
    let mut time = of_dimensions(path, open(path, &store, TIME)?, 1)?;
    let snapshots = rise.shape()[0];
    if time.shape()[0] != snapshots {
        time.set_shape(vec![snapshots]).map_err(|error| FieldError::zarr(path, error))?;
        layout::write_metadata(path, &time)?;
    }
    layout::consolidate(path)
}
