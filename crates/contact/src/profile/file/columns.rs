//! Numbers in the lines of a file, whatever parts them.
//!
//! Blanks, tabs, semicolons and commas part numbers. A comma within a number is a decimal comma where
//! something else parts the numbers of a line, as in `-69,9000;11,5416`.

/// Characters after which a line is a comment.
const COMMENT: [char; 3] = ['!', '#', '%'];

/// What part numbers beside commas.
fn is_gap(c: char) -> bool {
    c.is_whitespace() || c == ';'
}

/// How a file writes its numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    decimal_comma: bool,
}

impl Columns {
    /// Those of these lines of points.
    ///
    /// # Errors
    /// When a comma may be either; the line's index and the reason.
    pub fn of<'a>(lines: impl Iterator<Item = &'a str> + Clone) -> Result<Self, (usize, String)> {
        let decimal_comma = lines.clone().any(|line| {
            let parts: Vec<&str> = line.split(is_gap).filter(|part| !part.is_empty()).collect();
            let inside = |part: &&str| {
                let sides = part.trim_matches('"').split_once(',');
                sides.is_some_and(|(whole, rest)| {
                    let digit = |c: Option<char>| c.is_some_and(|c| c.is_ascii_digit());
                    !part.contains('.')
                        && digit(whole.chars().next_back())
                        && digit(rest.chars().next())
                })
            };
            parts.len() > 1
                && parts.iter().all(|part| inside(part) || !part.contains(','))
                && parts.iter().any(inside)
        });
        if !decimal_comma && !lines.clone().any(|line| line.contains('.')) {
            let unclear = |line: &str| {
                line.matches(',').count() > 1 && line.trim().split(is_gap).count() == 1
            };
            if let Some((i, line)) = lines.enumerate().find(|(_, line)| unclear(line)) {
                return Err((
                    i,
                    format!(
                        "\"{line}\": its commas may part numbers or be decimal; part the numbers by \
                         semicolons or blanks, or write decimal points"
                    ),
                ));
            }
        }
        Ok(Self { decimal_comma })
    }

    /// The numbers of a line; nothing if one of its parts is none, or it has no part.
    pub fn numbers(self, line: &str) -> Option<Vec<f64>> {
        let parts = line.split(|c: char| is_gap(c) || (c == ',' && !self.decimal_comma));
        let parts = parts.map(|part| part.trim_matches('"')).filter(|part| !part.is_empty());
        let numbers: Option<Vec<f64>> = parts.map(|part| self.number(part)).collect();
        numbers.filter(|numbers| !numbers.is_empty())
    }

    /// A number, also with a decimal comma, Fortran's `D` for the exponent or a typeset minus.
    fn number(self, part: &str) -> Option<f64> {
        let mut text = part.replace(['d', 'D'], "e").replace('\u{2212}', "-");
        if self.decimal_comma {
            text = text.replace(',', ".");
        }
        let is_number = text.starts_with(|c: char| c.is_ascii_digit() || "+-.".contains(c));
        text.parse().ok().filter(|number: &f64| is_number && number.is_finite())
    }
}

/// A line without its comment and the blanks around it.
pub(super) fn without_comment(line: &str) -> &str {
    line.split(COMMENT).next().unwrap_or_default().trim()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Vec<Option<Vec<f64>>> {
        let columns = Columns::of(text.lines()).unwrap();
        text.lines().map(|line| columns.numbers(line)).collect()
    }

    #[test]
    fn numbers_are_read_whatever_parts_them() {
        let expected = [Some(vec![-69.9, 11.5416]), Some(vec![-69.0, 13.0])];
        for text in [
            "-69.9 11.5416\n-69 13",
            "-69.9,11.5416\n-69,13",
            "-69.9, 11.5416\n-69, 13",
            "-69.9;11.5416\n-69;13",
            "-69.9\t11.5416\r\n-69\t13\r",
            "-69,9;11,5416\n-69;13",
            "-69,9000  11,5416\n-69,0  13,0",
            "\"-69,9\";\"11,5416\"\n\"-69\";\"13\"",
            "-6.99E+01 1.15416D1\n\u{2212}69 +13",
        ] {
            assert_eq!(read(text), expected, "{text}");
        }
    }

    #[test]
    fn what_is_no_number_is_not_read() {
        assert_eq!(read("1 x\n1 nan\n1 inf\n\n1.2.3 4"), [None, None, None, None, None]);
    }

    /// Four whole numbers or two with decimal commas.
    #[test]
    fn commas_that_may_be_either_are_refused() {
        let (line, reason) = Columns::of("1,2\n-69,9,11,5".lines()).unwrap_err();
        assert_eq!(line, 1);
        assert!(reason.contains("may part numbers or be decimal"), "{reason}");
    }
}
