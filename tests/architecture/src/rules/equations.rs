//! An equation of the theory has an anchor, is cited by code and is validated.
//!
//! The pages of a model number its equations through, `(12)`. The equation has the anchor
//! `<a id="eq-12"></a>`. Code of the model cites it as `docs/theory/page.md#eq-12`, which must be
//! there, or in short as "eq. 12" or "theory, eq. 12"; an equation of a publication stands behind its name
//! and is not meant. A page of `docs/validation` links to it as
//! `../theory/page.md#eq-12`.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use crate::breach::Breach;
use crate::workspace::{Source, Workspace};

/// The pages of a model, and the packages that hold its code.
const MODELS: [(&str, &[&str]); 4] = [
    ("docs/theory/longitudinal.md", &["fmus/longitudinal", "crates/stock"]),
    ("docs/theory/vehicle", &["fmus/vehicle", "crates/contact", "crates/track"]),
    ("docs/theory/railheat", &["fmus/railheat"]),
    ("docs/theory/synchronisation.md", &["crates/controller", "fmus/synchronisation"]),
];

/// Equations without anchor, without a citation in code, and without validation.
pub fn breaches(workspace: &Workspace) -> Vec<Breach> {
    let pages = workspace.pages("docs/theory");
    let validation: String =
        workspace.pages("docs/validation").into_iter().map(|(_, text)| text).collect();
    let links: Vec<_> = workspace.sources().flat_map(links).collect();
    let anchored = |link: &&Link| {
        let anchor = format!("id=\"eq-{}\"", link.number);
        pages.iter().any(|(path, text)| *path == link.page && text.contains(&anchor))
    };
    let broken = links.iter().filter(|link| !anchored(link));
    let mut found: Vec<_> = broken
        .map(|link| {
            let Link { page, number, file, line } = link;
            let message = format!("{} has no anchor eq-{number}", page.display());
            Breach::new(file, *line, message)
        })
        .collect();
    for (folder, packages) in MODELS {
        let cited = cited(workspace, packages);
        for (path, text) in pages.iter().filter(|(path, _)| path.starts_with(folder)) {
            let page = path.strip_prefix("docs").unwrap_or(path).display();
            for (number, line) in numbered(text) {
                let is_linked = links.iter().any(|link| link.leads_to(path, &number));
                let is_cited = is_linked || cited.iter().any(|cited| cited.holds(&number));
                let missing = [
                    (!text.contains(&format!("id=\"eq-{number}\"")), "an anchor"),
                    (!is_cited, "a citation in code"),
                    (!validation.contains(&format!("{page}#eq-{number})")), "validation"),
                ];
                let missing = missing.into_iter().filter(|(missing, _)| *missing);
                let missing: Vec<_> = missing.map(|(_, what)| what).collect();
                if !missing.is_empty() {
                    let message = format!("equation ({number}) is without {}", missing.join(", "));
                    found.push(Breach::new(Path::new(path), line, message));
                }
            }
        }
    }
    found
}

/// A link from code to the anchor of an equation.
struct Link {
    page: PathBuf,
    number: String,
    file: PathBuf,
    line: usize,
}

impl Link {
    fn leads_to(&self, page: &Path, number: &str) -> bool {
        self.page == page && self.number == number
    }
}

/// The links of a source; those of tests count for nothing.
fn links(source: &Source) -> Vec<Link> {
    const ANCHOR: &str = ".md#eq-";
    let code = source.text.lines().count() - source.lines_of_tests();
    let mut found = vec![];
    for (index, line) in source.text.lines().take(code).enumerate() {
        for (at, _) in line.match_indices(ANCHOR) {
            let begin = line[..at].rfind("docs/theory/");
            let number = &line[at + ANCHOR.len()..];
            let end = number.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(number.len());
            found.extend(begin.map(|begin| Link {
                page: PathBuf::from(format!("{}.md", &line[begin..at])),
                number: number[..end].to_owned(),
                file: source.path.clone(),
                line: index + 1,
            }));
        }
    }
    found
}

/// Equations that a comment names: from one to another, mostly the same.
#[derive(Debug, PartialEq)]
struct Cited {
    first: String,
    last: String,
}

impl Cited {
    fn holds(&self, number: &str) -> bool {
        let key = |number: &str| {
            let digits = number.trim_end_matches(|c: char| c.is_ascii_lowercase());
            (digits.parse::<usize>().unwrap_or(0), number[digits.len()..].to_owned())
        };
        (key(&self.first)..=key(&self.last)).contains(&key(number))
    }
}

/// What the code of some packages cites.
fn cited(workspace: &Workspace, packages: &[&str]) -> Vec<Cited> {
    let here = |folder: &Path| packages.iter().any(|package| Path::new(package) == folder);
    let packages = workspace.packages.iter().filter(|package| here(&package.folder));
    let sources =
        packages.flat_map(|package| package.sources.iter().filter(|s| package.is_product(s)));
    sources.flat_map(|source| citations(&source.text)).collect()
}

/// The citations in a text of code, whose comments may be broken into lines.
fn citations(text: &str) -> Vec<Cited> {
    let lines = text.lines().map(|line| line.trim().trim_start_matches(['/', '!']).trim());
    let text = lines.collect::<Vec<_>>().join(" ").replace("eqs ", "eq. ");
    let ours = |at: usize| {
        let before = text[..at].trim_end();
        ["(", ";", "theory", "theory,", "Theory"].iter().any(|end| before.ends_with(end))
    };
    let marks = text.match_indices("eq. ").filter(|(at, _)| ours(*at));
    marks.flat_map(|(at, mark)| list(&text[at + mark.len()..])).collect()
}

/// The equations at the beginning of a text: `2`, `2, 3`, `2 and 3` or `20 to 22`.
fn list(mut text: &str) -> Vec<Cited> {
    let mut found: Vec<Cited> = vec![];
    let mut first = None;
    loop {
        let end = text.find(|c: char| !c.is_ascii_alphanumeric()).unwrap_or(text.len());
        let (last, rest) = text.split_at(end);
        if !last.starts_with(|c: char| c.is_ascii_digit()) {
            return found;
        }
        if let Some(rest) = rest.strip_prefix(" to ") {
            (first, text) = (Some(last), rest);
            continue;
        }
        found.push(Cited { first: first.take().unwrap_or(last).to_owned(), last: last.to_owned() });
        match rest.strip_prefix(", ").or(rest.strip_prefix(" and ")) {
            Some(rest) => text = rest,
            None => return found,
        }
    }
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
    fn citations_are_told_from_those_of_publications() {
        let text = "//! It moves (theory, eq. 13). Then (theory,\n//! eq. 15c to 15f); Polach 2005, eq. 11.\n\
                    /// Theory eq. 5; (eqs 2 and 3) with stick; eq. 30).";
        let cited = citations(text);
        let pairs: Vec<_> = cited.iter().map(|c| (c.first.as_str(), c.last.as_str())).collect();
        let expected =
            [("13", "13"), ("15c", "15f"), ("5", "5"), ("2", "2"), ("3", "3"), ("30", "30")];
        assert_eq!(pairs, expected);
        assert!(cited[1].holds("15d") && !cited[1].holds("15b") && !cited[1].holds("16"));
    }

    #[test]
    fn equations_are_found_at_either_end_of_a_line_and_in_tables() {
        let text =
            "```text\n(1)   a = b\n```\n\n    c = d      (2a)\n\n| spring | F | (3) |\nsee (4)\n";
        let expected = [("1", 2), ("2a", 5), ("3", 7)];
        assert_eq!(numbered(text), expected.map(|(number, line)| (number.to_owned(), line)));
    }
}
