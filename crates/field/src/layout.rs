//! Names, chunks and codecs of the store.

use std::fs;
use std::path::Path;
use std::sync::Arc;

use serde_json::{Map, Value, json};
use zarrs::array::codec::ZstdCodec;
use zarrs::array::{Array, ArrayBuilder, ArrayMetadataOptions, CodecOptions, data_type};
use zarrs::filesystem::FilesystemStore;

use crate::axes::{Axes, Sections};
use crate::error::FieldError;

pub(crate) type Store = Arc<FilesystemStore>;
pub(crate) type StoredArray = Array<FilesystemStore>;

pub(crate) const TEMPERATURE_RISE: &str = "temperature_rise";
pub(crate) const TIME: &str = "time";
pub(crate) const CHAINAGE: &str = "chainage";
pub(crate) const DEPTH: &str = "depth";
pub(crate) const SECTION_RISE: &str = "section_rise";
pub(crate) const WARMEST_RISE: &str = "warmest_section_rise";
pub(crate) const WARMEST_CHAINAGE: &str = "warmest_section_chainage";
pub(crate) const SECTION_CHAINAGE: &str = "section_chainage";
pub(crate) const SECTION_Y: &str = "section_y";
pub(crate) const SECTION_Z: &str = "section_z";
pub(crate) const SECTION_AREA: &str = "section_area";
/// Dimensions of sections besides time.
const PROBE: &str = "probe";
const CELL: &str = "cell";

/// Attribute by which a store is known to be a rail field.
pub(crate) const KIND: (&str, &str) = ("kind", "hotfoot rail field");

/// Elements along the track in one compressed chunk.
///
/// With some 35 depths they are about 140 kB of f32, which decode in a fraction of a millisecond
/// when only a short length of rail is wanted.
const CHUNK_ELEMENTS: u64 = 1024;

/// Name of the metadata of the group and of each array.
const METADATA: &str = "zarr.json";

/// Name of metadata that are being written.
pub(crate) const PARTIAL: &str = "zarr.json.partial";

/// Level of zstd compression: the fastest.
const COMPRESSION_LEVEL: i32 = 1;

/// Opens the folder at `path` as a Zarr store.
pub(crate) fn store(path: &Path) -> Result<Store, FieldError> {
    FilesystemStore::new(path).map(Arc::new).map_err(|error| FieldError::zarr(path, error))
}

/// All work happens in the calling thread: the simulation decides about threads.
pub(crate) fn in_this_thread() -> CodecOptions {
    CodecOptions::default().with_concurrent_target(1)
}

/// The field itself, still without a snapshot.
///
/// A snapshot is one shard, so one file, of chunks of [`CHUNK_ELEMENTS`] elements.
pub(crate) fn temperature_rise(path: &Path, axes: &Axes) -> Result<StoredArray, FieldError> {
    let (elements, depths) = (axes.chainage.len() as u64, axes.depth.len() as u64);
    let chunk = CHUNK_ELEMENTS.min(elements);
    let shard = elements.next_multiple_of(chunk);
    ArrayBuilder::new(
        vec![0, elements, depths],
        vec![1, shard, depths],
        data_type::float32(),
        f32::NAN,
    )
    .subchunk_shape(vec![1, chunk, depths])
    .bytes_to_bytes_codecs(vec![Arc::new(ZstdCodec::new(COMPRESSION_LEVEL, false))])
    .dimension_names([TIME, CHAINAGE, DEPTH].into())
    .attributes(attributes(json!({
        "long_name": "temperature rise of the rail above its initial state",
        "units": "K",
    })))
    .build(store(path)?, &format!("/{TEMPERATURE_RISE}"))
    .map_err(|error| FieldError::zarr(path, error))
}

/// The times of the snapshots, still without one.
///
/// Each time is a chunk of its own, so that appending never rewrites what is on disk.
pub(crate) fn time(path: &Path) -> Result<StoredArray, FieldError> {
    let attributes = attributes(json!({
        "axis": "T",
        "long_name": "time since the start of the simulation",
        "units": "s",
    }));
    coordinate(path, TIME, (0, 1), attributes)
}

