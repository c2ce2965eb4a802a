//! The rail's steel.

/// Thermal properties of the rail's steel, constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Conductivity k, W/(m·K).
    pub conductivity: f64,
    /// Density ρ, kg/m³.
    pub density: f64,
    /// Specific heat c, J/(kg·K).
    pub specific_heat: f64,
}

impl Material {
    /// Table 4 of the paper (there with the unit "W/milli-Kelvin" for the conductivity).
    pub const PAPER: Self = Self { conductivity: 40.0, density: 7850.0, specific_heat: 450.0 };

    /// Heat capacity of a volume ρ c, J/(m³·K).
    pub fn heat_capacity(&self) -> f64 {
        self.density * self.specific_heat
    }

    /// Diffusivity α = k / (ρ c), m²/s.
    pub fn diffusivity(&self) -> f64 {
        self.conductivity / self.heat_capacity()
    }

    /// Thermal penetration coefficient β = √(k ρ c), W·√s/(m²·K).
    pub fn penetration(&self) -> f64 {
        (self.conductivity * self.heat_capacity()).sqrt()
    }
}
