//! Runs that go on from a checkpoint: they give the bytes of a run that was never interrupted, wherever it
//! was killed and on any number of threads.

use std::fs;
use std::path::Path;
use std::process::{Output, Stdio};
use std::time::Instant;

use hotfoot_tests::hostile::{Claims, hostile_vehicle};
use hotfoot_tests::killed::{contents, interrupt_at, kill_at, newest};
use hotfoot_tests::{SmallScenario, command, hotfoot};

use crate::ends::kills::kills;
use crate::ends::{is_running, wait_until};

/// Weather of a file, which lies in the FMU's resources while the run goes on.
const WEATHER: &str =
    "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg
0,12.5,1.0,0,30,10,80
3600,13.0,1.5,120,30,12,90
";

/// Two vehicles of one type on a rail of 60 m for 2 s, then a further train and a rest of 30 s; 60 s in all.
fn heating() -> SmallScenario {
    let keys = "rail = \"both\"\nfield_interval_s = 0.5\ncool_down_minutes = 0.5\ncool_down_step_s = 2.0\n\
                trains = { count = 2, headway_minutes = 0.5 }\nprobe = [{ chainage_m = 30.0 }]";
    let weather = "weather_file = \"weather.csv\"";
    let mut scenario = SmallScenario::heating_a_short_rail(2.0, keys, weather);
    scenario.text = scenario.text.replace("wagon-coco-134t-unpowered", "locomotive-coco-134t");
    fs::write(scenario.folder.path().join("weather.csv"), WEATHER).unwrap();
    scenario.write();
    scenario
}

/// Runs a scenario or package into the folder `unbroken`.
fn unbroken(folder: &Path, what: &str) {
    let run = hotfoot(folder, &["run", what, "--quiet", "--results", "unbroken"]);
    assert!(run.status.success(), "{}", said(&run));
}

/// The words of a run of `what` into a folder, with a checkpoint every so many seconds.
fn ordered<'a>(what: &'a str, results: &'a str, checkpoint: &'a str) -> Vec<&'a str> {
    vec!["run", what, "--quiet", "--results", results, "--checkpoint", checkpoint]
}

fn said(output: &Output) -> String {
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    text.replace(['│', '×'], " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

/// Goes on with a run, which must succeed, and gives what it says.
fn resume(folder: &Path, results: &str, threads: &str) -> String {
    let arguments = ["run", "--resume", results, "--quiet", "--threads", threads];
    let output = hotfoot(folder, &arguments);
    assert!(output.status.success(), "{}", said(&output));
    assert!(
        !folder.join(results).join("checkpoint").exists(),
        "a run that has ended has no checkpoints"
    );
    said(&output)
}

fn assert_same(folder: &Path, results: &str) {
    let (unbroken, resumed) = (contents(&folder.join("unbroken")), contents(&folder.join(results)));
    let names =
        |files: &std::collections::BTreeMap<_, _>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&unbroken), names(&resumed), "{results}");
    for (name, bytes) in &unbroken {
        assert!(resumed[name] == *bytes, "{results}: {} differs", name.display());
    }
}

/// Before the first checkpoint, in the run, while the rails are alone, under a further train, and in the rest:
/// a checkpoint every 0.4 s, where steps are longer every step.
#[test]
fn property_a_killed_run_goes_on_byte_for_byte() {
    let scenario = heating();
    let folder = scenario.folder.path();
    unbroken(folder, "scenario.toml");
    for (results, number, threads, from) in [
        ("early", 0, "2", "begins anew"),
        ("run", 3, "1", "goes on from 1."),
        ("alone", 9, "3", "goes on from "),
        ("train", 21, "2", "goes on from 3"),
        ("rest", 32, "1", "goes on from "),
    ] {
        kill_at(folder, &ordered("scenario.toml", results, "0.4"), results, number);
        let said = resume(folder, results, threads);
        assert!(said.contains(from), "{from} in {said}");
        assert_same(folder, results);
    }
}

