//! The results of a run: manifest, tables and their parts, the field of a rail.

use field::{Axes, FieldReader, FieldWriter, SectionRises, Sections};
use hotfoot::recording::{self, KeyValue, SeriesReader, TRAIN_TABLE};
use hotfoot::run::expected;
use hotfoot::run::folder::complete::is_complete;

use crate::scratch::Scratch;

/// A manifest, and what a report would be made of.
pub fn manifest(bytes: &[u8]) {
    let scratch = Scratch::with("manifest.toml", bytes);
    let _ = is_complete(scratch.folder());
    let _ = hotfoot::report::write(scratch.folder());
}

/// The figures that a run is to have.
pub fn expected(bytes: &[u8]) {
    let scratch = Scratch::with("expected.toml", bytes);
    scratch.write("manifest.toml", "simulated_s = 10.0");
    let _ = expected::compare(scratch.folder(), &scratch.path("expected.toml"));
}

/// A part of a table whose run was killed.
pub fn part(bytes: &[u8]) {
    tables(&Scratch::with("train.parts/part-00000.parquet", bytes));
}

/// The records since the last part of a table.
pub fn open_stream(bytes: &[u8]) {
    tables(&Scratch::with("train.parts/.open.arrows", bytes));
}

/// A table of a run.
pub fn table(bytes: &[u8]) {
    tables(&Scratch::with("train.parquet", bytes));
}

/// Reads all of the table of the train, completes it and reads it again.
fn tables(scratch: &Scratch) {
    read(scratch);
    let _ = recording::complete(scratch.folder(), true);
    read(scratch);
}

fn read(scratch: &Scratch) {
    let Ok(table) = SeriesReader::open(scratch.folder(), TRAIN_TABLE) else { return };
    for column in table.columns() {
        let _ = table.read(column.name(), &[]);
        let _ = table.read("time", &[(column.name(), KeyValue::Integer(1))]);
        let _ = table.read("time", &[(column.name(), KeyValue::Text("first"))]);
    }
}

/// What Zarr keeps of the whole field.
pub fn field_attributes(bytes: &[u8]) {
    field("zarr.json", bytes);
}

/// What Zarr keeps of the array of temperatures.
pub fn field_array(bytes: &[u8]) {
    field("temperature_rise/zarr.json", bytes);
}

/// What Zarr keeps of the array of chainages.
pub fn field_axis(bytes: &[u8]) {
    field("chainage/zarr.json", bytes);
}

/// A field of two snapshots, one file of which is replaced.
fn field(name: &str, bytes: &[u8]) {
    let scratch = Scratch::new();
    let path = scratch.path("field.zarr");
    let (y, z, area) = (vec![0.0], vec![0.001], vec![1e-5]);
    let sections = Some(Sections { chainage: vec![0.5], y, z, area });
    let axes = Axes { chainage: vec![0.5, 1.5], depth: vec![0.001, 0.003], sections };
    let mut writer = FieldWriter::create(&path, &axes, &[]).expect("a field can be written");
    for time in [0.0, 1.0] {
        let sections = SectionRises { kept: vec![0.5], warmest: vec![0.5], warmest_chainage: 1.5 };
        writer.append(time, &[0.0, 1.0, 2.0, 3.0], &sections).expect("a snapshot can be written");
    }
    scratch.write(&format!("field.zarr/{name}"), bytes);
    let read = || {
        let reader = FieldReader::open(&path)?;
        reader.at_time(0.6)?;
        reader.warmest_at_time(0.6)?;
        reader.sections_at_time(0.6)
    };
    let _ = read();
    let _ = field::complete(&path);
    let _ = read();
}
