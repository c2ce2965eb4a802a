//! Elements and attributes of SSP files, with messages that name file and line.

use std::str::FromStr;

use roxmltree::{Document, Node};

use super::error::SspError;
use crate::files::xml_depth::check_depth;

/// A file of the package, parsed; prefixes of names do not matter.
pub struct XmlFile<'t> {
    /// Path in the package, for messages.
    pub name: String,
    /// The tree.
    pub document: Document<'t>,
}

impl<'t> XmlFile<'t> {
    /// Parses the text of a file.
    ///
    /// # Errors
    /// When it is not XML.
    pub fn parse(name: &str, text: &'t str) -> Result<Self, SspError> {
        check_depth(text).map_err(|source| SspError::Depth { file: name.to_owned(), source })?;
        let document = Document::parse(text)
            .map_err(|source| SspError::Syntax { file: name.to_owned(), source })?;
        Ok(Self { name: name.to_owned(), document })
    }

    /// An error at an element.
    pub fn wrong(&self, node: Node<'_, '_>, message: impl Into<String>) -> SspError {
        let line = self.document.text_pos_at(node.range().start).row;
        SspError::Wrong { file: self.name.clone(), line, message: message.into() }
    }

    /// An attribute that must be there.
    ///
    /// # Errors
    /// When it is not.
    pub fn required<'n>(&self, node: Node<'n, '_>, name: &str) -> Result<&'n str, SspError> {
        node.attribute(name).ok_or_else(|| {
            let element = node.tag_name().name();
            self.wrong(node, format!("element {element} lacks the attribute '{name}'"))
        })
    }

    /// The value of an attribute, if it is there.
    ///
    /// # Errors
    /// When it is not of the type.
    pub fn value<T: FromStr>(&self, node: Node<'_, '_>, name: &str) -> Result<Option<T>, SspError> {
        let parse = |text: &str| {
            text.trim().parse().map_err(|_| {
                let wanted = match std::any::type_name::<T>() {
                    "f64" => "a number such as 0.5",
                    "bool" => "true or false",
                    _ => "a whole number such as 2",
                };
                self.wrong(node, format!("{name}=\"{text}\" must be {wanted}"))
            })
        };
        node.attribute(name).map(parse).transpose()
    }
}

/// The first child of that name.
pub fn child<'a, 'i>(node: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    children(node, name).next()
}

/// The children of that name.
pub fn children<'a, 'i>(
    node: Node<'a, 'i>,
    name: &str,
) -> impl Iterator<Item = Node<'a, 'i>> + use<'a, 'i> {
    let name = name.to_owned();
    node.children().filter(move |child| child.is_element() && child.tag_name().name() == name)
}

/// The children of that name in the first child `list`.
pub fn listed<'a, 'i>(
    node: Node<'a, 'i>,
    list: &str,
    name: &str,
) -> impl Iterator<Item = Node<'a, 'i>> + use<'a, 'i> {
    let name = name.to_owned();
    child(node, list).into_iter().flat_map(move |list| children(list, &name))
}
