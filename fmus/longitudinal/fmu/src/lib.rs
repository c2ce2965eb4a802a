//! The longitudinal train model as an FMU.

fmu::export!(longitudinal::Train);
