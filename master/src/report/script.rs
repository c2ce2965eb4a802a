//! The scripts of the page: the drawing library and the modules of the linked view as one module.

/// The drawing library uPlot (MIT, see `templates/vendor/uplot/LICENSE`).
pub(super) const UPLOT: &str = include_str!("../../templates/vendor/uplot/uPlot.iife.min.js");

/// Its styles.
pub(super) const UPLOT_STYLE: &str = include_str!("../../templates/vendor/uplot/uPlot.min.css");

/// Numbers, colours and panels, each module after those that it imports.
const DRAWING: [&str; 3] = [
    include_str!("../../templates/instrument/numbers.js"),
    include_str!("../../templates/instrument/colours.js"),
    include_str!("../../templates/instrument/panel.js"),
];

/// The modules of the linked view.
const MODULES: [&str; 6] = [
    include_str!("../../templates/instrument/run.js"),
    include_str!("../../templates/instrument/along_track.js"),
    include_str!("../../templates/instrument/heat_map.js"),
    include_str!("../../templates/instrument/section.js"),
    include_str!("../../templates/instrument/over_time.js"),
    include_str!("../../templates/instrument/main.js"),
];

/// The module of a comparison.
const COMPARISON: &str = include_str!("../../templates/compare/main.js");

/// The modules of the linked view as one: a page that is one file has nothing to import from.
pub(super) fn instrument() -> String {
    DRAWING.iter().chain(&MODULES).flat_map(|module| joinable(module)).collect()
}

/// The modules of a comparison as one.
pub(super) fn comparison() -> String {
    DRAWING.iter().chain([&COMPARISON]).flat_map(|module| joinable(module)).collect()
}

/// The lines of a module without its imports, and without the word `export`.
fn joinable(module: &str) -> impl Iterator<Item = String> {
    let lines = module.lines().filter(|line| !line.starts_with("import "));
    lines.map(|line| line.strip_prefix("export ").unwrap_or(line).to_owned() + "\n")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn imports_go_and_exports_become_plain() {
        let module = "import { a } from './a.js';\nexport const b = a;\n  export\n";
        let lines: Vec<_> = joinable(module).collect();
        assert_eq!(lines, ["const b = a;\n", "  export\n"]);
    }

    /// Imports take one line each, and no script ends the element that holds it.
    #[test]
    fn the_script_can_stand_in_a_page() {
        for script in [instrument(), comparison()] {
            for unwanted in ["import {", " from './", "</script", "<!--"] {
                assert!(!script.contains(unwanted), "{unwanted}");
            }
        }
        assert!(!UPLOT.contains("</script") && UPLOT.contains("uPlot"));
    }
}
