//! Rules on elements and attributes: each is one that the schema of FMI 2.0 has, stands where it may,
//! and holds what it may.

use roxmltree::Attribute as Written;

use super::description::{Description, Element};
use super::elements::ROOT;
use super::grammar::{Attribute, Schema, Slot, Value};
use super::rule::{Breaches, Rule, Severity};

pub const RULES: &[Rule] = &[
    Rule {
        name: "elements-as-in-schema",
        severity: Severity::Error,
        wants: "elements are those of the schema, in its order, and none that is needed is missing",
        check: elements,
    },
    Rule {
        name: "attributes-as-in-schema",
        severity: Severity::Error,
        wants: "attributes are those of the schema, and none that is needed is missing",
        check: attributes,
    },
    Rule {
        name: "values-as-in-schema",
        severity: Severity::Error,
        wants: "attributes hold numbers, words and dates where the schema wants them",
        check: values,
    },
];

fn elements(description: &Description<'_>, breaches: &mut Breaches) {
    let root = description.root;
    if !root.has_tag_name(ROOT.name) {
        let found = root.tag_name().name();
        breaches.at(root, format!("the root element is <{found}>, but must be <{}>", ROOT.name));
        return;
    }
    visit(root, &ROOT, &mut |element, schema| {
        if let Some(slots) = schema.slots {
            children(element, slots, breaches);
        }
    });
}

/// Child elements against their slots.
fn children(parent: Element<'_>, slots: &[Slot], breaches: &mut Breaches) {
    let name = parent.tag_name().name();
    let mut filled = vec![0_usize; slots.len()];
    let mut last = 0;
    for child in parent.children().filter(|child| child.is_element()) {
        let own = child.tag_name().name();
        let Some((slot, _)) = find(slots, child) else {
            breaches.at(child, format!("<{own}> cannot stand in <{name}>: {}", inside(slots)));
            continue;
        };
        if slot < last {
            let before = words(&slots[last]);
            breaches.at(child, format!("<{own}> must stand before {before} in <{name}>"));
        } else if filled[slot] > 0 && !slots[slot].many {
            let only = words(&slots[slot]);
            breaches.at(child, format!("<{name}> may hold only one {only}, but has a second"));
        }
        last = last.max(slot);
        filled[slot] += 1;
    }
    for (slot, _) in slots.iter().zip(filled).filter(|(slot, count)| slot.required && *count == 0) {
        breaches.at(parent, format!("<{name}> lacks {}", words(slot)));
    }
}

/// What may stand inside, in words.
fn inside(slots: &[Slot]) -> String {
    match slots.iter().map(words).collect::<Vec<_>>() {
        none if none.is_empty() => "it holds no elements".to_owned(),
        some => format!("it may hold {}", some.join(", ")),
    }
}

fn words(slot: &Slot) -> String {
    let names: Vec<_> = slot.choices.iter().map(|choice| format!("<{}>", choice.name)).collect();
    names.join(" or ")
}

/// The slot and schema of a child element.
fn find<'s>(slots: &'s [Slot], child: Element<'_>) -> Option<(usize, &'s Schema)> {
    slots.iter().enumerate().find_map(|(i, slot)| {
        let fitting = slot.choices.iter().find(|choice| child.has_tag_name(choice.name));
        fitting.map(|schema| (i, schema))
    })
}

/// Shows every element that the schema knows to `see`.
fn visit(element: Element<'_>, schema: &Schema, see: &mut impl FnMut(Element<'_>, &Schema)) {
    see(element, schema);
    for child in element.children().filter(|child| child.is_element()) {
        if let Some((_, schema)) = find(schema.slots.unwrap_or_default(), child) {
            visit(child, schema, see);
        }
    }
}

fn attributes(description: &Description<'_>, breaches: &mut Breaches) {
    visit(description.root, &ROOT, &mut |element, schema| {
        let name = schema.name;
        // Attributes of another namespace, such as xsi:schemaLocation, are nobody's business.
        let own = element.attributes().filter(|attribute| attribute.namespace().is_none());
        for attribute in own.filter(|attribute| of(schema, attribute).is_none()) {
            let known: Vec<_> = schema.attributes.iter().map(|known| known.name).collect();
            let (unknown, known) = (attribute.name(), known.join(", "));
            breaches.at(element, format!("<{name}> has no attribute `{unknown}`, only {known}"));
        }
        let missing = schema.attributes.iter().filter(|attribute| attribute.required);
        for attribute in missing.filter(|attribute| !element.has_attribute(attribute.name)) {
            breaches.at(element, format!("<{name}> lacks the attribute `{}`", attribute.name));
        }
    });
}

