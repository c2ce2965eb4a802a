//! Every reader of a file, as a function of bytes that gives an answer or an error: it must neither panic, nor
//! hang, nor take gigabytes, whatever the bytes are.
//!
//! | file | part |
//! |---|---|
//! | `written.rs` | the files that people write |
//! | `exchanged.rs` | the files of other tools: FMUs and packages |
//! | `results.rs` | the results of a run |
//! | `scratch.rs` | the folder in which a reader finds its bytes as a file |
//! | `mutation.rs` | bytes that are a little wrong |
//!
//! `tests/replay.rs` puts the kept corpus and mutations of it to all of them; `fuzz` has a target for each
//! (CONTRIBUTING.md, "Fuzzing").

mod exchanged;
pub mod mutation;
mod results;
mod scratch;
mod written;

/// Reads bytes as a file of one kind; whether they are right does not matter.
pub type Reader = fn(&[u8]);

/// The readers under the names of the folders of their corpus.
pub const READERS: &[(&str, Reader)] = &[
    ("consist", written::consist),
    ("draft-gear", written::draft_gear),
    ("driver", written::driver),
    ("irregularity", written::irregularity),
    ("logger", written::logger),
    ("rail-profile", written::rail_profile),
    ("rail-section", written::rail_section),
    ("rail-shape", written::rail_shape),
    ("scenario", written::scenario),
    ("track", written::track),
    ("vehicle", written::vehicle),
    ("weather", written::weather),
    ("wheel-profile", written::wheel_profile),
    ("archive", exchanged::archive),
    ("mapping", exchanged::mapping),
    ("model-description", exchanged::model_description),
    ("structure", exchanged::structure),
    ("values", exchanged::values),
    ("expected", results::expected),
    ("field-array", results::field_array),
    ("field-axis", results::field_axis),
    ("field-attributes", results::field_attributes),
    ("manifest", results::manifest),
    ("open-stream", results::open_stream),
    ("part", results::part),
    ("table", results::table),
];

/// The reader of this name.
pub fn reader(name: &str) -> Option<Reader> {
    READERS.iter().find(|(own, _)| *own == name).map(|(_, reader)| *reader)
}