/// The chainages of a field with this many elements.
pub(crate) fn chainage(path: &Path, elements: usize) -> Result<StoredArray, FieldError> {
    let attributes = attributes(json!({
        "axis": "X",
        "long_name": "chainage of the middle of the element",
        "units": "m",
    }));
    coordinate(path, CHAINAGE, (elements as u64, elements as u64), attributes)
}

/// The depths of a field with this many cells.
pub(crate) fn depth(path: &Path, cells: usize) -> Result<StoredArray, FieldError> {
    let attributes = attributes(json!({
        "axis": "Z",
        "positive": "down",
        "long_name": "depth of the middle of the cell below the running surface",
        "units": "m",
    }));
    coordinate(path, DEPTH, (cells as u64, cells as u64), attributes)
}

/// The sections at places, still without a snapshot.
pub(crate) fn section_rise(path: &Path, sections: &Sections) -> Result<StoredArray, FieldError> {
    let dimensions = [(PROBE, sections.chainage.len() as u64), (CELL, sections.y.len() as u64)];
    let attributes = attributes(json!({
        "coordinates": format!("{SECTION_CHAINAGE} {SECTION_Y} {SECTION_Z}"),
        "long_name": "temperature rise of the cells of the section above their initial state",
        "units": "K",
    }));
    over_time(path, SECTION_RISE, &dimensions, attributes)
}

/// The section where the foot is warmest, still without a snapshot.
pub(crate) fn warmest_rise(path: &Path, sections: &Sections) -> Result<StoredArray, FieldError> {
    let attributes = attributes(json!({
        "coordinates": format!("{WARMEST_CHAINAGE} {SECTION_Y} {SECTION_Z}"),
        "long_name": "temperature rise of the cells of the section where the foot is warmest, the mean of left and right",
        "units": "K",
    }));
    over_time(path, WARMEST_RISE, &[(CELL, sections.y.len() as u64)], attributes)
}

/// The chainages of that section, still without one; each is a chunk of its own, as the times are.
pub(crate) fn warmest_chainage(path: &Path) -> Result<StoredArray, FieldError> {
    let attributes = attributes(json!({
        "long_name": "chainage of the middle of the element whose foot is warmest",
        "units": "m",
    }));
    along(path, WARMEST_CHAINAGE, TIME, (0, 1), attributes)
}

/// An array of rises that grows with time. A snapshot is one chunk, so one file.
fn over_time(
    path: &Path,
    name: &str,
    dimensions: &[(&str, u64)],
    attributes: Map<String, Value>,
) -> Result<StoredArray, FieldError> {
    let shape = |snapshots| {
        std::iter::once(snapshots).chain(dimensions.iter().map(|(_, length)| *length)).collect()
    };
    let (none, one): (Vec<u64>, Vec<u64>) = (shape(0), shape(1));
    let names = std::iter::once(TIME).chain(dimensions.iter().map(|(name, _)| *name));
    ArrayBuilder::new(none, one, data_type::float32(), f32::NAN)
        .bytes_to_bytes_codecs(vec![Arc::new(ZstdCodec::new(COMPRESSION_LEVEL, false))])
        .dimension_names(names.collect::<Vec<_>>().into())
        .attributes(attributes)
        .build(store(path)?, &format!("/{name}"))
        .map_err(|error| FieldError::zarr(path, error))
}

/// What is known of the cells and places of sections: each array with its values.
pub(crate) fn of_sections<'s>(
    path: &Path,
    sections: &'s Sections,
) -> Result<Vec<(StoredArray, &'s [f64])>, FieldError> {
    let array = |name, dimension, values: &'s [f64], described| {
        let length = values.len() as u64;
        let array = along(path, name, dimension, (length, length), attributes(described))?;
        Ok::<_, FieldError>((array, values))
    };
    let chainage = json!({
        "long_name": "chainage of the middle of the element whose section is kept",
        "units": "m",
    });
    let y = json!({
        "long_name": "middle of the cell, to the right of the rail's middle",
        "units": "m",
    });
    let z = json!({
        "positive": "down",
        "long_name": "depth of the middle of the cell below the running surface",
        "units": "m",
    });
    let area = json!({ "long_name": "area of steel in the cell", "units": "m2" });
    let mut arrays = vec![
        array(SECTION_Y, CELL, &sections.y, y)?,
        array(SECTION_Z, CELL, &sections.z, z)?,
        array(SECTION_AREA, CELL, &sections.area, area)?,
    ];
    if !sections.chainage.is_empty() {
        arrays.push(array(SECTION_CHAINAGE, PROBE, &sections.chainage, chainage)?);
    }
    Ok(arrays)
}

