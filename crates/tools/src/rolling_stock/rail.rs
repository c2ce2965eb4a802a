//! Figures of a rail section.

use std::path::Path;

use files::Mistake;
use railheat::section::RailFile;

use super::entry::{Entry, Figure, Kind};

/// Density of rail steel, kg/m³, for the mass of a section.
const STEEL: f64 = 7850.0;

/// The entries of all sections in a folder, which may be missing.
pub(super) fn entries(folder: &Path) -> Result<Vec<Entry>, Mistake> {
    let files = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut files: Vec<_> = files.map(|file| file.path()).collect();
    files.retain(|file| file.extension().is_some_and(|extension| extension == "toml"));
    files.sort();
    files.iter().map(|file| entry(file)).collect()
}

fn entry(path: &Path) -> Result<Entry, Mistake> {
    let file = RailFile::open(&path.display().to_string())?;
    let mass = STEEL * file.area_mm2 * 1e-6;
    let figures = vec![
        Figure::number("height", file.height_mm, "mm", 1).main(),
        Figure::number("area", file.area_mm2 / 100.0, "cm²", 2).main(),
        Figure::number("mass", mass, "kg/m", 1).main(),
        Figure::number("centroid above the foot", file.centroid_above_foot_mm, "mm", 1).main(),
        Figure::number("second moment of area", file.second_moment_mm4 / 1e4, "cm⁴", 0).main(),
    ];
    Ok(Entry {
        kind: Kind::RailSection,
        name: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        title: file.name,
        file: Some(path.display().to_string()),
        source: file.source.trim().to_owned(),
        figures,
    })
}
