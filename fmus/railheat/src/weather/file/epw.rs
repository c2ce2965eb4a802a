//! Weather files of EnergyPlus (`.epw`): the hours of a typical year at one site.
//!
//! Eight lines of header, then a row for each hour, or as many as the header says (*EnergyPlus Auxiliary
//! Programs*, "EnergyPlus Weather File (EPW) Data Dictionary"). A row names the interval that ends: hour 1 is that
//! from 0:00 to 1:00, standard time of the site, and its minute 15 is 0:15. Where an hour has one row, its minute
//! says nothing: files have 0 or 60. Temperature, wind and radiation of the sky hold at the end, sunlight is
//! the mean of the interval and belongs to its middle; in between all is linear.
//!
//! The dictionary has sunlight in Wh/m², which is the mean in W/m² where the interval is an hour. EnergyPlus takes
//! the number as W/m² in shorter intervals too (`ReadEPlusWeatherForDay` in WeatherManager.cc), and so does this.
//!
//! The months of a typical year are of different years, so that a row is found by month, day and hour; 29
//! February is 28 February where the file does not have it. Dew point and humidity are not needed: the rail
//! knows no moisture, and that of the sky is in its radiation.

use std::collections::BTreeMap;

use chrono::{Datelike, NaiveDateTime, TimeDelta, Timelike};
use files::{Column, Document, Mistake, Table};

use super::columns::{AIR, DIFFUSE, DIRECT, GLOBAL, SKY, WIND};
use super::epw_header::{HEADER, location, rows_per_hour};
use super::sample::{Sample, Sunlight, between};
use crate::weather::sun::Sun;

/// Columns of the hours, as far as they are read.
const NAMES: [&str; 22] = [
    "Year",
    "Month",
    "Day",
    "Hour",
    "Minute",
    "Data Source and Uncertainty Flags",
    "Dry Bulb Temperature",
    "Dew Point Temperature",
    "Relative Humidity",
    "Atmospheric Station Pressure",
    "Extraterrestrial Horizontal Radiation",
    "Extraterrestrial Direct Normal Radiation",
    SKY.name,
    "Global Horizontal Radiation",
    "Direct Normal Radiation",
    "Diffuse Horizontal Radiation",
    "Global Horizontal Illuminance",
    "Direct Normal Illuminance",
    "Diffuse Horizontal Illuminance",
    "Zenith Luminance",
    "Wind Direction",
    "Wind Speed",
];
const MONTH: usize = 1;
const DAY: usize = 2;
const HOUR: usize = 3;
const MINUTE: usize = 4;
const DRY_BULB: usize = 6;
const SKY_RADIATION: usize = 12;
const GLOBAL_HORIZONTAL: usize = 13;
const DIRECT_NORMAL: usize = 14;
const DIFFUSE_HORIZONTAL: usize = 15;
const WIND_SPEED: usize = 21;

/// What stands for an irradiance that is missing, W/m².
const MISSING: f64 = 9999.0;

/// Seconds of an hour.
const SECONDS: u32 = 3600;

/// Month and day from 1, hour that begins and interval of it from 0.
type Key = [u32; 4];

/// The rows of a year.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Year {
    site: [f64; 2],
    /// Standard time of the site less universal time.
    zone: TimeDelta,
    /// Rows of an hour.
    per_hour: u32,
    rows: BTreeMap<Key, Row>,
    has_global: bool,
    has_sky: bool,
}

/// What a row says of its interval.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Row {
    air: f64,
    wind: f64,
    sky: f64,
    /// Direct and diffuse irradiance, or the global one and none, W/m².
    light: [f64; 2],
}

impl Year {
    pub(super) fn of(document: &Document) -> Result<Self, Mistake> {
        let (site, zone) = location(document)?;
        let per_hour = rows_per_hour(document)?;
        let table = Table::without_names(document, HEADER..usize::MAX, &NAMES)?;
        if table.is_empty() {
            let sentence = format!("has no rows below its header of {HEADER} lines");
            return Err(Mistake::in_file(document.name(), sentence));
        }
        let all = |holds: &dyn Fn(usize) -> bool| (0..table.len()).all(holds);
        let is_given =
            |i: usize| all(&|row| table.number(row, i).is_ok_and(|value| value < MISSING));
        // Some files have zeros where they do not know what of the sunlight is direct.
        let is_overcast = all(&|row| table.number(row, DIRECT_NORMAL) == Ok(0.0));
        let has_parts = is_given(DIRECT_NORMAL) && is_given(DIFFUSE_HORIZONTAL) && !is_overcast;
        let has_global = !has_parts && is_given(GLOBAL_HORIZONTAL);
        let has_sky = all(&|row| SKY.value(&table, row, SKY_RADIATION).is_ok());
        let (mut rows, mut of_hours) = (BTreeMap::new(), BTreeMap::new());
        for row in 0..table.len() {
            let light = match has_global {
                true => [value(&GLOBAL, &table, row, GLOBAL_HORIZONTAL)?, 0.0],
                false => [
                    value(&DIRECT, &table, row, DIRECT_NORMAL)?,
                    value(&DIFFUSE, &table, row, DIFFUSE_HORIZONTAL)?,
                ],
            };
            let content = Row {
                air: value(&AIR, &table, row, DRY_BULB)?,
                wind: value(&WIND, &table, row, WIND_SPEED)?,
                sky: if has_sky { table.number(row, SKY_RADIATION)? } else { 0.0 },
                light,
            };
            let key = key(&table, row, per_hour)?;
            if rows.insert(key, content).is_some() {
                return Err(repeated(&table, row, per_hour));
            }
            let [month, day, hour, _] = key;
            of_hours.entry([month, day, hour]).or_insert_with(Vec::new).push(row);
        }
        let wrong = of_hours.values().find(|of_hour| of_hour.len() < per_hour as usize);
        if let Some(of_hour) = wrong {
            let wanted = format!(
                "is an hour of which the file has {} of {per_hour} rows, as line {HEADER} says in rows an hour",
                of_hour.len()
            );
            return Err(table.error(of_hour[0], HOUR, wanted));
        }
        Ok(Self { site, zone, per_hour, rows, has_global, has_sky })
    }

