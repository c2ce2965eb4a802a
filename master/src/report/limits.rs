//! The limits of an acceptance run, judged.

use serde::Serialize;

use super::collect::ReportData;
use super::data::MainFigure;
use super::facts::Limit;
use super::quantity::with_unit;

/// A limit with what the run gave.
#[derive(Debug, PartialEq, Serialize)]
pub(super) struct Judged {
    /// The figure in words.
    pub name: String,
    /// What the run gave.
    pub found: String,
    /// The limit in words.
    pub limit: String,
    /// Where the limit comes from.
    pub source: String,
    /// Whether it is kept; `None` where the run does not tell.
    pub is_kept: Option<bool>,
}

/// Judges the limits by the figures of a run; one of another length tells nothing.
pub(super) fn judged(data: &ReportData) -> Vec<Judged> {
    let limits = &data.facts.limits;
    let of_rails = data.rails.iter().flat_map(|rail| &rail.figures);
    let figures: Vec<&MainFigure> = data.main_figures.iter().chain(of_rails).collect();
    let length = data.provenance.simulated_s;
    let is_whole = (length - limits.simulated_s).abs() <= 1e-6 * limits.simulated_s;
    let judged = |limit: &Limit| {
        let figure = figures.iter().find(|figure| figure.key == limit.key);
        let unit = figure.map_or("", |figure| figure.unit.as_str());
        let value = figure.and_then(|figure| figure.value).filter(|_| is_whole);
        let [least, most] = [limit.at_least, limit.at_most];
        let words = [(least, "at least"), (most, "at most")];
        let words = words.map(|(value, word)| value.map(|v| format!("{word} {}", number(v, unit))));
        Judged {
            name: figure.map_or(&limit.key, |figure| &figure.name).clone(),
            found: figure.map_or("not recorded".to_owned(), |figure| figure.text.clone()),
            limit: words.into_iter().flatten().collect::<Vec<_>>().join(", "),
            source: limit.source.clone(),
            is_kept: value.map(|value| {
                least.is_none_or(|least| value >= least) && most.is_none_or(|most| value <= most)
            }),
        }
    };
    limits.figures.iter().map(judged).collect()
}

/// A value with its unit; plain numbers have no prefix.
fn number(value: f64, unit: &str) -> String {
    match unit {
        "1" | "" => value.to_string(),
        unit => with_unit(value, unit),
    }
}
