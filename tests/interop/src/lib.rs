//! Interoperation tests: Hotfoot's FMUs run by the crate `fmi`.
