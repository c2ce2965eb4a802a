//! `hotfoot check`: our FMUs break no rule, and each of the mutations by which the checkers of
//! other makers were compared is found by its rule.

use std::path::{Path, PathBuf};

use hotfoot::check::check;
use hotfoot_tests::hostile::archive;
use hotfoot_tests::{fmu, hotfoot};

const DESCRIPTION: &str = "modelDescription.xml";

/// An unpacked FMU of ours whose files may be changed.
struct Copy(tempfile::TempDir);

impl Copy {
    fn of(model: &str) -> Self {
        let folder = tempfile::tempdir().unwrap();
        let file = std::fs::File::open(fmu(model)).unwrap();
        zip::ZipArchive::new(file).unwrap().extract(folder.path()).unwrap();
        Self(folder)
    }

    fn file(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn text(&self, name: &str) -> String {
        std::fs::read_to_string(self.file(name)).unwrap()
    }

    /// The FMU after one of its files has become `text`.
    fn with(&self, name: &str, text: &str) -> PathBuf {
        let mut files = vec![];
        collect(self.0.path(), self.0.path(), &mut files);
        let content = |own: &str, content: Vec<u8>| match own == name {
            true => text.as_bytes().to_vec(),
            false => content,
        };
        let files: Vec<(String, Vec<u8>)> = files
            .into_iter()
            .map(|(own, bytes)| {
                let bytes = content(&own, bytes);
                (own, bytes)
            })
            .collect();
        let entries: Vec<(&str, &[u8])> =
            files.iter().map(|(name, bytes)| (name.as_str(), bytes.as_slice())).collect();
        let mutant = tempfile::Builder::new().suffix(".fmu").tempfile().unwrap();
        let path = mutant.into_temp_path().keep().unwrap();
        archive(&path, &entries);
        path
    }
}

/// All files below a folder, with their names in the archive.
fn collect(root: &Path, folder: &Path, files: &mut Vec<(String, Vec<u8>)>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            collect(root, &path, files);
        } else {
            let name = path.strip_prefix(root).unwrap().to_str().unwrap().to_owned();
            files.push((name, std::fs::read(&path).unwrap()));
        }
    }
}

#[test]
fn our_fmus_break_no_rule_and_give_no_cause_for_advice() {
    for model in ["vehicle", "longitudinal", "railheat", "synchronisation"] {
        let findings = check(&fmu(model));
        assert!(findings.is_empty(), "{model}: {findings:#?}");
    }
}

#[test]
fn our_fmus_give_their_reference_result_again() {
    for model in ["vehicle", "longitudinal", "railheat", "synchronisation"] {
        let path = fmu(model);
        let output = hotfoot(Path::new("."), &["check", path.to_str().unwrap(), "--replay"]);
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{model}: {}", String::from_utf8_lossy(&output.stderr));
        assert!(text.contains("are those of the reference result"), "{model}: {text}");
    }
}

/// A result that is not that of the FMU is noticed, with signal, time and difference.
#[test]
fn another_reference_result_is_noticed() {
    const RESULT: &str = "extra/org.fmi-standard.fmi-ls-ref/ref.csv";
    let copy = Copy::of("vehicle");
    let text = copy.text(RESULT);
    let (lines, last) = text.trim_end().rsplit_once('\n').unwrap();
    let (time, rest) = last.split_once(',').unwrap();
    let (position, rest) = rest.split_once(',').unwrap();
    // The first signal is the position, some 16 m.
    let position = position.parse::<f64>().unwrap() + 1e-6;
    let mutant = copy.with(RESULT, &format!("{lines}\n{time},{position},{rest}\n"));
    let output = hotfoot(copy.0.path(), &["check", mutant.to_str().unwrap(), "--replay"]);
    std::fs::remove_file(&mutant).unwrap();
    assert!(!output.status.success());
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("`position` is") && message.contains("at 1 s, but was"), "{message}");
}

/// A variable at the end of the list, so that no index of another changes.
fn added(text: &str, variable: &str) -> String {
    text.replacen("</ModelVariables>", &format!("{variable}</ModelVariables>"), 1)
}

fn replaced(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from} is not in the model description");
    text.replacen(from, to, 1)
}

/// The text without the first line, after `after`, that holds `what`.
fn without(text: &str, after: &str, what: &str) -> String {
    let (before, rest) = text.split_once(after).expect("it is there");
    let line = rest.lines().find(|line| line.contains(what)).expect("it is there");
    format!("{before}{after}{}", rest.replacen(line, "", 1))
}

