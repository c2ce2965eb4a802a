//! The rail-heat model as an FMU.

fmu::export!(railheat::RailHeat);
