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

use super::conditions::Weather;
use super::sun::Sun;

/// First line of the file.
pub const HEADER: &str =
    "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg";

/// Number of columns without those of the sun.
const WITHOUT_SUN: usize = 5;

/// Lowest and highest value of each column after the time.
pub(crate) const BOUNDS: [(f64, f64); 6] =
    [(-90.0, 65.0), (0.0, 115.0), (0.0, 1500.0), (0.0, 1000.0), (-90.0, 90.0), (-360.0, 720.0)];

/// Longest time between two rows, s: beyond it weather cannot be called known.
const LONGEST_GAP: f64 = 3.0 * 3600.0;

/// Why the file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum WeatherFileError {
    /// The file cannot be read.
    #[error("weather_file {file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// A line is wrong.
    #[error("weather_file {file}, line {line}: {what}")]
    Line {
        /// File name.
        file: String,
        /// Line counted from one.
        line: usize,
        /// What is wrong, and what would be right.
        what: String,
    },
    /// The file does not cover a time.
    #[error(
        "weather_file {file} has weather from {first} s to {last} s, but the run needs {time} s; it must cover \
         all of the run, the time after the train included"
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
    pub fn open(path: &Path) -> Result<Self, WeatherFileError> {
        let name = path.display().to_string();
        match std::fs::read_to_string(path) {
            Ok(text) => Self::from_csv(&text, &name),
            Err(source) => Err(WeatherFileError::Read { file: name, source }),
        }
    }

    /// Reads the text of a file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When it has a gap or an absurd value.
    pub fn from_csv(text: &str, name: &str) -> Result<Self, WeatherFileError> {
        let wrong = |line: usize, what: String| WeatherFileError::Line {
            file: name.to_owned(),
            line: line + 1,
            what,
        };
        let mut lines = text.lines().enumerate().filter(|(_, line)| !line.trim().is_empty());
        let names: Vec<&str> = HEADER.split(',').collect();
        let header = lines.next().map_or("", |(_, line)| line.trim());
        let has_sun = header == HEADER;
        if !has_sun && header != names[..WITHOUT_SUN].join(",") {
            return Err(wrong(
                0,
                format!("must be {HEADER}, of which the last two may be left out"),
            ));
        }
        let names = &names[..if has_sun { names.len() } else { WITHOUT_SUN }];
        let mut file = Self { name: name.to_owned(), has_sun, times: vec![], rows: vec![] };
        for (index, line) in lines {
            let (time, row) = values(line, names).map_err(|what| wrong(index, what))?;
            let last = file.times.last().copied();
            if let Some(last) = last.filter(|last| time - last <= 0.0 || time - last > LONGEST_GAP)
            {
                return Err(wrong(
                    index,
                    format!(
                        "time_s = {time} after {last}: must rise, and by {LONGEST_GAP} s at most; a \
                     longer gap must be filled"
                    ),
                ));
            }
            file.times.push(time);
            file.rows.push(row);
        }
        if file.times.is_empty() {
            return Err(wrong(1, "there must be at least one row of weather".to_owned()));
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
            ambient: value(0) + 273.15,
            wind: value(1),
            direct: value(2),
            diffuse: value(3),
            sun: Sun { elevation: value(4).to_radians(), azimuth: value(5).to_radians() },
        })
    }
}

/// The time and the values of a line; zero in columns that are left out.
fn values(line: &str, names: &[&str]) -> Result<(f64, [f64; 6]), String> {
    let fields: Vec<&str> = line.split(',').map(str::trim).collect();
    if fields.len() != names.len() {
        return Err(format!(
            "has {} values: {} are needed, {}",
            fields.len(),
            names.len(),
            names.join(",")
        ));
    }
    let mut numbers = [0.0; 7];
    for ((number, field), name) in numbers.iter_mut().zip(&fields).zip(names) {
        let parsed: Option<f64> = field.parse().ok();
        *number = parsed
            .filter(|value| value.is_finite())
            .ok_or_else(|| format!("{name} = \"{field}\": must be a number"))?;
    }
    let [time, row @ ..] = numbers;
    for ((value, (low, high)), name) in row.iter().zip(BOUNDS).zip(&names[1..]) {
        if !(low..=high).contains(value) {
            return Err(format!("{name} = {value}: must lie between {low} and {high}"));
        }
    }
    Ok((time, row))
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
            ("time,air\n".to_owned(), "line 1: must be time_s,air_degC"),
            (format!("{HEADER}\n"), "at least one row"),
            ("time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2\n0,1".to_owned(), "5 are needed"),
            (format!("{HEADER}\n0,10,1,0,0,0"), "line 2: has 6 values: 7 are needed"),
            (format!("{HEADER}\n0,ten,1,0,0,0,0"), "air_degC = \"ten\": must be a number"),
            (format!("{HEADER}\n0,288,1,0,0,0,0"), "air_degC = 288: must lie between -90 and 65"),
            (format!("{HEADER}\n0,10,1,0,0,0,0\n0,10,1,0,0,0,0"), "line 3: time_s = 0 after 0"),
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
