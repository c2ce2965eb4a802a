//! Hotfoot's own annotations in a structure: when a component steps, and what it gets meanwhile. SSP
//! 1.0 has nothing for that but annotations of a namespace of one's own, which other tools ignore:
//!
//! ```xml
//! <ssd:Component name="rail" source="resources/rail.fmu">
//!   <ssd:Annotations>
//!     <ssc:Annotation type="org.hotfoot.schedule">
//!       <hotfoot:Schedule stage="2" every="10">
//!         <hotfoot:Input name="vehicle[1].wheelset[1].position" sampling="last"/>
//!       </hotfoot:Schedule>
//!     </ssc:Annotation>
//!   </ssd:Annotations>
//! </ssd:Component>
//! ```
//!
//! A component without one steps at every communication point in stage 0, and inputs without one get
//! means. `sameThread="true"` beside them: its FMU may be called by the thread only that has made it.

use roxmltree::Node;
use serde::Serialize;

use super::error::SspError;
use super::xml::{XmlFile, child, children};
use crate::system::structure::{Sampling, Schedule, Structure};

/// The namespace of the annotations.
pub const NAMESPACE: &str = "urn:hotfoot:ssp";
/// Type of the annotation of a component.
const SCHEDULE_TYPE: &str = "org.hotfoot.schedule";
/// Type of the annotation of the experiment, with the names of the stages.
const STAGES_TYPE: &str = "org.hotfoot.stages";

/// The annotation of a component, as XML has it.
#[derive(Serialize)]
pub struct Annotation<'a> {
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "hotfoot:Schedule")]
    schedule: ScheduleElement<'a>,
}

#[derive(Serialize)]
struct ScheduleElement<'a> {
    #[serde(rename = "@stage")]
    stage: usize,
    #[serde(rename = "@every")]
    every: u64,
    #[serde(rename = "@sameThread", skip_serializing_if = "std::ops::Not::not")]
    same_thread: bool,
    #[serde(rename = "hotfoot:Input")]
    inputs: Vec<Input<'a>>,
}

#[derive(Serialize)]
struct Input<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
    #[serde(rename = "@sampling")]
    sampling: &'static str,
}

/// The annotation of the experiment, as XML has it.
#[derive(Serialize)]
pub struct StagesAnnotation<'a> {
    #[serde(rename = "@type")]
    kind: &'static str,
    #[serde(rename = "hotfoot:Stages")]
    stages: Stages<'a>,
}

#[derive(Serialize)]
struct Stages<'a> {
    #[serde(rename = "hotfoot:Stage")]
    stages: Vec<Stage<'a>>,
}

#[derive(Serialize)]
struct Stage<'a> {
    #[serde(rename = "@name")]
    name: &'a str,
}

impl<'a> Annotation<'a> {
    /// The annotation of a component whose inputs are sampled like this; none where all is as without
    /// one.
    pub fn of(schedule: Schedule, samplings: &[(&'a str, Sampling)]) -> Option<Self> {
        if schedule == Schedule::default() {
            return None;
        }
        let stated = samplings.iter().filter(|_| schedule.every > 1);
        let stated = stated.filter(|(_, sampling)| *sampling != Sampling::default());
        let inputs = stated.map(|&(name, sampling)| Input { name, sampling: name_of(sampling) });
        let Schedule { stage, every, same_thread } = schedule;
        let inputs = inputs.collect();
        let schedule = ScheduleElement { stage, every, same_thread, inputs };
        Some(Self { kind: SCHEDULE_TYPE, schedule })
    }
}

impl<'a> StagesAnnotation<'a> {
    /// The annotation with the names of a structure's stages; none where a single one has none.
    pub fn of(structure: &'a Structure) -> Option<Self> {
        let stages: Vec<_> = structure.stages.iter().map(|name| Stage { name }).collect();
        (stages.len() > 1).then_some(Self { kind: STAGES_TYPE, stages: Stages { stages } })
    }
}

/// The samplings by the names that they have in files.
const SAMPLINGS: [(&str, Sampling); 3] =
    [("mean", Sampling::Mean), ("sum", Sampling::Sum), ("last", Sampling::Last)];

fn name_of(sampling: Sampling) -> &'static str {
    let found = SAMPLINGS.iter().find(|(_, other)| *other == sampling);
    found.map_or("mean", |(name, _)| name)
}

/// The schedule of a component and the samplings of its inputs.
///
/// # Errors
/// When the annotation is wrong.
pub fn read(
    file: &XmlFile<'_>,
    component: Node<'_, '_>,
) -> Result<(Schedule, Vec<(String, Sampling)>), SspError> {
    let Some(node) = annotation(component, SCHEDULE_TYPE, "Schedule") else {
        return Ok((Schedule::default(), vec![]));
    };
    let stage = file.value(node, "stage")?.unwrap_or(0);
    let every = file.value(node, "every")?.unwrap_or(1);
    if every == 0 || stage > MOST_STAGES {
        let message = format!(
            "stage=\"{stage}\" every=\"{every}\": a stage is at most {MOST_STAGES}, and every at least 1"
        );
        return Err(file.wrong(node, message));
    }
    let mut samplings = vec![];
    for input in children(node, "Input") {
        let name = file.required(input, "sampling")?;
        let sampling = SAMPLINGS.iter().find(|(other, _)| *other == name).ok_or_else(|| {
            file.wrong(input, format!("sampling=\"{name}\" must be mean, sum or last"))
        })?;
        samplings.push((file.required(input, "name")?.to_owned(), sampling.1));
    }
    let same_thread = file.value(node, "sameThread")?.unwrap_or(false);
    Ok((Schedule { stage, every, same_thread }, samplings))
}

/// A file that names a stage of a high number would take memory for all before it.
const MOST_STAGES: usize = 1000;

/// The names of the stages.
///
/// # Errors
/// When one has no name.
pub fn read_stages(file: &XmlFile<'_>, experiment: Node<'_, '_>) -> Result<Vec<String>, SspError> {
    let Some(stages) = annotation(experiment, STAGES_TYPE, "Stages") else { return Ok(vec![]) };
    let name = |stage| Ok(file.required(stage, "name")?.to_owned());
    children(stages, "Stage").map(name).collect()
}

/// The content of an element's annotation of a type, in Hotfoot's namespace.
fn annotation<'a, 'i>(element: Node<'a, 'i>, kind: &str, content: &str) -> Option<Node<'a, 'i>> {
    let annotations = child(element, "Annotations")?;
    let mut of_kind =
        children(annotations, "Annotation").filter(|node| node.attribute("type") == Some(kind));
    let content = child(of_kind.next()?, content)?;
    (content.tag_name().namespace() == Some(NAMESPACE)).then_some(content)
}
