//! When a snapshot of the field is written.

use std::path::{Path, PathBuf};

use field::{Attribute, Axes, FieldError, FieldWriter, SectionRises, Sections, is_rail_field};
use serde::{Deserialize, Serialize};

use crate::heat_model::HeatModel;

/// Slack in comparing times, s.
const SAME_TIME: f64 = 1e-9;

/// Writes a snapshot at the start and whenever another interval has passed.
///
/// A snapshot is written at the end of the first step that reaches a multiple of the interval.
/// After a saved state has been restored the store goes on where it was then: later snapshots are removed
/// when the next one is written. A field that is there before the run is replaced when the first step begins,
/// so that a state can be restored that goes on with it.
pub(crate) struct FieldFile {
    path: PathBuf,
    interval: f64,
    start_time: f64,
    written: Written,
    /// None until something is written.
    writer: Option<FieldWriter>,
    values: Vec<f32>,
    sections: SectionRises,
}

/// How far the field has been written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Written {
    /// Number of the interval at whose end the next snapshot is due.
    next: u64,
    snapshots: usize,
    /// Whether it was given up.
    lost: bool,
}

impl FieldFile {
    /// A field at `path`, which begins at once with the snapshot at the start if nothing is there yet.
    pub(crate) fn new(
        path: &Path,
        interval: f64,
        start_time: f64,
        model: &dyn HeatModel,
    ) -> (Self, Result<(), FieldError>) {
        let sections = model.kept_sections().map_or_else(SectionRises::default, |kept| {
            let of_one = vec![0.0; kept.cells.len()];
            SectionRises {
                kept: of_one.repeat(kept.chainages.len()),
                warmest: of_one,
                warmest_chainage: 0.0,
            }
        });
        let mut file = Self {
            sections,
            path: path.to_owned(),
            interval,
            start_time,
            written: Written::default(),
            writer: None,
            values: vec![0.0; model.line().elements * model.depths().len()],
        };
        let begun = if is_rail_field(path) { Ok(()) } else { file.write_start(model) };
        (file, begun)
    }

    /// How far the field has been written.
    pub(crate) fn written(&self) -> Written {
        self.written
    }

    /// Goes on behind what another instance has written.
    pub(crate) fn continue_from(&mut self, written: Written) {
        if written.snapshots != self.written.snapshots {
            self.writer = None;
        }
        self.written = written;
    }

    /// Writes nothing any more.
    pub(crate) fn stop(&mut self) {
        self.written.lost = true;
        self.writer = None;
    }

    /// Writes the snapshot at the start unless it is there.
    pub(crate) fn write_start(&mut self, model: &dyn HeatModel) -> Result<(), FieldError> {
        match self.written.snapshots {
            0 => self.write_if_due(self.start_time, model),
            _ => Ok(()),
        }
    }

    /// Writes a snapshot if its time has come.
    pub(crate) fn write_if_due(
        &mut self,
        time: f64,
        model: &dyn HeatModel,
    ) -> Result<(), FieldError> {
        let passed = (time - self.start_time + SAME_TIME) / self.interval;
        if self.written.lost || passed < self.written.next as f64 {
            return Ok(());
        }
        model.snapshot(&mut self.values);
        model.sections(&mut self.sections.kept);
        self.sections.warmest_chainage = model.warmest_section(&mut self.sections.warmest);
        let writer = match &mut self.writer {
            Some(writer) => writer,
            none => none.insert(match self.written.snapshots {
                0 => begin(&self.path, model)?,
                snapshots => FieldWriter::resume(&self.path, snapshots)?,
            }),
        };
        writer.append(time, &self.values, &self.sections)?;
        self.written.snapshots += 1;
        self.written.next = passed as u64 + 1;
        Ok(())
    }
}

/// Begins the store.
fn begin(path: &Path, model: &dyn HeatModel) -> Result<FieldWriter, FieldError> {
    let line = model.line();
    let kept = model.kept_sections();
    let axes = Axes {
        sections: kept.as_ref().map(|kept| Sections {
            chainage: kept.chainages.clone(),
            y: kept.cells.iter().map(|cell| cell.middle.y).collect(),
            z: kept.cells.iter().map(|cell| cell.middle.z).collect(),
            area: kept.cells.iter().map(|cell| cell.area).collect(),
        }),
        chainage: (0..line.elements).map(|element| line.chainage(element)).collect(),
        depth: model.depths(),
    };
    let mut attributes = vec![
        ("title", Attribute::from("Temperature rise of a rail under a train")),
        ("model", Attribute::from(model.name())),
        ("initial_temperature_K", Attribute::from(model.initial_temperature())),
        ("element_length_m", Attribute::from(line.element_length)),
        ("cell_size_m", Attribute::from(2.0 * axes.depth[0])),
    ];
    if let Some(kept) = &kept {
        let field_side = if kept.field_side_is_right { "right" } else { "left" };
        attributes.push(("section_cell_width_m", Attribute::from(kept.cell_width)));
        attributes.push(("field_side", Attribute::from(field_side)));
    }
    FieldWriter::create(path, &axes, &attributes)
}
