//! A structure as a person would draw it: like components and like connections stand together, so that
//! a train of 130 vehicles fits on a page.

use std::collections::BTreeMap;
use std::fmt::Write;

use numerics::seconds;

use super::structure::{Component, Connection, Sampling, Schedule, Structure};

/// Like components, which differ in their numbers only.
struct Group<'s> {
    /// Their name with `*` instead of numbers.
    pattern: String,
    first: &'s str,
    last: &'s str,
    count: usize,
    /// File of the FMU.
    source: &'s str,
    schedule: Schedule,
}

/// Like connections: who gives, who takes, and which variables, with `*` instead of numbers.
#[derive(PartialEq)]
struct Bundle {
    from: String,
    to: String,
    output: String,
    input: String,
    /// What is done to the values, and what a slower receiver gets.
    note: String,
    count: usize,
}

impl Structure {
    /// The structure in lines of text.
    pub fn text(&self) -> String {
        let mut text = String::new();
        let (components, connections) = (self.components.len(), self.connections.len());
        let step = self.step.map_or(String::new(), |step| format!(", step {} s", seconds(step)));
        let name = &self.name;
        line(
            &mut text,
            format!("{name}: {components} components, {connections} connections{step}"),
        );
        let groups = self.groups();
        let last_stage = groups.iter().map(|group| group.schedule.stage).max().unwrap_or(0);
        for stage in 0..=last_stage {
            let name = self.stages.get(stage).map_or(String::new(), |name| format!(" ({name})"));
            line(&mut text, format!("\nstage {}{name}", stage + 1));
            for group in groups.iter().filter(|group| group.schedule.stage == stage) {
                line(&mut text, format!("  {}", group.text(self.step)));
            }
        }
        let mut ends = (String::new(), String::new());
        for Bundle { from, to, output, input, note, count } in self.bundles() {
            if (&from, &to) != (&ends.0, &ends.1) {
                line(&mut text, format!("\n{from} -> {to}"));
                ends = (from, to);
            }
            line(&mut text, format!("  {count:>5} x {output} -> {input}{note}"));
        }
        text
    }

    /// The structure as a graph in the language of Graphviz.
    pub fn dot(&self) -> String {
        let mut text = String::from("digraph structure {\n  rankdir=LR; node [shape=box];\n");
        for group in self.groups() {
            let Group { pattern, count, source, schedule, .. } = group;
            let times = if count > 1 { format!("{count} x ") } else { String::new() };
            let every = match schedule.every {
                1 => String::new(),
                every => format!("\\nevery {every} steps"),
            };
            let stage = schedule.stage + 1;
            let label = format!("{pattern}\\n{times}{}\\nstage {stage}{every}", file_name(source));
            line(&mut text, format!("  \"{pattern}\" [label=\"{label}\"];"));
        }
        let mut edges: BTreeMap<(String, String), (usize, Vec<String>)> = BTreeMap::new();
        for Bundle { from, to, output, count, .. } in self.bundles() {
            let (sum, outputs) = edges.entry((from, to)).or_default();
            *sum += count;
            outputs.push(output);
        }
        for ((from, to), (count, outputs)) in edges {
            let label = format!("{count} connections\\n{}", outputs.join("\\n"));
            line(&mut text, format!("  \"{from}\" -> \"{to}\" [label=\"{label}\"];"));
        }
        text + "}\n"
    }

    /// The components in groups: those that follow one another and differ in their numbers only.
    fn groups(&self) -> Vec<Group<'_>> {
        let mut groups: Vec<Group<'_>> = vec![];
        for Component { name, source, schedule, .. } in &self.components {
            let (pattern, schedule) = (without_numbers(name), *schedule);
            match groups.last_mut() {
                Some(group)
                    if group.pattern == pattern
                        && group.source == source
                        && group.schedule == schedule =>
                {
                    group.last = name;
                    group.count += 1;
                }
                _ => {
                    let (first, last, count) = (name, name, 1);
                    groups.push(Group { pattern, first, last, count, source, schedule });
                }
            }
        }
        groups
    }

    /// The connections in bundles, those between the same components together.
    fn bundles(&self) -> Vec<Bundle> {
        let mut counts: BTreeMap<[String; 5], usize> = BTreeMap::new();
        let mut order: Vec<[String; 5]> = vec![];
        let every: BTreeMap<&str, u64> =
            self.components.iter().map(|c| (c.name.as_str(), c.schedule.every)).collect();
        for connection in &self.connections {
            let Connection { from, to, .. } = connection;
            let slow = every.get(to.element.as_str()).is_some_and(|every| *every > 1);
            let key = [
                without_numbers(&from.element),
                without_numbers(&to.element),
                without_numbers(&from.connector),
                without_numbers(&to.connector),
                note(connection, slow),
            ];
            let count = counts.entry(key.clone()).or_default();
            if *count == 0 {
                order.push(key);
            }
            *count += 1;
        }
        let ends: Vec<(String, String)> =
            order.iter().map(|[from, to, ..]| (from.clone(), to.clone())).collect();
        // Between the same components they stand where the first of them stands.
        order.sort_by_key(|[from, to, ..]| ends.iter().position(|(a, b)| a == from && b == to));
        let bundle = |key: [String; 5]| {
            let count = counts[&key];
            let [from, to, output, input, note] = key;
            Bundle { from, to, output, input, note, count }
        };
        order.into_iter().map(bundle).collect()
    }
}