/// All in processes of their own, which the resumed run has too: the same bytes as in the process of the run.
#[test]
fn property_a_killed_run_of_isolated_fmus_goes_on_byte_for_byte() {
    let scenario = heating();
    let folder = scenario.folder.path();
    unbroken(folder, "scenario.toml");
    for (results, number, threads) in [("run", 3, "1"), ("train", 21, "2")] {
        let order = [ordered("scenario.toml", results, "0.4"), vec!["--isolate", "all"]].concat();
        kill_at(folder, &order, results, number);
        let said = resume(folder, results, threads);
        assert!(said.contains("goes on from "), "{said}");
        assert_same(folder, results);
    }
}

/// Whichever processes are killed, and whenever: what has begun goes on, and nothing is left when it has ended.
#[test]
fn property_a_run_killed_at_any_moment_goes_on_byte_for_byte() {
    let scenario = heating();
    let folder = scenario.folder.path();
    let begin = Instant::now();
    unbroken(folder, "scenario.toml");
    let (mut count, mut resumed) = (0, 0);
    // The moments spread over some two checkpoints behind one of them.
    for (kill, (who, moment)) in kills(begin.elapsed() / 20).enumerate() {
        count += 1;
        let results = format!("killed-{kill}");
        let mut run = command(folder, &ordered("scenario.toml", &results, "0.4"));
        let mut run = run.stdout(Stdio::null()).stderr(Stdio::null()).spawn().unwrap();
        let checkpoints = folder.join(&results).join("checkpoint");
        let (order, behind) = (checkpoints.join("run.toml"), kill as u64 * 7 % 31);
        wait_until("a checkpoint", || {
            newest(&checkpoints) >= Some(behind) || !is_running(run.id())
        });
        std::thread::sleep(moment);
        let series = folder.join(&results).join("series");
        let (has_begun, _) = who.kill(&mut run, || series.exists());
        if order.exists() {
            resume(folder, &results, ["1", "2", "3"][kill % 3]);
            resumed += 1;
        } else if !series.exists() {
            assert!(!has_begun, "{who:?} killed after {moment:?}: what was recorded has gone");
            continue;
        }
        assert_same(folder, &results);
        fs::remove_dir_all(folder.join(&results)).unwrap();
    }
    assert!(2 * resumed > count, "most kills come in the run, and not {resumed} of {count}");
}

/// In the run, and in what follows it: stopped by Ctrl-C, a run writes a checkpoint of its own at the step that
/// it has come to, and keeps it though its results are complete; from there it goes on.
#[test]
fn property_an_interrupted_run_goes_on_byte_for_byte() {
    let scenario = heating();
    let folder = scenario.folder.path();
    unbroken(folder, "scenario.toml");
    for (results, number, threads) in [("run", 2, "1"), ("alone", 9, "2"), ("train", 21, "2")] {
        let code = interrupt_at(folder, &ordered("scenario.toml", results, "0.4"), results, number);
        assert_eq!(code, Some(130));
        let manifest = fs::read_to_string(folder.join(results).join("manifest.toml")).unwrap();
        assert!(manifest.contains("end = \"interrupted\""), "{manifest}");
        let stopped = manifest.split_once("SIGINT) at ").unwrap().1;
        let stopped = stopped.split_once(" s").unwrap().0;
        let said = resume(folder, results, threads);
        assert!(said.contains(&format!("goes on from {stopped} s")), "{stopped} in {said}");
        assert_same(folder, results);
    }
}

