//! Files on disk: archives, XML in its encodings, foreign texts, what is shipped with the program, and what
//! goes wrong with a file.

pub mod archive;
pub mod file_error;
pub mod printable;
pub mod shipped;
pub mod xml_depth;
pub mod xml_text;
