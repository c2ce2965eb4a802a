//! Every shipped scenario runs: its first half second, so that the whole of it fits into the test run.

use hotfoot_tests::{hotfoot, root};

#[test]
fn every_shipped_scenario_starts_and_runs() {
    let folders = ["scenarios", "scenarios/benchmarks"].map(|folder| root().join(folder));
    let entries = folders.into_iter().flat_map(|folder| std::fs::read_dir(folder).unwrap());
    let scenarios = entries.flatten().map(|entry| entry.path().join("scenario.toml"));
    let mut count = 0;
    for scenario in scenarios.filter(|file| file.exists()) {
        let folder = tempfile::tempdir().unwrap();
        let results = folder.path().join("results");
        let arguments = [
            "run",
            scenario.to_str().unwrap(),
            "--duration",
            "0.5",
            "--quiet",
            "--results",
            results.to_str().unwrap(),
        ];
        let output = hotfoot(root(), &arguments);
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{}: {text}", scenario.display());
        assert!(results.join("report.html").exists(), "{}", scenario.display());
        count += 1;
    }
    assert!(count >= 5, "only {count} scenarios were found");
}