fn of<'s>(schema: &'s Schema, written: &Written<'_, '_>) -> Option<&'s Attribute> {
    schema.attributes.iter().find(|known| known.name == written.name())
}

fn values(description: &Description<'_>, breaches: &mut Breaches) {
    visit(description.root, &ROOT, &mut |element, schema| {
        for written in element.attributes() {
            let Some(known) = of(schema, &written) else { continue };
            if let Some(wanted) = known.value.refuses(written.value()) {
                let (name, value) = (written.name(), written.value());
                breaches.at(element, format!("`{name}` is \"{value}\", but must be {wanted}"));
            }
        }
    });
}

impl Value {
    /// What a text would have to be, if it is not.
    fn refuses(&self, text: &str) -> Option<String> {
        let text = text.trim();
        let every = |right: &dyn Fn(&str) -> bool| text.split_whitespace().all(right);
        let (right, wanted) = match self {
            Self::Text => return None,
            Self::Real => (is_number(text), "a number".to_owned()),
            Self::Integer => (text.parse::<i32>().is_ok(), "a whole number".to_owned()),
            Self::Unsigned => (is_unsigned(text), "a whole number from 0".to_owned()),
            Self::UnsignedList => {
                (every(&is_unsigned), "whole numbers with spaces between them".to_owned())
            }
            Self::Boolean => {
                (["true", "false", "1", "0"].contains(&text), "true or false".to_owned())
            }
            Self::DateTime => {
                (is_date_time(text), "a date and time such as 2026-11-22T09:30:00Z".to_owned())
            }
            Self::Word(words) => (words.contains(&text), format!("one of {}", words.join(", "))),
            Self::WordList(words) => {
                (every(&|word| words.contains(&word)), format!("words of {}", words.join(", ")))
            }
        };
        (!right).then_some(wanted)
    }
}

/// A number as XML writes it; Rust reads some words that XML does not, such as `infinity`.
fn is_number(text: &str) -> bool {
    text.parse::<f64>().is_ok_and(f64::is_finite)
}

fn is_unsigned(text: &str) -> bool {
    text.parse::<u32>().is_ok()
}

/// `YYYY-MM-DDThh:mm:ss` with a fraction and a zone, if they are given.
fn is_date_time(text: &str) -> bool {
    const FORM: &[u8] = b"0000-00-00T00:00:00";
    let (Some(first), Some(rest)) = (text.get(..FORM.len()), text.get(FORM.len()..)) else {
        return false;
    };
    let fits = |(&own, &form): (&u8, &u8)| match form {
        b'0' => own.is_ascii_digit(),
        mark => own == mark,
    };
    first.bytes().zip(FORM).all(|(own, form)| fits((&own, form)))
        && rest.bytes().all(|byte| byte.is_ascii_digit() || b".Z+-:".contains(&byte))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What a value may be written as: XML Schema Part 2 (W3C 2004), sections 3.2.2 boolean, 3.2.5 double,
    /// 3.2.7 dateTime, 3.3.17 int and 3.3.22 unsignedInt; white space around a value does not count (4.3.6).
    #[test]
    fn benchmark_values_are_those_of_xml_schema() {
        let words = Value::Word(&["fixed", "tunable"]);
        let list = Value::WordList(&["dependent", "constant"]);
        let cases: [(&Value, &[&str], &[&str]); 8] = [
            (
                &Value::Real,
                &["1", "-1.5e-3", "+2", ".5", " 3 "],
                &["", "one", "1,5", "infinity", "1 2"],
            ),
            (&Value::Integer, &["0", "-2147483648", "2147483647"], &["1.0", "2147483648", ""]),
            (&Value::Unsigned, &["0", "4294967295"], &["-1", "4294967296", "1.0", ""]),
            (&Value::UnsignedList, &["", "1", "1 2  3"], &["1,2", "1 -2"]),
            (&Value::Boolean, &["true", "false", "1", "0"], &["True", "yes", "2", ""]),
            (
                &Value::DateTime,
                &["2026-11-22T09:30:00Z", "2026-11-22T09:30:00.25+01:00"],
                &["2026-11-22", "2026-11-22 09:30:00Z", "22.11.2026", "2026-11-22T09:30:00 noon"],
            ),
            (&words, &["fixed", "tunable"], &["Fixed", "fixed tunable", ""]),
            (&list, &["", "dependent", "constant dependent"], &["dependent,constant", "fixed"]),
        ];
        for (value, right, wrong) in cases {
            for text in right {
                assert_eq!(value.refuses(text), None, "'{text}'");
            }
            for text in wrong {
                assert!(value.refuses(text).is_some(), "'{text}'");
            }
        }
    }
}
