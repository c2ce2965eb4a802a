//! Reads the snapshots of a field.

use std::io;
use std::path::{Path, PathBuf};

use zarrs::array::{ArraySubset, ElementOwned, FromArrayBytes};

use crate::axes::{Axes, Sections};
use crate::error::FieldError;
use crate::layout::{
    self, CHAINAGE, DEPTH, SECTION_AREA, SECTION_CHAINAGE, SECTION_RISE, SECTION_Y, SECTION_Z,
    Store, StoredArray, TEMPERATURE_RISE, TIME, WARMEST_CHAINAGE, WARMEST_RISE,
};
use crate::writer::is_rail_field;

/// Most values of a coordinate: a line of 1000 km in elements of 0.1 m.
///
/// The values are all read, and the length is what the metadata says, whatever is stored.
const LONGEST_AXIS: u64 = 10_000_000;

/// The temperature rise at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Rise above the initial state, K; the depths of the first element first.
    pub rise: Vec<f32>,
}

/// The section where the foot is warmest at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct WarmestSection {
    /// Where that is, m.
    pub chainage: f64,
    /// Rise of each cell above the initial state, K, the mean of left and right.
    pub rise: Vec<f32>,
}

/// The fields in a folder, by name.
///
/// # Errors
/// When the folder cannot be read.
pub fn fields_in(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let entries = std::fs::read_dir(folder)?.flatten().map(|entry| entry.path());
    let mut fields: Vec<PathBuf> = entries.filter(|path| is_rail_field(path)).collect();
    fields.sort();
    Ok(fields)
}

/// Reads a field, also one that is still being written or whose writer was killed.
pub struct FieldReader {
    path: PathBuf,
    temperature_rise: StoredArray,
    section_rise: Option<StoredArray>,
    /// The section where the foot is warmest, and its chainages.
    warmest: Option<(StoredArray, StoredArray)>,
    axes: Axes,
    times: Vec<f64>,
}

impl FieldReader {
    /// Opens the field at `path` with the snapshots that it has now.
    ///
    /// # Errors
    /// When there is no rail field at the path, or it cannot be read.
    pub fn open(path: &Path) -> Result<Self, FieldError> {
        if !is_rail_field(path) {
            return Err(FieldError::NotAField {
                path: path.to_owned(),
                reason: "zarr.json is missing or not one that Hotfoot wrote".to_owned(),
            });
        }
        let store = layout::store(path)?;
        let temperature_rise = of_dimensions(path, open(path, &store, TEMPERATURE_RISE)?, 3)?;
        let axis = |name| coordinate(path, &of_dimensions(path, open(path, &store, name)?, 1)?);
        let of_sections = |name, wanted| open_if_there(path, &store, name, wanted);
        let section_rise = of_sections(SECTION_RISE, 3)?;
        let warmest = of_sections(WARMEST_RISE, 2)?.zip(of_sections(WARMEST_CHAINAGE, 1)?);
        let sections = match section_rise.is_some() || warmest.is_some() {
            false => None,
            true => Some(Sections {
                chainage: section_rise.as_ref().map_or(Ok(vec![]), |_| axis(SECTION_CHAINAGE))?,
                y: axis(SECTION_Y)?,
                z: axis(SECTION_Z)?,
                area: axis(SECTION_AREA)?,
            }),
        };
        let axes = Axes { chainage: axis(CHAINAGE)?, depth: axis(DEPTH)?, sections };
        let mut times = axis(TIME)?;
        // A writer that was killed within an append may have made the time visible only.
        times.truncate(temperature_rise.shape()[0] as usize);
        Ok(Self { path: path.to_owned(), temperature_rise, section_rise, warmest, axes, times })
    }

    /// Where the values of each snapshot lie.
    pub fn axes(&self) -> &Axes {
        &self.axes
    }

    /// Times of the snapshots, s, rising.
    pub fn times(&self) -> &[f64] {
        &self.times
    }

    /// The snapshot nearest to `time` in s, the earlier one of two that are equally near.
    ///
    /// # Errors
    /// When the field has no snapshot or the file cannot be read.
    pub fn at_time(&self, time: f64) -> Result<Snapshot, FieldError> {
        self.snapshot(self.nearest(time)?)
    }