/// Writes the values of a chunk.
pub(crate) fn store_chunk<T: zarrs::array::Element>(
    path: &Path,
    array: &StoredArray,
    chunk: &[u64],
    values: &[T],
) -> Result<(), FieldError> {
    array
        .store_chunk_opt(chunk, values, &in_this_thread())
        .map_err(|error| FieldError::zarr(path, error))
}

fn coordinate(
    path: &Path,
    name: &str,
    lengths: (u64, u64),
    attributes: Map<String, Value>,
) -> Result<StoredArray, FieldError> {
    along(path, name, name, lengths, attributes)
}

/// An array of one dimension.
fn along(
    path: &Path,
    name: &str,
    dimension: &str,
    (length, chunk): (u64, u64),
    attributes: Map<String, Value>,
) -> Result<StoredArray, FieldError> {
    ArrayBuilder::new(vec![length], vec![chunk], data_type::float64(), f64::NAN)
        .dimension_names([dimension].into())
        .attributes(attributes)
        .build(store(path)?, &format!("/{name}"))
        .map_err(|error| FieldError::zarr(path, error))
}

fn attributes(value: Value) -> Map<String, Value> {
    match value {
        Value::Object(map) => map,
        _ => Map::new(),
    }
}

/// Writes an array's metadata by a rename, so that a reader finds the old or the new, whole.
pub(crate) fn write_metadata(path: &Path, array: &StoredArray) -> Result<(), FieldError> {
    let options = ArrayMetadataOptions::default().with_include_zarrs_metadata(false);
    let text = array.metadata_opt(&options).to_string_pretty();
    let folder = path.join(array.path().as_str().trim_start_matches('/'));
    write_whole(&folder, &text).map_err(|source| FieldError::io(path, source))
}

/// Copies the metadata of all arrays into those of the group, so that a reader opens one file only.
///
/// One rename shows a snapshot and its time together.
pub(crate) fn consolidate(path: &Path) -> Result<(), FieldError> {
    let mut group = read_metadata(path)?;
    let mut arrays = Map::new();
    let of_field = [CHAINAGE, DEPTH, TEMPERATURE_RISE, TIME];
    let of_sections = [
        SECTION_RISE,
        SECTION_CHAINAGE,
        SECTION_Y,
        SECTION_Z,
        SECTION_AREA,
        WARMEST_RISE,
        WARMEST_CHAINAGE,
    ];
    // Not all rails have sections.
    let kept = of_sections.into_iter().filter(|name| path.join(name).exists());
    for name in of_field.into_iter().chain(kept) {
        arrays.insert(name.to_owned(), read_metadata(&path.join(name))?);
    }
    group["consolidated_metadata"] =
        json!({ "kind": "inline", "must_understand": false, "metadata": arrays });
    write_whole(path, &format!("{group:#}")).map_err(|source| FieldError::io(path, source))
}

fn read_metadata(folder: &Path) -> Result<Value, FieldError> {
    let file = folder.join(METADATA);
    let text = fs::read_to_string(&file).map_err(|source| FieldError::io(&file, source))?;
    serde_json::from_str(&text).map_err(|error| FieldError::zarr(&file, error))
}

/// Writes `zarr.json` of the group or array in `folder` by a rename.
pub(crate) fn write_whole(folder: &Path, text: &str) -> std::io::Result<()> {
    fs::create_dir_all(folder)?;
    let partial = folder.join(PARTIAL);
    fs::write(&partial, text)?;
    fs::rename(partial, folder.join(METADATA))
}
