//! `hotfoot schema`: what may stand in the files of a train and its line.

use longitudinal::driver::Driver;
use railheat::section::RailFile;
use schemars::{Schema, schema_for};
use serde_json::{Map, Value, json};
use stock::{Library, Vehicle};
use track::TrackFile;

/// The JSON schema of track files.
pub fn track() -> Schema {
    TrackFile::schema()
}

/// The JSON schema of driver files.
pub fn driver() -> Schema {
    Driver::schema()
}

/// The JSON schema of draft-gear files.
pub fn draft_gear() -> Schema {
    Library::draft_gear_schema()
}

/// The JSON schema of rail files.
pub fn rail() -> Schema {
    schema_for!(RailFile)
}

/// The JSON schema of vehicle files.
///
/// One that `extends` another may leave out whatever the other has, in sections too; so only the keys at its
/// top are needed, where it extends none.
pub fn vehicle() -> Schema {
    let mut schema = schema_for!(Vehicle);
    let own = schema.ensure_object();
    if let Some(Value::Object(properties)) = own.get_mut("properties") {
        let extends =
            "Vehicle of the library whose values this one has, besides those that it states itself";
        properties.insert("extends".into(), json!({ "type": "string", "description": extends }));
        let without = "Sections of that vehicle that this one has not";
        properties.insert(
            "without".into(),
            json!({ "type": "array", "items": { "type": "string" }, "description": without }),
        );
    }
    if let Some(required) = own.remove("required") {
        own.insert("anyOf".into(), json!([{ "required": ["extends"] }, { "required": required }]));
    }
    if let Some(Value::Object(sections)) = own.get_mut("$defs") {
        sections.values_mut().filter_map(Value::as_object_mut).for_each(need_nothing);
    }
    schema
}

fn need_nothing(section: &mut Map<String, Value>) {
    section.remove("required");
}

/// A column of a CSV file: name, unit, whether it is needed, and what it is.
type Column = (&'static str, &'static str, bool, &'static str);

/// The columns of weather files, as a [Table Schema](https://specs.frictionlessdata.io/table-schema/).
pub fn weather() -> Value {
    columns(&[
        ("time_s", "s", true, "Simulated time; must rise, by at most 3 h"),
        ("air_degC", "°C", true, "Temperature of the air"),
        ("wind_m_s", "m/s", true, "Speed of the wind"),
        ("direct_W_m2", "W/m²", true, "Direct irradiance on a surface that faces the sun"),
        ("diffuse_W_m2", "W/m²", true, "Diffuse irradiance on a horizontal surface"),
        (
            "sun_elevation_deg",
            "deg",
            false,
            "Elevation of the sun; left out where site.date_time says when it is",
        ),
        (
            "sun_azimuth_deg",
            "deg",
            false,
            "Azimuth of the sun, clockwise from north; left out likewise",
        ),
    ])
}

/// The columns of a logger's file; the section `[replay]` of a driver file says what they are called.
pub fn logger() -> Value {
    columns(&[
        ("time", "s", true, "Time, which must rise; its name is replay.time"),
        ("speed", "km/h", true, "Measured speed; replay.speed, in the unit of replay.speed_unit"),
        (
            "throttle",
            "1",
            false,
            "Throttle or notch; replay.throttle, in parts of replay.throttle_full",
        ),
        (
            "dynamic_brake",
            "1",
            false,
            "Dynamic brake; replay.dynamic_brake, in parts of replay.dynamic_brake_full",
        ),
        (
            "train_brake",
            "1",
            false,
            "Train brake; replay.train_brake, in parts of replay.train_brake_full",
        ),
        (
            "locomotive_brake",
            "1",
            false,
            "Locomotive brake; replay.locomotive_brake, in parts of replay.locomotive_brake_full",
        ),
    ])
}

/// The columns of a file of measured irregularities.
pub fn irregularity() -> Value {
    columns(&[
        ("chainage_m", "m", true, "Chainage, at equal distances"),
        ("left_lateral_mm", "mm", true, "Left rail to the right"),
        ("left_vertical_mm", "mm", true, "Left rail down"),
        ("right_lateral_mm", "mm", true, "Right rail to the right"),
        ("right_vertical_mm", "mm", true, "Right rail down"),
    ])
}

fn columns(columns: &[Column]) -> Value {
    let field = |(name, unit, required, description): &Column| {
        json!({
            "name": name,
            "type": "number",
            "unit": unit,
            "description": description,
            "constraints": { "required": required },
        })
    };
    json!({ "fields": columns.iter().map(field).collect::<Vec<_>>() })
}

#[cfg(test)]
mod tests {
    use railheat::weather::HEADER;
    use track::irregularity::COLUMNS;

    use super::*;

    fn names(table: &Value) -> Vec<&str> {
        let fields = table["fields"].as_array().unwrap();
        fields.iter().map(|field| field["name"].as_str().unwrap()).collect()
    }

    #[test]
    fn columns_are_those_that_the_readers_want() {
        assert_eq!(names(&weather()).join(","), HEADER);
        assert_eq!(names(&irregularity()), COLUMNS);
    }

    /// A file may have only what its schema has, and its keys say what they are.
    #[test]
    fn schemas_are_closed_and_described() {
        for (kind, schema) in [
            ("track", track()),
            ("driver", driver()),
            ("vehicle", vehicle()),
            ("gear", draft_gear()),
            ("rail", rail()),
        ] {
            let value = schema.as_value();
            assert_eq!(value["additionalProperties"], false, "{kind}");
            assert!(value["properties"].as_object().unwrap().len() > 5, "{kind}");
        }
        let track = track();
        let alignment = &track.as_value()["properties"]["alignment"];
        assert!(alignment["description"].as_str().unwrap().contains("designed line"));
        let vehicle = vehicle();
        assert!(vehicle.as_value()["properties"]["extends"].is_object());
        assert_eq!(vehicle.as_value()["anyOf"][0]["required"][0], "extends");
    }
}
