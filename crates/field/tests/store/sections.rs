//! What a field must hold of sections.

use std::fs;

use field::{Axes, FieldError, FieldReader, FieldWriter, SectionRises, Sections, WarmestSection};

use crate::{axes, metadata, rise};

/// The same with two sections of three cells.
fn axes_with_sections() -> Axes {
    let sections = Sections {
        chainage: vec![310.0, 320.0],
        y: vec![-0.01, 0.0, 0.01],
        z: vec![0.002, 0.002, 0.004],
        area: vec![1e-5, 2e-5, 1e-5],
    };
    Axes { sections: Some(sections), ..axes() }
}

/// Sections that differ in every cell and at every time.
fn sections(snapshot: usize) -> SectionRises {
    let rises = |cells| (0..cells).map(|i| 10.0 * snapshot as f32 + i as f32).collect();
    let warmest_chainage = 300.05 + 0.1 * snapshot as f64;
    SectionRises { kept: rises(6), warmest: rises(3), warmest_chainage }
}

/// The section where the foot is warmest, as it is read.
fn warmest(snapshot: usize) -> Option<WarmestSection> {
    let SectionRises { warmest, warmest_chainage, .. } = sections(snapshot);
    Some(WarmestSection { chainage: warmest_chainage, rise: warmest })
}

/// Sections go on, are cut and completed as the field is.
#[test]
fn property_sections_are_as_long_as_the_field() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let mut writer = FieldWriter::create(&path, &axes_with_sections(), &[]).unwrap();
    for snapshot in 0..3 {
        let (time, rise) = (snapshot as f64, rise(&axes(), snapshot));
        writer.append(time, &rise, &sections(snapshot)).unwrap();
    }
    let size = writer.append(3.0, &rise(&axes(), 3), &SectionRises::default()).unwrap_err();
    assert!(matches!(size, FieldError::Size { found: 0, wanted: 6, .. }));
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!(reader.axes(), &axes_with_sections());
    assert_eq!(reader.sections_at_time(1.2).unwrap(), sections(1).kept);
    assert_eq!(reader.warmest_at_time(1.2).unwrap(), warmest(1));
    let chunks = ["section_rise/c/2/0/0", "warmest_section_rise/c/2/0"].map(|name| path.join(name));
    assert!(chunks.iter().all(|chunk| chunk.exists()));
    let before = fs::read(path.join("temperature_rise/zarr.json")).unwrap();
    writer.append(3.0, &rise(&axes(), 3), &sections(3)).unwrap();
    fs::write(path.join("temperature_rise/zarr.json"), before).unwrap();
    let length = || {
        let of_array = |name| metadata(&path.join(name))["shape"][0].as_u64().unwrap();
        let [kept, others @ ..] =
            ["section_rise", "warmest_section_rise", "warmest_section_chainage"].map(of_array);
        assert_eq!(others, [kept; 2]);
        kept
    };
    assert_eq!(length(), 4);
    field::complete(&path).unwrap();
    assert_eq!(length(), 3);
    let mut writer = FieldWriter::resume(&path, 2).unwrap();
    assert_eq!(length(), 2);
    assert!(!chunks.iter().any(|chunk| chunk.exists()), "what is cut is removed");
    writer.append(7.0, &rise(&axes(), 7), &sections(7)).unwrap();
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!((reader.times(), length()), (&[0.0, 1.0, 7.0][..], 3));
    assert_eq!(reader.sections_at_time(7.0).unwrap(), sections(7).kept);
    assert_eq!(reader.warmest_at_time(7.0).unwrap(), warmest(7));
}

/// Without places the field has the section where the foot is warmest alone.
#[test]
fn property_the_warmest_section_needs_no_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("rail.zarr");
    let of_cells = Sections { chainage: vec![], ..axes_with_sections().sections.unwrap() };
    let axes = Axes { sections: Some(of_cells), ..axes() };
    let rises = |snapshot| SectionRises { kept: vec![], ..sections(snapshot) };
    let mut writer = FieldWriter::create(&path, &axes, &[]).unwrap();
    for snapshot in 0..2 {
        writer.append(snapshot as f64, &rise(&axes, snapshot), &rises(snapshot)).unwrap();
    }
    let reader = FieldReader::open(&path).unwrap();
    assert_eq!(reader.axes(), &axes);
    assert_eq!(reader.warmest_at_time(1.0).unwrap(), warmest(1));
    assert!(reader.sections_at_time(1.0).unwrap().is_empty());
    assert!(!path.join("section_rise").exists() && !path.join("section_chainage").exists());
    drop(writer);
    FieldWriter::resume(&path, 1).unwrap();
    assert_eq!(FieldReader::open(&path).unwrap().warmest_at_time(1.0).unwrap(), warmest(0));
}