    /// Latitude and longitude, rad.
    pub(super) fn site(&self) -> [f64; 2] {
        self.site
    }

    /// What the file says of a moment in universal time, or the begin of the interval that it lacks.
    pub(super) fn at(&self, moment: NaiveDateTime) -> Result<Sample, NaiveDateTime> {
        let local = moment + self.zone;
        let (ends, share) = self.around(local, self.interval())?;
        let [air, wind, sky] = [|row: &Row| row.air, |row: &Row| row.wind, |row: &Row| row.sky]
            .map(|value| between(ends.map(value), share));
        let (middles, share) = self.around(local, self.interval() / 2)?;
        let light = [0, 1].map(|i| between(middles.map(|row| row.light[i]), share));
        let light = match self.has_global {
            true => Sunlight::Global(light[0]),
            false => Sunlight::Parts(light),
        };
        Ok(Sample { air, wind, light, sky: self.has_sky.then_some(sky), sun: Sun::default() })
    }

    /// Length of an interval.
    fn interval(&self) -> TimeDelta {
        TimeDelta::seconds((SECONDS / self.per_hour).into())
    }

    /// The rows between which a moment lies, and how far, if their values hold so long after they begin.
    fn around(
        &self,
        moment: NaiveDateTime,
        after: TimeDelta,
    ) -> Result<([&Row; 2], f64), NaiveDateTime> {
        let moment = moment - after;
        let length = SECONDS / self.per_hour;
        let whole = (60 * moment.minute() + moment.second()) % length;
        let since =
            TimeDelta::seconds(whole.into()) + TimeDelta::nanoseconds(moment.nanosecond().into());
        let begin = moment - since;
        let share = (f64::from(whole) + 1e-9 * f64::from(moment.nanosecond())) / f64::from(length);
        Ok(([self.row(begin)?, self.row(begin + self.interval())?], share))
    }

    fn row(&self, begin: NaiveDateTime) -> Result<&Row, NaiveDateTime> {
        let of_day = |day| [begin.month(), day, begin.hour(), begin.minute() * self.per_hour / 60];
        let day = match [begin.month(), begin.day()] {
            [2, 29] if !self.rows.contains_key(&of_day(29)) => 28,
            [_, day] => day,
        };
        self.rows.get(&of_day(day)).ok_or(begin)
    }
}

/// A value that every row must have.
fn value(column: &Column, table: &Table, row: usize, i: usize) -> Result<f64, Mistake> {
    column.value(table, row, i).map_err(|mut mistake| {
        mistake.sentence += "; a value that is missing (99.9, 999, 9999) must be filled";
        mistake
    })
}

/// A row for an interval that has one already.
fn repeated(table: &Table, row: usize, per_hour: u32) -> Mistake {
    let same_year = row > 0
        && [0, MONTH, DAY, HOUR].iter().all(|i| table.text(row, *i) == table.text(row - 1, *i));
    if same_year && per_hour > 1 {
        return table.error(row, MINUTE, "is that of the row above too; an interval has one row");
    }
    let wanted = match same_year {
        true => format!(
            "is in the row above too, while line {HEADER} says that an hour has one row; it must say how many"
        ),
        false => {
            "is there before for this month and day; leave one year of the file only".to_owned()
        }
    };
    table.error(row, HOUR, wanted)
}

fn key(table: &Table, row: usize, per_hour: u32) -> Result<Key, Mistake> {
    let whole = |column: usize, most: u32| {
        let number = table.text(row, column).parse().ok();
        number.filter(|number| (1..=most).contains(number)).ok_or_else(|| {
            table.error(row, column, format!("must be a whole number from 1 to {most}"))
        })
    };
    let [month, day, hour] = [whole(MONTH, 12)?, whole(DAY, 31)?, whole(HOUR, 24)? - 1];
    if per_hour == 1 {
        return Ok([month, day, hour, 0]);
    }
    let length = 60 / per_hour;
    let minute: Option<u32> = table.text(row, MINUTE).parse().ok();
    let ends = minute.filter(|minute| (1..=60).contains(minute) && minute % length == 0);
    let interval = ends.map(|minute| minute / length - 1).ok_or_else(|| {
        let wanted = format!(
            "must be a multiple of {length} from {length} to 60: the minute at which the interval ends, of which \
             line {HEADER} says that an hour has {per_hour}"
        );
        table.error(row, MINUTE, wanted)
    })?;
    Ok([month, day, hour, interval])
}
