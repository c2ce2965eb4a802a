//! How deep the elements of an XML text lie in each other.
//!
//! The parsers take a time that grows with the square of the depth, and some a stack that grows with it, so
//! this is looked at before.

/// Elements may lie in so many others; those of FMI and SSP lie in eight, annotations in some more.
const DEEPEST: usize = 200;

/// Elements lie too deep in each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
#[error(
    "line {line}: elements lie in more than {DEEPEST} others, which no tool writes; the file is refused"
)]
pub struct TooDeep {
    /// Line of the first that does.
    pub line: usize,
}

/// Looks whether elements lie too deep in each other, in a time that grows with the text's length.
///
/// # Errors
/// When they do. What is no XML is left to the parsers to tell.
pub fn check_depth(text: &str) -> Result<(), TooDeep> {
    let mut depth = 0_usize;
    let mut rest = text;
    while let Some(begin) = rest.find('<') {
        rest = &rest[begin..];
        let skipped =
            [("<!--", "-->"), ("<![CDATA[", "]]>"), ("<?", "?>"), ("</", ">"), ("<!", "")];
        if let Some((mark, end)) = skipped.iter().find(|(mark, _)| rest.starts_with(mark)) {
            depth -= usize::from(*mark == "</" && depth > 0);
            rest = behind(&rest[mark.len()..], end);
            continue;
        }
        let length = tag_length(rest);
        if !rest[..length].ends_with("/>") {
            depth += 1;
        }
        if depth > DEEPEST {
            let line = 1 + text[..text.len() - rest.len()].matches('\n').count();
            return Err(TooDeep { line });
        }
        rest = &rest[length..];
    }
    Ok(())
}

/// What follows behind `end`; nothing if that does not come.
fn behind<'t>(text: &'t str, end: &str) -> &'t str {
    text.find(end).map_or("", |at| &text[at + end.len()..])
}

/// Length of the tag that the text begins with; `>` in quotes does not end it.
fn tag_length(text: &str) -> usize {
    let mut quote = None;
    for (at, mark) in text.bytes().enumerate() {
        match (quote, mark) {
            (None, b'>') => return at + 1,
            (None, b'"' | b'\'') => quote = Some(mark),
            (Some(open), _) if open == mark => quote = None,
            _ => {}
        }
    }
    text.len()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_elements_that_hold_each_other_count() {
        let flat =
            "<a x='>' y=\"/\"/><b>text</b><!-- <c> --><![CDATA[<d>]]><?e <f>?>\n".repeat(1000);
        assert_eq!(check_depth(&format!("<!DOCTYPE r>\n<r>{flat}</r>")), Ok(()));
        let nested = |depth: usize| "<a>\n".repeat(depth) + &"</a>".repeat(depth);
        assert_eq!(check_depth(&nested(DEEPEST)), Ok(()));
        assert_eq!(check_depth(&nested(DEEPEST + 1)), Err(TooDeep { line: DEEPEST + 1 }));
    }

    /// What is cut off anywhere, or no XML, ends the search.
    #[test]
    fn every_beginning_of_a_text_is_looked_through() {
        let text = "<?xml version='1.0'?><a b='ü'><!-- c --><![CDATA[d]]></a> < > <";
        for (end, _) in text.char_indices() {
            assert_eq!(check_depth(&text[..end]), Ok(()));
        }
    }

    /// 200 000 elements in each other, in less than a second.
    #[test]
    fn a_deep_text_is_refused_at_once() {
        let begin = std::time::Instant::now();
        let deep = "<a>".repeat(200_000) + &"</a>".repeat(200_000);
        assert!(check_depth(&deep).unwrap_err().to_string().contains("more than 200 others"));
        assert!(begin.elapsed().as_secs_f64() < 1.0);
    }
}
