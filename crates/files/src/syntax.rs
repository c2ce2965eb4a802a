//! A text that is no TOML: brackets, double keys, numbers with a comma or a unit.

/// A message of the TOML library in plain words, of those that are known.
///
/// The line is that of the error, up to it and from it on.
pub(crate) fn in_words(
    (before, after): (&str, &str),
    message: &str,
    marked: Option<&str>,
) -> Option<String> {
    if message == "duplicate key" {
        let name = marked.unwrap_or_default();
        let line = before.trim_start();
        return Some(match (line.starts_with("[["), line.starts_with('[')) {
            (true, _) => format!(
                "`{name}` stands twice; write [[{}]] in double brackets for each, the first one too",
                after_brackets(line, after)
            ),
            (_, true) => format!(
                "the section [{}] stands twice; put its keys together",
                after_brackets(line, after)
            ),
            _ => format!("`{name}` stands twice; leave one of them out"),
        });
    }
    if message.starts_with("string values must be quoted") {
        let first = marked.and_then(|text| text.split_whitespace().next());
        let is_number = first.is_some_and(|text| text.parse::<f64>().is_ok());
        return Some(match is_number {
            true => "a number stands alone; its unit is at the end of the key".to_owned(),
            false => "a text needs quotes".to_owned(),
        });
    }
    if message.starts_with("invalid basic string, expected `\"`") {
        return Some("the quotation mark at the end of the text is missing".to_owned());
    }
    let value = before.split_once('=').map(|(_, value)| value.trim());
    let is_number = value.is_some_and(|value| value.parse::<f64>().is_ok());
    let decimal_comma = is_number && after.starts_with(',');
    decimal_comma.then(|| "a number has a decimal point, not a comma".to_owned())
}

/// The name of a section whose line is split in two.
fn after_brackets(before: &str, after: &str) -> String {
    let line = format!("{before}{after}");
    line.trim_start_matches('[').split(']').next().unwrap_or_default().trim().to_owned()
}
