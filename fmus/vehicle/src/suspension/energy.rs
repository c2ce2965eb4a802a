//! Energy that force elements store and turn into heat.

/// Energy in the elements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ElementEnergy {
    /// Stored in springs, stops, grips and series stiffnesses, J.
    pub stored: f64,
    /// Power turned into heat, W.
    pub dissipated: f64,
}
