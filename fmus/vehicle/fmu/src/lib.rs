//! The vehicle model as an FMU.

fmu::export!(vehicle::Vehicle);
