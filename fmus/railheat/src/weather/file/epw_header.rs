//! The lines above the hours of a weather file of EnergyPlus: where it is of, and rows an hour.

use chrono::TimeDelta;
use files::{Document, Mistake, Table};

/// Lines above the hours.
pub(super) const HEADER: usize = 8;

/// Line that says how many rows an hour has, from 0.
const PERIODS: usize = 7;

/// Columns of the first line.
const LOCATION: [&str; 10] = [
    "LOCATION",
    "city",
    "state",
    "country",
    "source",
    "station",
    "latitude",
    "longitude",
    "time zone",
    "elevation",
];
const LATITUDE: usize = 6;
const LONGITUDE: usize = 7;
const ZONE: usize = 8;

/// Latitude and longitude in rad, and the time zone.
pub(super) fn location(document: &Document) -> Result<([f64; 2], TimeDelta), Mistake> {
    let table = Table::without_names(document, 0..1, &LOCATION)?;
    if table.is_empty() || table.text(0, 0) != LOCATION[0] {
        let sentence = "must begin with the line LOCATION of a weather file of EnergyPlus";
        return Err(document.mistake(0..1, sentence));
    }
    let within = |column, bound: f64, unit| table.number_within(0, column, [-bound, bound], unit);
    let site = [within(LATITUDE, 90.0, "°")?, within(LONGITUDE, 180.0, "°")?];
    let zone = within(ZONE, 14.0, "h")?;
    Ok((site.map(f64::to_radians), TimeDelta::seconds((3600.0 * zone).round() as i64)))
}

/// Number of rows that each hour has.
pub(super) fn rows_per_hour(document: &Document) -> Result<u32, Mistake> {
    let names = ["DATA PERIODS", "number of periods", "rows an hour"];
    let table = Table::without_names(document, PERIODS..HEADER, &names)?;
    if table.is_empty() || table.text(0, 0) != names[0] {
        let sentence = format!(
            "must have a header of {HEADER} lines, from LOCATION to {}, as weather files of EnergyPlus have",
            names[0]
        );
        return Err(Mistake::in_file(document.name(), sentence));
    }
    let rows: Option<u32> = table.text(0, 2).parse().ok();
    rows.filter(|rows| (1..=60).contains(rows) && 60 % rows == 0).ok_or_else(|| {
        let wanted = "must be a whole number of which 60 is a multiple, such as 1 or 4";
        table.error(0, 2, wanted)
    })
}
