//! Tests of the whole system: the programs, the packed FMUs, and what they do together.
//!
//! | file | what is tested |
//! |---|---|
//! | `chosen_outputs.rs` | what a run records, and CSV |
//! | `command_line.rs` | answers to wrong input |
//! | `compare.rs` | runs beside each other and beside measurements |
//! | `determinism.rs` | any number of threads gives the same bytes |
//! | `documents.rs` | what README, licences and vocabulary say |
//! | `ends.rs`, `ends/` | every end of a run |
//! | `error_messages.rs` | each sentence of an error comes once |
//! | `examples.rs` | the examples |
//! | `facts.rs` | what the manifest states against what the units have |
//! | `field_lost.rs` | a temperature field that is lost in a run |
//! | `fmu_check.rs` | `hotfoot check` |
//! | `fmu_kinds.rs` | FMUs as other tools write them |
//! | `force_balance.rs` | forces balance between the models |
//! | `heat_input.rs` | wrong input of the rail heat |
//! | `hostile.rs` | FMUs that misbehave in a train |
//! | `isolated.rs` | FMUs in processes of their own |
//! | `mutations.rs` | mutations of a good FMU |
//! | `native.rs` | a model called directly and as an FMU |
//! | `outputs.rs` | further recorded outputs |
//! | `own_vehicles.rs` | vehicle files beside the scenario |
//! | `packages.rs` | packages of scenarios against the scenarios |
//! | `profile_files.rs` | profiles of vehicle files |
//! | `rails.rs` | the heated rails |
//! | `resume.rs` | runs that go on from a checkpoint |
//! | `seam.rs` | FMUs that misbehave at the seam: values, memory, threads, messages |
//! | `scenarios.rs` | every shipped scenario |
//! | `scripts.rs` | answers for scripts: JSON, schemas, completions, manual pages |
//! | `ssp_kinds.rs` | packages as other tools write them |
//! | `synchronisation.rs` | the controller in the whole loop |
//! | `tools.rs` | the engineering commands |
//! | `tutorials.rs` | the tutorials of the book |
//! | `wrong_input.rs`, `wrong-input/` | wrong files, and the whole message for each |
//!
//! All are one program, since linking is what takes the time of such tests' build. They need the
//! packed FMUs (`cargo xtask fmus`); `cargo test --release -p hotfoot-tests rails` runs those of `rails.rs`.

mod chosen_outputs;
mod command_line;
mod compare;
mod determinism;
mod documents;
mod ends;
mod error_messages;
mod examples;
mod facts;
mod field_lost;
mod fmu_check;
mod fmu_kinds;
mod force_balance;
mod heat_input;
mod hostile;
mod isolated;
mod mutations;
mod native;
mod outputs;
mod own_vehicles;
mod packages;
mod profile_files;
mod rails;
mod resume;
mod scenarios;
mod scripts;
mod seam;
mod ssp_kinds;
mod synchronisation;
mod tools;
mod tutorials;
mod wrong_input;
