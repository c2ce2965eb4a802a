//! FMUs as the tools of other makers write them, and what a run tells of one that it cannot use.

use std::path::Path;
use std::process::{Command, Output};

use hotfoot::recording::SeriesReader;
use hotfoot_tests::hostile::archive;
use hotfoot_tests::hotfoot;
use hotfoot_tests::probe::{self, BINARY, DESCRIPTION, Package, component};

/// The package of one probe with start values.
fn alone(values: &[(&str, f64)]) -> Package {
    Package::new(&format!("<ssd:Elements>{}</ssd:Elements>", component("a", values)), &[])
}

fn text(output: &Output) -> String {
    [&output.stdout, &output.stderr].map(|part| String::from_utf8_lossy(part)).concat()
}

/// `stop.ssp`: with a step of 0.05 s the last steps of about half of these runs end behind the stop time by
/// rounding; with the others some.
#[test]
fn the_last_step_does_not_pass_the_announced_stop_time() {
    let package = alone(&[("mode", 2.0)]);
    for (step, durations) in [("0.05", 1..=12), ("0.005", 8..=12), ("0.001", 1..=2)] {
        for duration in durations {
            let told = package.run_well(&[
                "--step",
                step,
                "--duration",
                &duration.to_string(),
                "--interval",
                "1",
            ]);
            assert!(told.contains(&format!("{duration}.0 s simulated")), "{told}");
        }
    }
}

/// It discards the step from 0.05 s by half.
#[test]
fn a_run_ends_well_where_an_fmu_wants_it_to_end_with_that_row() {
    let package = alone(&[("mode", 1.0), ("u", 2.0)]);
    let told = package.run_well(&[]);
    assert!(told.contains("the run ended at 0.055 s, because a ("), "{told}");
    let times = package.recorded("a", "time");
    assert_eq!(times.len(), 7, "{times:?}");
    assert_eq!(times[6], 0.055);
    assert_eq!(package.recorded("a", "count")[5..], [5.0, 5.0]);
}

#[test]
fn an_fmu_is_told_the_tolerance_that_it_proposes_or_another() {
    let package = alone(&[]);
    package.run_well(&[]);
    assert_eq!(package.recorded("a", "tolerance")[0], 1e-5);
    let package = alone(&[]);
    package.run_well(&["--tolerance", "1e-7"]);
    assert_eq!(package.recorded("a", "tolerance")[0], 1e-7);
}

/// An FMU, a folder and a structure's file are systems as a package is one.
#[test]
fn an_fmu_a_folder_and_a_structure_are_run_as_they_are() {
    let folder = tempfile::tempdir().unwrap();
    probe::fmu(folder.path(), "my probe.fmu", &[]);
    let run = |what: &str, results: &str| {
        let output = hotfoot(folder.path(), &["run", what, "--quiet", "--results", results]);
        assert!(output.status.success(), "{what}: {}", text(&output));
        SeriesReader::open(&folder.path().join(results).join("series"), "my_probe")
            .or_else(|_| SeriesReader::open(&folder.path().join(results).join("series"), "a"))
            .unwrap()
    };
    let times = run("my probe.fmu", "single").read("time", &[]).unwrap();
    assert_eq!((times.len(), times.last().copied()), (6, Some(0.5)), "its default experiment");
    let unpacked = folder.path().join("unpacked/resources");
    std::fs::create_dir_all(&unpacked).unwrap();
    probe::fmu(&unpacked, "probe.fmu", &[]);
    let structure = "<ssd:SystemStructureDescription name=\"s\" version=\"1.0\" \
        xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\"><ssd:System name=\"r\">\
        <ssd:Elements><ssd:Component name=\"a\" source=\"resources/probe.fmu\"/></ssd:Elements>\
        </ssd:System></ssd:SystemStructureDescription>";
    std::fs::write(folder.path().join("unpacked/SystemStructure.ssd"), structure).unwrap();
    std::fs::write(folder.path().join("unpacked/other.ssd"), structure).unwrap();
    for (what, results) in [("unpacked", "folder"), ("unpacked/other.ssd", "file")] {
        assert_eq!(run(what, results).read("y", &[]).unwrap().len(), 6);
        let wiring = hotfoot(folder.path(), &["wiring", what]);
        assert!(text(&wiring).contains("1 components"), "{}", text(&wiring));
    }
}

/// Runs and checks an FMU of these files and gives what both say.
fn run_and_check(files: &[(&str, &[u8])]) -> [(bool, String); 2] {
    let folder = tempfile::tempdir().unwrap();
    archive(&folder.path().join("x.fmu"), files);
    [&["run", "x.fmu", "--quiet"][..], &["check", "x.fmu"]].map(|arguments| {
        let output = hotfoot(folder.path(), arguments);
        (output.status.success(), text(&output))
    })
}

fn described(description: &[u8]) -> (&'static str, &[u8]) {
    ("modelDescription.xml", description)
}

