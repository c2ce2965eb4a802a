//! Weather files of EnergyPlus (`.epw`): the hours of a typical year at one site.
//!
//! Eight lines of header, then a row for each hour (*EnergyPlus Auxiliary Programs*, "EnergyPlus Weather File
//! (EPW) Data Dictionary"). A row names the hour that ends: hour 1 is that from 0:00 to 1:00, standard time of
//! the site. Temperature, wind and radiation of the sky hold at its end, sunlight is the mean of it and
//! belongs to its middle; in between all is linear.
//!
//! The months of a typical year are of different years, so that a row is found by month, day and hour; 29
//! February is 28 February where the file does not have it. Dew point and humidity are not needed: the rail
//! knows no moisture, and that of the sky is in its radiation.

use std::collections::BTreeMap;

use chrono::{Datelike, NaiveDateTime, TimeDelta, Timelike};
use files::{Column, Document, Mistake, Table};

use super::columns::{AIR, DIFFUSE, DIRECT, GLOBAL, SKY, WIND};
use super::epw_header::{HEADER, check_periods, location};
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
const DRY_BULB: usize = 6;
const SKY_RADIATION: usize = 12;
const GLOBAL_HORIZONTAL: usize = 13;
const DIRECT_NORMAL: usize = 14;
const DIFFUSE_HORIZONTAL: usize = 15;
const WIND_SPEED: usize = 21;

/// What stands for an irradiance that is missing, W/m².
const MISSING: f64 = 9999.0;

/// Month, day and hour that begins, from 1, 1 and 0.
type Key = [u32; 3];

/// The hours of a year.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Year {
    site: [f64; 2],
    /// Standard time of the site less universal time.
    zone: TimeDelta,
    hours: BTreeMap<Key, Hour>,
    has_global: bool,
    has_sky: bool,
}

/// A row.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Hour {
    air: f64,
    wind: f64,
    sky: f64,
    /// Direct and diffuse irradiance, or the global one and none, W/m².
    light: [f64; 2],
}

impl Year {
    pub(super) fn of(document: &Document) -> Result<Self, Mistake> {
        let (site, zone) = location(document)?;
        check_periods(document)?;
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
        let mut hours = BTreeMap::new();
        for row in 0..table.len() {
            let light = match has_global {
                true => [value(&GLOBAL, &table, row, GLOBAL_HORIZONTAL)?, 0.0],
                false => [
                    value(&DIRECT, &table, row, DIRECT_NORMAL)?,
                    value(&DIFFUSE, &table, row, DIFFUSE_HORIZONTAL)?,
                ],
            };
            let hour = Hour {
                air: value(&AIR, &table, row, DRY_BULB)?,
                wind: value(&WIND, &table, row, WIND_SPEED)?,
                sky: if has_sky { table.number(row, SKY_RADIATION)? } else { 0.0 },
                light,
            };
            if hours.insert(key(&table, row)?, hour).is_some() {
                let wanted =
                    "is there before for this month and day; leave one year of the file only";
                return Err(table.error(row, HOUR, wanted));
            }
        }
        Ok(Self { site, zone, hours, has_global, has_sky })
    }

    /// Latitude and longitude, rad.
    pub(super) fn site(&self) -> [f64; 2] {
        self.site
    }

    /// What the file says of a moment in universal time, or the begin of the hour that it lacks.
    pub(super) fn at(&self, moment: NaiveDateTime) -> Result<Sample, NaiveDateTime> {
        let local = moment + self.zone;
        let (ends, share) = self.around(local, TimeDelta::hours(1))?;
        let [air, wind, sky] =
            [|hour: &Hour| hour.air, |hour: &Hour| hour.wind, |hour: &Hour| hour.sky]
                .map(|value| between(ends.map(value), share));
        let (middles, share) = self.around(local, TimeDelta::minutes(30))?;
        let light = [0, 1].map(|i| between(middles.map(|hour| hour.light[i]), share));
        let light = match self.has_global {
            true => Sunlight::Global(light[0]),
            false => Sunlight::Parts(light),
        };
        Ok(Sample { air, wind, light, sky: self.has_sky.then_some(sky), sun: Sun::default() })
    }

