//! Kinds of comparisons: with a value, with a limit, and without a number.

use crate::Page;

/// A value of a model against a value from elsewhere.
pub struct Row<'a> {
    /// What is compared.
    pub case: &'a str,
    /// Value of the model.
    pub value: f64,
    /// Value that the source has.
    pub expected: f64,
    /// Unit of both.
    pub unit: &'a str,
    /// Where the expectation comes from: a publication, a closed form, another program.
    pub source: &'a str,
    /// Allowed difference in the same unit, and why it is what it is.
    pub tolerance: (f64, &'a str),
}

impl Row<'_> {
    /// Prints the row.
    ///
    /// # Panics
    /// If the value is further from the expectation than the tolerance, or is no number; if the page
    /// does not show the row, or shows another value as obtained (further from this one than the
    /// tolerance).
    pub fn holds(&self, page: &Page) {
        let Self { case, value, expected, unit, source, tolerance: (allowed, reason) } = self;
        let begin = format!("| {case} | {} {unit} | {source} | ", six_digits(*expected));
        let obtained = format!("{} {unit}", six_digits(*value));
        let end = format!(" | {} {unit}: {reason} |", six_digits(*allowed));
        println!("{begin}{obtained}{end}");
        let within = |other: f64| (value - other).abs() <= *allowed;
        assert!(within(*expected), "{case}: {value} {unit}, expected {expected} {unit}");
        let shown = page.shown(&begin, &obtained, &end);
        let number = shown.strip_suffix(unit).and_then(|number| number.trim_end().parse().ok());
        assert!(
            shown == obtained || number.is_some_and(within),
            "{case}: {} says {shown}, obtained are {value} {unit}",
            page.path
        );
    }
}

/// Values of a model that must keep a limit, which the test itself asserts.
pub struct Bound<'a> {
    /// What is bounded.
    pub case: &'a str,
    /// The limit, with its unit.
    pub limit: &'a str,
    /// What the model has, with its unit.
    pub obtained: &'a str,
}

impl Bound<'_> {
    /// Prints the row.
    ///
    /// # Panics
    /// If the page has no row with this case and limit.
    pub fn stands_in(&self, page: &Page) {
        stands_in(page, &format!("| {} | {} | bound | ", self.case, self.limit), self.obtained);
    }
}

/// What a test has asserted without a number, such as two files that are equal.
pub struct Finding<'a> {
    /// What is compared.
    pub case: &'a str,
    /// What must hold.
    pub expected: &'a str,
    /// What it is compared with.
    pub source: &'a str,
}

impl Finding<'_> {
    /// Prints the row. To be called when the test has found that it holds.
    ///
    /// # Panics
    /// If the page has no such row.
    pub fn stands_in(&self, page: &Page) {
        let begin = format!("| {} | {} | {} | ", self.case, self.expected, self.source);
        stands_in(page, &begin, "holds");
    }
}

fn stands_in(page: &Page, begin: &str, obtained: &str) {
    println!("{begin}{obtained} | |");
    page.shown(begin, obtained, " | |");
}

/// A number with six significant digits, as the tables show it.
pub fn six_digits(value: f64) -> String {
    let digits = 5 - value.abs().max(1e-12).log10().floor() as i32;
    match digits {
        0..=9 => format!("{value:.*}", digits as usize),
        _ => format!("{value:.3e}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PAGE: Page = Page {
        path: "docs/validation/springs.md",
        text: "# Springs\n\n\
            | case | expected | source | obtained | allowed difference |\n|---|---|---|---|---|\n\
            | force at 2 mm | 4.00000 N | Hooke | 4.00100 N | 0.0100000 N: rounding |\n\
            | energy | below 1 J | bound | 0.2 J | |\n\
            | two threads | equal files | one thread | holds | |\n",
    };

    fn row(value: f64) -> Row<'static> {
        let tolerance = (0.01, "rounding");
        Row { case: "force at 2 mm", value, expected: 4.0, unit: "N", source: "Hooke", tolerance }
    }

    #[test]
    fn a_value_within_the_tolerance_holds() {
        row(4.009).holds(&PAGE);
        row(3.992).holds(&PAGE);
    }

    #[test]
    #[should_panic(expected = "4.011 N, expected 4 N")]
    fn a_value_beyond_the_tolerance_does_not() {
        row(4.011).holds(&PAGE);
    }

    #[test]
    #[should_panic(expected = "NaN N, expected 4 N")]
    fn nor_does_what_is_no_number() {
        row(f64::NAN).holds(&PAGE);
    }

    #[test]
    #[should_panic(expected = "says 4.00100 N, obtained are 3.9905 N")]
    fn the_page_must_show_what_is_obtained_now() {
        row(3.9905).holds(&PAGE);
    }

    #[test]
    #[should_panic(
        expected = "docs/validation/springs.md lacks | force at 3 mm | 4.00000 N | Hooke | \
                               4.00000 N | 0.0100000 N: rounding |"
    )]
    fn a_case_that_the_page_lacks_is_told() {
        Row { case: "force at 3 mm", ..row(4.0) }.holds(&PAGE);
    }

    #[test]
    #[should_panic(expected = "lacks")]
    fn another_tolerance_than_that_of_the_page_is_told() {
        Row { tolerance: (0.1, "rounding"), ..row(4.0) }.holds(&PAGE);
    }

    #[test]
    #[should_panic(expected = "lacks")]
    fn another_source_than_that_of_the_page_is_told() {
        Row { source: "Newton", ..row(4.0) }.holds(&PAGE);
    }

    #[test]
    fn bounds_and_findings_stand_in_the_page() {
        Bound { case: "energy", limit: "below 1 J", obtained: "0.3 J" }.stands_in(&PAGE);
        let threads = "two threads";
        Finding { case: threads, expected: "equal files", source: "one thread" }.stands_in(&PAGE);
    }

    #[test]
    #[should_panic(expected = "lacks | energy | below 2 J | bound | 0.3 J | |")]
    fn a_bound_that_the_page_lacks_is_told() {
        Bound { case: "energy", limit: "below 2 J", obtained: "0.3 J" }.stands_in(&PAGE);
    }

    #[test]
    #[should_panic(expected = "lacks | three threads")]
    fn a_finding_that_the_page_lacks_is_told() {
        Finding { case: "three threads", expected: "equal files", source: "one thread" }
            .stands_in(&PAGE);
    }

    #[test]
    fn numbers_have_six_digits() {
        assert_eq!(six_digits(0.0), "0.000e0");
        assert_eq!(six_digits(2.0 / 3.0), "0.666667");
        assert_eq!(six_digits(162_748.4), "162748");
        assert_eq!(six_digits(-31.1), "-31.1000");
        assert_eq!(six_digits(1_048_924.0), "1.049e6");
        assert_eq!(six_digits(2.538e-9), "2.538e-9");
    }
}
