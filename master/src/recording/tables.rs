//! The tables `series/vehicles` and `series/wheels` of a run. The columns of the third table,
//! `series/train`, are what the FMUs of train and rail have to say.
//!
//! Forces are in newtons, coupler forces positive in tension, creepage is (wheel − rail)/speed
//! and positive in traction, as everywhere.

use super::column::{Column, Key, KeyValues};

/// Declares a row of a table: its fields, and from them the columns of the file.
///
/// `double` keeps all digits of an f64, `extremes` records lowest and highest values too.
macro_rules! row {
    (
        $(#[doc = $about:literal])*
        $name:ident {
            $( #[doc = $description:literal] $field:ident: $unit:literal $($flag:ident)*; )*
        }
    ) => {
        $(#[doc = $about])*
        #[derive(Debug, Clone, Copy, Default, PartialEq)]
        pub struct $name {
            $( #[doc = $description] pub $field: f64, )*
        }

        impl $name {
            /// The columns of the file.
            pub fn columns() -> Vec<Column> {
                vec![$(
                    Column::new(stringify!($field), $unit, $description.trim())$(.$flag())*
                ),*]
            }

            /// The values, in the order of the columns.
            pub fn values(&self) -> [f64; [$(stringify!($field)),*].len()] {
                [$( self.$field ),*]
            }
        }
    };
}

row! {
    /// A row of `series/vehicles`: a vehicle at an instant.
    VehicleRow {
        /// Chainage of the vehicle's middle in the vehicle model
        position: "m" double;
        /// Speed in the vehicle model
        velocity: "m/s" double;
        /// Chainage of the vehicle's middle in the train model
        train_position: "m" double;
        /// Speed in the train model
        train_velocity: "m/s" double;
        /// Force in the front coupler, positive in tension
        coupler_front_force: "N" double extremes;
        /// Force in the rear coupler, positive in tension
        coupler_rear_force: "N" double extremes;
        /// Traction force at the wheel rims, sum of the axles; negative: dynamic brake
        traction_force: "N";
        /// Friction brake force
        brake_force: "N";
        /// Resistance force; negative against the motion
        resistance_force: "N";
        /// Synchronisation force on the vehicle body
        sync_force: "N" extremes;
        /// Position error, vehicle model minus train model
        position_error: "m" extremes;
        /// Longitudinal creep force of all wheels on the vehicle, positive in traction
        creep_force: "N" extremes;
        /// Friction power in all wheel-rail contacts of the vehicle
        friction_power: "W" extremes;
    }
}

row! {
    /// A row of `series/wheels`: a wheel of a recorded vehicle at an instant.
    WheelRow {
        /// Chainage of the wheelset
        position: "m" double;
        /// Longitudinal creepage
        creepage_longitudinal: "1" double extremes;
        /// Lateral creepage
        creepage_lateral: "1" double extremes;
        /// Spin creepage
        creepage_spin: "1/m" double extremes;
        /// Longitudinal creep force on the wheel
        force_longitudinal: "N" extremes;
        /// Lateral creep force on the wheel
        force_lateral: "N" extremes;
        /// Normal force
        force_normal: "N" extremes;
        /// Friction power in the contact
        friction_power: "W" extremes;
        /// Semi-axis of the contact patch along the rail
        contact_a: "m";
        /// Semi-axis of the contact patch across the rail
        contact_b: "m";
        /// Highest flash temperature by that of the same friction power spread as the pressure
        contact_flash_factor: "1";
        /// Place of the contact on the rail head, from its middle
        contact_lateral_position: "m";
    }
}

/// A side of the track, seen in the running direction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Side {
    /// The left rail.
    Left,
    /// The right rail.
    Right,
}

impl Side {
    /// The name of the side in files.
    pub fn name(self) -> &'static str {
        match self {
            Self::Left => "left",
            Self::Right => "right",
        }
    }
}

/// The keys of `series/vehicles`: vehicles 1 to `count`, from the head of the train.
pub fn vehicle_keys(count: usize) -> Vec<Key> {
    vehicle_keys_of(1..=count)
}

/// The keys of a table of some vehicles, which have these numbers from the head of the train.
pub fn vehicle_keys_of(numbers: impl IntoIterator<Item = usize>) -> Vec<Key> {
    let saturated = |number| i32::try_from(number).unwrap_or(i32::MAX);
    let numbers = numbers.into_iter().map(saturated).collect();
    vec![integer_key("vehicle", "Number of the vehicle from the head of the train", numbers)]
}

/// The keys of `series/wheels`: vehicle and wheelset, both from 1, and side of each row.
pub fn wheel_keys(rows: &[(usize, usize, Side)]) -> Vec<Key> {
    let numbers = |number: fn(&(usize, usize, Side)) -> usize| {
        let saturated = |row| i32::try_from(number(row)).unwrap_or(i32::MAX);
        rows.iter().map(saturated).collect()
    };
    vec![
        integer_key(
            "vehicle",
            "Number of the vehicle from the head of the train",
            numbers(|row| row.0),
        ),
        integer_key(
            "wheelset",
            "Number of the wheelset from the front of the vehicle",
            numbers(|row| row.1),
        ),
        Key {
            name: "side".to_owned(),
            description: "Side of the track in the running direction, left or right".to_owned(),
            values: KeyValues::Text(rows.iter().map(|row| row.2.name().to_owned()).collect()),
        },
    ]
}

fn integer_key(name: &str, description: &str, values: Vec<i32>) -> Key {
    Key {
        name: name.to_owned(),
        description: description.to_owned(),
        values: KeyValues::Integer(values),
    }
}
