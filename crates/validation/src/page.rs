//! The page that shows the comparisons.

/// A page of tables under `docs/validation`.
pub struct Page<'a> {
    /// Path from the root of the repository, for messages.
    pub path: &'a str,
    /// Its text.
    pub text: &'a str,
}

impl<'a> Page<'a> {
    /// What the page shows between the beginning and the end of a line.
    ///
    /// # Panics
    /// If no line begins and ends like this. The message has the line that is missing, with `obtained`
    /// in between.
    pub(crate) fn shown(&self, begin: &str, obtained: &str, end: &str) -> &'a str {
        let mut shown = self.text.lines().filter_map(|line| {
            let rest = line.trim_end().strip_prefix(begin)?;
            rest.strip_suffix(end)
        });
        shown.next().unwrap_or_else(|| panic!("{} lacks {begin}{obtained}{end}", self.path))
    }
}
