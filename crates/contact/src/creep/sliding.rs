//! What friction laws say of a contact that slips.

/// Friction of a contact that slips.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sliding {
    /// Friction coefficient of the whole contact.
    pub coefficient: f64,
    /// Highest flash temperature by that of the same power with one coefficient all over the contact.
    pub flash: f64,
}
