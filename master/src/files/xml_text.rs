//! The text of an XML file in whatever encoding it declares (XML 1.0, 4.3.3 and appendix F).

use std::io::{self, ErrorKind};
use std::ops::Range;
use std::path::Path;

use encoding_rs::{Encoding, UTF_8, UTF_16BE, UTF_16LE};

/// Reads an XML file. A byte order mark says how it is encoded, else its declaration, else it is UTF-8.
///
/// The text comes without another encoding in its declaration, which holds no longer.
///
/// # Errors
/// When the file cannot be read, declares an encoding that is not known, or is not encoded as it says.
pub fn read(file: &Path) -> io::Result<String> {
    decoded(std::fs::read(file)?)
}

fn decoded(bytes: Vec<u8>) -> io::Result<String> {
    let invalid = |sentence: String| io::Error::new(ErrorKind::InvalidData, sentence);
    let declared = declared_encoding(&bytes);
    let (encoding, mark) = match (Encoding::for_bom(&bytes), declared) {
        (Some(found), _) => found,
        (None, Some(range)) => {
            let label = &bytes[range];
            let unknown = || {
                let label = String::from_utf8_lossy(label);
                invalid(format!("the file declares the encoding \"{label}\", which is not known"))
            };
            match Encoding::for_label(label).ok_or_else(unknown)? {
                // Its declaration could not have been read if that were true.
                encoding if encoding == UTF_16LE || encoding == UTF_16BE => (UTF_8, 0),
                encoding => (encoding, 0),
            }
        }
        // Without a mark the declaration's first letter tells the order of the bytes.
        (None, None) if bytes.starts_with(b"<\0") => (UTF_16LE, 0),
        (None, None) if bytes.starts_with(b"\0<") => (UTF_16BE, 0),
        (None, None) => (UTF_8, 0),
    };
    let text = encoding.decode_without_bom_handling_and_without_replacement(&bytes[mark..]);
    let text = text.ok_or_else(|| {
        invalid(format!("the file is not encoded in {}, as it says", encoding.name()))
    })?;
    Ok(as_utf_8(text.into_owned()))
}

/// Where the name of the encoding stands in the declaration of a text whose letters are single bytes.
fn declared_encoding(bytes: &[u8]) -> Option<Range<usize>> {
    let end = bytes.windows(2).position(|pair| pair == b"?>")?;
    let declaration = std::str::from_utf8(&bytes[..end]).ok()?;
    if !declaration.starts_with("<?xml") {
        return None;
    }
    let after = declaration.find("encoding")? + "encoding".len();
    let quote = after + declaration[after..].find(['"', '\''])?;
    let name = quote + 1;
    let length = declaration[name..].find(declaration[quote..].chars().next()?)?;
    Some(name..name + length)
}

/// The text with spaces in place of another encoding in its declaration.
fn as_utf_8(mut text: String) -> String {
    let other = |name: &Range<usize>| !text[name.clone()].eq_ignore_ascii_case("utf-8");
    if let Some(name) = declared_encoding(text.as_bytes()).filter(other)
        && let Some(begin) = text[..name.start].rfind("encoding")
    {
        text.replace_range(begin..=name.end, &" ".repeat(name.end + 1 - begin));
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    fn with(encoding: &str) -> String {
        format!("<?xml version=\"1.0\" encoding=\"{encoding}\"?>\n<a unit=\"°C\" name=\"Züge\"/>")
    }

    /// The value of an attribute as a parser reads it from the decoded text.
    fn attribute(bytes: Vec<u8>, name: &str) -> String {
        let text = decoded(bytes).unwrap();
        let document = roxmltree::Document::parse(&text).unwrap();
        // The other parser of the master follows the declaration.
        serde_xml_rs::from_str::<std::collections::HashMap<String, String>>(&text).unwrap();
        document.root_element().attribute(name).unwrap().to_owned()
    }

    fn utf_16(text: &str, bytes: fn(u16) -> [u8; 2]) -> Vec<u8> {
        text.encode_utf16().flat_map(bytes).collect()
    }

    #[test]
    fn a_text_is_read_in_the_encoding_that_it_declares() {
        for label in ["ISO-8859-1", "iso-8859-1", "Windows-1252"] {
            let bytes: Vec<u8> = with(label).chars().map(|c| c as u8).collect();
            assert_eq!(attribute(bytes.clone(), "unit"), "°C", "{label}");
            assert_eq!(attribute(bytes, "name"), "Züge", "{label}");
        }
        for (label, mark) in [("UTF-16", "\u{feff}"), ("UTF-16", "")] {
            let text = format!("{mark}{}", with(label));
            assert_eq!(attribute(utf_16(&text, u16::to_le_bytes), "name"), "Züge");
            assert_eq!(attribute(utf_16(&text, u16::to_be_bytes), "name"), "Züge");
        }
        for text in
            [with("UTF-8"), format!("\u{feff}{}", with("utf-16")), "<a name='Züge'/>".into()]
        {
            assert_eq!(attribute(text.into_bytes(), "name"), "Züge");
        }
    }

    #[test]
    fn lines_and_columns_stay() {
        let bytes: Vec<u8> = with("ISO-8859-1").chars().map(|c| c as u8).collect();
        let text = decoded(bytes).unwrap();
        assert_eq!(text.chars().count(), with("ISO-8859-1").chars().count());
        assert!(!text.contains("encoding"), "{text}");
    }

    #[test]
    fn what_is_not_as_it_declares_is_refused_with_the_encoding() {
        let error = decoded(with("EBCDIC-CP-BE").into_bytes()).unwrap_err().to_string();
        assert!(error.contains("\"EBCDIC-CP-BE\", which is not known"), "{error}");
        let latin: Vec<u8> = with("UTF-8").chars().map(|c| c as u8).collect();
        let error = decoded(latin).unwrap_err().to_string();
        assert!(error.contains("is not encoded in UTF-8"), "{error}");
    }
}
