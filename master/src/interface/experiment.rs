//! What an FMU proposes for a run of its own.

use super::xml;

/// What an FMU proposes for a run of its own (§2.2.5).
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct DefaultExperiment {
    /// Start, s.
    pub start: Option<f64>,
    /// End, s.
    pub stop: Option<f64>,
    /// Step of the exchange, s.
    pub step: Option<f64>,
    /// Relative tolerance of its solver.
    pub tolerance: Option<f64>,
}

impl From<xml::DefaultExperiment> for DefaultExperiment {
    fn from(xml: xml::DefaultExperiment) -> Self {
        let number =
            |text: Option<String>| text?.trim().parse().ok().filter(|n: &f64| n.is_finite());
        let positive = |text| number(text).filter(|number| *number > 0.0);
        Self {
            start: number(xml.start),
            stop: number(xml.stop),
            step: positive(xml.step),
            tolerance: positive(xml.tolerance),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_makes_no_sense_is_as_if_it_were_not_there() {
        let text = |text: &str| Some(text.to_owned());
        let of = |start, stop, step, tolerance| {
            DefaultExperiment::from(xml::DefaultExperiment { start, stop, step, tolerance })
        };
        let sound = of(text("-1"), text(" 2.5 "), text("1e-3"), text("1E-6"));
        let expected = DefaultExperiment {
            start: Some(-1.0),
            stop: Some(2.5),
            step: Some(1e-3),
            tolerance: Some(1e-6),
        };
        assert_eq!(sound, expected);
        let odd = of(text("soon"), text("INF"), text("0"), text("-1e-6"));
        assert_eq!(odd, of(None, None, None, None));
    }
}
