//! Texts of other makers on the terminal.

/// A text of an FMU as a terminal may show it: control characters, and those that turn the direction of
/// writing, as their codes.
pub fn printable(text: &str) -> String {
    let turns = |c| matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let mut shown = String::new();
    for c in text.trim_end().chars() {
        match c.is_control() || turns(c) {
            true => shown.extend(c.escape_default()),
            false => shown.push(c),
        }
    }
    shown
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_terminal_would_obey_is_shown() {
        assert_eq!(printable("a\u{1b}[2Jb\tc\u{9b}31m\n"), "a\\u{1b}[2Jb\\tc\\u{9b}31m");
        assert_eq!(printable("Züge über 100 °C"), "Züge über 100 °C");
    }
}
