//! How elements of a modelDescription.xml are described: attributes, and slots for children.

/// What an attribute may hold.
pub enum Value {
    /// Any text.
    Text,
    /// A number.
    Real,
    /// A whole number.
    Integer,
    /// A whole number, not negative.
    Unsigned,
    /// Whole numbers, not negative, with spaces between them.
    UnsignedList,
    /// `true`, `false`, `1` or `0`.
    Boolean,
    /// A date and time as `2026-11-22T09:30:00Z`.
    DateTime,
    /// One of these words.
    Word(&'static [&'static str]),
    /// Some of these words, with spaces between them.
    WordList(&'static [&'static str]),
}

/// An attribute.
pub struct Attribute {
    /// Name.
    pub name: &'static str,
    /// What it may hold.
    pub value: Value,
    /// Whether it must be there.
    pub required: bool,
}

/// An element: its attributes and what may stand inside, in this order.
pub struct Schema {
    /// Name.
    pub name: &'static str,
    /// Attributes.
    pub attributes: &'static [Attribute],
    /// Slots for child elements in order; `None`: anything may stand inside.
    pub slots: Option<&'static [Slot]>,
}

/// A slot for child elements.
pub struct Slot {
    /// One of these stands there.
    pub choices: &'static [Schema],
    /// Whether the slot must be filled.
    pub required: bool,
    /// Whether several may stand there.
    pub many: bool,
}

/// An attribute that may be left out.
pub const fn may(name: &'static str, value: Value) -> Attribute {
    Attribute { name, value, required: false }
}

/// An attribute that must be there.
pub const fn must(name: &'static str, value: Value) -> Attribute {
    Attribute { name, value, required: true }
}

/// An element without children.
pub const fn leaf(name: &'static str, attributes: &'static [Attribute]) -> Schema {
    Schema { name, attributes, slots: Some(&[]) }
}

/// An element with children.
pub const fn tree(
    name: &'static str,
    attributes: &'static [Attribute],
    slots: &'static [Slot],
) -> Schema {
    Schema { name, attributes, slots: Some(slots) }
}

/// A slot that may hold one of these.
pub const fn optional(choices: &'static [Schema]) -> Slot {
    Slot { choices, required: false, many: false }
}

/// A slot that must hold one of these.
pub const fn one(choices: &'static [Schema]) -> Slot {
    Slot { choices, required: true, many: false }
}

/// A slot that must hold at least one of these.
pub const fn some(choices: &'static [Schema]) -> Slot {
    Slot { choices, required: true, many: true }
}

/// A slot that may hold any number of these.
pub const fn any_number(choices: &'static [Schema]) -> Slot {
    Slot { choices, required: false, many: true }
}
