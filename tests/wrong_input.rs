//! Wrong files, and the whole message that `hotfoot check` answers each with: `wrong-input/cases.txt`.
//!
//! Each case changes some files of the small train in `wrong-input/base`. With `HOTFOOT_ANSWERS=print` the
//! answers of now are printed in the form of that file.

use std::fs;
use std::path::{Path, PathBuf};

use hotfoot_tests::{copy_folder, hotfoot, root};

/// A wrong input and its answer.
#[derive(Default)]
struct Case<'a> {
    /// What is wrong.
    title: &'a str,
    /// The lines that say what is changed: file, text, and what stands there instead.
    changes: Vec<&'a str>,
    /// The lines of the answer.
    answer: Vec<&'a str>,
}

/// The cases of a text: `## title`, `file: text => other text`, and lines of the answer behind `> `.
fn cases(text: &str) -> Vec<Case<'_>> {
    let mut cases: Vec<Case<'_>> = vec![];
    for line in text.lines().filter(|line| !line.is_empty() && !line.starts_with("# ")) {
        if let Some(title) = line.strip_prefix("## ") {
            cases.push(Case { title, ..Case::default() });
            continue;
        }
        let case = cases.last_mut().expect("a title comes first");
        match line.strip_prefix('>') {
            Some(answer) => case.answer.push(answer.strip_prefix(' ').unwrap_or(answer)),
            None => case.changes.push(line),
        }
    }
    cases
}

/// Where a file of the base lies in the folder of the scenario.
fn place_of(folder: &Path, name: &str) -> PathBuf {
    match name {
        "my-wagon.toml" => folder.join("stock/vehicles").join(name),
        "my-gear.toml" => folder.join("stock/draft_gears").join(name),
        name => folder.join(name),
    }
}

impl Case<'_> {
    /// The folder of its scenario.
    fn write(&self) -> tempfile::TempDir {
        let folder = tempfile::tempdir().unwrap();
        copy_folder(&root().join("stock"), &folder.path().join("stock"));
        let base = root().join("tests/wrong-input/base");
        for file in fs::read_dir(base).unwrap().flatten() {
            let name = file.file_name().into_string().unwrap();
            fs::copy(file.path(), place_of(folder.path(), &name)).unwrap();
        }
        for change in &self.changes {
            let (name, change) = change.split_once(": ").unwrap();
            let (from, to) = change.split_once(" =>").unwrap();
            let (from, to) = (lines(from), lines(to.strip_prefix(' ').unwrap_or(to)));
            let file = place_of(folder.path(), name);
            let text = fs::read_to_string(&file).unwrap();
            assert!(text.contains(&from), "{}: {name} has no {from}", self.title);
            fs::write(file, text.replacen(&from, &to, 1)).unwrap();
        }
        folder
    }

    /// What the program says of it, without the folder's name.
    fn answer(&self) -> String {
        let folder = self.write();
        let output = hotfoot(folder.path(), &["check", "scenario.toml"]);
        let said = [output.stderr, output.stdout].map(|said| String::from_utf8(said).unwrap());
        said.concat().replace(&format!("{}/", folder.path().display()), "").trim_end().to_owned()
    }
}

/// A text with `\n` as the ends of lines.
fn lines(text: &str) -> String {
    text.replace("\\n", "\n")
}

#[test]
fn every_wrong_input_is_answered_in_these_words() {
    let text = fs::read_to_string(root().join("tests/wrong-input/cases.txt")).unwrap();
    let cases = cases(&text);
    assert!(cases.len() >= 50, "{} cases", cases.len());
    let print = std::env::var_os("HOTFOOT_ANSWERS").is_some();
    let mut other = vec![];
    for case in &cases {
        let answer = case.answer();
        if print {
            let quoted: String = answer.lines().map(|line| format!("> {line}\n")).collect();
            println!("## {}\n{}\n{quoted}", case.title, case.changes.join("\n"));
        } else if answer != case.answer.join("\n") {
            other.push(format!("{}:\n{answer}\nand not\n{}", case.title, case.answer.join("\n")));
        }
    }
    assert!(other.is_empty(), "{}", other.join("\n\n"));
}
