//! Why a file of weather cannot be used.

use chrono::NaiveDateTime;
use files::Mistake;

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
        asked(*time)
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
    /// The file lacks an interval.
    #[error(
        "weather_file {file} has no row for the interval that begins on {}, standard time of its site, which \
         the run needs at {} s; take a file of the whole year",
        missing.format("%d %B at %H:%M"),
        asked(*time)
    )]
    NoSuchHour {
        /// File name.
        file: String,
        /// Begin of the interval.
        missing: NaiveDateTime,
        /// Time wanted, s.
        time: f64,
    },
    /// The file asks for a date, and there is none.
    #[error(
        "weather_file {file}: site.date_time must say when second 0 is, such as 2018-06-21T14:30:00+10:00, \
         to find the hour of a year (.epw) and to split global_W_m2; model = \"paper\" has no date"
    )]
    NeedsDate {
        /// File name.
        file: String,
    },
}

/// A time that is asked for, to the millisecond: the stop time is asked for with a margin of 1e-9 of it.
fn asked(time: f64) -> f64 {
    (1e3 * time).round() / 1e3
}