    /// The hours between which a moment lies, and how far, if their values hold so long after they begin.
    fn around(
        &self,
        moment: NaiveDateTime,
        after: TimeDelta,
    ) -> Result<([&Hour; 2], f64), NaiveDateTime> {
        let moment = moment - after;
        let whole = i64::from(60 * moment.minute() + moment.second());
        let since = TimeDelta::seconds(whole) + TimeDelta::nanoseconds(moment.nanosecond().into());
        let begin = moment - since;
        let share = (whole as f64 + 1e-9 * f64::from(moment.nanosecond())) / 3600.0;
        Ok(([self.hour(begin)?, self.hour(begin + TimeDelta::hours(1))?], share))
    }

    fn hour(&self, begin: NaiveDateTime) -> Result<&Hour, NaiveDateTime> {
        let day = match [begin.month(), begin.day()] {
            [2, 29] if !self.hours.contains_key(&[2, 29, begin.hour()]) => 28,
            [_, day] => day,
        };
        self.hours.get(&[begin.month(), day, begin.hour()]).ok_or(begin)
    }
}

/// A value that every row must have.
fn value(column: &Column, table: &Table, row: usize, i: usize) -> Result<f64, Mistake> {
    column.value(table, row, i).map_err(|mut mistake| {
        mistake.sentence += "; a value that is missing (99.9, 999, 9999) must be filled";
        mistake
    })
}

