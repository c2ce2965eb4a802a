//! What a run says of each heated rail: extremes of its temperature, what cameras see of its
//! foot, heat by source, energies.

use std::path::Path;

use numerics::seconds;

use super::data::{Foot, HeatAt, MainFigure, RailData};
use super::error::ReportError;
use super::facts::{EnergyLine, RailFacts};
use super::main_figures::largest;
use super::quantity::{round_with_unit, with_unit};
use crate::recording::{KeyValue, RAIL_TABLE, RecordingError, SeriesReader};

/// The sources of heat as the rail's outputs name them, and in words.
pub(super) const SOURCES: [(&str, &str); 4] = [
    ("friction", "friction"),
    ("chill", "conduction from the wheels"),
    ("bending", "hysteresis of bending"),
    ("weather", "weather"),
];

/// Unit of rises above untouched rail; their descriptions need no more words.
const KELVIN: &str = "K";

/// The rows of one rail in the table of the rails.
pub(super) struct RailSeries<'r> {
    table: &'r SeriesReader,
    side: &'r str,
}

/// Reads what the report says of each rail.
pub(super) fn of_run(folder: &Path, facts: &RailFacts) -> Result<Vec<RailData>, ReportError> {
    let table = SeriesReader::open(&folder.join("series"), RAIL_TABLE)?;
    let rail = |side: &String| {
        let series = RailSeries { table: &table, side };
        let mut figures = series.extremes()?;
        let foot = series.foot(facts)?;
        if let Some(foot) = &foot {
            figures.extend(series.answer(facts, foot)?);
        }
        figures.extend(series.audit()?);
        Ok(RailData {
            side: side.clone(),
            figures,
            energy: series.energies()?,
            foot,
            heat: series.heat(facts)?,
            surface: series.surface()?,
        })
    };
    facts.sides.iter().map(rail).collect()
}

