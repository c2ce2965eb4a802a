//! `hotfoot check`: our FMUs break no rule and give their reference result; what is wrong with an
//! archive, its terminals or its binary is found. The rules of modelDescription.xml have their tests
//! in `mutations.rs` and in `master/src/check/tests.rs`.

use std::path::{Path, PathBuf};

use hotfoot::check::{Finding, Severity, check};
use hotfoot_tests::fmu_copy::FmuCopy;
use hotfoot_tests::hostile::{Claims, archive, hostile_vehicle};
use hotfoot_tests::{fmu, hotfoot};

const DESCRIPTION: &str = "modelDescription.xml";

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

/// Every link of the documentation that an FMU carries leads to a place of the page, or to the web.
#[test]
fn links_in_the_packed_equations_lead_somewhere() {
    for model in ["vehicle", "longitudinal", "railheat", "synchronisation"] {
        let page = FmuCopy::of(model).text("documentation/equations.html");
        for link in page.split("href=\"").skip(1) {
            let link = link.split('"').next().unwrap();
            let place = link.strip_prefix('#').map(|id| format!("id=\"{id}\""));
            let leads = place.map_or(link.starts_with("https://"), |place| page.contains(&place));
            assert!(leads, "{model}: the link {link} leads nowhere");
        }
    }
}

/// A result that is not that of the FMU is noticed, with signal, time and difference.
#[test]
fn another_reference_result_is_noticed() {
    const RESULT: &str = "extra/org.fmi-standard.fmi-ls-ref/ref.csv";
    let copy = FmuCopy::of("vehicle");
    let text = copy.text(RESULT);
    let (lines, last) = text.trim_end().rsplit_once('\n').unwrap();
    let (time, rest) = last.split_once(',').unwrap();
    let (position, rest) = rest.split_once(',').unwrap();
    // The first signal is the position, some 16 m.
    let position = position.parse::<f64>().unwrap() + 1e-6;
    let result = format!("{lines}\n{time},{position},{rest}\n");
    let replay =
        |fmu: &Path| hotfoot(Path::new("."), &["check", fmu.to_str().unwrap(), "--replay"]);
    let output = copy.with(RESULT, &result, replay);
    assert!(!output.status.success());
    let message = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(message.contains("`position` is") && message.contains("at 1 s, but was"), "{message}");
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
    let text = FmuCopy::of("vehicle").text(DESCRIPTION);
    let fmu = folder.path().join("few.fmu");
    let library = std::fs::read(&binary).unwrap();
    let entries: [(&str, &[u8]); 2] =
        [("modelDescription.xml", text.as_bytes()), ("binaries/linux64/vehicle.so", &library)];
    archive(&fmu, &entries);
    let findings = check(&fmu);
    let own = findings.iter().find(|finding| finding.rule == "functions-are-complete").unwrap();
    assert!(own.sentence.contains("fmi2CancelStep, ") && !own.sentence.contains("fmi2DoStep,"));
}

/// The one finding of a check, with this rule.
fn only(findings: &[Finding], rule: &str) -> String {
    assert_eq!(findings.iter().map(|f| f.rule).collect::<Vec<_>>(), [rule], "{findings:#?}");
    findings[0].sentence.clone()
}

/// An FMU whose description is good, with a binary at this place.
fn with_binary(folder: &Path, place: &str, binary: &[u8]) -> PathBuf {
    hostile_vehicle(folder, "WELL", &Claims::default());
    let file = std::fs::File::open(folder.join("hostile.fmu")).unwrap();
    zip::ZipArchive::new(file).unwrap().extract(folder).unwrap();
    let text = std::fs::read(folder.join(DESCRIPTION)).unwrap();
    let fmu = folder.join("other.fmu");
    archive(&fmu, &[(DESCRIPTION, text.as_slice()), (place, binary)]);
    fmu
}

#[test]
fn a_good_fmu_of_another_maker_breaks_no_rule() {
    let folder = tempfile::tempdir().unwrap();
    let findings = check(&hostile_vehicle(folder.path(), "WELL", &Claims::default()));
    assert!(findings.is_empty(), "{findings:#?}");
}

#[test]
fn a_file_that_is_no_archive_or_has_no_description_is_told_apart() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.fmu");
    std::fs::write(&file, "no archive").unwrap();
    only(&check(&file), "archive-can-be-unpacked");
    archive(&file, &[("model.png", b"x")]);
    only(&check(&file), "description-is-there");
}

/// The method in both headers of an entry is changed from 0, stored, to 12, bzip2.
#[test]
fn an_archive_packed_in_another_way_is_found() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("x.fmu");
    let stored =
        zip::write::SimpleFileOptions::default().compression_method(zip::CompressionMethod::Stored);
    let mut zip = zip::ZipWriter::new(std::fs::File::create(&file).unwrap());
    zip.start_file("x", stored).unwrap();
    zip.finish().unwrap();
    let mut bytes = std::fs::read(&file).unwrap();
    let directory = bytes.windows(4).position(|mark| mark == b"PK\x01\x02").unwrap();
    // Local header: method at 8; directory: at 10.
    bytes[8] = 12;
    bytes[directory + 10] = 12;
    std::fs::write(&file, bytes).unwrap();
    let findings = check(&file);
    assert_eq!(findings[0].rule, "archive-is-stored-or-deflated", "{findings:#?}");
}

#[test]
fn a_terminal_with_an_unknown_variable_is_found() {
    const TERMINALS: &str = "terminalsAndIcons/terminalsAndIcons.xml";
    let copy = FmuCopy::of("vehicle");
    let text = copy.text(TERMINALS);
    let member = "variableName=\"coupler.front.force\"";
    assert!(text.contains(member), "{text}");
    let other = text.replacen(member, "variableName=\"coupler\"", 1);
    let findings = copy.with(TERMINALS, &other, check);
    assert!(only(&findings, "terminals-name-variables").contains("no variable `coupler`"));
    only(&copy.with(TERMINALS, "<fmiTerminalsAndIcons>", check), "terminals-are-xml");
}

#[test]
fn a_binary_that_cannot_be_used_is_told_why() {
    let folder = tempfile::tempdir().unwrap();
    let broken = with_binary(folder.path(), "binaries/linux64/hostile.so", b"no library");
    only(&check(&broken), "binary-can-be-loaded");
    let foreign = with_binary(folder.path(), "binaries/win64/hostile.dll", b"x");
    let findings = check(&foreign);
    assert!(only(&findings, "binary-is-for-this-platform").contains("win64"));
    assert_eq!(findings[0].severity, Severity::Advice);
    let older = hostile_vehicle(folder.path(), "OTHER_VERSION", &Claims::default());
    assert!(only(&check(&older), "binary-is-of-fmi-2.0").contains("\"1.0\""));
}