#[test]
fn what_an_fmu_has_instead_of_a_binary_for_this_platform_is_told() {
    for (file, wanted) in [
        ("binaries/win64/probe.dll", "it has binaries for win64 only"),
        ("sources/probe.c", "it has sources only: compile them"),
    ] {
        let files = [described(DESCRIPTION.as_bytes()), (file, &b"x"[..])];
        let [(ran, run), (kept, check)] = run_and_check(&files);
        assert!(!ran && run.contains(wanted) && run.contains(BINARY), "{run}");
        assert!(kept && check.contains("advice") && check.contains(wanted), "{check}");
        let folder = tempfile::tempdir().unwrap();
        archive(&folder.path().join("x.fmu"), &files);
        assert!(hotfoot(folder.path(), &["interface", "x.fmu"]).status.success());
        let role = text(&hotfoot(folder.path(), &["check", "x.fmu", "--as", "vehicle"]));
        assert!(role.contains("it cannot be used as Vehicle"), "the role needs no binary: {role}");
    }
}

/// The library that is missing, as dlopen says it.
#[test]
fn the_library_that_a_binary_lacks_is_named() {
    let folder = tempfile::tempdir().unwrap();
    let compile = |source: &str, content: &str, arguments: &[&str]| {
        std::fs::write(folder.path().join(source), content).unwrap();
        let mut compiler = Command::new("cc");
        compiler.current_dir(folder.path()).args(["-shared", "-fPIC", source]).args(arguments);
        assert!(compiler.status().unwrap().success());
    };
    compile("other.c", "int other(void) { return 0; }", &["-o", "libnowhere.so"]);
    let user = "int other(void); int fmi2DoStep(void) { return other(); }";
    compile("user.c", user, &["-o", "user.so", "-L.", "-lnowhere"]);
    let binary = std::fs::read(folder.path().join("user.so")).unwrap();
    let both = run_and_check(&[described(DESCRIPTION.as_bytes()), (BINARY, &binary)]);
    for (well, said) in both {
        assert!(!well && said.contains("libnowhere.so: cannot open shared object file"), "{said}");
        assert!(!said.contains("dlopen failed"), "nothing more than that: {said}");
    }
}

#[test]
fn an_fmu_with_backslashes_and_in_another_encoding_is_read() {
    let latin =
        DESCRIPTION.replace("UTF-8", "ISO-8859-1").replace("\"probe\" guid", "\"Züge\" guid");
    let latin: Vec<u8> = latin.chars().map(|c| c as u8).collect();
    let utf_16 = DESCRIPTION.replace("UTF-8", "UTF-16");
    let utf_16: Vec<u8> =
        format!("\u{feff}{utf_16}").encode_utf16().flat_map(u16::to_le_bytes).collect();
    for (description, binary) in [
        (DESCRIPTION.as_bytes(), "binaries\\linux64\\probe.so"),
        (&latin, BINARY),
        (&utf_16, BINARY),
    ] {
        for (well, said) in run_and_check(&[described(description), (binary, probe::binary())]) {
            assert!(well, "{said}");
        }
    }
}

#[test]
fn a_package_in_another_encoding_is_read() {
    let folder = tempfile::tempdir().unwrap();
    let structure = "<?xml version=\"1.0\" encoding=\"windows-1252\"?>\n\
        <ssd:SystemStructureDescription name=\"Züge\" version=\"1.0\" \
        xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\"><ssd:System name=\"r\">\
        <ssd:Elements><ssd:Component name=\"Fähre\" source=\"p.fmu\"/></ssd:Elements></ssd:System>\
        </ssd:SystemStructureDescription>";
    let structure: Vec<u8> = structure.chars().map(|c| c as u8).collect();
    let probe = std::fs::read(probe::fmu(folder.path(), "p.fmu", &[])).unwrap();
    archive(
        &folder.path().join("s.ssp"),
        &[("SystemStructure.ssd", structure.as_slice()), ("p.fmu", &probe)],
    );
    let output = hotfoot(folder.path(), &["run", "s.ssp", "--quiet", "--results", "r"]);
    assert!(text(&output).contains("Züge: 0.5 s simulated"), "{}", text(&output));
    assert!(folder.path().join("r/series/Fähre.parquet").exists());
}

#[test]
fn an_fmu_without_outputs_is_told_that_nothing_is_recorded() {
    let outputs =
        DESCRIPTION.find("<Outputs>").unwrap()..DESCRIPTION.find("</ModelStructure>").unwrap();
    let mut description = DESCRIPTION.to_owned();
    description.replace_range(outputs, "");
    let description = description.replace("causality=\"output\"", "causality=\"local\"");
    let [(ran, said), _] =
        run_and_check(&[described(description.as_bytes()), (BINARY, probe::binary())]);
    assert!(
        ran && said.contains("has no outputs that are numbers: nothing of it is recorded"),
        "{said}"
    );
}

