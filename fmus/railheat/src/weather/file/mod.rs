//! Weather that changes, from a file: rows of the run's own time, or the hours of a year.
//!
//! | file | part |
//! |---|---|
//! | `rows.rs` | CSV with the times of the simulation, linear between its rows |
//! | `epw.rs`, `epw_header.rs` | weather files of EnergyPlus, the hours of a typical year, or shorter intervals |
//! | `sample.rs` | what a file says of a time |
//! | `columns.rs` | the columns, and what is possible in them |
//! | `error.rs` | why a file cannot be used |
//!
//! A time that a file does not cover is refused; nothing is made up outside of it.

mod columns;
mod epw;
mod epw_header;
#[cfg(test)]
mod epw_tests;
mod error;
mod rows;
mod sample;

use std::path::Path;

use files::{Document, Mistake};
use numerics::constants::ZERO_CELSIUS;

use super::conditions::Weather;
use super::ephemeris::Ephemeris;
use super::erbs::split;

pub use columns::COLUMNS;
pub use error::WeatherFileError;

use epw::Year;
use rows::Rows;
use sample::{Sample, Sunlight};

/// A file of weather.
#[derive(Clone, Debug, PartialEq)]
pub struct WeatherFile {
    name: String,
    content: Content,
}

#[derive(Clone, Debug, PartialEq)]
enum Content {
    Rows(Rows),
    Year(Year),
}

impl WeatherFile {
    /// Reads a file: of EnergyPlus where its name ends in `.epw`, else CSV.
    ///
    /// # Errors
    /// When it cannot be read, has a gap or an absurd value.
    pub fn open(path: &Path) -> Result<Self, Mistake> {
        Self::of(&Document::read(path)?)
    }

    /// Reads the text of a file, whose name says by its end what file it is.
    ///
    /// # Errors
    /// When it has a gap or an absurd value.
    pub fn of(document: &Document) -> Result<Self, Mistake> {
        let name = document.name().to_owned();
        let content = match name.to_lowercase().ends_with(".epw") {
            true => Content::Year(Year::of(document)?),
            false => Content::Rows(Rows::of(document)?),
        };
        Ok(Self { name, content })
    }

    /// Whether the file says where the sun stands.
    pub fn has_sun(&self) -> bool {
        matches!(&self.content, Content::Rows(rows) if rows.has_sun())
    }

    /// Latitude (north positive) and longitude (east positive), rad, if the file says where it is of.
    pub fn site(&self) -> Option<[f64; 2]> {
        match &self.content {
            Content::Rows(_) => None,
            Content::Year(year) => Some(year.site()),
        }
    }

    /// The weather at a time in s; the ephemeris says when and where that is.
    ///
    /// # Errors
    /// When the file does not cover it, or asks for a date and there is none.
    pub fn at(
        &self,
        time: f64,
        ephemeris: Option<&Ephemeris>,
    ) -> Result<Weather, WeatherFileError> {
        let sample = self.sample(time, ephemeris)?;
        let sun = ephemeris.map_or(sample.sun, |ephemeris| ephemeris.at(time));
        let [direct, diffuse] = match sample.light {
            Sunlight::Parts(parts) => parts,
            Sunlight::Global(global) => {
                let ephemeris = ephemeris.ok_or_else(|| self.needs_date())?;
                split(global, sun.elevation, ephemeris.outside(time))
            }
        };
        let Sample { air, wind, sky, .. } = sample;
        Ok(Weather { ambient: air + ZERO_CELSIUS, wind, direct, diffuse, sky, sun })
    }

    fn sample(&self, time: f64, ephemeris: Option<&Ephemeris>) -> Result<Sample, WeatherFileError> {
        match &self.content {
            Content::Rows(rows) => rows.at(time).ok_or_else(|| {
                let [first, last] = rows.covers();
                WeatherFileError::NotCovered { file: self.name.clone(), first, last, time }
            }),
            Content::Year(year) => {
                let ephemeris = ephemeris.ok_or_else(|| self.needs_date())?;
                year.at(ephemeris.clock(time).naive_utc()).map_err(|missing| {
                    WeatherFileError::NoSuchHour { file: self.name.clone(), missing, time }
                })
            }
        }
    }

    fn needs_date(&self) -> WeatherFileError {
        WeatherFileError::NeedsDate { file: self.name.clone() }
    }
}
