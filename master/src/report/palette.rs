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

    /// Okabe and Ito's set as printed by Wong, Points of view: Color blindness, Nature Methods 8 (2011) 441.
    #[test]
    fn benchmark_lines_have_the_published_colours() {
        let published = [
            ("black", 0x00_00_00),
            ("orange", 0xE6_9F_00),
            ("sky blue", 0x56_B4_E9),
            ("bluish green", 0x00_9E_73),
            ("blue", 0x00_72_B2),
            ("vermillion", 0xD5_5E_00),
            ("reddish purple", 0xCC_79_A7),
        ];
        for (name, colour) in published {
            let found = LINES.iter().any(|&line| html(line) == format!("#{colour:06x}"));
            assert!(found, "{name}");
        }
        assert_eq!(LINES.len(), published.len());
    }

    /// Two colours of the middle are those of ColorBrewer's YlOrRd (Brewer 2003), five and more classes.
    #[test]
    fn benchmark_the_middle_of_heat_has_published_colours() {
        assert_eq!(html(heat(2.0 / 6.0)), "#fed976");
        assert_eq!(html(heat(3.0 / 6.0)), "#fd8d3c");
        assert_eq!(html(heat(0.0)), "#ffffff");
    }

    /// Linear light of an 8-bit channel (IEC 61966-2-1, sRGB).
    fn linear(channel: u8) -> f64 {
        let share = f64::from(channel) / 255.0;
        if share <= 0.040_45 { share / 12.92 } else { ((share + 0.055) / 1.055).powf(2.4) }
    }

    fn encoded(light: f64) -> f64 {
        let light = light.clamp(0.0, 1.0);
        255.0
            * if light <= 0.003_130_8 {
                12.92 * light
            } else {
                1.055 * light.powf(1.0 / 2.4) - 0.055
            }
    }

    /// What a dichromat sees: Machado, Oliveira and Fernandes, IEEE Trans. Visualization and Computer
    /// Graphics 15 (2009) 1291, table 1, severity 1.
    const DICHROMATS: [(&str, [[f64; 3]; 3]); 2] = [
        (
            "protanope",
            [
                [0.152_286, 1.052_583, -0.204_868],
                [0.114_503, 0.786_281, 0.099_216],
                [-0.003_882, -0.048_116, 1.051_998],
            ],
        ),
        (
            "deuteranope",
            [
                [0.367_322, 0.860_646, -0.227_968],
                [0.280_085, 0.672_501, 0.047_413],
                [-0.011_820, 0.042_940, 0.968_881],
            ],
        ),
    ];

    fn seen(matrix: &[[f64; 3]; 3], colour: RGBColor) -> [f64; 3] {
        let light = [colour.0, colour.1, colour.2].map(linear);
        matrix.map(|row| encoded(row.iter().zip(light).map(|(weight, light)| weight * light).sum()))
    }

    /// A figure has at most five lines (`plotted_vehicles` of the shipped scenarios); 40 of 255 is more than
    /// a fifth of the way from black to white along one channel.
    #[test]
    fn property_dichromats_tell_neighbouring_lines_apart() {
        for (who, matrix) in &DICHROMATS {
            for pair in LINES[..5].windows(2) {
                let [a, b] = [pair[0], pair[1]].map(|colour| seen(matrix, colour));
                let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
                let distance = squares.sum::<f64>().sqrt();
                assert!(distance > 40.0, "{who}: {pair:?} are {distance:.0} apart");
            }
        }
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
