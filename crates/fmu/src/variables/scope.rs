//! Where the variables of a table stand in an FMU.

/// What the names of a table's variables begin with, and what their descriptions speak of.
///
/// A plain text is a scope with that prefix, an empty one the top of the FMU:
///
/// ```
/// use fmu::Scope;
/// let top = Scope::from("");
/// assert_eq!(top.name("position"), "position");
/// let wheelset = Scope::from("vehicle[3].wheelset[1]").about("the wheelset");
/// assert_eq!(wheelset.name("position"), "vehicle[3].wheelset[1].position");
/// assert_eq!(wheelset.description(&[" Chainage of {}."]), "Chainage of the wheelset");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Scope {
    prefix: String,
    subject: String,
}

impl Scope {
    /// The scope whose descriptions have `subject` where `{}` stands in them.
    ///
    /// A `{}` in the subject itself is the subject of before.
    ///
    /// # Panics
    /// When the subject speaks of one before it, and there is none.
    #[must_use]
    pub fn about(self, subject: &str) -> Self {
        Self { subject: self.filled(subject), ..self }
    }

    /// The full name of a variable or group; a group without a name stands where the table stands.
    pub fn name(&self, name: &str) -> String {
        match (self.prefix.as_str(), name) {
            ("", name) => name.to_owned(),
            (prefix, "") => prefix.to_owned(),
            (prefix, name) => format!("{prefix}.{name}"),
        }
    }

    /// The description in the first paragraph of a doc comment.
    ///
    /// # Panics
    /// When the paragraph speaks of a subject, `{}`, and the scope has none.
    pub fn description(&self, comment: &[&str]) -> String {
        let lines = comment.iter().map(|line| line.trim()).take_while(|line| !line.is_empty());
        let paragraph = lines.collect::<Vec<_>>().join(" ");
        let sentence = paragraph.strip_suffix('.').unwrap_or(&paragraph);
        self.filled(sentence)
    }

    /// The scope of a group in this one, about the same subject.
    #[must_use]
    pub fn group(&self, name: &str) -> Self {
        Self { prefix: self.name(name), subject: self.subject.clone() }
    }

    fn filled(&self, text: &str) -> String {
        let speaks_of_a_subject = text.contains("{}");
        assert!(
            !(speaks_of_a_subject && self.subject.is_empty()),
            "\"{text}\" at \"{}\" needs a subject: Scope::about",
            self.prefix
        );
        text.replace("{}", &self.subject)
    }
}

impl From<&str> for Scope {
    fn from(prefix: &str) -> Self {
        Self { prefix: prefix.to_owned(), subject: String::new() }
    }
}

impl From<String> for Scope {
    fn from(prefix: String) -> Self {
        Self { prefix, subject: String::new() }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_description_is_the_first_paragraph_without_its_full_stop() {
        let comment = [" Chainage of the", " middle; 1.5 m.", "", " Equation 3."];
        assert_eq!(Scope::default().description(&comment), "Chainage of the middle; 1.5 m");
    }

    #[test]
    fn a_group_in_a_group_has_both_names_and_may_speak_of_the_outer_subject() {
        let wheelset = Scope::from(String::from("wheelset[2]")).about("wheelset 2");
        let wheel = wheelset.group("left").about("left wheel of {}");
        assert_eq!(wheel.name("speed"), "wheelset[2].left.speed");
        assert_eq!(wheel.description(&["Speed, {}"]), "Speed, left wheel of wheelset 2");
        let contact = wheel.group("");
        assert_eq!(contact.name("a"), "wheelset[2].left.a");
        assert_eq!(contact.description(&["{}"]), "left wheel of wheelset 2");
    }

    #[test]
    #[should_panic(expected = "\"Speed of {}\" at \"train\" needs a subject")]
    fn a_missing_subject_is_a_programming_error() {
        let _ = Scope::from("train").description(&[" Speed of {}"]);
    }
}