impl RailSeries<'_> {
    fn read(&self, column: &str) -> Result<Vec<f64>, RecordingError> {
        self.table.read(column, &[("rail", KeyValue::Text(self.side))])
    }

    fn has(&self, column: &str) -> bool {
        self.table.columns().any(|other| other.name() == column)
    }

    fn last(&self, column: &str) -> Result<f64, RecordingError> {
        Ok(self.read(column)?.last().copied().unwrap_or(f64::NAN))
    }

    /// The columns with that unit, with their descriptions.
    fn with_unit_of(&self, unit: &str) -> impl Iterator<Item = (&str, &str)> {
        self.table
            .columns()
            .filter(move |c| c.metadata().get("unit").is_some_and(|u| u == unit))
            .map(|column| {
                let description = column.metadata().get("description");
                (column.name().as_str(), description.unwrap_or(column.name()).as_str())
            })
    }

    fn figure(&self, key: &str, name: impl Into<String>, value: f64, unit: &str) -> MainFigure {
        MainFigure::new(format!("{}.{key}", self.side), name, value, unit)
    }

    /// The highest of each rise that the rail gives as its highest along the track
    /// (`highest.….rise` with its `.chainage`).
    fn extremes(&self) -> Result<Vec<MainFigure>, RecordingError> {
        let time = self.read("time")?;
        let mut figures = vec![];
        for (column, description) in self.with_unit_of(KELVIN) {
            let Some(what) = column.strip_suffix(".rise").filter(|w| w.starts_with("highest."))
            else {
                continue;
            };
            let rise = self.read(column)?;
            let Some(record) = largest(&rise) else { continue };
            let figure = self.figure(what, description, rise[record], KELVIN);
            let chainage = format!("{what}.chainage");
            figures.push(match self.has(&chainage) {
                true => figure.on_track(self.read(&chainage)?[record], time[record]),
                false => figure.at(format!("at {} s", seconds(time[record]))),
            });
        }
        Ok(figures)
    }

    /// Highest rise of the surface along the track at each record.
    fn surface(&self) -> Result<Vec<(f64, f64)>, RecordingError> {
        let column = "highest.surface.rise";
        if !self.has(column) {
            return Ok(vec![]);
        }
        Ok(self.read("time")?.into_iter().zip(self.read(column)?).collect())
    }

    /// What cameras see of the foot, if the model tells it: the paper's has no such answer.
    fn foot(&self, facts: &RailFacts) -> Result<Option<Foot>, RecordingError> {
        let columns = ["foot.present.rise", "camera.train.rise"];
        if facts.model == "paper" || !columns.iter().all(|column| self.has(column)) {
            return Ok(None);
        }
        Ok(Some(Foot {
            time: self.read("time")?,
            highest: self.read(columns[0])?,
            under_train: self.read(columns[1])?,
        }))
    }

    /// The answer on the foot: how warm, where and when; when seen first; and seen from where.
    fn answer(&self, facts: &RailFacts, foot: &Foot) -> Result<Vec<MainFigure>, RecordingError> {
        let found = |key: &str, what: &str, column: &str| {
            let part = |part: &str| self.last(&format!("{column}.{part}"));
            let figure = self.figure(key, what, part("rise")?, KELVIN);
            if figure.value.is_some_and(|rise| rise > 0.0) {
                return Ok::<_, RecordingError>(figure.on_track(part("chainage")?, part("time")?));
            }
            Ok(MainFigure { text: "no rise".to_owned(), ..figure })
        };
        let mut answer = vec![
            found("foot.highest", "Foot: highest rise over untouched rail", "foot.highest")?,
            self.detection(facts)?,
            found(
                "camera.train",
                "Camera on the train: foot under the last wheel",
                "camera.train.highest",
            )?,
            self.track_side(facts, foot)?,
        ];
        answer.extend(self.thermoelastic()?);
        Ok(answer)
    }

    /// By how much bending changes the foot reversibly as axles pass the probes; its value is the whole swing.
    fn thermoelastic(&self) -> Result<Option<MainFigure>, RecordingError> {
        let [mut lowest, mut highest] = [0.0_f64; 2];
        for probe in 1..=self.probes().count() {
            let column = format!("probe[{probe}].foot.thermoelastic");
            if self.has(&column) {
                for change in self.read(&column)? {
                    (lowest, highest) = (lowest.min(change), highest.max(change));
                }
            }
        }
        let swing = highest - lowest;
        let name = "Foot: reversible change by bending at the probes";
        let text = [lowest, highest].map(|change| round_with_unit(change, KELVIN)).join(" to ");
        let figure = MainFigure { text, ..self.figure("foot.thermoelastic", name, swing, KELVIN) };
        Ok((swing > 0.0).then(|| figure.at("at the records, between which it may be more")))
    }

    /// The error of the energy audit over the heat that wheels put in, if the model tells it.
    fn audit(&self) -> Result<Option<MainFigure>, RecordingError> {
        if !self.has("energy.error") {
            return Ok(None);
        }
        let mut put_in = 0.0;
        for (source, _) in SOURCES.iter().filter(|(source, _)| *source != "weather") {
            put_in += self.last(&format!("energy.{source}"))?.abs();
        }
        let error = self.last("energy.error")?.abs() / put_in;
        if !error.is_finite() {
            return Ok(None);
        }
        let name = "Energy audit: error over the heat that wheels put in";
        let figure = self.figure("energy.audit", name, error, "1");
        Ok(Some(MainFigure { text: format!("{error:.0e}"), ..figure }))
    }

    /// When and where the foot first passes the threshold of detection.
    fn detection(&self, facts: &RailFacts) -> Result<MainFigure, RecordingError> {
        let threshold = round_with_unit(facts.detection_threshold_k, KELVIN);
        let time = self.last("foot.detection.time")?;
        let name = format!("Foot: first reaches {threshold}");
        let figure = self.figure("foot.detection", name, time, "s");
        if time < 0.0 {
            return Ok(MainFigure { value: None, text: "never".to_owned(), ..figure });
        }
        let chainage = self.last("foot.detection.chainage")?;
        Ok(MainFigure {
            text: format!("at {} s", seconds(time)),
            ..figure.on_track(chainage, time)
        })
    }

    /// What a camera at the track side sees after the last train.
    fn track_side(&self, facts: &RailFacts, foot: &Foot) -> Result<MainFigure, RecordingError> {
        let name = "Camera at the track side, after the last train";
        let first = foot.time.partition_point(|&time| time <= facts.last_train_end_s + 1e-9);
        let after = &foot.highest[first..];
        let highest = (0..after.len()).max_by(|&a, &b| after[a].total_cmp(&after[b]));
        let Some(record) = highest.map(|record| first + record) else {
            let figure = self.figure("camera.track_side", name, f64::NAN, KELVIN);
            return Ok(MainFigure { value: None, text: "not simulated".to_owned(), ..figure }
                .at("heat.cool_down_minutes lets the rail go on after the train"));
        };
        let chainage = self.read("foot.present.chainage")?[record];
        let figure = self.figure("camera.track_side", name, foot.highest[record], KELVIN);
        let figure = figure.on_track(chainage, foot.time[record]);
        let later = (foot.time[record] - facts.last_train_end_s) / 60.0;
        let location =
            format!("{}, {later:.1} min after the run of the last train", figure.location);
        Ok(figure.at(location))
    }

    /// Heat per metre by source at the probes, and its mean over the modelled rail.
    fn heat(&self, facts: &RailFacts) -> Result<Vec<HeatAt>, RecordingError> {
        if facts.model == "paper" || !self.has("energy.friction") {
            return Ok(vec![]);
        }
        let at = |location: String, column: &dyn Fn(&str) -> String, metres: f64| {
            let source = |&(source, _): &(&str, &str)| Ok(self.last(&column(source))? / metres);
            let sources = SOURCES.iter().map(source).collect::<Result<_, RecordingError>>()?;
            Ok::<_, RecordingError>(HeatAt { location, sources })
        };
        let mut all = vec![];
        for (probe, chainage) in self.probes().enumerate() {
            let column = |source: &str| format!("probe[{}].heat.{source}", probe + 1);
            all.push(at(chainage, &column, 1.0)?);
        }
        let column = |source: &str| format!("energy.{source}");
        // A run that was killed early has not said how long its rail is.
        if facts.length_m > 0.0 {
            all.push(at("mean of the modelled rail".to_owned(), &column, facts.length_m)?);
        }
        Ok(all)
    }

    /// The probes' chainages in words, from the descriptions of their heat.
    fn probes(&self) -> impl Iterator<Item = String> {
        let heat = self.with_unit_of("J/m");
        let of_probe =
            heat.filter(|(column, _)| column.starts_with("probe[") && column.ends_with("].heat"));
        of_probe.map(|(_, description)| match description.rsplit_once(" at ") {
            Some((_, chainage)) => chainage.to_owned(),
            None => description.to_owned(),
        })
    }

    /// The energies at the end.
    fn energies(&self) -> Result<Vec<EnergyLine>, RecordingError> {
        let line = |(column, description): (&str, &str)| {
            Ok(EnergyLine { name: description.to_owned(), joules: self.last(column)? })
        };
        self.with_unit_of("J").map(line).collect()
    }
}

/// All figures of a rail for a list that holds those of other rails too.
pub(super) fn listed(rail: &RailData) -> impl Iterator<Item = MainFigure> {
    let figures = rail.figures.iter().cloned().chain(heat_figures(rail));
    figures
        .map(|figure| MainFigure { name: format!("{} rail: {}", rail.side, figure.name), ..figure })
}

/// Heat per metre as figures for programs.
fn heat_figures(rail: &RailData) -> Vec<MainFigure> {
    let side = &rail.side;
    let figures = rail.heat.iter().flat_map(|HeatAt { location, sources }| {
        SOURCES.iter().zip(sources).map(move |(&(source, words), &heat)| {
            let key = format!("{side}.heat.{source}.{}", location.replace(' ', "_"));
            let name = format!("Heat per metre by {words}, {location}");
            MainFigure { text: with_unit(heat, "J/m"), ..MainFigure::new(key, name, heat, "J/m") }
        })
    });
    figures.collect()
}
