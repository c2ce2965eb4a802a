//! Weather with the times of the simulation: a CSV file, linear between its rows.
//!
//! ```text
//! time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg
//! 0,12.5,1.0,0,0,-10,80
//! 3600,13.0,1.5,120,30,2,90
//! ```
//!
//! The last two columns may be left out where `site.date_time` says when it is, and are not looked at there.
//! There may be one column `global_W_m2` in place of the last four then.
//!
//! A run that is not covered is refused at the start of it, or where the simulation tool does not say when it
//! will stop, refused when it gets there.

use files::{Column, Document, Mistake, Table};

use super::columns::{AIR, DIFFUSE, DIRECT, GLOBAL, SUN_AZIMUTH, SUN_ELEVATION, TIME, WIND};
use super::sample::{Sample, Sunlight, between};
use crate::weather::sun::Sun;

/// Longest time between two rows, s: beyond it weather cannot be called known.
const LONGEST_GAP: f64 = 3.0 * 3600.0;

/// The columns of a file in order.
const WITH_SUN: [Column; 7] = [TIME, AIR, WIND, DIRECT, DIFFUSE, SUN_ELEVATION, SUN_AZIMUTH];
const WITH_GLOBAL: [Column; 4] = [TIME, AIR, WIND, GLOBAL];

/// Number of columns without those of the sun.
const WITHOUT_SUN: usize = 5;

/// The rows of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Rows {
    /// Number of columns, which differs between the lists.
    columns: usize,
    times: Vec<f64>,
    /// Values behind the time in the order of the columns; zero in those that the file has not.
    values: Vec<[f64; WITH_SUN.len() - 1]>,
}

impl Rows {
    pub(super) fn of(document: &Document) -> Result<Self, Mistake> {
        let table = Table::new(document)?;
        let columns = columns(&table)?;
        let mut rows = Self { columns: columns.len(), times: vec![], values: vec![] };
        for row in 0..table.len() {
            let time = table.number(row, 0)?;
            let last = rows.times.last().copied();
            if let Some(last) = last.filter(|last| time - last <= 0.0 || time - last > LONGEST_GAP)
            {
                let wanted = format!(
                    "must rise from {last} before it, and by {LONGEST_GAP} s at most; a longer gap must \
                     be filled"
                );
                return Err(table.error(row, 0, wanted));
            }
            rows.times.push(time);
            let mut values = [0.0; WITH_SUN.len() - 1];
            for (value, (i, column)) in values.iter_mut().zip(columns.iter().enumerate().skip(1)) {
                *value = column.value(&table, row, i)?;
            }
            rows.values.push(values);
        }
        Ok(rows)
    }

    /// Whether the file says where the sun stands.
    pub(super) fn has_sun(&self) -> bool {
        self.columns == WITH_SUN.len()
    }

    /// The first and the last time, s.
    pub(super) fn covers(&self) -> [f64; 2] {
        [self.times[0], self.times[self.times.len() - 1]]
    }

    /// What the file says of a time in s, if it covers it.
    pub(super) fn at(&self, time: f64) -> Option<Sample> {
        let [first, last] = self.covers();
        if !(first..=last).contains(&time) {
            return None;
        }
        let after = self.times.partition_point(|t| *t <= time).min(self.times.len() - 1);
        let before = after.saturating_sub(1);
        let length = self.times[after] - self.times[before];
        let share = if length > 0.0 { (time - self.times[before]) / length } else { 0.0 };
        let value = |i: usize| between([self.values[before][i], self.values[after][i]], share);
        let light = match self.columns == WITH_GLOBAL.len() {
            true => Sunlight::Global(value(2)),
            false => Sunlight::Parts([value(2), value(3)]),
        };
        let sun = Sun { elevation: value(4).to_radians(), azimuth: value(5).to_radians() };
        Some(Sample { air: value(0), wind: value(1), light, sky: None, sun })
    }
}

