//! The pages in an FMU's folder `documentation`: the table of signals, which the FMU writes
//! itself, and the equations of its model.

use std::path::{Component, Path, PathBuf};

use pulldown_cmark::{Event, Options, Parser, Tag, TagEnd, html};

/// Entry page inside of an FMU.
pub const INDEX: &str = "documentation/index.html";
/// Page with the equations inside of an FMU.
pub const EQUATIONS: &str = "documentation/equations.html";

const STYLE: &str = "body{font:16px/1.4 sans-serif;max-width:60em;margin:2em auto;padding:0 1em}\
table{border-collapse:collapse}th,td{border-bottom:1px solid #ccc;padding:.2em .6em;text-align:left}\
pre{background:#f4f4f4;padding:.6em;overflow-x:auto}";

/// A text with equations.
pub struct Text {
    /// Its file, to which the links in other texts point.
    pub file: PathBuf,
    /// The text in Markdown.
    pub markdown: String,
}

/// The page with the equations, from texts that follow one another. Links between the texts lead to
/// their heading on the page; of links to files that are not on it the words stay.
pub fn equations_page(texts: &[Text]) -> String {
    let mut body = String::new();
    for text in texts {
        body += &format!("<section id=\"{}\">\n", anchor(&text.file));
        let mut in_dead_link = false;
        let parser = Parser::new_ext(&text.markdown, Options::ENABLE_TABLES);
        let events = parser.filter_map(|event| match event {
            Event::Start(Tag::Link { link_type, dest_url, title, id }) => {
                let dest_url = destination(&text.file, &dest_url, texts);
                in_dead_link = dest_url.is_none();
                let dest_url = dest_url?.into();
                Some(Event::Start(Tag::Link { link_type, dest_url, title, id }))
            }
            Event::End(TagEnd::Link) if std::mem::take(&mut in_dead_link) => None,
            event => Some(event),
        });
        html::push_html(&mut body, events);
        body += "</section>\n";
    }
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <title>Equations</title>\n<style>{STYLE}</style>\n</head>\n<body>\n{body}</body>\n</html>\n"
    )
}

/// Where a link in the text of a file leads from the page; `None` where its target is not there.
fn destination(file: &Path, link: &str, texts: &[Text]) -> Option<String> {
    if link.contains("://") {
        return Some(link.to_owned());
    }
    let path = link.split('#').next().filter(|path| !path.is_empty());
    let linked = path.map_or(file.to_owned(), |path| file.with_file_name(path));
    let linked = plain(&linked);
    let text = texts.iter().find(|text| plain(&text.file) == linked)?;
    Some(format!("#{}", anchor(&text.file)))
}

/// The path without steps up and down again.
fn plain(path: &Path) -> PathBuf {
    let mut plain = PathBuf::new();
    for part in path.components() {
        match part {
            Component::ParentDir if plain.file_name().is_some() => _ = plain.pop(),
            Component::CurDir => {}
            part => plain.push(part),
        }
    }
    plain
}

/// The anchor of a text on the page.
fn anchor(file: &Path) -> String {
    file.file_stem().unwrap_or_default().to_string_lossy().into_owned()
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

    fn text(file: &str, markdown: &str) -> Text {
        Text { file: file.into(), markdown: markdown.to_owned() }
    }

    #[test]
    fn links_lead_to_places_on_the_page_or_are_words() {
        let page = equations_page(&[
            text(
                "theory/vehicle/README.md",
                "[frames](frames.md), [*eq.* (1)](../vehicle/frames.md#one), [guide](../guide.md), \
                 [standard](https://fmi-standard.org)",
            ),
            text("theory/vehicle/frames.md", "[overview](README.md)"),
        ]);
        let wanted = "<a href=\"#frames\">frames</a>, <a href=\"#frames\"><em>eq.</em> (1)</a>, guide, \
                      <a href=\"https://fmi-standard.org\">standard</a>";
        assert!(page.contains(wanted), "{page}");
        assert!(page.contains("<section id=\"frames\">\n<p><a href=\"#README\">"), "{page}");
    }

    #[test]
    fn equations_and_tables_survive() {
        let markdown = "# Title\n\n    F = −k x   (1)\n\n| a | b |\n|---|---|\n| 1 | 2 |\n";
        let page = equations_page(&[text("theory.md", markdown)]);
        assert!(page.contains("<pre><code>F = −k x   (1)\n</code></pre>"), "{page}");
        assert!(page.contains("<td>1</td><td>2</td>"), "{page}");
    }

    #[test]
    fn the_link_stands_behind_the_title() {
        let page = with_link_to_equations("<h1>Model</h1>\n<p>Text</p>");
        assert!(page.starts_with("<h1>Model</h1>\n<p><a href=\"equations.html\">"), "{page}");
    }
}
