//! Colours of lines and of heat, chosen to be told apart by colour-blind readers and in grey.

use plotters::style::RGBColor;

/// Colours of lines: the set of Okabe and Ito (2008) without yellow, which is too pale on white.
pub(super) const LINES: [RGBColor; 7] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
    RGBColor(0, 0, 0),
];

/// Colours of heat from none to most: steadily darker, so that order shows in grey too.
pub(super) const HEAT: [RGBColor; 7] = [
    RGBColor(255, 255, 255),
    RGBColor(255, 243, 201),
    RGBColor(254, 217, 118),
    RGBColor(253, 141, 60),
    RGBColor(227, 40, 28),
    RGBColor(140, 0, 50),
    RGBColor(45, 0, 45),
];

/// The colour of the line with this number.
pub(super) fn line(index: usize) -> RGBColor {
    LINES[index % LINES.len()]
}

/// The colour of heat at `share` of the scale, 0 to 1.
pub(super) fn heat(share: f64) -> RGBColor {
    let position = share.clamp(0.0, 1.0) * (HEAT.len() - 1) as f64;
    let before = (position as usize).min(HEAT.len() - 2);
    let (from, to) = (HEAT[before], HEAT[before + 1]);
    let weight = position - before as f64;
    let mix = |from: u8, to: u8| {
        (f64::from(from) + weight * (f64::from(to) - f64::from(from))).round() as u8
    };
    RGBColor(mix(from.0, to.0), mix(from.1, to.1), mix(from.2, to.2))
}

/// A colour as HTML has it.
pub(super) fn html(colour: RGBColor) -> String {
    format!("#{:02x}{:02x}{:02x}", colour.0, colour.1, colour.2)
}

/// Logarithmic scale of temperature rise: four decades, so that the little heat that has come
/// deep shows beside the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct HeatScale {
    /// Rise with the darkest colour, K.
    pub highest: f64,
}

/// Decades of the scale.
const DECADES: f64 = 4.0;

/// The scale never ends below this, so that rounding errors do not look like heat, K.
const SMALLEST_TOP: f64 = 1e-3;

impl HeatScale {
    /// The scale for rises up to `largest`: its top is the next 1, 2 or 5 times a power of ten.
    pub fn of(largest: f64) -> Self {
        let largest = largest.max(SMALLEST_TOP);
        let decade = 10f64.powf(largest.log10().floor());
        let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
        let highest = steps.into_iter().find(|&step| largest <= step * (1.0 + 1e-9));
        Self { highest: highest.unwrap_or(10.0 * decade) }
    }

    /// Rise below which there is no colour, K.
    pub fn lowest(self) -> f64 {
        self.highest * 10f64.powf(-DECADES)
    }

    /// Place of a rise on the scale, 0 to 1.
    pub fn share(self, rise: f64) -> f64 {
        let above = (rise / self.lowest()).log10();
        if above > 0.0 { (above / DECADES).min(1.0) } else { 0.0 }
    }

    /// The powers of ten on the scale, K.
    pub fn ticks(self) -> impl Iterator<Item = f64> {
        let first = self.lowest().log10().ceil() as i32;
        let last = self.highest.log10().floor() as i32;
        (first..=last).map(|exponent| 10f64.powi(exponent))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Luminance by ITU-R BT.709.
    fn luminance(colour: RGBColor) -> f64 {
        0.2126 * f64::from(colour.0) + 0.7152 * f64::from(colour.1) + 0.0722 * f64::from(colour.2)
    }

    #[test]
    fn property_more_heat_is_darker() {
        let shades = (0..=255).map(|i| luminance(heat(f64::from(i) / 255.0)));
        assert!(shades.is_sorted_by(|lighter, darker| lighter >= darker));
    }

    #[test]
    fn analytic_heat_scale_spans_four_decades() {
        let scale = HeatScale::of(34.0);
        assert_eq!(scale.highest, 50.0);
        assert!((scale.share(0.5) - 0.5).abs() < 1e-12, "two decades below the top");
        assert_eq!(scale.share(0.0), 0.0);
        assert_eq!(scale.share(-1.0), 0.0);
        assert_eq!(scale.ticks().count(), 4, "0.01, 0.1, 1 and 10 K");
        assert_eq!(HeatScale::of(0.0).highest, 1e-3);
    }
}