/// Inputs and outputs of all types, and an FMU that ends itself, in the form of the Reference FMUs.
#[test]
fn a_replay_compares_all_types_and_ends_where_the_fmu_does() {
    let folder = "extra/org.fmi-standard.fmi-ls-ref/";
    let path = |name: &str| format!("{folder}{name}");
    let manifest = "<?xml version=\"1.0\"?><fmiReferences>\
        <Related source=\"in.csv\" role=\"input\"/><Related source=\"out.csv\" role=\"result\"/>\
        </fmiReferences>";
    let inputs = "time,u,choice_in,flag_in,text_in\n0,0,1,false,a\n0.02,4,2,true,\"b, c\"\n";
    let rows = |changed: (&str, &str)| {
        let rows = "time,y,count,choice,flag,text,Binary_output\n0,0,0,1,false,a,666f6f\n\
            0.01,0,1,1,false,a,666f6f\n0.02,2,2,1,false,a,666f6f\n0.03,4,3,2,true,\"b, c\",666f6f\n";
        rows.replacen(changed.0, changed.1, 1)
    };
    let replay = |description: &str, inputs: &str, result: &str| {
        let place = tempfile::tempdir().unwrap();
        let (manifest_file, inputs_file, result_file) =
            (path("fmi-ls-manifest.xml"), path("in.csv"), path("out.csv"));
        let files: [(&str, &[u8]); 5] = [
            described(description.as_bytes()),
            (BINARY, probe::binary()),
            (&manifest_file, manifest.as_bytes()),
            (&inputs_file, inputs.as_bytes()),
            (&result_file, result.as_bytes()),
        ];
        archive(&place.path().join("x.fmu"), &files);
        let output = hotfoot(place.path(), &["check", "x.fmu", "--replay"]);
        (output.status.success(), text(&output))
    };
    let (well, said) = replay(DESCRIPTION, inputs, &rows(("", "")));
    assert!(well && said.contains("5 signals over 0.03 s (4 rows)"), "{said}");
    assert!(
        said.contains("not compared, as the FMU has no such variables: Binary_output"),
        "{said}"
    );
    for (from, to, wanted) in [
        ("0.02,2,", "0.02,2.5,", "`y` is 2 at 0.02 s, but was 2.5"),
        ("0.02,2,2,", "0.02,2,3,", "`count` is 2 at 0.02 s, but was 3"),
        ("0.02,2,2,1,", "0.02,2,2,2,", "`choice` is 1 at 0.02 s, but was 2"),
        ("4,3,2,true", "4,3,2,false", "`flag` is true at 0.03 s, but was false"),
        ("\"b, c\"", "b", "`text` is b, c at 0.03 s, but was b"),
    ] {
        let (well, said) = replay(DESCRIPTION, inputs, &rows((from, to)));
        assert!(!well && said.contains(wanted), "{wanted}: {said}");
    }
}

/// The start value of the description does not reach a binary; a parameter does not stand in a reference
/// result. So the FMU that ends itself is one whose binary begins with that mode.
#[test]
fn a_replay_of_an_fmu_that_ends_itself_ends_with_its_last_row() {
    let place = tempfile::tempdir().unwrap();
    let source =
        std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("probe/probe.c"));
    let source = source
        .unwrap()
        .replace("probe->reals[2] = 1;", "probe->reals[2] = 1; probe->integers[0] = 1;");
    std::fs::write(place.path().join("probe.c"), source).unwrap();
    let mut compiler = Command::new("cc");
    compiler.current_dir(place.path()).args(["-shared", "-fPIC", "-w", "-o", "p.so", "probe.c"]);
    assert!(compiler.status().unwrap().success());
    let binary = std::fs::read(place.path().join("p.so")).unwrap();
    let manifest = "<fmiReferences><Related source=\"out.csv\" role=\"result\"/></fmiReferences>";
    let folder = "extra/org.fmi-standard.fmi-ls-ref";
    let replay = |result: &str| {
        let names = [format!("{folder}/fmi-ls-manifest.xml"), format!("{folder}/out.csv")];
        let files: [(&str, &[u8]); 4] = [
            described(DESCRIPTION.as_bytes()),
            (BINARY, &binary),
            (&names[0], manifest.as_bytes()),
            (&names[1], result.as_bytes()),
        ];
        archive(&place.path().join("x.fmu"), &files);
        let output = hotfoot(place.path(), &["check", "x.fmu", "--replay"]);
        (output.status.success(), text(&output))
    };
    let rows = "time,count\n0,0\n0.02,2\n0.04,4\n";
    let (well, said) = replay(&format!("{rows}0.055,5\n"));
    assert!(well && said.contains("1 signals over 0.055 s (4 rows)"), "{said}");
    let (well, said) = replay(&format!("{rows}0.06,6\n0.08,8\n"));
    let wanted =
        "after 3 rows the run goes on at 0.055 s, but the reference result goes on at 0.06 s";
    assert!(!well && said.contains(wanted), "{said}");
}
