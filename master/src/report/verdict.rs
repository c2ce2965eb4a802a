//! The answer of a run in sentences: whether the foot warms, where, when, seen from where, by which
//! source. All words of the verdict stand here.

use numerics::seconds;
use serde::Serialize;

use super::collect::ReportData;
use super::data::{MainFigure, RailData};
use super::facts::RailFacts;
use super::limits::Judged;
use super::quantity::{round_with_unit, with_unit};
use super::rail_figures::SOURCES;

/// The answer of a run.
#[derive(Debug, Default, PartialEq, Serialize)]
pub(super) struct Verdict {
    /// The answer in a few words.
    pub answer: String,
    /// What belongs to it: a paragraph for each rail, or for each thing to say.
    pub sentences: Vec<String>,
}

/// The answer of a run, whose limits were judged.
pub(super) fn verdict(data: &ReportData, limits: &[Judged]) -> Verdict {
    let mut verdict = match &data.facts.rails {
        Some(facts) => of_rails(&data.rails, facts),
        None => Verdict {
            answer: "No rail was heated in this run.".to_owned(),
            sentences: of_train(&data.main_figures),
        },
    };
    if !limits.is_empty() {
        let broken = limits.iter().filter(|limit| limit.is_kept == Some(false)).count();
        let unknown = limits.iter().filter(|limit| limit.is_kept.is_none()).count();
        let answer = match (broken, unknown) {
            (0, 0) => format!("All {} limits are kept.", limits.len()),
            (0, _) => format!("{unknown} of {} limits are not judged.", limits.len()),
            _ => format!("{broken} of {} limits are exceeded.", limits.len()),
        };
        let before = std::mem::replace(&mut verdict.answer, answer);
        verdict.sentences.insert(0, before);
    }
    verdict
}

/// What the train did, from the main figures.
fn of_train(figures: &[MainFigure]) -> Vec<String> {
    let largest = ["coupler.tension", "coupler.compression"].map(|key| {
        let figure = figures.iter().find(|figure| figure.key == key)?;
        Some(format!("{}: {}, {}.", figure.name, figure.text, figure.location))
    });
    largest.into_iter().flatten().collect()
}

fn of_rails(rails: &[RailData], facts: &RailFacts) -> Verdict {
    let threshold = round_with_unit(facts.detection_threshold_k, "K");
    if rails.iter().all(|rail| rail.foot.is_none()) {
        return Verdict {
            answer: format!(
                "This run does not say whether the rail foot warms by {threshold}: the heat model \"{}\" \
                 has no answer on the foot.",
                facts.model
            ),
            sentences: rails.iter().filter_map(surface).collect(),
        };
    }
    let warm: Vec<&str> =
        rails.iter().filter(|rail| detection(rail).is_some()).map(|r| r.side.as_str()).collect();
    let answer = match warm.as_slice() {
        [] => format!("The rail foot does not warm by {threshold} in the time that was simulated."),
        [side] => format!("Yes: the foot of the {side} rail warms by {threshold}."),
        _ => format!("Yes: the foot of both rails warms by {threshold}."),
    };
    let mut sentences = vec![];
    for rail in rails {
        let of_rail = of_foot(rail, facts, &threshold).into_iter().chain(source(rail));
        sentences.push(of_rail.collect::<Vec<_>>().join(" "));
    }
    Verdict { answer, sentences }
}

/// A figure of a rail.
fn figure<'r>(rail: &'r RailData, key: &str) -> Option<&'r MainFigure> {
    let key = format!("{}.{key}", rail.side);
    rail.figures.iter().find(|figure| figure.key == key)
}

/// When and where the foot first passes the threshold, if it does.
fn detection(rail: &RailData) -> Option<&MainFigure> {
    figure(rail, "foot.detection").filter(|figure| figure.value.is_some())
}

/// How warm the foot gets, and who sees it.
fn of_foot(rail: &RailData, facts: &RailFacts, threshold: &str) -> Vec<String> {
    let mut sentences = vec![];
    let side = &rail.side;
    if let Some(MainFigure { time_s: Some(time), chainage_m: Some(at), .. }) = detection(rail) {
        sentences.push(format!(
            "The foot of the {side} rail first reaches {threshold} at chainage {at:.1} m, {}.",
            after_train(*time, facts)
        ));
    }
    if let Some(highest @ MainFigure { time_s: Some(time), chainage_m: Some(at), .. }) =
        figure(rail, "foot.highest")
    {
        sentences.push(format!(
            "The foot of the {side} rail is warmest, by {}, at chainage {at:.1} m, {}.",
            highest.text,
            after_train(*time, facts)
        ));
    }
    let seen = |key: &str| figure(rail, key).and_then(|figure| Some((figure, figure.value?)));
    let sees = |rise: f64| match rise >= facts.detection_threshold_k {
        true => "sees it",
        false => "does not see it",
    };
    if let Some((figure, rise)) = seen("camera.train") {
        let text = &figure.text;
        sentences
            .push(format!("A camera on the train {}: {text} under the last wheel.", sees(rise)));
    }
    if let Some(figure) = figure(rail, "foot.thermoelastic") {
        sentences.push(format!(
            "Not in these rises: with each axle, bending changes the foot by {} and leaves nothing. What stays of \
             it under the last wheel is hysteresis; the heat of friction comes minutes later.",
            figure.text
        ));
    }
    sentences.push(match seen("camera.track_side") {
        Some((figure, rise)) => {
            format!("A camera at the track side {} after the train: {}.", sees(rise), figure.text)
        }
        None => "What a camera at the track side sees after the train was not simulated: heat takes some 25 \
                 minutes to the foot."
            .to_owned(),
    });
    sentences
}

/// A time over the end of the last train's run.
fn after_train(time: f64, facts: &RailFacts) -> String {
    let later = time - facts.last_train_end_s;
    match later > 0.0 {
        true => format!("{:.1} min after the end of the train's run", later / 60.0),
        false => format!("at {} s, while the train runs", seconds(time)),
    }
}

/// The source that brings a rail most heat, in the mean along it, of those that come with the train.
fn source(rail: &RailData) -> Option<String> {
    let mean = &rail.heat.last()?.sources;
    let of_train = SOURCES.iter().zip(mean).filter(|((source, _), _)| *source != "weather");
    let ((_, words), heat) = of_train.max_by(|a, b| a.1.total_cmp(b.1))?;
    (*heat > 0.0).then(|| {
        let heat = with_unit(*heat, "J/m");
        format!(
            "Most heat of the {} rail comes by {words}: {heat} in the mean along it.",
            rail.side
        )
    })
}

/// The highest rise of a rail's surface.
fn surface(rail: &RailData) -> Option<String> {
    let figure = figure(rail, "highest.surface")?;
    Some(format!(
        "The surface of the {} rail is warmest, by {}, at {}.",
        rail.side, figure.text, figure.location
    ))
}