fn key(table: &Table, row: usize) -> Result<Key, Mistake> {
    let whole = |column: usize, most: u32| {
        let number = table.text(row, column).parse().ok();
        number.filter(|number| (1..=most).contains(number)).ok_or_else(|| {
            table.error(row, column, format!("must be a whole number from 1 to {most}"))
        })
    };
    Ok([whole(MONTH, 12)?, whole(DAY, 31)?, whole(HOUR, 24)? - 1])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::weather::{Ephemeris, Weather, WeatherFile, split};

    /// Two days of a typical year, one of 2007 and one of 2011: each hour has its number as temperature, ten
    /// times it as diffuse irradiance and eighty times it as direct one.
    fn two_days() -> String {
        let mut text = "LOCATION,Rockhampton,QLD,AUS,made up,943740,-23.38,150.48,10.0,14.0\n\
                        DESIGN CONDITIONS,0\nTYPICAL/EXTREME PERIODS,0\nGROUND TEMPERATURES,0\n\
                        HOLIDAYS/DAYLIGHT SAVINGS,No,0,0,0\nCOMMENTS 1,\nCOMMENTS 2,\n\
                        DATA PERIODS,1,1,Data,Sunday, 6/30, 7/ 1\n"
            .to_owned();
        for (year, month, day) in [(2011, 6, 30), (2007, 7, 1)] {
            for hour in 1..=24 {
                let light = if (8..18).contains(&hour) { 10 * hour } else { 0 };
                text += &format!(
                    "{year},{month},{day},{hour},60,?9,{hour}.0,5.0,60,101300,0,0,300,{},{},{light},0,0,0,0,90,2.5,\
                     5,5,20\n",
                    5 * light,
                    8 * light
                );
            }
        }
        text
    }

    fn read(text: &str) -> Result<WeatherFile, Mistake> {
        WeatherFile::of(&Document::new("Rockhampton.EPW", text))
    }

    fn at(file: &WeatherFile, date_time: &str, time: f64) -> Weather {
        let [latitude, longitude] = file.site().unwrap();
        let ephemeris = Ephemeris::new(date_time, latitude, longitude).unwrap();
        file.at(time, Some(&ephemeris)).unwrap()
    }

    #[test]
    fn temperatures_hold_at_the_end_of_an_hour_and_sunlight_in_its_middle() {
        let file = read(&two_days()).unwrap();
        let weather = at(&file, "2018-06-30T12:00:00+10:00", 0.0);
        assert_eq!(weather.ambient, 273.15 + 12.0);
        assert_eq!((weather.direct, weather.diffuse), (1000.0, 125.0));
        assert_eq!((weather.wind, weather.sky), (2.5, Some(300.0)));
        let later = at(&file, "2018-06-30T12:00:00+10:00", 1800.0);
        assert_eq!(later.ambient, 273.15 + 12.5);
        assert_eq!((later.direct, later.diffuse), (1040.0, 130.0));
        assert!(later.sun.elevation > 0.6 && !file.has_sun());
    }

    /// The same moment, said in another time zone, and in another year.
    #[test]
    fn hours_are_found_by_month_and_day_in_the_standard_time_of_the_site() {
        let file = read(&two_days()).unwrap();
        let here = at(&file, "2018-07-01T10:30:00+10:00", 0.0);
        assert_eq!(here.ambient, 273.15 + 10.5);
        let there = at(&file, "2018-07-01T02:30:00+02:00", 0.0);
        assert_eq!(there.ambient, here.ambient);
        // Over midnight from the last hour of one day, of 2011, to the first one of the next, of 2007.
        let midnight = at(&file, "1999-06-30T18:00:00+10:00", 6.5 * 3600.0);
        assert_eq!(midnight.ambient, 273.15 + 12.5);
    }

    #[test]
    fn global_irradiance_is_split_where_a_row_has_no_other() {
        let whole = two_days().replace(",500,800,100,", ",500,9999,9999,");
        let file = read(&whole).unwrap();
        let weather = at(&file, "2018-06-30T09:30:00+10:00", 0.0);
        let [latitude, longitude] = file.site().unwrap();
        let morning = Ephemeris::new("2018-06-30T09:30:00+10:00", latitude, longitude).unwrap();
        let parts = split(500.0, weather.sun.elevation, morning.outside(0.0));
        assert_eq!([weather.direct, weather.diffuse], parts);
        assert_eq!(
            at(&read(&two_days().replace(",300,", ",9999,")).unwrap(), "2018-06-30T09:30:00Z", 0.0)
                .sky,
            None
        );
    }

    #[test]
    fn the_end_of_february_is_that_of_the_file() {
        let days = two_days().replace(",6,30,", ",2,28,").replace(",7,1,", ",3,1,");
        let file = read(&days).unwrap();
        assert_eq!(at(&file, "2024-02-29T12:00:00+10:00", 0.0).ambient, 273.15 + 12.0);
    }

    #[test]
    fn what_a_file_lacks_is_told() {
        let file = read(&two_days()).unwrap();
        let [latitude, longitude] = file.site().unwrap();
        let august = Ephemeris::new("2018-08-01T12:00:00+10:00", latitude, longitude).unwrap();
        let text = file.at(0.0, Some(&august)).unwrap_err().to_string();
        assert!(text.contains("no row for the hour that begins on 01 August at 11:00"), "{text}");
        let text = file.at(0.0, None).unwrap_err().to_string();
        assert!(text.contains("site.date_time must say when second 0 is"), "{text}");
        for (from, to, wanted) in [
            (",24,60,", ",25,60,", "EPW:32:11: Hour = 25: must be a whole number from 1 to 24"),
            (
                ",12,60,?9,12.0,",
                ",12,60,?9,99.9,",
                "EPW:20:20: Dry Bulb Temperature = 99.9: must lie",
            ),
            ("DATA PERIODS,1,1,", "DATA PERIODS,1,4,", "EPW:8:16: rows an hour = 4: must be 1"),
            ("-23.38", "-233.8", "EPW:1:45: latitude = -233.8: must lie between -90 and 90 °"),
            ("LOCATION,", "PLACE,", "EPW:1:1: must begin with the line LOCATION"),
            (",6,30,", ",7,1,", "EPW:33:10: Hour = 1: is there before for this month and day"),
        ] {
            let text = read(&two_days().replace(from, to)).unwrap_err().to_string();
            assert!(text.contains(wanted), "{text}");
        }
    }
}