    /// The sections at the snapshot nearest to `time`: the rise in K, the cells of the first place first;
    /// nothing where none are kept.
    ///
    /// # Errors
    /// When the field has no snapshot or the file cannot be read.
    pub fn sections_at_time(&self, time: f64) -> Result<Vec<f32>, FieldError> {
        let (Some(array), Some(sections)) = (&self.section_rise, &self.axes.sections) else {
            return Ok(vec![]);
        };
        let index = self.nearest(time)? as u64;
        let (probes, cells) = (sections.chainage.len() as u64, sections.y.len() as u64);
        let ranges = [index..index + 1, 0..probes, 0..cells];
        read(&self.path, array, &ArraySubset::new_with_ranges(&ranges))
    }

    /// The section where the foot is warmest at the snapshot nearest to `time`; none of a rail without a
    /// whole section.
    ///
    /// # Errors
    /// When the field has no snapshot or the file cannot be read.
    pub fn warmest_at_time(&self, time: f64) -> Result<Option<WarmestSection>, FieldError> {
        let (Some((rise, chainage)), Some(sections)) = (&self.warmest, &self.axes.sections) else {
            return Ok(None);
        };
        let index = self.nearest(time)? as u64;
        let (now, cells) = (index..index + 1, 0..sections.y.len() as u64);
        let at: Vec<f64> =
            read(&self.path, chainage, &ArraySubset::new_with_ranges(std::slice::from_ref(&now)))?;
        let rise = read(&self.path, rise, &ArraySubset::new_with_ranges(&[now, cells]))?;
        Ok(Some(WarmestSection { chainage: at[0], rise }))
    }

    /// The number of the snapshot nearest to a time, the earlier one of two.
    fn nearest(&self, time: f64) -> Result<usize, FieldError> {
        let distance = |index: &usize| (self.times[*index] - time).abs();
        (0..self.times.len())
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .ok_or_else(|| FieldError::NoSnapshot { path: self.path.clone() })
    }

    /// The snapshot number `index`, from zero, of [`times`](Self::times).
    fn snapshot(&self, index: usize) -> Result<Snapshot, FieldError> {
        let (elements, depths) = (self.axes.chainage.len(), self.axes.depth.len());
        let index_range = index as u64..index as u64 + 1;
        let subset =
            ArraySubset::new_with_ranges(&[index_range, 0..elements as u64, 0..depths as u64]);
        Ok(Snapshot {
            time: self.times[index],
            rise: read(&self.path, &self.temperature_rise, &subset)?,
        })
    }
}

pub(crate) fn open(path: &Path, store: &Store, name: &str) -> Result<StoredArray, FieldError> {
    StoredArray::open(store.clone(), &format!("/{name}")).map_err(|error| FieldError::NotAField {
        path: path.to_owned(),
        reason: format!("array {name}: {error}"),
    })
}

/// An array of sections with so many dimensions, if the store has it.
pub(crate) fn open_if_there(
    path: &Path,
    store: &Store,
    name: &str,
    dimensions: usize,
) -> Result<Option<StoredArray>, FieldError> {
    match path.join(name).is_dir() {
        true => of_dimensions(path, open(path, store, name)?, dimensions).map(Some),
        false => Ok(None),
    }
}

/// The array, if it has so many dimensions.
pub(crate) fn of_dimensions(
    path: &Path,
    array: StoredArray,
    wanted: usize,
) -> Result<StoredArray, FieldError> {
    match array.dimensionality() {
        found if found == wanted => Ok(array),
        found => {
            let name = array.path().to_string();
            let reason = format!("array {name} must have {wanted} dimensions, not {found}");
            Err(FieldError::NotAField { path: path.to_owned(), reason })
        }
    }
}

fn coordinate(path: &Path, array: &StoredArray) -> Result<Vec<f64>, FieldError> {
    let length = array.shape()[0];
    if length > LONGEST_AXIS {
        let name = array.path().to_string();
        let reason =
            format!("array {name} has {length} values; it must have {LONGEST_AXIS} at most");
        return Err(FieldError::NotAField { path: path.to_owned(), reason });
    }
    read(path, array, &array.subset_all())
}

fn read<T: ElementOwned>(
    path: &Path,
    array: &StoredArray,
    subset: &ArraySubset,
) -> Result<Vec<T>, FieldError>
where
    Vec<T>: FromArrayBytes,
{
    array
        .retrieve_array_subset_opt(subset, &layout::in_this_thread())
        .map_err(|error| FieldError::zarr(path, error))
}
