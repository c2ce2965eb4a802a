//! Appends snapshots to a field while the simulation runs.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Map, Value, json};

use crate::axes::{Attribute, Axes, SectionRises};
use crate::error::FieldError;
use crate::layout::{self, KIND, StoredArray, store_chunk};
use crate::section_arrays::SectionArrays;

/// Appends snapshots of the temperature rise to a store on disk.
///
/// Nothing has to be finished: the store is complete after every [`append`](Self::append).
pub struct FieldWriter {
    path: PathBuf,
    temperature_rise: StoredArray,
    time: StoredArray,
    sections: Option<SectionArrays>,
    /// One snapshot with the padding that fills the last chunk.
    shard: Vec<f32>,
    values: usize,
    snapshots: u64,
    last: Option<f64>,
}

impl FieldWriter {
    /// Begins a field at `path`.
    ///
    /// A rail field that is there already is replaced; anything else is left alone and refused.
    ///
    /// # Errors
    /// When an axis is empty, something else is at the path, or it cannot be written.
    pub fn create(
        path: &Path,
        axes: &Axes,
        attributes: &[(&str, Attribute)],
    ) -> Result<Self, FieldError> {
        let sections = axes.sections.iter();
        let of_sections = sections.map(|sections| ("cell", &sections.y));
        let of_field = [("chainage", &axes.chainage), ("depth", &axes.depth)];
        for (axis, values) in of_field.into_iter().chain(of_sections) {
            if values.is_empty() {
                let path = path.to_owned();
                return Err(FieldError::EmptyAxis { path, axis });
            }
        }
        make_room(path)?;
        write_group(path, attributes)?;
        let chainage = layout::chainage(path, axes.chainage.len())?;
        let depth = layout::depth(path, axes.depth.len())?;
        for (array, values) in [(chainage, &axes.chainage), (depth, &axes.depth)] {
            store_chunk(path, &array, &[0], values)?;
            layout::write_metadata(path, &array)?;
        }
        if let Some(sections) = &axes.sections {
            for (array, values) in layout::of_sections(path, sections)? {
                store_chunk(path, &array, &[0], values)?;
                layout::write_metadata(path, &array)?;
            }
        }
        let writer = Self::after(path, axes, &[])?;
        writer.show()?;
        Ok(writer)
    }

    /// A writer of the store at `path` behind the snapshots of these times, s.
    pub(crate) fn after(path: &Path, axes: &Axes, times: &[f64]) -> Result<Self, FieldError> {
        let (temperature_rise, time) = (layout::temperature_rise(path, axes)?, layout::time(path)?);
        let shard = shard_values(path, &temperature_rise)?;
        let sections = match &axes.sections {
            Some(sections) => Some(SectionArrays::new(path, sections)?),
            None => None,
        };
        let mut writer = Self {
            path: path.to_owned(),
            temperature_rise,
            time,
            sections,
            shard: vec![f32::NAN; shard],
            values: axes.values(),
            snapshots: times.len() as u64,
            last: times.last().copied(),
        };
        writer.set_length(writer.snapshots)?;
        Ok(writer)
    }

    /// Removes what lies behind the last snapshot.
    pub(crate) fn cut(&self) -> Result<(), FieldError> {
        self.show()?;
        let zarr = |error: &dyn std::fmt::Display| FieldError::Zarr {
            path: self.path.clone(),
            reason: error.to_string(),
        };
        for n in self.snapshots.. {
            let mut found = false;
            let sections = self.sections.iter().flat_map(SectionArrays::all);
            for array in [&self.time, &self.temperature_rise].into_iter().chain(sections) {
                let chunk = &[n, 0, 0][..array.dimensionality()];
                found |= array.retrieve_encoded_chunk(chunk).map_err(|e| zarr(&e))?.is_some();
                array.erase_chunk(chunk).map_err(|e| zarr(&e))?;
            }
            if !found {
                break;
            }
        }
        Ok(())
    }

    fn set_length(&mut self, snapshots: u64) -> Result<(), FieldError> {
        grow(&self.path, &mut self.time, snapshots)?;
        for array in self.sections.iter_mut().flat_map(SectionArrays::all_mut) {
            grow(&self.path, array, snapshots)?;
        }
        grow(&self.path, &mut self.temperature_rise, snapshots)
    }

    /// Makes visible what is on disk; the field itself last, whose length is that of the store.
    fn show(&self) -> Result<(), FieldError> {
        layout::write_metadata(&self.path, &self.time)?;
        for array in self.sections.iter().flat_map(SectionArrays::all) {
            layout::write_metadata(&self.path, array)?;
        }
        layout::write_metadata(&self.path, &self.temperature_rise)?;
        layout::consolidate(&self.path)
    }

