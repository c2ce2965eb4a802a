//! Weather files of EnergyPlus: when their rows hold, and which are refused.

use files::{Document, Mistake};

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
        at(&read(&two_days().replace(",300,", ",9999,")).unwrap(), "2018-06-30T09:30:00Z", 0.0).sky,
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
    assert!(text.contains("no row for the interval that begins on 01 August at 11:00"), "{text}");
    let text = file.at(0.0, None).unwrap_err().to_string();
    assert!(text.contains("site.date_time must say when second 0 is"), "{text}");
    for (from, to, wanted) in [
        (",24,60,", ",25,60,", "EPW:32:11: Hour = 25: must be a whole number from 1 to 24"),
        (",12,60,?9,12.0,", ",12,60,?9,99.9,", "EPW:20:20: Dry Bulb Temperature = 99.9: must lie"),
        (
            "DATA PERIODS,1,1,",
            "DATA PERIODS,1,7,",
            "EPW:8:16: rows an hour = 7: must be a whole number of which 60 is a multiple",
        ),
        ("-23.38", "-233.8", "EPW:1:45: latitude = -233.8: must lie between -90 and 90 °"),
        ("LOCATION,", "PLACE,", "EPW:1:1: must begin with the line LOCATION"),
        (",6,30,", ",7,1,", "EPW:33:10: Hour = 1: is there before for this month and day"),
    ] {
        let text = read(&two_days().replace(from, to)).unwrap_err().to_string();
        assert!(text.contains(wanted), "{text}");
    }
}

/// Two hours in quarters, from 10:00 to 12:00 on 30 June and a row before and behind them: each quarter has the
/// minutes from 10:00 to its end as temperature, ten times it as direct irradiance and once as diffuse one.
fn quarters() -> String {
    let header = two_days().lines().take(8).collect::<Vec<_>>().join("\n");
    let mut text = header.replace("DATA PERIODS,1,1,", "DATA PERIODS,1,4,") + "\n";
    for quarter in 0..8 {
        let (hour, minute, value) = (11 + quarter / 4, 15 * (quarter % 4 + 1), 5 * (quarter + 1));
        let direct = 10 * value;
        text += &format!(
            "2011,6,30,{hour},{minute},?9,{value}.0,5.0,60,101300,0,0,300,0,{direct},{value},0,0,0,0,90,2.5,5,5,20\n"
        );
    }
    text
}

/// The row of hour 11, minute 15 ends at 10:15, where its temperature is; its sunlight belongs to 10:07:30.
#[test]
fn rows_within_an_hour_end_at_their_minute() {
    let file = read(&quarters()).unwrap();
    for (time, value) in
        [("10:15:00", 5.0), ("10:30:00", 10.0), ("11:00:00", 20.0), ("11:45:00", 35.0)]
    {
        let here = at(&file, &format!("2018-06-30T{time}+10:00"), 0.0);
        assert_eq!(here.ambient, 273.15 + value, "{time}");
    }
    assert_eq!(at(&file, "2018-06-30T11:07:30+10:00", 0.0).ambient, 273.15 + 22.5);
    let middle = at(&file, "2018-06-30T10:15:00+10:00", 7.5 * 60.0);
    assert_eq!((middle.direct, middle.diffuse), (100.0, 10.0));
    let later = at(&file, "2018-06-30T10:30:00+10:00", 0.0);
    assert_eq!((later.direct, later.diffuse), (125.0, 12.5));
}

#[test]
fn rows_that_do_not_fit_the_header_are_told() {
    let sentence = |from: &str, to: &str| {
        assert!(quarters().contains(from), "{from}");
        read(&quarters().replacen(from, to, 1)).unwrap_err().to_string()
    };
    for (from, to, wanted) in [
        (
            "11,15,",
            "11,0,",
            "EPW:9:14: Minute = 0: must be a multiple of 15 from 15 to 60: the minute at which the interval ends, of \
             which line 8 says that an hour has 4",
        ),
        ("11,30,", "11,20,", "EPW:10:14: Minute = 20: must be a multiple of 15 from 15 to 60"),
        (
            "DATA PERIODS,1,4,",
            "DATA PERIODS,1,1,",
            "EPW:10:11: Hour = 11: is in the row above too, while line 8 says that an hour has one row",
        ),
        (
            "11,30,",
            "11,15,",
            "EPW:10:14: Minute = 15: is that of the row above too; an interval has one row",
        ),
        (
            "DATA PERIODS,1,4,",
            "DATA PERIODS,1,12,",
            "EPW:9:11: Hour = 11: is an hour of which the file has 4 of 12 rows, as line 8 says",
        ),
        (
            "DATA PERIODS,1,4,",
            "DATA PERIODS,1,x,",
            "EPW:8:16: rows an hour = x: must be a whole number of which 60 is a multiple",
        ),
    ] {
        let text = sentence(from, to);
        assert!(text.contains(wanted), "{text}");
    }
    let file = read(&quarters()).unwrap();
    let [latitude, longitude] = file.site().unwrap();
    let late = Ephemeris::new("2018-06-30T12:05:00+10:00", latitude, longitude).unwrap();
    let text = file.at(0.0, Some(&late)).unwrap_err().to_string();
    assert!(text.contains("no row for the interval that begins on 30 June at 12:00"), "{text}");
}
