//! A table read back by another reader than ours: the row interface of the crate `parquet`, which decodes
//! the pages itself and knows nothing of Arrow.

use std::fs::File;
use std::path::Path;

use parquet::basic::{Compression, Type as PhysicalType};
use parquet::file::reader::{FileReader, SerializedFileReader};
use parquet::record::{Field, Row};

use super::*;

/// Two records of a locomotive's left and right wheel, whose numbers are exact in binary.
fn write(folder: &Path) -> PathBuf {
    let keys = wheel_keys(&[(1, 2, Side::Left), (1, 2, Side::Right)]);
    let columns = vec![
        Column::new("position", "m", "Chainage of the wheelset").double(),
        Column::new("force", "N", "Normal force").extremes(),
        Column::new("power", "W", "Friction power").mean(),
    ];
    let mut writer = SeriesWriter::create(folder, "wheels", keys, columns, 10).unwrap();
    for step in 0..=4 {
        for row in 0..2 {
            let side = f64::from(row as u8);
            // The force swings between the records: its extremes are those of steps 1 and 3.
            let force = 109_500.0 + side + [0.0, 64.0, 0.0, -32.0, 0.0][step];
            writer.observe(row, &[100.0 + 0.1 * step as f64, force, step as f64]);
        }
        if step % 4 == 0 {
            writer.record(step as f64 * 0.025).unwrap();
        }
    }
    writer.finish().unwrap();
    folder.join("wheels.parquet")
}

fn rows(reader: &SerializedFileReader<File>) -> Vec<Row> {
    reader.get_row_iter(None).unwrap().map(Result::unwrap).collect()
}

fn value<'r>(row: &'r Row, column: &str) -> &'r Field {
    let found = row.get_column_iter().find(|(name, _)| *name == column);
    found.unwrap_or_else(|| panic!("no column {column} in {row}")).1
}

#[test]
fn another_reader_finds_the_same_values_and_keys() {
    let folder = tempfile::tempdir().unwrap();
    let file = File::open(write(folder.path())).unwrap();
    let rows = rows(&SerializedFileReader::new(file).unwrap());
    assert_eq!(rows.len(), 4, "two wheels at two instants");
    for (index, row) in rows.iter().enumerate() {
        let (instant, side) = (index / 2, index % 2);
        let force = 109_500.0 + side as f32;
        assert_eq!(value(row, "time"), &Field::Double(0.1 * instant as f64));
        assert_eq!(value(row, "vehicle"), &Field::Int(1));
        assert_eq!(value(row, "wheelset"), &Field::Int(2));
        assert_eq!(value(row, "side"), &Field::Str(["left", "right"][side].to_owned()));
        assert_eq!(value(row, "position"), &Field::Double([100.0, 100.4][instant]));
        assert_eq!(value(row, "force"), &Field::Float(force));
        // Nothing came before the first record but itself.
        let swing = [(0.0, 0.0), (64.0, -32.0)][instant];
        assert_eq!(value(row, "force_max"), &Field::Float(force + swing.0));
        assert_eq!(value(row, "force_min"), &Field::Float(force + swing.1));
        // The mean of 1, 2, 3 and 4.
        assert_eq!(value(row, "power_mean"), &Field::Float([0.0, 2.5][instant]));
    }
}

/// The format begins and ends with the four bytes PAR1 (Apache Parquet, File Format); types and packing
/// are those that the module says.
#[test]
fn the_file_is_what_it_says_it_is() {
    let folder = tempfile::tempdir().unwrap();
    let path = write(folder.path());
    let bytes = std::fs::read(&path).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));

    let reader = SerializedFileReader::new(File::open(&path).unwrap()).unwrap();
    let metadata = reader.metadata();
    assert_eq!(metadata.file_metadata().num_rows(), 4);
    assert_eq!(metadata.file_metadata().created_by(), Some("hotfoot"));
    let columns = metadata.row_group(0).columns();
    let of = |name: &str| {
        let found = columns.iter().find(|column| column.column_path().string() == name);
        found.unwrap_or_else(|| panic!("no column {name}"))
    };
    for (name, wanted) in [
        ("time", PhysicalType::DOUBLE),
        ("vehicle", PhysicalType::INT32),
        ("side", PhysicalType::BYTE_ARRAY),
        ("position", PhysicalType::DOUBLE),
        ("force_min", PhysicalType::FLOAT),
    ] {
        assert_eq!(of(name).column_type(), wanted, "{name}");
        assert!(matches!(of(name).compression(), Compression::ZSTD(_)), "{name}");
    }
}
