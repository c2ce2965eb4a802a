//! Elasticity of wheel and rail.

/// A linear elastic, isotropic material; wheel and rail are made of the same.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Shear modulus G in Pa.
    pub shear_modulus: f64,
    /// Poisson's ratio nu.
    pub poisson_ratio: f64,
}

impl Material {
    /// Combined modulus of two equal bodies, E* = E / (2 (1 - nu^2)) = G / (1 - nu), in Pa.
    pub fn contact_modulus(&self) -> f64 {
        self.shear_modulus / (1.0 - self.poisson_ratio)
    }
}

/// Wheel and rail steel as in the Manchester contact benchmark and the examples of CONTACT:
/// G = 82 GPa, nu = 0.28 (so E = 210 GPa).
pub const STEEL: Material = Material { shear_modulus: 82e9, poisson_ratio: 0.28 };
