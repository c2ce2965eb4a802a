//! What the documents say stands: one licence everywhere, and a vocabulary of names that exist.

use std::collections::BTreeSet;
use std::io::Read;
use std::path::{Path, PathBuf};

use hotfoot_tests::{fmu, root};

/// The licence of all that is ours.
const LICENSE: &str = "MIT OR Apache-2.0";

const MODELS: [&str; 4] = ["longitudinal", "vehicle", "railheat", "synchronisation"];

fn text(path: &str) -> String {
    std::fs::read_to_string(root().join(path)).unwrap_or_else(|e| panic!("{path}: {e}"))
}

/// Files of a name or ending below the root, but for what is built and what is run.
fn files(folder: &Path, wanted: &dyn Fn(&Path) -> bool, found: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        match path.is_dir() {
            true if name.starts_with('.') || name == "target" || name == "results" => {}
            true => files(&path, wanted, found),
            false if wanted(&path) => found.push(path),
            false => {}
        }
    }
}

#[test]
fn every_manifest_states_the_one_licence() {
    let workspace: toml::Table = text("Cargo.toml").parse().unwrap();
    assert_eq!(workspace["workspace"]["package"]["license"].as_str(), Some(LICENSE));
    let mut manifests = vec![];
    files(root(), &|path| path.ends_with("Cargo.toml"), &mut manifests);
    for manifest in manifests {
        let table: toml::Table = std::fs::read_to_string(&manifest).unwrap().parse().unwrap();
        let Some(package) = table.get("package") else { continue };
        let license = package.get("license").unwrap_or_else(|| panic!("{manifest:?}: no license"));
        let inherited = license.get("workspace").and_then(toml::Value::as_bool) == Some(true);
        assert!(inherited || license.as_str() == Some(LICENSE), "{manifest:?}: {license}");
    }
}

#[test]
fn readme_citation_and_model_descriptions_agree_with_it() {
    for (path, parts) in [
        ("README.md", ["[LICENSE-MIT]", "[LICENSE-APACHE]"]),
        ("CITATION.cff", ["- MIT\n", "- Apache-2.0\n"]),
        ("master/assets/license.txt", ["LICENSE-MIT", "LICENSE-APACHE"]),
    ] {
        for part in parts {
            assert!(text(path).contains(part), "{path} does not name {part}");
        }
    }
    for model in MODELS {
        let description = text(&format!("modelDescription/{model}.xml"));
        assert!(description.contains(&format!("license=\"{LICENSE}\"")), "{model}.xml");
    }
}

#[test]
fn packed_fmus_hold_both_texts() {
    for model in MODELS {
        let mut archive = zip::ZipArchive::new(std::fs::File::open(fmu(model)).unwrap()).unwrap();
        for name in ["LICENSE-MIT", "LICENSE-APACHE"] {
            let mut packed = String::new();
            let path = format!("documentation/licenses/{name}");
            archive.by_name(&path).unwrap().read_to_string(&mut packed).unwrap();
            assert_eq!(packed, text(name), "{model}: {path}");
        }
    }
}

/// Cells of the vocabulary's tables in the column of this head, what stands in backticks.
fn named(column: &str) -> BTreeSet<String> {
    let page = text("docs/vocabulary.md");
    let mut index = None;
    let mut names = BTreeSet::new();
    for line in page.lines().map(str::trim) {
        let Some(row) = line.strip_prefix('|').and_then(|line| line.strip_suffix('|')) else {
            index = None;
            continue;
        };
        let cells: Vec<&str> = row.split('|').map(str::trim).collect();
        match index {
            None => index = cells.iter().position(|cell| *cell == column),
            Some(index) => {
                let cell: &str = cells.get(index).unwrap_or_else(|| panic!("cut off: {line}"));
                names.extend(cell.split('`').skip(1).step_by(2).map(str::to_owned));
            }
        }
    }
    assert!(names.len() > 50, "{} names of {column}", names.len());
    names
}

