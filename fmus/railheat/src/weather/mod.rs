//! The weather: air, wind, sun and shade, and the heat that the rail exchanges with them.
//!
//! | file | part |
//! |---|---|
//! | `conditions.rs` | the weather at a time |
//! | `file/` | weather from a file: rows of the run (CSV), or hours of a year (EPW) |
//! | `erbs.rs` | the global irradiance, split into sun and sky |
//! | `exchange.rs` | heat exchanged with air, sky, sun and pad by each piece of surface |
//! | `sun.rs` | the sun seen from the rail, and the rail's shadow on itself |
//! | `light.rs` | the sunlight that the surface absorbs |
//! | `ephemeris.rs` | where the sun stands, by position on Earth and time |
//! | `shadow.rs` | the shadow of a vehicle on the rail |

mod conditions;
mod ephemeris;
mod erbs;
mod exchange;
mod file;
mod light;
mod shadow;
mod sun;

pub use conditions::Weather;
pub use ephemeris::{Ephemeris, EphemerisError};
pub use erbs::{diffuse_share, split};
pub use exchange::{Exchange, Surface};
pub use file::{COLUMNS, WeatherFile, WeatherFileError};
pub(crate) use light::Light;
pub use shadow::Body;
pub use sun::Sun;
