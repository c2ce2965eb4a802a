//! `hotfoot schema`: what may stand in the files of a train and its line.

use files::Column;
use longitudinal::driver::Driver;
use railheat::Shape;
use railheat::section::RailFile;
use schemars::{Schema, schema_for};
use serde_json::{Map, Value, json};
use stock::{Consist, Library, Vehicle};
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

/// The JSON schema of consist files, which the resources of the train's FMU have.
pub fn consist() -> Schema {
    Consist::schema()
}

/// The JSON schema of `railheat.toml`, which the resources of the rail's FMU have.
pub fn rail_heat() -> Schema {
    Shape::schema()
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

/// The columns of weather files, as a [Table Schema](https://specs.frictionlessdata.io/table-schema/).
pub fn weather() -> Value {
    columns(&railheat::weather::COLUMNS)
}

/// The columns of a logger's file; the section `[replay]` of a driver file says what they are called.
pub fn logger() -> Value {
    columns(&longitudinal::driver::LOGGER_COLUMNS)
}

/// The columns of a file of measured irregularities.
pub fn irregularity() -> Value {
    columns(&track::irregularity::COLUMNS)
}

/// What stands in a line of a profile of a wheel or rail, whose columns have no names in the file.
const POINT: [Column; 2] = [
    Column {
        name: "lateral",
        unit: "mm",
        required: true,
        bounds: Some([-200.0, 200.0]),
        description: "To the field side, from the running circle of a wheel or the middle of a rail",
    },
    Column {
        name: "height",
        unit: "mm",
        required: true,
        bounds: Some([-200.0, 200.0]),
        description: "Downwards",
    },
];

/// The columns of a profile.
pub fn profile() -> Value {
    let mut table = columns(&POINT);
    table["description"] = "A point on each line, its two numbers parted by blanks, tabs, semicolons or commas; names \
                            of columns may stand above, and lines that begin with #, % or ! are comments. Files of \
                            MiniProf (.whl, .ban), SIMPACK and CONTACT (.prw, .prr) and GENSYS (.wheel, .rail) are \
                            read with what their headers say."
        .into();
    table
}

fn columns(columns: &[Column]) -> Value {
    json!({ "fields": columns.iter().map(field).collect::<Vec<_>>() })
}

fn field(column: &Column) -> Value {
    let mut constraints = json!({ "required": column.required });
    if let Some([low, high]) = column.bounds {
        constraints["minimum"] = low.into();
        constraints["maximum"] = high.into();
    }
    json!({
        "name": column.name,
        "type": "number",
        "unit": column.unit,
        "description": column.description,
        "constraints": constraints,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_say_name_unit_bounds_and_meaning() {
        for table in [weather(), logger(), irregularity(), profile()] {
            let fields = table["fields"].as_array().unwrap();
            assert!(fields.iter().any(|field| field["constraints"]["required"] == true));
            assert!(fields.iter().all(|field| field["unit"].is_string()));
            assert!(fields.iter().all(|field| field["description"] != ""));
        }
        let air = &weather()["fields"][1];
        assert_eq!(air["name"], "air_degC");
        assert_eq!(air["constraints"]["maximum"], 65.0);
    }

    /// A file may have only what its schema has, and its keys say what they are.
    #[test]
    fn schemas_are_closed_and_described() {
        for (kind, schema, keys) in [
            ("track", track(), 6),
            ("driver", driver(), 6),
            ("vehicle", vehicle(), 6),
            ("gear", draft_gear(), 6),
            ("rail", rail(), 6),
            ("consist", consist(), 1),
            ("rail heat", rail_heat(), 3),
        ] {
            let value = schema.as_value();
            assert_eq!(value["additionalProperties"], false, "{kind}");
            assert!(value["properties"].as_object().unwrap().len() >= keys, "{kind}");
        }
        let track = track();
        let alignment = &track.as_value()["properties"]["alignment"];
        assert!(alignment["description"].as_str().unwrap().contains("designed line"));
        let vehicle = vehicle();
        assert!(vehicle.as_value()["properties"]["extends"].is_object());
        assert_eq!(vehicle.as_value()["anyOf"][0]["required"][0], "extends");
    }
}