#[test]
fn the_vocabulary_names_variables_that_the_fmus_have() {
    let published: String = MODELS.map(|m| text(&format!("modelDescription/{m}.xml"))).concat();
    for name in named("FMI name") {
        // A terminal of the vocabulary stands for all that begins with it.
        let name = name.replace("[i]", "[1]").replace("[j]", "[1]").replace("[k]", "[1]");
        let name = name.replace(".s.", ".left.");
        let (whole, begin) = (format!("name=\"{name}\""), format!("name=\"{name}."));
        assert!(published.contains(&whole) || published.contains(&begin), "no variable {name}");
    }
}

#[test]
fn the_vocabulary_names_what_stands_in_the_code() {
    let mut sources = vec![];
    for folder in ["crates", "fmus", "master"] {
        files(
            &root().join(folder),
            &|path| path.extension().is_some_and(|e| e == "rs"),
            &mut sources,
        );
    }
    let is_letter = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = BTreeSet::new();
    for file in sources {
        let source = std::fs::read_to_string(file).unwrap();
        let code = source.lines().filter(|line| !line.trim_start().starts_with("//"));
        words.extend(code.flat_map(|line| line.split(|c| !is_letter(c)).map(str::to_owned)));
    }
    for name in named("name in code") {
        assert!(words.contains(&name), "docs/vocabulary.md: no {name} in the code");
    }
}

#[test]
fn each_equation_is_listed_with_tests_that_exist() {
    let (mut pages, mut sources) = (vec![], vec![]);
    files(
        &root().join("docs/theory"),
        &|path| path.extension().is_some_and(|e| e == "md"),
        &mut pages,
    );
    for folder in ["crates", "fmus"] {
        files(
            &root().join(folder),
            &|path| path.extension().is_some_and(|e| e == "rs"),
            &mut sources,
        );
    }
    let list = text("docs/validation/equations.md");
    for page in pages {
        let path = page.strip_prefix(root().join("docs")).unwrap().display();
        for anchor in std::fs::read_to_string(&page).unwrap().split("<a id=\"").skip(1) {
            let link = format!("(../{path}#{})", anchor.split('"').next().unwrap());
            assert!(list.contains(&link), "docs/validation/equations.md lacks {link}");
        }
    }
    let code: String = sources.iter().map(|file| std::fs::read_to_string(file).unwrap()).collect();
    for name in list.split('`').skip(1).step_by(2).filter(|name| name.contains('_')) {
        let function = format!("fn {name}(");
        assert!(code.contains(&function), "docs/validation/equations.md: no test {name}");
    }
}

#[test]
fn every_link_between_pages_leads_to_a_file() {
    let mut pages = vec![];
    files(root(), &|path| path.extension().is_some_and(|e| e == "md"), &mut pages);
    assert!(pages.len() > 50, "{} pages", pages.len());
    for page in pages {
        let markdown = std::fs::read_to_string(&page).unwrap();
        for link in markdown.split("](").skip(1).filter_map(|rest| rest.split(')').next()) {
            let file = link.split('#').next().unwrap();
            let elsewhere = file.contains("://") || file.contains(' ') || file.is_empty();
            assert!(elsewhere || page.with_file_name(file).exists(), "{page:?} links to {link}");
        }
    }
}

/// Paths in backticks, from the repository's root or beside the page; `NAME` and `*` stand for what a reader has.
#[test]
fn every_path_that_a_page_names_exists() {
    const ROOMS: [&str; 10] = [
        "cli",
        "crates",
        "docs",
        "examples",
        "fmus",
        "master",
        "python",
        "scenarios",
        "stock",
        "xtask",
    ];
    let mut pages = vec![];
    files(root(), &|path| path.extension().is_some_and(|e| e == "md"), &mut pages);
    let mut wrong = vec![];
    for page in pages {
        let markdown = std::fs::read_to_string(&page).unwrap();
        for name in markdown.split('`').skip(1).step_by(2) {
            let is_path = name.split_once('/').is_some_and(|(room, _)| ROOMS.contains(&room));
            let is_whole =
                !name.contains([' ', '*', '<', '{', '\n', ':']) && !name.contains("NAME");
            if is_path
                && is_whole
                && !(root().join(name).exists() || page.with_file_name(name).exists())
            {
                wrong.push(format!("{}: {name}", page.display()));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
