//! The packages of the repository and their sources, read and parsed.

use std::path::{Path, PathBuf};

use walkdir::WalkDir;

/// The repository.
pub struct Workspace {
    /// Its root.
    pub root: PathBuf,
    /// Its packages in order of their folders.
    pub packages: Vec<Package>,
}

/// A package of the workspace.
pub struct Package {
    /// Folder relative to the root of the repository.
    pub folder: PathBuf,
    /// The table of its `Cargo.toml`.
    pub manifest: toml::Table,
    /// Its sources in order of their paths.
    pub sources: Vec<Source>,
}

/// A file of Rust.
pub struct Source {
    /// Path relative to the root of the repository.
    pub path: PathBuf,
    /// Its text.
    pub text: String,
    /// The text as a tree of items.
    pub tree: syn::File,
}

impl Workspace {
    /// Reads the repository in which this crate stands.
    ///
    /// # Panics
    /// When a file cannot be read or parsed.
    pub fn read() -> Self {
        let root = Path::new(env!("CARGO_MANIFEST_DIR")).ancestors().nth(2);
        Self::read_at(root.expect("the package lies two folders below the root"))
    }

    /// Reads the repository at `root`.
    ///
    /// # Panics
    /// When a file cannot be read or parsed.
    pub fn read_at(root: &Path) -> Self {
        let files = files_below(root);
        let mut packages: Vec<_> = files
            .iter()
            .filter(|path| path.file_name().is_some_and(|name| name == "Cargo.toml"))
            .filter_map(|path| {
                let manifest: toml::Table = read(&root.join(path)).parse().expect("a manifest");
                manifest.contains_key("package").then(|| Package {
                    folder: path.parent().expect("a file has a folder").to_owned(),
                    manifest,
                    sources: vec![],
                })
            })
            .collect();
        for path in files.iter().filter(|path| path.extension().is_some_and(|name| name == "rs")) {
            // The innermost package: one may lie in the folder of another.
            let package = packages
                .iter_mut()
                .filter(|package| path.starts_with(&package.folder))
                .max_by_key(|package| package.folder.components().count());
            let text = read(&root.join(path));
            let tree = syn::parse_file(&text).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
            if let Some(package) = package {
                package.sources.push(Source { path: path.clone(), text, tree });
            }
        }
        Self { root: root.to_owned(), packages }
    }

    /// All sources.
    pub fn sources(&self) -> impl Iterator<Item = &Source> {
        self.packages.iter().flat_map(|package| &package.sources)
    }

    /// Text of a file of the repository; empty when there is none.
    pub fn text(&self, path: &str) -> String {
        std::fs::read_to_string(self.root.join(path)).unwrap_or_default()
    }

    /// The pages below a folder of the repository with their texts.
    pub fn pages(&self, folder: &str) -> Vec<(PathBuf, String)> {
        files_below(&self.root.join(folder))
            .into_iter()
            .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
            .map(|path| Path::new(folder).join(path))
            .map(|path| (path.clone(), read(&self.root.join(path))))
            .collect()
    }
}

impl Package {
    /// Name of the package.
    pub fn name(&self) -> &str {
        self.manifest["package"]["name"].as_str().expect("the name of a package is a string")
    }

    /// Whether a source belongs to the product: it lies below `src` and is no file of tests.
    pub fn is_product(&self, source: &Source) -> bool {
        source.path.starts_with(self.folder.join("src")) && !source.is_test()
    }
}

impl Source {
    /// Whether the file as a whole is for tests: it stands in a folder of tests or benches, or its name
    /// says so.
    pub fn is_test(&self) -> bool {
        let stem = self.path.file_stem().unwrap_or_default().to_string_lossy();
        let in_folder = |name| self.path.iter().any(|part| part == name);
        in_folder("tests") || in_folder("benches") || stem == "tests" || stem.ends_with("_tests")
    }

    /// Lines that belong to tests: all of a test file, else those from `#[cfg(test)]` on.
    pub fn lines_of_tests(&self) -> usize {
        let lines = self.text.lines().count();
        if self.is_test() {
            return lines;
        }
        let code = self.text.lines().position(|line| line.trim() == "#[cfg(test)]");
        // A `mod` line of another file is no test.
        let module = code.and_then(|code| self.text.lines().nth(code + 1));
        match (code, module) {
            (Some(code), Some(module)) if module.trim_end().ends_with('{') => lines - code,
            _ => 0,
        }
    }
}

/// Paths of all files below a folder, relative to it and sorted; neither those that are built nor hidden
/// ones.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = WalkDir::new(folder).sort_by_file_name().into_iter().filter_entry(|entry| {
        let name = entry.file_name().to_string_lossy();
        entry.depth() == 0 || name != "target" && !name.starts_with('.')
    });
    entries
        .filter_map(Result::ok)
        .filter(|entry| entry.file_type().is_file())
        .filter_map(|entry| entry.path().strip_prefix(folder).map(Path::to_owned).ok())
        .collect()
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}
