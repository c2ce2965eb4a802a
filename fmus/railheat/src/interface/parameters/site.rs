//! The parameters of the site: where the track runs, where the sun stands, what day it is.

use std::f64::consts::{FRAC_PI_2, PI};
use std::path::Path;

use fmu::ModelError;
use track::Track;

use crate::energy::{Azimuth, Day};
use crate::line::Line;
use crate::weather::{Body, Ephemeris, Weather};

/// Length of a day, s.
const DAY: f64 = 86_400.0;

/// Steps of a day that comes again, s.
const DAY_STEP: f64 = 60.0;

fmu::variables! {
    /// What only `model = "energy"` has of the site.
    pub(crate) struct SiteParameters: parameter {
        /// Date and time at the time zero with offset from universal time, such as
        /// 2018-06-21T14:30:00+10:00: the sun's direction is computed; empty: the sun stands where the
        /// inputs or the weather file say
        date_time: "site.date_time", String = "";
        /// Track whose curves turn the running direction; empty: track.toml in the resources if there
        /// is one, else a straight track
        track_file: "track_file", file("track.toml");
        /// Start in the state to which a day's weather brings the rail when it comes again and again:
        /// that of the 24 h before the start, or after it where the weather file begins later
        day: "initial.day", bool = false;
        /// Whether the vehicles keep the sun off the rail
        shade: "train.shade", bool = true;
        /// Azimuth of the running direction where the track begins, from north over east
        azimuth: "track.azimuth", RADIAN = 0.0;
        /// Latitude, north positive; left at 0 with the longitude: that of an EnergyPlus weather file
        latitude: "site.latitude", RADIAN = 0.0, -FRAC_PI_2..=FRAC_PI_2;
        /// Longitude, east positive
        longitude: "site.longitude", RADIAN = 0.0, -PI..=PI;
        /// Half the width of the body that shades the rail
        half_width: "train.half_width", METRE = Body::WAGON.half_width, above(0.0);
        /// Height of its floor above the rail
        floor: "train.floor_height", METRE = Body::WAGON.floor, above(0.0);
        /// Height of its roof above the rail
        roof: "train.roof_height", METRE = Body::WAGON.roof, above(0.0);
        /// Place of this rail to the right of the track's middle; negative: the left rail
        rail: "rail.lateral_position", METRE = Body::WAGON.rail;
    }
}

/// What the parameters of the site amount to.
pub(crate) struct Site {
    pub line: Line,
    pub azimuth: Azimuth,
    pub ephemeris: Option<Ephemeris>,
    pub shade: Option<Body>,
    pub day: Option<Day>,
}

impl SiteParameters {
    /// The site of a line whose weather is known over time, at the start.
    pub(crate) fn site(
        &self,
        line: Line,
        resources: &Path,
        ephemeris: Option<Ephemeris>,
        weather: impl Fn(f64) -> Result<Weather, ModelError>,
        start: f64,
    ) -> Result<Site, ModelError> {
        Ok(Site {
            azimuth: self.azimuth(resources, &line)?,
            shade: self.body()?,
            day: match self.day {
                true => Some(day(weather, ephemeris.as_ref(), start)?),
                false => None,
            },
            ephemeris,
            line,
        })
    }

    /// The direction of each element, from the track's curves.
    fn azimuth(&self, resources: &Path, line: &Line) -> Result<Azimuth, ModelError> {
        let file = self.track_file.path(resources);
        if self.track_file.named.is_empty() && !file.exists() {
            return Ok(Azimuth::Constant(self.azimuth));
        }
        let track = Track::from_file(&file).map_err(ModelError::from_error)?;
        let mut last = 0;
        let mut direction =
            |element| self.azimuth + track.at(line.chainage(element), &mut last).heading;
        Ok(Azimuth::Along((0..line.elements).map(&mut direction).collect()))
    }

    /// The sun by position and time, if the parameters say when.
    ///
    /// Where the weather is of, latitude and longitude in rad, is the position that is not set.
    pub(crate) fn ephemeris(
        &self,
        of_weather: Option<[f64; 2]>,
    ) -> Result<Option<Ephemeris>, ModelError> {
        if self.date_time.is_empty() {
            return Ok(None);
        }
        let [latitude, longitude] = match [self.latitude, self.longitude] {
            [0.0, 0.0] => of_weather.unwrap_or_default(),
            set => set,
        };
        let ephemeris = Ephemeris::new(&self.date_time, latitude, longitude);
        ephemeris.map(Some).map_err(ModelError::from_error)
    }

    /// What shades the rail.
    fn body(&self) -> Result<Option<Body>, ModelError> {
        let Self { half_width, floor, roof, rail, .. } = *self;
        if floor >= roof {
            let sentence = format!(
                "train.floor_height = {floor} and train.roof_height = {roof}: the roof must be higher"
            );
            return Err(ModelError::new(sentence));
        }
        Ok(self.shade.then_some(Body { half_width, floor, roof, rail }))
    }
}

/// The day before a start, or after it when its weather is not known.
fn day(
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
