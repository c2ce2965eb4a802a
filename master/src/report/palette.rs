//! Colours and patterns of lines, chosen to be told apart by colour-blind readers and in grey.

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

/// The colour of the line with this number.
pub(super) fn line(index: usize) -> RGBColor {
    LINES[index % LINES.len()]
}

/// A colour as HTML has it.
pub(super) fn html(colour: RGBColor) -> String {
    format!("#{:02x}{:02x}{:02x}", colour.0, colour.1, colour.2)
}

/// Pattern of the line with this number, as `stroke-dasharray` of SVG; empty where it is solid. Lines
/// that lie on each other are told apart by it, as are lines in print without colour.
pub(super) fn dashes(index: usize) -> &'static str {
    ["", "18 10", "4 8"][index % 3]
}

#[cfg(test)]
mod tests {
    use super::*;

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
}