/// The tables of a killed run may have been completed; a damaged checkpoint is passed over; what differs from
/// the run's beginning is named, and so is a run that has ended.
#[test]
fn a_run_goes_on_from_a_whole_checkpoint_and_as_it_was_or_not_at_all() {
    let scenario = heating();
    let folder = scenario.folder.path();
    unbroken(folder, "scenario.toml");
    kill_at(folder, &ordered("scenario.toml", "killed", "0.4"), "killed", 4);

    let refuse = |parts: &[&str]| {
        let output = hotfoot(folder, &["run", "--resume", "killed", "--quiet"]);
        let said = said(&output);
        assert!(!output.status.success(), "{said}");
        for part in parts {
            assert!(said.contains(part), "{part} in {said}");
        }
    };
    let file = folder.join("track.toml");
    fs::write(&file, format!("{}# longer", scenario.track)).unwrap();
    refuse(&["track.toml is not what it was when the run began", "put it back"]);
    fs::write(&file, &scenario.track).unwrap();
    fs::rename(folder.join("killed"), folder.join("moved")).unwrap();
    let output = hotfoot(folder, &["run", "--resume", "moved"]);
    assert!(said(&output).contains("move it back"), "{}", said(&output));
    fs::rename(folder.join("moved"), folder.join("killed")).unwrap();

    let report = hotfoot(folder, &["report", "killed"]);
    assert!(report.status.success(), "{}", said(&report));
    let newest = fs::read_dir(folder.join("killed/checkpoint")).unwrap();
    let newest = newest.map(|entry| entry.unwrap().path());
    let newest = newest.filter(|path| path.extension().is_some_and(|ending| ending == "state"));
    let newest = newest.max().unwrap();
    let mut bytes = fs::read(&newest).unwrap();
    let middle = bytes.len() / 2;
    bytes[middle] ^= 1;
    fs::write(&newest, bytes).unwrap();
    let said = resume(folder, "killed", "2");
    let name = newest.file_name().unwrap().to_string_lossy().into_owned();
    assert!(said.contains(&format!("{name} is not taken: it is damaged")), "{said}");
    assert!(said.contains("the run goes on from "), "{said}");
    assert_same(folder, "killed");
    refuse(&["there is nothing to go on with", "when it has come to its end"]);
}

#[test]
fn property_a_train_alone_goes_on_byte_for_byte() {
    let mut scenario = SmallScenario::new(40.0);
    scenario.leave_out_heat();
    scenario.text = scenario.text.replace("step_s = 0.001", "step_s = 0.001\ntrain_alone = true");
    scenario.text += "[record]\ncheckpoint_s = 2.5\n";
    scenario.write();
    let folder = scenario.folder.path();
    unbroken(folder, "scenario.toml");
    let run = ["run", "scenario.toml", "--quiet", "--results", "killed"];
    kill_at(folder, &run, "killed", 5);
    resume(folder, "killed", "1");
    assert_same(folder, "killed");
}

/// A package, its folder, and its structure alone, each with options that the resumed run has too.
#[test]
fn property_a_package_goes_on_byte_for_byte() {
    let scenario = heating();
    let folder = scenario.folder.path();
    let exported = scenario.hotfoot(&["export-ssp", "scenario.toml", "-o", "train.ssp"]);
    assert!(exported.status.success(), "{}", said(&exported));
    let package = fs::File::open(folder.join("train.ssp")).unwrap();
    zip::ZipArchive::new(package).unwrap().extract(folder.join("train")).unwrap();
    for (what, options) in [
        ("train.ssp", &[][..]),
        ("train", &["--tolerance", "1e-5", "--checks", "warn"]),
        ("train/SystemStructure.ssd", &["--same-thread"]),
    ] {
        let run = ["run", what, "--quiet", "--overwrite", "--results", "unbroken"];
        let run = hotfoot(folder, &[&run, options].concat());
        assert!(run.status.success(), "{}", said(&run));
        let ordered = [&ordered(what, "killed", "0.3"), options].concat();
        kill_at(folder, &ordered, "killed", 4);
        resume(folder, "killed", "3");
        assert_same(folder, "killed");
        fs::remove_dir_all(folder.join("killed")).unwrap();
    }
}

/// An FMU that cannot save its state is named at the start; the run goes on to its end without checkpoints.
#[test]
fn fmus_without_states_are_named_and_no_checkpoints_are_written() {
    let mut scenario = SmallScenario::new(0.1);
    hostile_vehicle(scenario.folder.path(), "WELL", &Claims::default());
    scenario.text += "\n[record]\ninterval_s = 0.01\ncheckpoint_s = 0.02\n\
                      [fmus]\nvehicle_at = [{ vehicle = 2, file = \"hostile.fmu\" }]\n";
    let output = scenario.run(&[]);
    let said = said(&output);
    assert!(output.status.success(), "{said}");
    for part in ["no checkpoints are written", "hostile.fmu cannot save its state"] {
        assert!(said.contains(part), "{part} in {said}");
    }
    let report = fs::read_to_string(scenario.results().join("report.html")).unwrap();
    assert!(report.contains("no checkpoints are written"));
    assert!(!scenario.results().join("checkpoint").exists());
}
