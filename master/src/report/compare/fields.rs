//! The fields of the rails of two runs.

use std::path::Path;

use field::{Axes, FieldReader, Sections, fields_in};

use super::error::CompareError;
use super::field_errors::{FieldErrors, Position};
use super::grid::shared;
use super::run::Run;
use crate::files::file_error::FileError;

/// Coordinates that differ by no more than this are the same, m.
const SAME: f64 = 1e-6;

/// What the fields of two runs have in common.
#[derive(Debug, Default)]
pub(super) struct Fields {
    /// Errors of every variable that both have.
    pub errors: Vec<FieldErrors>,
    /// Why others cannot be compared, in sentences.
    pub not_compared: Vec<String>,
    /// Fields that only the first has.
    pub only_in_first: Vec<String>,
    /// Fields that only the other has.
    pub only_in_other: Vec<String>,
}

impl Fields {
    /// Compares the fields of two runs that have the same name.
    pub fn of(first: &Run, other: &Run) -> Result<Self, CompareError> {
        let (own, others) = (names(first)?, names(other)?);
        let beyond = |these: &[String], those: &[String]| {
            these.iter().filter(|name| !those.contains(name)).cloned().collect()
        };
        let mut fields = Self {
            only_in_first: beyond(&own, &others),
            only_in_other: beyond(&others, &own),
            ..Self::default()
        };
        for name in own.iter().filter(|name| others.contains(name)) {
            let [first, other] = [&first.folder, &other.folder].map(|folder| folder.join(name));
            fields.add(name, &first, &other)?;
        }
        Ok(fields)
    }

    /// Compares a field of this name with another one.
    fn add(&mut self, name: &str, first: &Path, other: &Path) -> Result<(), CompareError> {
        let (first, other) = (FieldReader::open(first)?, FieldReader::open(other)?);
        let times = shared(first.times(), other.times());
        let times: Vec<f64> = times.into_iter().map(|(index, _)| first.times()[index]).collect();
        if times.is_empty() {
            self.not_compared.push(format!(
                "{name} is not compared: the runs have no snapshot of the same time; give both the same \
                 heat.field_interval_s"
            ));
            return Ok(());
        }
        match other_grid(first.axes(), other.axes()) {
            Some(why) => self.not_compared.push(format!("{name} is not compared: {why}")),
            None => {
                let positions = positions(first.axes());
                let name = (name, "temperature_rise");
                self.errors.push(FieldErrors::of(name, &times, &positions, |time| {
                    Ok([first.at_time(time)?.rise, other.at_time(time)?.rise])
                })?);
            }
        }
        match (&first.axes().sections, &other.axes().sections) {
            (None, None) => {}
            // The sections where the feet are warmest are of other places.
            (Some(own), Some(others))
                if own.chainage.is_empty() && others.chainage.is_empty() => {}
            (Some(own), Some(others)) if are_same(own, others) => {
                let positions = section_positions(own);
                let name = (name, "section_rise");
                self.errors.push(FieldErrors::of(name, &times, &positions, |time| {
                    Ok([first.sections_at_time(time)?, other.sections_at_time(time)?])
                })?);
            }
            _ => self.not_compared.push(format!(
                "the sections of {name} are not compared: they are of other probes or cells; give both runs the \
                 same heat.probe, section.rail and section.cell_size"
            )),
        }
        Ok(())
    }
}

/// Names of the fields of a run.
pub(super) fn names(run: &Run) -> Result<Vec<String>, CompareError> {
    let fields = fields_in(&run.folder).map_err(FileError::at(&run.folder))?;
    Ok(fields.iter().filter_map(|path| Some(path.file_name()?.to_str()?.to_owned())).collect())
}

/// Why values of two grids cannot be compared; none if they can.
fn other_grid(first: &Axes, other: &Axes) -> Option<String> {
    let text = |axes: &Axes| {
        let (elements, depths) = (axes.chainage.len(), axes.depth.len());
        let (from, to) = (axes.chainage.first(), axes.chainage.last());
        let (from, to) = (from.copied().unwrap_or_default(), to.copied().unwrap_or_default());
        format!("{elements} elements from {from:.1} to {to:.1} m in {depths} depths")
    };
    let are_same = same(&first.chainage, &other.chainage) && same(&first.depth, &other.depth);
    (!are_same).then(|| {
        format!(
            "the grids differ, {} and {}; give both runs the same model, rail, heat.begin_m, heat.length_m and \
             cell size",
            text(first),
            text(other)
        )
    })
}

fn are_same(first: &Sections, other: &Sections) -> bool {
    same(&first.chainage, &other.chainage) && same(&first.y, &other.y) && same(&first.z, &other.z)
}

fn same(first: &[f64], other: &[f64]) -> bool {
    first.len() == other.len() && first.iter().zip(other).all(|(a, b)| (a - b).abs() <= SAME)
}

/// The positions of the values of a snapshot.
fn positions(axes: &Axes) -> Vec<Position> {
    let depths = |&chainage: &f64| axes.depth.iter().map(move |&depth| (chainage, depth, None));
    axes.chainage.iter().flat_map(depths).collect()
}

/// The positions of the values of the sections.
fn section_positions(sections: &Sections) -> Vec<Position> {
    let cells = |&chainage: &f64| {
        sections.y.iter().zip(&sections.z).map(move |(&y, &z)| (chainage, z, Some(y)))
    };
    sections.chainage.iter().flat_map(cells).collect()
}
