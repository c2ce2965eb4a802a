//! The book: the pages of `docs/SUMMARY.md` as a site in `target/book/html`.
//!
//! mdBook takes pages from one folder, while ours link to files all over the repository, and to `README.md`, whose
//! pages it calls `index.html`. So it is given a copy in which both are so. The pages of `tables.rs`, which the
//! program itself knows best, are made for it.

mod tables;

use std::path::{Component, Path, PathBuf};
use std::process::Command;

use anyhow::{Context, Result};

use crate::shell::{cargo, output, run, target};

/// The version of mdBook, which is installed in `target/tools`.
const MDBOOK: &str = "0.5.4";

/// The page that the book begins with; it stands at the root of the site.
const FIRST_PAGE: &str = "docs/introduction.md";

/// The line of the summary behind which the pages of tables stand.
const BEFORE_TABLES: &str = "  - [The files of a train](docs/user-guide/train-files.md)\n";

/// The pages of tables in the summary.
const TABLES: &str = "  - [Keys of all files](docs/user-guide/keys.md)\n  - [Signals of the models](docs/user-guide/signals.md)\n";

/// Builds the book and gives its folder.
pub fn build() -> Result<PathBuf> {
    let mdbook = mdbook()?;
    let folder = std::path::absolute(target())?.join("book");
    let source = folder.join("source");
    if source.exists() {
        std::fs::remove_dir_all(&source)?;
    }
    let tracked = output(
        Command::new("git")
            .args(["ls-files", "-z", "--cached", "--others"])
            .arg("--exclude-standard"),
    )?;
    for file in tracked.split_terminator('\0').map(Path::new).filter(|file| file.exists()) {
        copy(file, &source)?;
    }
    tables::write(&source.join("docs/user-guide"))?;
    std::fs::copy("book.toml", folder.join("book.toml"))?;
    let html = folder.join("html");
    run(Command::new(mdbook).arg("build").arg("--dest-dir").arg(&html).arg(&folder))?;
    Ok(html)
}

/// The program mdBook; installs it if it is not there.
fn mdbook() -> Result<PathBuf> {
    let tools = std::path::absolute(target())?.join("tools");
    let program = tools.join("bin/mdbook");
    let version = output(Command::new(&program).arg("--version")).unwrap_or_default();
    if !version.contains(MDBOOK) {
        let version = ["install", "mdbook", "--version", MDBOOK, "--locked", "--debug"];
        let library = ["--no-default-features", "--features", "search", "--force", "--quiet"];
        let mut install = cargo();
        install.args(version).args(library).arg("--root").arg(&tools);
        run(install.env("CARGO_PROFILE_DEV_DEBUG", "false"))?;
    }
    Ok(program)
}

/// Copies a file of the repository into the source of the book; pages get the names and links of mdBook.
fn copy(file: &Path, source: &Path) -> Result<()> {
    let named = |path: &Path| match path.file_name() {
        Some(name) if name == "README.md" => path.with_file_name("index.md"),
        _ => path.to_owned(),
    };
    let target = match file.to_str() {
        Some("docs/SUMMARY.md") => source.join("SUMMARY.md"),
        Some(FIRST_PAGE) => source.join("introduction.md"),
        _ => source.join(named(file)),
    };
    std::fs::create_dir_all(target.parent().context("a file lies in a folder")?)?;
    if file.extension().is_none_or(|extension| extension != "md") {
        std::fs::copy(file, target)?;
        return Ok(());
    }
    let text = std::fs::read_to_string(file)?.replace("README.md)", "index.md)");
    let text = text.replace("README.md#", "index.md#");
    let is_at_root = target.parent() == Some(source);
    let text = if is_at_root && file.starts_with("docs") { at_root(&text) } else { text };
    let text = text.replacen(BEFORE_TABLES, &format!("{BEFORE_TABLES}{TABLES}"), 1);
    Ok(std::fs::write(target, text)?)
}

/// A page of `docs` with the links that it has at the root.
fn at_root(page: &str) -> String {
    let mut parts = page.split("](");
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (link, rest) = part.split_once(')').unwrap_or((part, ""));
        let link = match link {
            "introduction.md" => link.to_owned(),
            link if link.contains("://") || link.starts_with('#') => link.to_owned(),
            link => plain(&Path::new("docs").join(link)),
        };
        text += &format!("]({link}){rest}");
    }
    text
}

/// A relative path without `..`.
fn plain(path: &Path) -> String {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir => drop(plain.pop()),
            part => plain.push(part),
        }
    }
    plain.display().to_string()
}
