//! The FMU's parameters of site and time: where the track runs, where the sun stands, what day it is.

use std::path::Path;

use fmu::{Boolean, Declaration, ModelError, Real, Text, Values, unit};
use track::Track;

use super::bounds::{positive, wrong};
use crate::energy::{Azimuth, Day};
use crate::line::Line;
use crate::weather::{Body, Ephemeris, Weather};

/// Track in the resources, used when no other is named.
const TRACK_FILE: &str = "track.toml";

const DAY: f64 = 86_400.0;

/// Steps of a day that comes again, s.
const DAY_STEP: f64 = 60.0;

/// Handles of the parameters.
#[derive(Debug)]
pub(crate) struct SiteSignals {
    azimuth: Real,
    track_file: Text,
    date_time: Text,
    latitude: Real,
    longitude: Real,
    pub(crate) day: Boolean,
    shade: Boolean,
    half_width: Real,
    floor: Real,
    roof: Real,
    rail: Real,
}

impl SiteSignals {
    pub(crate) fn declare(declaration: &mut Declaration) -> Self {
        let date_time = declaration.text_parameter(
            "site.date_time",
            "Date and time at the time zero with offset from universal time, such as \
             2018-06-21T14:30:00+10:00: the sun's place is computed; empty: the sun stands where the \
             inputs or the weather file say",
            "",
        );
        let track_file = declaration.text_parameter(
            "track_file",
            "Track whose curves turn the running direction; empty: track.toml in the resources if there \
             is one, else a straight track",
            "",
        );
        let day = declaration.boolean_parameter(
            "initial.day",
            "Start in the state to which a day's weather brings the rail when it comes again and again: \
             that of the 24 h before the start, or after it where the weather file begins later",
            false,
        );
        let shade = declaration.boolean_parameter(
            "train.shade",
            "Whether the vehicles keep the sun off the rail",
            true,
        );
        let mut real = |name: &str, unit, description: &str, start: f64| {
            declaration.real(name, unit, description).parameter(start)
        };
        Self {
            date_time,
            track_file,
            day,
            shade,
            azimuth: real(
                "track.azimuth",
                unit::RADIAN,
                "Azimuth of the running direction where the track begins, from north over east",
                0.0,
            ),
            latitude: real("site.latitude", unit::RADIAN, "Latitude, north positive", 0.0),
            longitude: real("site.longitude", unit::RADIAN, "Longitude, east positive", 0.0),
            half_width: real(
                "train.half_width",
                unit::METRE,
                "Half the width of the body that shades the rail",
                Body::WAGON.half_width,
            ),
            floor: real(
                "train.floor_height",
                unit::METRE,
                "Height of its floor above the rail",
                Body::WAGON.floor,
            ),
            roof: real(
                "train.roof_height",
                unit::METRE,
                "Height of its roof above the rail",
                Body::WAGON.roof,
            ),
            rail: real(
                "rail.lateral_position",
                unit::METRE,
                "Place of this rail to the right of the track's middle; negative: the left rail",
                Body::WAGON.rail,
            ),
        }
    }

    /// The direction of each element, from the track's curves.
    pub(crate) fn azimuth(
        &self,
        values: &Values,
        resources: &Path,
        line: &Line,
    ) -> Result<Azimuth, ModelError> {
        let begin = values[self.azimuth];
        if !begin.is_finite() {
            return Err(wrong("track.azimuth", begin, "must be a finite number"));
        }
        let named = Path::new(&values[self.track_file]);
        let inside = resources.join(TRACK_FILE);
        let file = match named {
            named if !named.as_os_str().is_empty() => named,
            _ if inside.exists() => &inside,
            _ => return Ok(Azimuth::Constant(begin)),
        };
        let track = Track::from_file(file).map_err(ModelError::from_error)?;
        let mut cached = 0;
        let direction = |element| begin + track.at(line.chainage(element), &mut cached).heading;
        Ok(Azimuth::Along((0..line.elements).map(direction).collect()))
    }

    /// The sun by position and time, if the parameters say when.
    pub(crate) fn ephemeris(&self, values: &Values) -> Result<Option<Ephemeris>, ModelError> {
        if values[self.date_time].is_empty() {
            return Ok(None);
        }
        let (latitude, longitude) = (values[self.latitude], values[self.longitude]);
        Ephemeris::new(&values[self.date_time], latitude, longitude)
            .map(Some)
            .map_err(ModelError::from_error)
    }

    /// What shades the rail.
    pub(crate) fn body(&self, values: &Values) -> Result<Option<Body>, ModelError> {
        let (floor, roof) = (values[self.floor], values[self.roof]);
        let body = Body {
            half_width: positive("train.half_width", values[self.half_width])?,
            floor: positive("train.floor_height", floor)?,
            roof: positive("train.roof_height", roof)?,
            rail: values[self.rail],
        };
        if !body.rail.is_finite() {
            return Err(wrong("rail.lateral_position", body.rail, "must be a finite number"));
        }
        if floor >= roof {
            let sentence = format!(
                "train.floor_height = {floor} and train.roof_height = {roof}: the roof must be higher"
            );
            return Err(ModelError::new(sentence));
        }
        Ok(values[self.shade].then_some(body))
    }
}

/// The day before a start, or after it when its weather is not known.
pub(crate) fn day(
    weather: impl Fn(f64) -> Result<Weather, ModelError>,
    ephemeris: Option<&Ephemeris>,
    start: f64,
) -> Result<Day, ModelError> {
    let samples = |begin: f64| {
        let of_step = |step: u32| {
            let time = begin + (f64::from(step) + 0.5) * DAY_STEP;
            let mut weather = weather(time)?;
            if let Some(ephemeris) = ephemeris {
                weather.sun = ephemeris.at(time);
            }
            Ok(weather)
        };
        (0..(DAY / DAY_STEP) as u32).map(of_step).collect::<Result<Vec<_>, ModelError>>()
    };
    let weather = samples(start - DAY).or_else(|_| samples(start)).map_err(|error| {
        ModelError::new(format!(
            "initial.day needs the weather of the 24 h before or after the start: {error}"
        ))
    })?;
    Ok(Day { weather, step: DAY_STEP })
}
