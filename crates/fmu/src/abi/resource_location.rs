//! The resource location of `fmi2Instantiate`: a file URI (RFC 3986, RFC 8089).

use std::path::PathBuf;

use percent_encoding::percent_decode_str;

use crate::error::Error;

/// The folder that a resource location means; an empty one means none.
///
/// Besides `file:///path`, which the standard wants, tools give `file:/path`,
/// `file://localhost/path` and the plain path.
pub(crate) fn path_of(location: &str) -> Result<PathBuf, Error> {
    let refuse = |problem| Error::ResourceLocation { location: location.to_owned(), problem };
    let path = match location.split_once(':') {
        Some((scheme, path)) if scheme.eq_ignore_ascii_case("file") => path,
        None => return Ok(PathBuf::from(location)),
        Some(_) if location.starts_with('/') => return Ok(PathBuf::from(location)),
        Some(_) => return Err(refuse("is not a file URI")),
    };
    let path = match path.strip_prefix("//") {
        Some(rest) => rest.strip_prefix("localhost").unwrap_or(rest),
        None => path,
    };
    if !path.starts_with('/') {
        return Err(refuse("is not an absolute path on this machine"));
    }
    match percent_decode_str(path).decode_utf8() {
        Ok(path) => Ok(PathBuf::from(path.as_ref())),
        Err(_) => Err(refuse("has percent-escapes that are not UTF-8")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn all_forms_of_a_file_uri_are_understood() {
        for location in [
            "file:///tmp/my%20fmu/resources",
            "file:/tmp/my%20fmu/resources",
            "file://localhost/tmp/my%20fmu/resources",
            "FILE:///tmp/my fmu/resources",
            "/tmp/my fmu/resources",
        ] {
            let path = path_of(location).expect(location);
            assert_eq!(path, PathBuf::from("/tmp/my fmu/resources"), "{location}");
        }
    }

    #[test]
    fn a_percent_sign_and_other_letters_survive() {
        let path = path_of("file:///tmp/100%25/Z%C3%BCge").expect("valid");
        assert_eq!(path, PathBuf::from("/tmp/100%/Züge"));
        let path = path_of("/tmp/a:b%20").expect("a plain path");
        assert_eq!(path, PathBuf::from("/tmp/a:b%20"));
    }

    #[test]
    fn no_location_is_an_empty_path() {
        assert_eq!(path_of("").expect("allowed"), PathBuf::new());
    }

    #[test]
    fn other_locations_are_refused() {
        for (location, problem) in [
            ("https://example.org/resources", "is not a file URI"),
            ("file://server/resources", "is not an absolute path on this machine"),
            ("file:resources", "is not an absolute path on this machine"),
            ("file:///%FF", "has percent-escapes that are not UTF-8"),
        ] {
            let error = path_of(location).unwrap_err().to_string();
            assert!(error.contains(location) && error.ends_with(problem), "{error}");
        }
    }
}
