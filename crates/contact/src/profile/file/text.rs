//! The text of a file.

use std::fs::File;
use std::io::Read;
use std::path::Path;

/// Most bytes of a file of points. A profile of 20 000 points has two million.
const MOST_BYTES: u64 = 16 << 20;

/// The text of the file at `path`: UTF-8 or, where its first bytes say so, UTF-16; what is neither
/// is taken as Windows-1252, in which the comments of older gauges are written.
///
/// # Errors
/// When the file cannot be read or is larger than any profile; the text is the reason.
pub(super) fn read(path: &Path) -> Result<String, String> {
    let file = File::open(path).map_err(|error| error.to_string())?;
    let mut bytes = Vec::new();
    file.take(MOST_BYTES + 1).read_to_end(&mut bytes).map_err(|error| error.to_string())?;
    if bytes.len() as u64 > MOST_BYTES {
        return Err(format!("the file has more than {} MB: it is no profile", MOST_BYTES >> 20));
    }
    Ok(decoded(&bytes))
}

/// The text that these bytes are, without a byte order mark.
fn decoded(bytes: &[u8]) -> String {
    let (text, _, broken) = encoding_rs::UTF_8.decode(bytes);
    match broken {
        true => encoding_rs::WINDOWS_1252.decode(bytes).0.into_owned(),
        false => text.into_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn byte_order_marks_and_older_encodings_are_understood() {
        assert_eq!(decoded(b"\xef\xbb\xbf1 2"), "1 2");
        assert_eq!(decoded(b"\xff\xfe1\0 \x002\0"), "1 2");
        assert_eq!(decoded(b"# K\xf6ln\n1 2"), "# Köln\n1 2");
    }

    #[test]
    fn a_file_too_large_for_a_profile_is_not_read() {
        let file = tempfile::NamedTempFile::new().unwrap();
        file.as_file().set_len(MOST_BYTES + 1).unwrap();
        assert!(read(file.path()).unwrap_err().contains("no profile"));
    }
}
