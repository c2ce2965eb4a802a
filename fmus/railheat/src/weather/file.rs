//! Weather that changes: a CSV file, linear between its rows.
//!
//! ```text
//! time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg
//! 0,12.5,1.0,0,0,-10,80
//! 3600,13.0,1.5,120,30,2,90
//! ```
//!
//! The last two columns may be left out where `site.date_time` says when it is, and are not looked at there.
//!
//! Times are those of the simulation. A run that is not covered is refused at the start of it, or where the
//! simulation tool does not say when it will stop, refused when it gets there; nothing is made up outside the file.

use std::path::Path;

use files::{Document, Mistake, Table};
use numerics::constants::ZERO_CELSIUS;

use super::conditions::Weather;
use super::sun::Sun;

/// First line of the file.
pub const HEADER: &str =
    "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg";

/// Column of the time.
const TIME: usize = 0;

/// Number of columns without those of the sun.
const WITHOUT_SUN: usize = 5;

/// Lowest and highest value of each column after the time.
const BOUNDS: [(f64, f64); 6] =
    [(-90.0, 65.0), (0.0, 115.0), (0.0, 1500.0), (0.0, 1000.0), (-90.0, 90.0), (-360.0, 720.0)];

/// Longest time between two rows, s: beyond it weather cannot be called known.
const LONGEST_GAP: f64 = 3.0 * 3600.0;

/// Why the file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum WeatherFileError {
    /// The file cannot be read, or a value in it is not possible.
    #[error(transparent)]
    File(#[from] Mistake),
    /// The file does not cover a time.
    #[error(
        "weather_file {file} has weather from {first} s to {last} s, but the run needs {} s; it must cover \
         all of the run, the time after the train included",
        (1e3 * time).round() / 1e3
    )]
    NotCovered {
        /// File name.
        file: String,
        /// First time, s.
        first: f64,
        /// Last time, s.
        last: f64,
        /// Time wanted, s.
        time: f64,
    },
}

/// The rows of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct WeatherFile {
    name: String,
    has_sun: bool,
    times: Vec<f64>,
    rows: Vec<[f64; 6]>,
}

impl WeatherFile {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, has a gap or an absurd value.
    pub fn open(path: &Path) -> Result<Self, Mistake> {
        Self::of(&Document::read(path)?)
    }

    /// Reads the text of a file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When it has a gap or an absurd value.
    pub fn from_csv(text: &str, name: &str) -> Result<Self, WeatherFileError> {
        Ok(Self::of(&Document::new(name, text))?)
    }

    fn of(document: &Document) -> Result<Self, Mistake> {
        let table = Table::new(document)?;
        let has_sun = table.names().eq(HEADER.split(','));
        if !has_sun && !table.names().eq(HEADER.split(',').take(WITHOUT_SUN)) {
            let wanted = format!("the columns must be {HEADER}; the last two may be left out");
            return Err(table.error_in_names(wanted));
        }
        let name = document.name().to_owned();
        let mut file = Self { name, has_sun, times: vec![], rows: vec![] };
        for row in 0..table.len() {
            let time = table.number(row, TIME)?;
            let last = file.times.last().copied();
            if let Some(last) = last.filter(|last| time - last <= 0.0 || time - last > LONGEST_GAP)
            {
                let wanted = format!(
                    "must rise from {last} before it, and by {LONGEST_GAP} s at most; a longer gap must \
                     be filled"
                );
                return Err(table.error(row, TIME, wanted));
            }
            file.times.push(time);
            file.rows.push(values(&table, row)?);
        }
        Ok(file)
    }

    /// Whether the file says where the sun stands.
    pub fn has_sun(&self) -> bool {
        self.has_sun
    }

    /// The weather at a time in s.
    ///
    /// # Errors
    /// When the file does not cover it.
    pub fn at(&self, time: f64) -> Result<Weather, WeatherFileError> {
        let (first, last) = (self.times[0], self.times[self.times.len() - 1]);
        if !(first..=last).contains(&time) {
            let file = self.name.clone();
            return Err(WeatherFileError::NotCovered { file, first, last, time });
        }
        let after = self.times.partition_point(|t| *t <= time).min(self.times.len() - 1);
        let before = after.saturating_sub(1);
        let length = self.times[after] - self.times[before];
        let share = if length > 0.0 { (time - self.times[before]) / length } else { 0.0 };
        let value = |column: usize| {
            let (from, to) = (self.rows[before][column], self.rows[after][column]);
            from + share * (to - from)
        };
        Ok(Weather {
            ambient: value(0) + ZERO_CELSIUS,
            wind: value(1),
            direct: value(2),
            diffuse: value(3),
            sun: Sun { elevation: value(4).to_radians(), azimuth: value(5).to_radians() },
        })
    }
}

/// The values of a row behind its time; zero in columns that are left out.
fn values(table: &Table, row: usize) -> Result<[f64; 6], Mistake> {
    let mut values = [0.0; 6];
    let columns = TIME + 1..table.names().count();
    for ((value, (low, high)), column) in values.iter_mut().zip(BOUNDS).zip(columns) {
        *value = table.number(row, column)?;
        if !(low..=high).contains(value) {
            let wanted = format!("must lie between {low} and {high}");
            return Err(table.error(row, column, wanted));
        }
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn analytic_weather_is_linear_between_rows() {
        let text = format!("{HEADER}\n0,10,1,0,0,-10,80\n3600,20,3,400,100,10,100\n");
        let file = WeatherFile::from_csv(&text, "day.csv").unwrap();
        let weather = file.at(900.0).unwrap();
        assert_eq!(weather.ambient, 285.65);
        assert_eq!((weather.wind, weather.direct, weather.diffuse), (1.5, 100.0, 25.0));
        assert_eq!(weather.sun.elevation, (-5_f64).to_radians());
        assert_eq!(file.at(3600.0).unwrap().wind, 3.0);
        let sentence = file.at(3601.0).unwrap_err().to_string();
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
                "day.csv:2:3: air_degC = 288: must lie between -90 and 65",
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
            let sentence = WeatherFile::from_csv(&text, "day.csv").unwrap_err().to_string();
            assert!(sentence.contains(wanted), "{sentence}");
        }
    }
}