/// The columns that a file has; its names must be those of one of the lists.
fn columns(table: &Table) -> Result<&'static [Column], Mistake> {
    let lists = [&WITH_SUN[..], &WITH_SUN[..WITHOUT_SUN], &WITH_GLOBAL[..]];
    let fits = |list: &&[Column]| table.names().eq(list.iter().map(|column| column.name));
    lists.into_iter().find(fits).ok_or_else(|| {
        let names = |columns: &[Column]| {
            columns.iter().map(|column| column.name).collect::<Vec<_>>().join(",")
        };
        table.error_in_names(format!(
            "the columns must be {}, of which the last two may be left out; or {}",
            names(&WITH_SUN),
            names(&WITH_GLOBAL)
        ))
    })
}

#[cfg(test)]
mod tests {
    use crate::weather::{Ephemeris, WeatherFile, split};
    use files::Document;

    const HEADER: &str =
        "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg";

    fn read(text: &str) -> Result<WeatherFile, files::Mistake> {
        WeatherFile::of(&Document::new("day.csv", text))
    }

    #[test]
    fn analytic_weather_is_linear_between_rows() {
        let text = format!("{HEADER}\n0,10,1,0,0,-10,80\n3600,20,3,400,100,10,100\n");
        let file = read(&text).unwrap();
        let weather = file.at(900.0, None).unwrap();
        assert_eq!(weather.ambient, 285.65);
        assert_eq!((weather.wind, weather.direct, weather.diffuse), (1.5, 100.0, 25.0));
        assert_eq!(weather.sun.elevation, (-5_f64).to_radians());
        assert_eq!(file.at(3600.0, None).unwrap().wind, 3.0);
        let sentence = file.at(3601.0, None).unwrap_err().to_string();
        assert!(sentence.contains("day.csv has weather from 0 s to 3600 s"), "{sentence}");
    }

    #[test]
    fn wrong_lines_are_named() {
        for (text, wanted) in [
            ("time,air\n0,1".to_owned(), "day.csv:1:1: the columns must be time_s,air_degC"),
            (format!("{HEADER}\n"), "day.csv: has no rows below the names"),
            (
                "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2\n0,1".to_owned(),
                "2 values, but the rows above it have 5",
            ),
            (
                format!("{HEADER}\n0,10,1,0,0,0"),
                "day.csv:2:1: this row has 6 values, but the rows above it have 7",
            ),
            (format!("{HEADER}\n0,ten,1,0,0,0,0"), "day.csv:2:3: air_degC = ten: must be a number"),
            (
                format!("{HEADER}\n0,288,1,0,0,0,0"),
                "day.csv:2:3: air_degC = 288: must lie between -90 and 65 °C",
            ),
            (
                format!("{HEADER}\n0,10,1,0,0,0,0\n0,10,1,0,0,0,0"),
                "day.csv:3:1: time_s = 0: must rise from 0 before it",
            ),
            (
                format!("{HEADER}\n0,10,1,0,0,0,0\n20000,10,1,0,0,0,0"),
                "a longer gap must be filled",
            ),
        ] {
            let sentence = read(&text).unwrap_err().to_string();
            assert!(sentence.contains(wanted), "{sentence}");
        }
    }

    /// At noon in Rockhampton, whose sun stands 43° high in June.
    #[test]
    fn global_irradiance_is_split_by_date_and_sun() {
        let text = "time_s,air_degC,wind_m_s,global_W_m2\n0,20,1,500\n3600,20,1,600\n";
        let file = read(text).unwrap();
        let [latitude, longitude] = [-23.4_f64, 150.5].map(f64::to_radians);
        let noon = Ephemeris::new("2018-06-21T12:00:00+10:00", latitude, longitude).unwrap();
        let weather = file.at(1800.0, Some(&noon)).unwrap();
        let parts = split(550.0, weather.sun.elevation, noon.outside(1800.0));
        assert_eq!([weather.direct, weather.diffuse], parts);
        // kt = 550/(1322 sin 43°) = 0.61, of which the correlation makes 42 % diffuse.
        assert!((weather.diffuse / 550.0 - 0.42).abs() < 0.02, "{}", weather.diffuse);
        let sentence = file.at(0.0, None).unwrap_err().to_string();
        assert!(sentence.contains("day.csv: site.date_time must say when second 0 is"));
        let mixed =
            "time_s,air_degC,wind_m_s,global_W_m2,sun_elevation_deg,sun_azimuth_deg\n0,1,1,1,1,1";
        assert!(read(mixed).is_err());
    }
}