/// The mutations of one good FMU by which eight tools were compared, each with the rule that finds
/// it; no rule: the mutation is legal.
#[test]
fn each_mutation_is_found_by_its_rule() {
    let copy = Copy::of("vehicle");
    let good = copy.text(DESCRIPTION);
    let local = |rest: &str| {
        added(
            &good,
            &format!("<ScalarVariable name=\"more\" valueReference=\"0\" {rest}</ScalarVariable>"),
        )
    };
    let index = |name: &str| {
        let names = good.split("<ScalarVariable name=\"").skip(1);
        1 + names.into_iter().position(|text| text.starts_with(&format!("{name}\""))).unwrap()
    };
    let position = format!("index=\"{}\"", index("position"));
    let mutations: [(&str, Option<&str>, String); 21] = [
        (
            "an output is not in ModelStructure/Outputs",
            Some("outputs-are-complete"),
            without(&good, "<Outputs>", &position),
        ),
        (
            "a calculated output is not in InitialUnknowns",
            Some("initial-unknowns-are-complete"),
            without(&good, "<InitialUnknowns>", &position),
        ),
        (
            "an input has no start",
            Some("start-is-given"),
            replaced(&good, "<Real unit=\"N\" start=\"0\"/>", "<Real unit=\"N\"/>"),
        ),
        (
            "a unit is not defined",
            Some("units-are-defined"),
            replaced(&good, "<Real unit=\"N\" start=\"0\"/>", "<Real unit=\"lbf\" start=\"0\"/>"),
        ),
        (
            "two variables of a type and reference have starts",
            Some("aliases-have-one-start"),
            local("causality=\"parameter\" variability=\"fixed\"><Real start=\"1\"/>"),
        ),
        (
            "a name is there twice",
            Some("names-are-unique"),
            replaced(&good, "name=\"velocity\"", "name=\"position\""),
        ),
        (
            "a parameter is continuous",
            Some("variability-fits-causality"),
            local("causality=\"parameter\" variability=\"continuous\"><Real start=\"1\"/>"),
        ),
        (
            "local, fixed and exact",
            Some("initial-fits-causality"),
            local(
                "causality=\"local\" variability=\"fixed\" initial=\"exact\"><Real start=\"1\"/>",
            ),
        ),
        (
            "a start is outside of the bounds",
            Some("start-is-within-bounds"),
            replaced(&good, "min=\"0.01\"", "min=\"0.9\""),
        ),
        (
            "the GUID is wrong",
            Some("instance-can-be-made"),
            replaced(&good, "guid=\"{", "guid=\"{0"),
        ),
        (
            "the modelIdentifier is wrong",
            Some("binary-is-there"),
            replaced(&good, "modelIdentifier=\"vehicle\"", "modelIdentifier=\"wagon\""),
        ),
        (
            "a name is not structured",
            Some("names-are-structured"),
            replaced(&good, "name=\"velocity\"", "name=\"v 1\""),
        ),
        (
            "the experiment stops before it starts",
            Some("experiment-goes-forward"),
            replaced(&good, "startTime=\"0\"", "startTime=\"20\""),
        ),
        (
            "an index in Outputs is 0",
            Some("indices-are-in-range"),
            replaced(&good, &format!("<Unknown {position}"), "<Unknown index=\"0\""),
        ),
        (
            "a unit is there twice",
            Some("units-are-unique"),
            replaced(&good, "<Unit name=\"N\">", "<Unit name=\"m\">"),
        ),
        (
            "a log category is there twice",
            Some("log-categories-are-unique"),
            replaced(&good, "name=\"logEvents\"", "name=\"logAll\""),
        ),
        (
            "a state can be serialized but not got",
            Some("serializing-needs-states"),
            replaced(&good, "canGetAndSetFMUstate=\"true\"", "canGetAndSetFMUstate=\"false\""),
        ),
        (
            "the independent variable has a start",
            Some("start-is-not-given"),
            added(
                &good,
                "<ScalarVariable name=\"time\" valueReference=\"9999\" causality=\"independent\" variability=\"continuous\"><Real start=\"0\"/></ScalarVariable>",
            ),
        ),
        (
            "a dependency is beyond the variables",
            Some("dependencies-are-in-range"),
            replaced(&good, "dependencies=\"\"", "dependencies=\"99999\""),
        ),
        ("there is no independent variable", None, good.clone()),
        (
            "the description is not XML",
            Some("xml-is-well-formed"),
            replaced(&good, "</ModelVariables>", ""),
        ),
    ];
    for (mutation, rule, text) in mutations {
        let mutant = copy.with(DESCRIPTION, &text);
        let findings = check(&mutant);
        std::fs::remove_file(&mutant).unwrap();
        match rule {
            None => assert!(findings.is_empty(), "{mutation}: {findings:#?}"),
            Some(rule) => {
                assert!(findings.iter().any(|f| f.rule == rule), "{mutation}: {findings:#?}")
            }
        }
    }
}

/// An FMU with some of the 34 functions, as tools load it that look up what they call.
#[test]
fn an_fmu_without_all_functions_is_told_which_it_lacks() {
    let folder = tempfile::tempdir().unwrap();
    let source = folder.path().join("few.c");
    std::fs::write(&source, "int fmi2DoStep(void) { return 0; }\n").unwrap();
    let binary = folder.path().join("vehicle.so");
    let mut compiler = std::process::Command::new("cc");
    compiler.args(["-shared", "-fPIC", "-o"]).arg(&binary).arg(&source);
    assert!(compiler.status().unwrap().success());
    let text = Copy::of("vehicle").text(DESCRIPTION);
    let fmu = folder.path().join("few.fmu");
    let library = std::fs::read(&binary).unwrap();
    let entries: [(&str, &[u8]); 2] =
        [("modelDescription.xml", text.as_bytes()), ("binaries/linux64/vehicle.so", &library)];
    archive(&fmu, &entries);
    let findings = check(&fmu);
    let own = findings.iter().find(|finding| finding.rule == "functions-are-complete").unwrap();
    assert!(own.sentence.contains("fmi2CancelStep, ") && !own.sentence.contains("fmi2DoStep,"));
}
