//! Where the sun stands, by position on Earth, date and time.
//!
//! The solar position algorithm of Reda and Andreas, *Solar Energy* 76 (2004) 577-589 (0.0003°), by
//! the crate `solar-positioning`. Refraction is left out: it lifts the sun by half a degree at the horizon,
//! where it gives nearly nothing. Validated by `benchmark_sun_position`.

use std::f64::consts::TAU;

use chrono::{DateTime, Datelike, TimeDelta, Utc};
use solar_positioning::time::JulianDate;
use solar_positioning::{Location, SolarPositions, delta_t};

use super::sun::Sun;

const SECONDS_PER_DAY: f64 = 86_400.0;

/// Irradiance outside of the atmosphere on a surface that faces the sun, mean of the year G_sc, W/m².
const SOLAR_CONSTANT: f64 = 1367.0;

/// Position on Earth and time cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum EphemerisError {
    /// Not a date and time.
    #[error(
        "site.date_time = \"{text}\": {source}; must be date, time and offset from universal time, such \
         as 2018-06-21T14:30:00+10:00"
    )]
    DateTime {
        /// Text found.
        text: String,
        /// Reason.
        source: chrono::ParseError,
    },
    /// Not a position on Earth, or a year without known orbit.
    #[error(
        "site.latitude = {latitude}°, site.longitude = {longitude}°, site.date_time = \"{text}\": \
         {source}"
    )]
    Position {
        /// Latitude, degrees.
        latitude: f64,
        /// Longitude, degrees.
        longitude: f64,
        /// Date and time.
        text: String,
        /// Reason.
        source: solar_positioning::Error,
    },
}

/// The sun seen from one position on Earth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ephemeris {
    location: Location,
    /// Date and time of the time zero.
    begin: DateTime<Utc>,
    /// Julian date of the time zero.
    zero: f64,
    delta_t: f64,
}

impl Ephemeris {
    /// The sun at a latitude (north positive) and longitude (east positive) in rad.
    ///
    /// The time zero is at `date_time`, as RFC 3339 writes it.
    ///
    /// # Errors
    /// When position or time cannot be.
    pub fn new(date_time: &str, latitude: f64, longitude: f64) -> Result<Self, EphemerisError> {
        let instant = DateTime::parse_from_rfc3339(date_time)
            .map_err(|source| EphemerisError::DateTime { text: date_time.to_owned(), source })?;
        let location =
            Location { latitude: latitude.to_degrees(), longitude: longitude.to_degrees() };
        let refused = |source| EphemerisError::Position {
            latitude: location.latitude,
            longitude: location.longitude,
            text: date_time.to_owned(),
            source,
        };
        let delta_t = delta_t::estimate_from_date_like(&instant).map_err(refused)?;
        let zero = JulianDate::from_datetime(&instant, delta_t).map_err(refused)?.julian_date();
        let ephemeris = Self { location, begin: instant.to_utc(), zero, delta_t };
        ephemeris.position(0.0).map_err(refused)?;
        Ok(ephemeris)
    }

    /// Where the sun stands at a time in s.
    pub fn at(&self, time: f64) -> Sun {
        // Position and date were checked at the start; a run does not leave the years of the algorithm.
        self.position(time).unwrap_or_default()
    }

    /// Date and time at a time in s, universal time.
    pub fn clock(&self, time: f64) -> DateTime<Utc> {
        let since = TimeDelta::nanoseconds((1e9 * time).round() as i64);
        self.begin.checked_add_signed(since).unwrap_or(self.begin)
    }

    /// Irradiance outside of the atmosphere on a surface that faces the sun at a time in s, W/m².
    ///
    /// I_0 = G_sc (1 + 0.033 cos(2π n/365)) on the day n of the year (Duffie and Beckman, *Solar Engineering
    /// of Thermal Processes*, 4th ed. 2013, eq. 1.4.1a).
    pub fn outside(&self, time: f64) -> f64 {
        let day = f64::from(self.clock(time).ordinal());
        SOLAR_CONSTANT * (1.0 + 0.033 * libm::cos(TAU * day / 365.0))
    }

    fn position(&self, time: f64) -> Result<Sun, solar_positioning::Error> {
        let date = JulianDate::new(self.zero + time / SECONDS_PER_DAY, self.delta_t)?;
        let position = SolarPositions::new().at_from_julian(date, self.location, 0.0, None)?;
        Ok(Sun {
            elevation: position.elevation_angle().to_radians(),
            azimuth: position.azimuth().to_radians(),
        })
    }
}
