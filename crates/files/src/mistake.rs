//! A mistake in a file that a person wrote.

use std::error::Error;
use std::fmt;
use std::ops::Range;

/// What is wrong with a file, where, and what would be right.
///
/// It reads `file:line:column: sentence`, with the line and a caret below it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mistake {
    /// File as its user names it.
    pub file: String,
    /// Where in the file; none where it concerns all of it.
    pub mark: Option<Mark>,
    /// Key and value, if it is about one, what is wrong, and what would be right.
    pub sentence: String,
}

/// A stretch of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Mark {
    /// Number of the line, from 1.
    pub line: usize,
    /// Number of the first character in the line, from 1.
    pub column: usize,
    /// Number of characters, at least one.
    pub width: usize,
    /// The text of the line.
    pub text: String,
}

/// Characters of a value that a sentence repeats: a longer one is marked only.
const LONGEST_VALUE: usize = 40;

/// Whether a sentence repeats this value.
pub(crate) fn is_short(value: &str) -> bool {
    value.chars().count() <= LONGEST_VALUE && !value.contains('\n')
}

impl Mistake {
    /// A mistake that concerns all of a file.
    pub fn in_file(file: impl ToString, sentence: impl Into<String>) -> Self {
        Self { file: file.to_string(), mark: None, sentence: sentence.into() }
    }
}

impl Mark {
    /// The stretch of `text` from byte to byte; of several lines, what stands in the first one.
    pub(crate) fn new(text: &str, bytes: Range<usize>) -> Self {
        let begin = floor(text, bytes.start);
        let end = floor(text, bytes.end).max(begin);
        let line_begin = text[..begin].rfind('\n').map_or(0, |newline| newline + 1);
        let line = text[line_begin..].lines().next().unwrap_or_default();
        let end = end.min(line_begin + line.len()).max(begin);
        Self {
            line: text[..line_begin].matches('\n').count() + 1,
            column: text[line_begin..begin].chars().count() + 1,
            width: text[begin..end].chars().count().max(1),
            text: line.to_owned(),
        }
    }
}

/// The beginning of the character in which this byte lies.
fn floor(text: &str, byte: usize) -> usize {
    let byte = byte.min(text.len());
    (0..=byte).rev().find(|byte| text.is_char_boundary(*byte)).unwrap_or_default()
}

impl fmt::Display for Mistake {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { file, mark, sentence } = self;
        match mark {
            None => write!(f, "{file}: {sentence}"),
            Some(mark) => {
                write!(f, "{file}:{}:{}: {sentence}\n{mark}", mark.line, mark.column)
            }
        }
    }
}

impl fmt::Display for Mark {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { line, column, width, text } = self;
        let gutter = " ".repeat(line.to_string().len());
        // A tab stays one, so that the caret stands below its character.
        let before = text.chars().take(column - 1);
        let before: String = before.map(|c| if c == '\t' { c } else { ' ' }).collect();
        writeln!(f, "{gutter} |")?;
        writeln!(f, "{line} | {}", text.trim_end())?;
        write!(f, "{gutter} | {before}{}", "^".repeat(*width))
    }
}

impl Error for Mistake {}

#[cfg(test)]
mod tests {
    use super::*;

    fn mark(text: &str, marked: &str) -> Mark {
        let begin = text.find(marked).unwrap();
        Mark::new(text, begin..begin + marked.len())
    }

    #[test]
    fn lines_columns_and_widths_count_characters_from_one() {
        let text = "a = 1\nnäme = \"Müller\"\n";
        let marked = mark(text, "\"Müller\"");
        assert_eq!((marked.line, marked.column, marked.width), (2, 8, 8));
        let mistake =
            Mistake { file: "f.toml".into(), mark: Some(marked), sentence: "is wrong".into() };
        let shown = "f.toml:2:8: is wrong\n  |\n2 | näme = \"Müller\"\n  |        ^^^^^^^^";
        assert_eq!(mistake.to_string(), shown);
    }

    #[test]
    fn a_caret_stands_below_a_character_behind_a_tab() {
        assert!(mark("\tx = 7", "7").to_string().ends_with("| \t    ^"));
    }

    #[test]
    fn of_several_lines_the_first_one_is_shown() {
        let marked = mark("x = [1,\n2]\n", "[1,\n2]");
        assert_eq!((marked.line, marked.width), (1, 3));
        assert!(marked.to_string().ends_with("^^^"));
    }

    /// Behind the end of a text, as where a quotation mark is missing.
    #[test]
    fn a_mark_at_the_end_is_one_wide() {
        let marked = Mark::new("x = ", 4..4);
        assert_eq!((marked.line, marked.column, marked.width), (1, 5, 1));
        assert_eq!(Mark::new("", 0..9).width, 1);
        // In the middle of a character.
        assert_eq!(Mark::new("ä", 1..1).column, 1);
    }
}
