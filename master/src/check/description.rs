//! A model description as the rules see it: its elements with their lines in the text.

use std::collections::HashMap;

use roxmltree::{Document, Node};

/// An element of the text.
pub type Element<'x> = Node<'x, 'x>;

/// A variable, with the defaults of §2.2.7 for what it does not state.
pub struct Variable<'x> {
    /// The element `ScalarVariable`.
    pub element: Element<'x>,
    /// Its index in `ModelVariables`, counted from one.
    pub index: usize,
    /// `name`.
    pub name: &'x str,
    /// `valueReference`, where it is a number.
    pub reference: Option<u32>,
    /// `causality`.
    pub causality: &'x str,
    /// `variability`.
    pub variability: &'x str,
    /// `initial`, as written or as the causality and variability imply.
    pub initial: Option<&'x str>,
    /// `Real`, `Integer`, `Boolean`, `String` or `Enumeration`, where one stands there.
    pub kind: Option<Element<'x>>,
}

/// The five types of variables.
pub const KINDS: [&str; 5] = ["Real", "Integer", "Boolean", "String", "Enumeration"];

/// A model description whose text is XML.
pub struct Description<'x> {
    /// The root element.
    pub root: Element<'x>,
    /// The variables in order.
    pub variables: Vec<Variable<'x>>,
    /// The declared types by name, the first of each.
    pub types: HashMap<&'x str, Element<'x>>,
    /// The units by name, the first of each.
    pub units: HashMap<&'x str, Element<'x>>,
}

impl<'x> Description<'x> {
    /// Reads the variables of a document.
    pub fn new(document: &'x Document<'x>) -> Self {
        let root = document.root_element();
        let scalars = child(root, "ModelVariables")
            .into_iter()
            .flat_map(|variables| children(variables, "ScalarVariable"));
        Self {
            root,
            variables: scalars.zip(1..).map(variable).collect(),
            types: by_name(root, "TypeDefinitions", "SimpleType"),
            units: by_name(root, "UnitDefinitions", "Unit"),
        }
    }

    /// The elements `name` in the list `list` of the root.
    pub fn list(&self, list: &str, name: &'static str) -> Vec<Element<'x>> {
        child(self.root, list).into_iter().flat_map(|list| children(list, name)).collect()
    }
}

/// The elements `name` in the list `list` by their attribute `name`.
fn by_name<'x>(root: Element<'x>, list: &str, name: &'static str) -> HashMap<&'x str, Element<'x>> {
    let mut found = HashMap::new();
    for element in child(root, list).into_iter().flat_map(|list| children(list, name)) {
        if let Some(name) = element.attribute("name") {
            found.entry(name).or_insert(element);
        }
    }
    found
}

fn variable((element, index): (Element<'_>, usize)) -> Variable<'_> {
    let causality = element.attribute("causality").unwrap_or("local");
    let variability = element.attribute("variability").unwrap_or("continuous");
    Variable {
        element,
        index,
        name: element.attribute("name").unwrap_or_default(),
        reference: element.attribute("valueReference").and_then(|text| text.parse().ok()),
        causality,
        variability,
        initial: element.attribute("initial").or_else(|| implied_initial(causality, variability)),
        kind: KINDS.iter().find_map(|kind| child(element, kind)),
    }
}

/// The default of `initial` (§2.2.7, table of the defaults).
fn implied_initial(causality: &str, variability: &str) -> Option<&'static str> {
    match (causality, variability) {
        ("parameter", _) | (_, "constant") => Some("exact"),
        ("input" | "independent", _) => None,
        _ => Some("calculated"),
    }
}

impl<'x> Variable<'x> {
    /// Name of its type; empty where the element is missing.
    pub fn type_name(&self) -> &'x str {
        self.kind.map_or("", |kind| kind.tag_name().name())
    }

    /// An attribute of its type.
    pub fn of_kind(&self, attribute: &str) -> Option<&'x str> {
        self.kind?.attribute(attribute)
    }
}

/// The first child element of that name.
pub fn child<'x>(element: Element<'x>, name: &str) -> Option<Element<'x>> {
    element.children().find(|child| child.has_tag_name(name))
}

/// All child elements of that name.
pub fn children<'x>(element: Element<'x>, name: &'static str) -> impl Iterator<Item = Element<'x>> {
    element.children().filter(move |child| child.has_tag_name(name))
}

/// The number that an attribute holds; `None` where it is missing or is not a number.
pub fn number(element: Element<'_>, attribute: &str) -> Option<f64> {
    element.attribute(attribute)?.trim().parse().ok()
}
