//! What stands in a file of weather: the columns, and what is possible in them.

use files::Column;

/// Columns of a CSV file: the time of the simulation, then the weather.
///
/// Of the last ones a file has the direct and the diffuse irradiance, with or without the sun's direction, or
/// the global one.
pub const COLUMNS: [Column; 8] =
    [TIME, AIR, WIND, DIRECT, DIFFUSE, SUN_ELEVATION, SUN_AZIMUTH, GLOBAL];

pub(super) const TIME: Column = Column {
    name: "time_s",
    unit: "s",
    required: true,
    bounds: None,
    description: "Simulated time; must rise, by at most 3 h",
};

pub(super) const AIR: Column = Column {
    name: "air_degC",
    unit: "°C",
    required: true,
    bounds: Some([-90.0, 65.0]),
    description: "Temperature of the air",
};

pub(super) const WIND: Column = Column {
    name: "wind_m_s",
    unit: "m/s",
    required: true,
    bounds: Some([0.0, 115.0]),
    description: "Speed of the wind",
};

pub(super) const DIRECT: Column = Column {
    name: "direct_W_m2",
    unit: "W/m²",
    required: false,
    bounds: Some([0.0, 1500.0]),
    description: "Direct irradiance on a surface that faces the sun",
};

pub(super) const DIFFUSE: Column = Column {
    name: "diffuse_W_m2",
    unit: "W/m²",
    required: false,
    bounds: Some([0.0, 1000.0]),
    description: "Diffuse irradiance on a horizontal surface",
};

pub(super) const SUN_ELEVATION: Column = Column {
    name: "sun_elevation_deg",
    unit: "deg",
    required: false,
    bounds: Some([-90.0, 90.0]),
    description: "Elevation of the sun; left out where site.date_time says when it is",
};

pub(super) const SUN_AZIMUTH: Column = Column {
    name: "sun_azimuth_deg",
    unit: "deg",
    required: false,
    bounds: Some([-360.0, 720.0]),
    description: "Azimuth of the sun, clockwise from north; left out likewise",
};

pub(super) const GLOBAL: Column = Column {
    name: "global_W_m2",
    unit: "W/m²",
    required: false,
    bounds: Some([0.0, 1500.0]),
    description: "Irradiance on a horizontal surface from sun and sky, in place of the last four; split where \
                  site.date_time says when it is",
};

/// Thermal radiation of the sky in a weather file of EnergyPlus.
pub(super) const SKY: Column = Column {
    name: "Horizontal Infrared Radiation Intensity",
    unit: "W/m²",
    required: false,
    bounds: Some([50.0, 1000.0]),
    description: "Thermal radiation of the sky on a horizontal surface",
};
