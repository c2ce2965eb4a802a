//! The pages in an FMU's folder `documentation`: the table of signals, which the FMU writes
//! itself, and the equations of its model.

use pulldown_cmark::{Options, Parser, html};

/// Entry page inside of an FMU.
pub const INDEX: &str = "documentation/index.html";
/// Page with the equations inside of an FMU.
pub const EQUATIONS: &str = "documentation/equations.html";

const STYLE: &str = "body{font:16px/1.4 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}\
table{border-collapse:collapse}th,td{border-bottom:1px solid #ccc;padding:.2em .6em;text-align:left}\
pre{background:#f4f4f4;padding:.6em;overflow-x:auto}";

/// The page with the equations, from a text in Markdown.
pub fn equations_page(markdown: &str) -> String {
    let mut body = String::new();
    html::push_html(&mut body, Parser::new_ext(markdown, Options::ENABLE_TABLES));
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Equations</title>\n<style>{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n"
    )
}

/// The entry page with a link to the equations behind its title.
pub fn with_link_to_equations(index: &str) -> String {
    index.replacen(
        "</h1>",
        "</h1>\n<p><a href=\"equations.html\">Equations of the model</a></p>",
        1,
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equations_and_tables_survive() {
        let page =
            equations_page("# Title\n\n    F = −k x   (1)\n\n| a | b |\n|---|---|\n| 1 | 2 |\n");
        assert!(page.contains("<pre><code>F = −k x   (1)\n</code></pre>"), "{page}");
        assert!(page.contains("<td>1</td><td>2</td>"), "{page}");
    }

    #[test]
    fn the_link_stands_behind_the_title() {
        let page = with_link_to_equations("<h1>Model</h1>\n<p>Text</p>");
        assert!(page.starts_with("<h1>Model</h1>\n<p><a href=\"equations.html\">"), "{page}");
    }
}