    /// Appends the snapshot at `time` in s: the rise in K, the depths of the first element first, and
    /// those of the sections.
    ///
    /// # Errors
    /// When the snapshot has the wrong size, does not come after the last one, or cannot be
    /// written; the snapshots before it stay readable. When the store is no longer there: nothing is
    /// written then, for half of a store is none.
    pub fn append(
        &mut self,
        time: f64,
        rise: &[f32],
        sections: &SectionRises,
    ) -> Result<(), FieldError> {
        self.check(time, rise, sections)?;
        let written = self.write(time, rise, sections);
        match written.is_err() && !is_rail_field(&self.path) {
            true => Err(self.gone()),
            false => written,
        }
    }

    /// As [`Self::append`], of a snapshot of the right size.
    fn write(&mut self, time: f64, rise: &[f32], rises: &SectionRises) -> Result<(), FieldError> {
        self.shard[..self.values].copy_from_slice(rise);
        let n = self.snapshots;
        self.set_length(n + 1)?;
        store_chunk(&self.path, &self.time, &[n], &[time])?;
        if let Some(sections) = &self.sections {
            sections.store(&self.path, n, rises)?;
        }
        store_chunk(&self.path, &self.temperature_rise, &[n, 0, 0], &self.shard)?;
        // The values are on disk; now they become visible.
        self.show()?;
        self.snapshots = n + 1;
        self.last = Some(time);
        Ok(())
    }

    /// Time of the last snapshot, s.
    pub fn last_time(&self) -> Option<f64> {
        self.last
    }

    fn gone(&self) -> FieldError {
        FieldError::Gone { path: self.path.clone() }
    }

    fn check(&self, time: f64, rise: &[f32], rises: &SectionRises) -> Result<(), FieldError> {
        let [kept, section] = self.sections.as_ref().map_or([0, 0], SectionArrays::values);
        for (found, wanted) in
            [(rise.len(), self.values), (rises.kept.len(), kept), (rises.warmest.len(), section)]
        {
            if found != wanted {
                return Err(FieldError::Size { path: self.path.clone(), found, wanted });
            }
        }
        if !is_rail_field(&self.path) {
            return Err(self.gone());
        }
        match self.last {
            Some(last) if time <= last => {
                Err(FieldError::NotLater { path: self.path.clone(), time, last })
            }
            _ => Ok(()),
        }
    }
}

/// Removes an older rail field at `path`.
fn make_room(path: &Path) -> Result<(), FieldError> {
    let io = |source| FieldError::io(path, source);
    if !path.try_exists().map_err(io)? {
        return Ok(());
    }
    if is_rail_field(path) {
        return fs::remove_dir_all(path).map_err(io);
    }
    // A writer that was killed at its very beginning leaves the metadata under another name.
    let begun = |entry: &std::io::Result<fs::DirEntry>| {
        entry.as_ref().is_ok_and(|entry| entry.file_name() == layout::PARTIAL)
    };
    if path.is_dir() && fs::read_dir(path).map_err(io)?.all(|entry| begun(&entry)) {
        Ok(())
    } else {
        let path = path.to_owned();
        Err(FieldError::Occupied { path })
    }
}

/// Whether the group at `path` says that it is a rail field.
pub fn is_rail_field(path: &Path) -> bool {
    let metadata = fs::read_to_string(path.join("zarr.json"))
        .ok()
        .and_then(|text| serde_json::from_str::<Value>(&text).ok());
    metadata.is_some_and(|metadata| metadata["attributes"][KIND.0] == KIND.1)
}

fn write_group(path: &Path, attributes: &[(&str, Attribute)]) -> Result<(), FieldError> {
    let mut all = Map::from_iter([
        (KIND.0.to_owned(), Value::from(KIND.1)),
        ("Conventions".to_owned(), Value::from("CF-1.11")),
    ]);
    all.extend(attributes.iter().map(|(name, value)| ((*name).to_owned(), value.into())));
    let group = json!({ "zarr_format": 3, "node_type": "group", "attributes": all });
    layout::write_whole(path, &format!("{group:#}")).map_err(|source| FieldError::io(path, source))
}

/// Number of values of a shard of the field.
fn shard_values(path: &Path, array: &StoredArray) -> Result<usize, FieldError> {
    let shape = array.chunk_shape(&[0, 0, 0]).map_err(|error| FieldError::zarr(path, error))?;
    Ok(shape.iter().map(|length| length.get() as usize).product())
}

fn grow(path: &Path, array: &mut StoredArray, snapshots: u64) -> Result<(), FieldError> {
    let mut shape = array.shape().to_vec();
    shape[0] = snapshots;
    array.set_shape(shape).map(|_| ()).map_err(|error| FieldError::zarr(path, error))
}