impl Group<'_> {
    /// The group in a line; `step` is that of the exchange, s.
    fn text(&self, step: Option<f64>) -> String {
        let Self { first, last, count, source, schedule, .. } = self;
        let names = match count {
            1 => (*first).to_owned(),
            _ => format!("{first} to {last}"),
        };
        let mut text = format!("{names:<32} {count:>3} x {}", file_name(source));
        if schedule.every > 1 {
            let _ = write!(text, ", every {} steps", schedule.every);
            if let Some(step) = step {
                let _ = write!(text, " ({} s)", seconds(step * schedule.every as f64));
            }
        }
        text
    }
}

/// What happens to a value on its way.
fn note(connection: &Connection, slow: bool) -> String {
    let mut text = String::new();
    let transformation = connection.transformation;
    if !transformation.is_identity() {
        let _ = write!(text, ", times {} plus {}", transformation.factor, transformation.offset);
    }
    match connection.sampling {
        _ if !slow => {}
        Sampling::Mean => text += ", mean",
        Sampling::Sum => text += ", sum",
        Sampling::Last => text += ", last value",
    }
    text
}

/// A name with `*` instead of numbers in brackets or at its end behind a line: `vehicle[17].force`
/// and `vehicle_17`.
fn without_numbers(name: &str) -> String {
    let mut pattern = String::new();
    let mut rest = name;
    while let Some(begin) = rest.find('[') {
        let (before, behind) = rest.split_at(begin + 1);
        let digits = behind.len() - behind.trim_start_matches(|c: char| c.is_ascii_digit()).len();
        pattern += before;
        rest = &behind[digits..];
        if digits > 0 {
            pattern.push('*');
        }
    }
    let text = rest.trim_end_matches(|c: char| c.is_ascii_digit());
    pattern += text;
    if text.len() < rest.len() {
        pattern.push_str(if text.ends_with('_') { "*" } else { &rest[text.len()..] });
    }
    pattern
}

/// The file at the end of a path, with `/` on every system as in packages.
fn file_name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}

fn line(text: &mut String, line: String) {
    text.push_str(&line);
    text.push('\n');
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::si::Linear;
    use crate::system::structure::Endpoint;

    /// A train of three vehicles on a slower rail.
    fn structure() -> Structure {
        let component = |name: &str, source: &str, stage, every| Component {
            name: name.to_owned(),
            source: format!("/results/fmus/{source}.fmu"),
            schedule: Schedule { stage, every, ..Schedule::default() },
            ..Component::default()
        };
        let mut structure = Structure {
            name: "train".to_owned(),
            step: Some(0.001),
            stages: ["train", "vehicles", "rail"].map(str::to_owned).to_vec(),
            components: vec![
                component("train", "train", 0, 1),
                component("vehicle[1]", "locomotive", 1, 1),
                component("vehicle[2]", "wagon", 1, 1),
                component("vehicle[3]", "wagon", 1, 1),
                component("rail", "rail", 2, 20),
            ],
            ..Structure::default()
        };
        for i in 1..=3 {
            let mut connect = |from: [&str; 2], to: [&str; 2], factor, sampling| {
                let [from, to] = [from, to].map(|[part, name]| {
                    let number = |text: &str| text.replace('#', &i.to_string());
                    Endpoint::new(&number(part), &number(name))
                });
                let factor = Linear { factor, offset: 0.0 };
                structure.connections.push(Connection::of(from, to, factor, sampling));
            };
            let vehicle = "vehicle[#]";
            connect(["train", "vehicle[#].force"], [vehicle, "force"], 1000.0, Sampling::Mean);
            connect([vehicle, "x"], ["rail", "vehicle[#].x"], 1.0, Sampling::Last);
            connect([vehicle, "power"], ["rail", "vehicle[#].power"], 1.0, Sampling::Mean);
        }
        structure
    }

    #[test]
    fn golden_like_components_and_connections_stand_together() {
        let expected = "\
train: 5 components, 9 connections, step 0.001 s

stage 1 (train)
  train                              1 x train.fmu

stage 2 (vehicles)
  vehicle[1]                         1 x locomotive.fmu
  vehicle[2] to vehicle[3]           2 x wagon.fmu

stage 3 (rail)
  rail                               1 x rail.fmu, every 20 steps (0.02 s)

train -> vehicle[*]
      3 x vehicle[*].force -> force, times 1000 plus 0

vehicle[*] -> rail
      3 x x -> vehicle[*].x, last value
      3 x power -> vehicle[*].power, mean
";
        assert_eq!(structure().text(), expected);
    }

    #[test]
    fn golden_a_graph_has_a_box_for_like_components_and_an_arrow_for_their_connections() {
        let dot = structure().dot();
        for wanted in [
            "\"rail\" [label=\"rail\\nrail.fmu\\nstage 3\\nevery 20 steps\"];",
            "\"vehicle[*]\" [label=\"vehicle[*]\\n2 x wagon.fmu\\nstage 2\"];",
            "\"vehicle[*]\" -> \"rail\" [label=\"6 connections\\nx\\npower\"];",
        ] {
            assert!(dot.contains(wanted), "{dot}");
        }
        assert!(dot.starts_with("digraph") && dot.ends_with("}\n"));
    }

    #[test]
    fn numbers_are_taken_out_of_names_of_both_kinds() {
        for (name, pattern) in [
            ("vehicle[17].wheelset[4].left.force", "vehicle[*].wheelset[*].left.force"),
            ("vehicle_17", "vehicle_*"),
            ("rail[left]", "rail[left]"),
            ("m1", "m1"),
            ("x", "x"),
        ] {
            assert_eq!(without_numbers(name), pattern);
        }
    }
}
