//! The name of an FMU's binary and, in FMI 1.0, of its functions.

/// What a name in C is, in words.
pub const C_NAME: &str = "a name in C: letters, digits and underscores, not beginning with a digit";

/// Whether a text is a name in C, as the binary of an FMU must have.
pub fn is_c_name(text: &str) -> bool {
    let is_part = |c: char| c.is_ascii_alphanumeric() || c == '_';
    text.starts_with(|c: char| is_part(c) && !c.is_ascii_digit()) && text.chars().all(is_part)
}

#[cfg(test)]
mod tests {
    use crate::interface::Interface;

    /// The binary of an FMU is loaded by this name, so a path must not pass.
    #[test]
    fn a_model_identifier_that_is_no_c_name_is_refused() {
        let read = |name| {
            Interface::from_xml(&format!(
                "<fmiModelDescription fmiVersion=\"2.0\" modelName=\"m\" guid=\"1\">\
                 <CoSimulation modelIdentifier=\"{name}\"/><ModelVariables/></fmiModelDescription>"
            ))
        };
        for wrong in ["/tmp/evil", "../m", "1m", "", "m.so", "m m"] {
            let error = read(wrong).unwrap_err().to_string();
            assert!(error.contains(&format!("\"{wrong}\", but must be a name in C")), "{error}");
        }
        assert_eq!(read("_m1").unwrap().identifier, "_m1");
    }
}
