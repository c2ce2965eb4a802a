//! An equation of the theory has an anchor, is cited by code and is validated.
//!
//! A page of `docs/theory` numbers its equations, `(12)`. The equation has the anchor
//! `<a id="eq-12"></a>`. Code cites it as `docs/theory/page.md#eq-12`, and so does the page of
//! `docs/validation` that has its row, as `../theory/page.md#eq-12`.

use std::collections::BTreeSet;
use std::path::Path;

use crate::breach::Breach;
use crate::workspace::Workspace;

/// Equations without anchor, without a citation in code, and without validation.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let code: String = workspace
        .packages
        .iter()
        .flat_map(|package| package.sources.iter().filter(|source| package.is_product(source)))
        .map(|source| source.text.as_str())
        .collect();
    let validation: String =
        workspace.pages("docs/validation").into_iter().map(|(_, text)| text).collect();
    let mut found = vec![];
    for (path, text) in workspace.pages("docs/theory") {
        for (number, line) in numbered(&text) {
            let page = path.strip_prefix("docs").unwrap_or(&path).display();
            let link = format!("{page}#eq-{number}");
            let cited = |text: &str| {
                // `#eq-1` is no citation of `#eq-12`.
                text.match_indices(&link).any(|(at, _)| {
                    let next = text[at + link.len()..].chars().next();
                    !next.is_some_and(|c| c.is_ascii_alphanumeric())
                })
            };
            let missing = [
                (!text.contains(&format!("id=\"eq-{number}\"")), "an anchor"),
                (!cited(&code), "a citation in code"),
                (!cited(&validation), "validation"),
            ];
            let missing: Vec<_> =
                missing.into_iter().filter(|(missing, _)| *missing).map(|(_, what)| what).collect();
            if !missing.is_empty() {
                let message = format!("equation ({number}) is without {}", missing.join(", "));
                found.push(Breach::new(Path::new(&path), line, message));
            }
        }
    }
    found
}

/// Numbers of the equations of a page with their lines: at the beginning of a line of formulas, at its
/// end, and in the last cell of a table.
fn numbered(text: &str) -> Vec<(String, usize)> {
    let mut seen = BTreeSet::new();
    let mut found = vec![];
    let mut fenced = false;
    for (index, line) in text.lines().enumerate() {
        if line.trim_start().starts_with("```") {
            fenced = !fenced;
        }
        let formula = fenced || line.starts_with("    ");
        let begin = line.split_whitespace().next().filter(|_| fenced);
        let end = line.split_whitespace().next_back().filter(|_| formula);
        let cell = line.trim().strip_suffix('|').and_then(|row| row.rsplit('|').next());
        for candidate in [begin, end, cell.map(str::trim)].into_iter().flatten() {
            if let Some(number) = number(candidate)
                && seen.insert(number.to_owned())
            {
                found.push((number.to_owned(), index + 1));
            }
        }
    }
    found
}

/// `12a` of `(12a)`.
fn number(text: &str) -> Option<&str> {
    let number = text.strip_prefix('(')?.strip_suffix(')')?;
    let digits = number.trim_end_matches(|c: char| c.is_ascii_lowercase());
    let short = number.len() <= digits.len() + 1;
    (short && !digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit())).then_some(number)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_are_found_at_either_end_of_a_line_and_in_tables() {
        let text =
            "```text\n(1)   a = b\n```\n\n    c = d      (2a)\n\n| spring | F | (3) |\nsee (4)\n";
        let expected = [("1", 2), ("2a", 5), ("3", 7)];
        assert_eq!(numbered(text), expected.map(|(number, line)| (number.to_owned(), line)));
    }
}
