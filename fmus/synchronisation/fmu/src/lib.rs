//! The synchronisation controller as an FMU.

fmu::export!(synchronisation::Synchronisation);
