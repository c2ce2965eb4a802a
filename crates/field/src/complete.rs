//! Completes a field whose writer was killed.

use std::path::Path;

use crate::error::FieldError;
use crate::layout::{self, SECTION_RISE, TEMPERATURE_RISE, TIME, WARMEST_CHAINAGE, WARMEST_RISE};
use crate::reader::{of_dimensions, open, open_if_there};

/// Gives a field whose writer was killed the same number of times, sections and snapshots: within an
/// append, time and sections become visible before the snapshot, and all before the group's copy of
/// their metadata.
///
/// # Errors
/// When there is no rail field at the path, or it cannot be written.
pub fn complete(path: &Path) -> Result<(), FieldError> {
    let store = layout::store(path)?;
    let rise = of_dimensions(path, open(path, &store, TEMPERATURE_RISE)?, 3)?;
    let time = of_dimensions(path, open(path, &store, TIME)?, 1)?;
    let snapshots = rise.shape()[0];
    let sections = [(SECTION_RISE, 3), (WARMEST_RISE, 2), (WARMEST_CHAINAGE, 1)];
    let sections = sections
        .into_iter()
        .map(|(name, dimensions)| open_if_there(path, &store, name, dimensions))
        .collect::<Result<Vec<_>, _>>()?;
    for mut array in std::iter::once(time).chain(sections.into_iter().flatten()) {
        let mut shape = array.shape().to_vec();
        if shape[0] != snapshots {
            shape[0] = snapshots;
            array.set_shape(shape).map_err(|error| FieldError::zarr(path, error))?;
            layout::write_metadata(path, &array)?;
        }
    }
    layout::consolidate(path)
}
