//! Files as people have them, from text to profile.

use super::*;
use crate::profile::{rail::RailProfile, wheel::WheelProfile};

const MM: f64 = 1e-3;

/// S1002 from the flange back to the field side, in mm, every 0.25 mm.
fn wheel() -> Vec<[f64; 2]> {
    let at = |i: i32| -69.9 + 0.25 * f64::from(i);
    (0..520).map(at).map(|y| [y, WheelProfile::S1002.at(y * MM).height / MM]).collect()
}

/// 60E1 with its flanks of 1:20 down to 30 mm, in mm, every 0.25 mm along the flanks and on the crown.
fn rail() -> Vec<[f64; 2]> {
    let flank = |i: i32| {
        let depth = 14.3 + 0.25 * f64::from(i);
        [35.9986 + (depth - 14.2997) / 20.0, depth]
    };
    let left = (0..64).rev().map(flank).map(|[y, z]| [-y, z]);
    let crown = (0..288).map(|i| -35.9 + 0.25 * f64::from(i));
    let crown = crown.map(|y| [y, RailProfile::Rail60E1.at(y * MM).height / MM]);
    left.chain(crown).chain((0..64).map(flank)).collect()
}

fn lines(points: &[[f64; 2]]) -> String {
    points.iter().map(|[y, z]| format!("{y:.4} {z:.4}\n")).collect()
}

fn read(text: &str, name: &str) -> Result<ProfileFile, ContactError> {
    ProfileFile::of_text(text, name, None, &Reading::default())
}

/// Fails unless the profile is S1002 within `tolerance` metres, square to it.
fn is_s1002(file: &ProfileFile, tolerance: f64) {
    assert_eq!(file.kind, ProfileKind::Wheel);
    for i in -260..236 {
        let lateral = 0.25 * f64::from(i) * MM;
        let (found, expected) = (file.profile.at(lateral), WheelProfile::S1002.at(lateral));
        let square = 1.0 / (1.0 + expected.slope * expected.slope).sqrt();
        let off = (found.height - expected.height) * square;
        assert!(off.abs() < tolerance, "{off} m at {lateral} m: {:?}", file.notes);
    }
}

/// The same wheel as other programs write it: whatever the origin, the senses and the order, it is
/// S1002. Tolerance: what smoothing leaves where S1002's curvature jumps from that of 13 mm to a plane.
#[test]
fn property_a_wheel_is_the_same_in_every_format() {
    let points = wheel();
    let each = |change: fn([f64; 2]) -> [f64; 2]| -> Vec<[f64; 2]> {
        points.iter().copied().map(change).collect()
    };
    let miniprof = format!(
        "ProgramName=MiniProf\r\nColumnDef=X,Y\r\nXYPoints=520\r\n\r\n{}",
        lines(&each(|[y, z]| [y + 70.0, z])).replace('\n', "\r\n")
    );
    let towards_middle = lines(&each(|[y, z]| [-y, z]));
    let upwards = lines(&each(|[y, z]| [y, -z]));
    let mut shuffled = points.clone();
    for i in 0..shuffled.len() {
        shuffled.swap(i, (i * 7919 + 13) % 520);
    }
    let commas = lines(&points).replace(' ', ";").replace('.', ",");
    let metres = format!(
        "header.begin\ntype = 1\nheader.end\nspline.begin\nunits.len.f = 1\npoint.begin\n{}point.end\nspline.end\n",
        each(|[y, z]| [y * MM, z * MM])
            .iter()
            .map(|[y, z]| format!("{y:.7} {z:.7}\n"))
            .collect::<String>()
    );
    for (text, name, note) in [
        (lines(&points), "w.txt", None),
        (miniprof, "W.WHL", Some("from the flange back")),
        (lines(&each(|[y, z]| [y + 70.0, z])), "w.txt", Some("from the flange back")),
        (towards_middle, "w.Wheel", Some("towards the middle")),
        (upwards, "w.dat", Some("heights count upwards")),
        (lines(&shuffled), "w.csv", Some("did not stand in the order")),
        (format!("\u{feff}y;z\n{commas}"), "w.csv", None),
        (metres, "w.prw", None),
    ] {
        let file = read(&text, name).unwrap();
        is_s1002(&file, 6e-6);
        let noted = note.is_none_or(|note| file.notes.iter().any(|found| found.contains(note)));
        assert!(noted, "{name}: {:?}", file.notes);
        assert!(note.is_some() || file.notes.is_empty(), "{name}: {:?}", file.notes);
    }
}

/// Rounded to 0.01 mm, as MiniProf's averages are, or with noise, the points come out smooth again.
///
/// Largest distance from the clean outline, and the radius of flange root and gauge corner, which are
/// 13 mm. Tolerances: filter (P1) leaves 0.32 of white noise of points 0.25 mm apart and 0.5 of those 0.6 mm apart, as they are on
/// steep parts; four times that is not passed by 500 places.
#[test]
fn property_rounded_and_noisy_points_come_out_smooth() {
    let mut state = 1_u64;
    let mut normal = move || {
        let mut uniform = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (state >> 11) as f64 / (1_u64 << 53) as f64
        };
        (0..12).map(|_| uniform()).sum::<f64>() - 6.0
    };
    for (points, kind) in [(wheel(), ProfileKind::Wheel), (rail(), ProfileKind::Rail)] {
        let clean = ProfileFile::of_text(&lines(&points), "p", Some(kind), &Reading::default());
        let clean = clean.unwrap();
        // What smoothing takes from a clean outline where its curvature jumps.
        let own = clean.roughness.rms;
        let clean = clean.profile;
        for noise in [0.0, 0.1, 0.5, 1.0, 2.0, 5.0] {
            let rough: Vec<[f64; 2]> = points
                .iter()
                .map(|point| match noise > 0.0 {
                    true => point.map(|value| value + 1e-3 * noise * normal()),
                    false => point.map(|value| (100.0 * value).round() / 100.0),
                })
                .collect();
            let text: String = rough.iter().map(|[y, z]| format!("{y:.6} {z:.6}\n")).collect();
            let file = ProfileFile::of_text(&text, "p", Some(kind), &Reading::default()).unwrap();
            // Rounding to 0.01 mm has the standard deviation 0.01 mm/sqrt(12).
            let deviation = if noise > 0.0 { noise * 1e-6 } else { 2.9e-6 };
            let rms = (file.roughness.rms.powi(2) - own.powi(2)).max(0.0).sqrt() / deviation;
            assert!(deviation < own || (0.75..1.1).contains(&rms), "{kind}, {noise}: {rms}");
            let (begin, end) = clean.range();
            for i in 8..=492 {
                let lateral = begin + (end - begin) * f64::from(i) / 500.0;
                let (found, expected) = (file.profile.at(lateral), clean.at(lateral));
                let square = 1.0 / (1.0 + expected.slope * expected.slope).sqrt();
                let off = (found.height - expected.height) * square;
                assert!(off.abs() < 2.0 * deviation, "{kind}, {noise} µm: {off} m at {lateral} m");
            }
        }
    }
}

/// The flange root of S1002 and the gauge corner of 60E1 keep their radius of 13 mm when they are made
/// smooth: the curve's curvature over 6 mm of the arc. Tolerance 2 %.
#[test]
fn property_corners_keep_their_radius() {
    let wheel = read(&lines(&wheel()), "w.whl").unwrap().profile;
    let rail = read(&lines(&rail()), "r.ban").unwrap().profile;
    for (profile, from, to) in [(wheel, -37.6, -35.4), (rail, -35.0, -29.5)] {
        let turn = |lateral: f64| profile.at(lateral * MM).slope.atan();
        let steps = 400;
        let at = |i: i32| from + (to - from) * f64::from(i) / f64::from(steps);
        let length: f64 = (0..steps)
            .map(|i| {
                let (p, q) = (profile.at(at(i) * MM).height, profile.at(at(i + 1) * MM).height);
                ((at(i + 1) - at(i)) * MM).hypot(q - p)
            })
            .sum();
        let radius = length / (turn(to) - turn(from)).abs();
        assert!((radius / 0.013 - 1.0).abs() < 0.02, "{radius} m");
    }
}

/// A clean file is read as it is, and gives the profile that was written.
#[test]
fn property_a_clean_file_is_not_made_smooth_again() {
    let rough = read(&lines(&wheel()), "w.whl").unwrap();
    let again = read(&rough.clean_text(), "clean.txt").unwrap();
    assert_eq!(again.wavelength, 0.0);
    for i in -276..240 {
        let lateral = 0.25 * f64::from(i) * MM;
        let (found, expected) = (again.profile.at(lateral), rough.profile.at(lateral));
        assert!((found.height - expected.height).abs() < 2e-9 * (1.0 + expected.slope.abs()));
    }
}

/// A wheel whose running circle lies elsewhere is asked for it, with the key, and right with it.
#[test]
fn a_running_circle_elsewhere_is_asked_for() {
    let aside: Vec<_> = wheel().iter().map(|[y, z]| [y - 5.0, *z]).collect();
    let text = lines(&aside);
    let message = read(&text, "w.txt").unwrap_err().to_string();
    assert!(message.contains("the flange back lies 74.9 mm from the origin"), "{message}");
    assert!(message.contains("running_circle_mm = 75"), "{message}");
    let reading = Reading { running_circle: 0.075, ..Reading::default() };
    let file = ProfileFile::of_text(&text, "w.txt", None, &reading).unwrap();
    let rise = file.profile.at(-5.0 * MM).height;
    // The circle is 5 mm nearer to the field side than that of S1002, and the level is there.
    let expected = -WheelProfile::S1002.at(5.0 * MM).height;
    assert!((rise - expected).abs() < 1e-6, "{rise} {expected}");
    // MiniProf counts from the flange back; the key says where the circle is.
    let miniprof: Vec<_> = wheel().iter().map(|[y, z]| [y + 70.0, *z]).collect();
    let file = ProfileFile::of_text(&lines(&miniprof), "w.whl", None, &reading).unwrap();
    let (begin, _) = file.profile.range();
    assert!((begin + 74.9 * MM).abs() < 1e-5, "{begin}");
}

/// Lengths in another unit are refused with the unit that they would have, and read in it if it is said.
#[test]
fn lengths_in_another_unit_are_told() {
    for (per_metre, unit) in
        [(1.0, "metres"), (100.0, "centimetres"), (1e3 / 25.4, "inches"), (1e6, "micrometres")]
    {
        let scaled: String = wheel()
            .iter()
            .map(|[y, z]| format!("{:.8} {:.8}\n", y * MM * per_metre, z * MM * per_metre))
            .collect();
        let kind = Some(ProfileKind::Wheel);
        let message = ProfileFile::of_text(&scaled, "w.txt", kind, &Reading::default());
        let message = message.unwrap_err().to_string();
        assert!(message.contains(&format!("are the lengths {unit}")), "{message}");
        assert!(message.starts_with("w.txt: line"), "{message}");
        let reading = Reading { per_metre: Some(per_metre), ..Reading::default() };
        is_s1002(&ProfileFile::of_text(&scaled, "w.txt", kind, &reading).unwrap(), 6e-6);
    }
    let message = read("0 0\n1 1\n2 2\n3 3\n60000 1\n", "p.txt").unwrap_err().to_string();
    assert!(message.contains("line 5: the lateral coordinate is 60000.0 mm"), "{message}");
    let message = read("0 0\n1 1\n2 -1e308\n3 3\n4 1\n", "p.txt").unwrap_err().to_string();
    assert!(message.contains("line 3: the height is -1e308 mm;"), "{message}");
}

#[test]
fn what_is_no_wheel_and_no_rail_is_told() {
    let text = |scale: f64| -> String {
        let points = [(-60, 25), (-40, 20), (-20, 9), (0, 0), (20, -1), (40, -2), (60, -3)];
        let line = |(y, z)| format!("{} {}\n", scale * f64::from(y), scale * f64::from(z));
        points.map(line).concat()
    };
    let as_kind =
        |text: &str, kind| ProfileFile::of_text(text, "p.txt", Some(kind), &Reading::default());
    let message = |text: &str, kind| as_kind(text, kind).unwrap_err().to_string();
    assert!(as_kind(&text(1.0), ProfileKind::Wheel).is_ok());
    let small = message(&text(0.5), ProfileKind::Wheel);
    let wanted = "the width of the wheel is 60.0 mm; it must lie between 100.0 mm and 160.0 mm";
    assert!(small.starts_with(&format!("p.txt: {wanted}")), "{small}");
    let flat = text(1.0).replace("-60 25", "-60 15").replace("-40 20", "-40 14");
    let flat = message(&flat, ProfileKind::Wheel);
    assert!(flat.contains("the height of the flange is 15.0 mm"), "{flat}");
    let wide = message("-60 9\n-40 4\n-20 1\n0 0\n20 1\n40 4\n60 9", ProfileKind::Rail);
    assert!(wide.contains("the width of the rail's head is 120.0 mm"), "{wide}");
    let gap = message("-30 4\n-20 2\n0 0\n21 2\n30 4", ProfileKind::Rail);
    assert!(
        gap.starts_with("p.txt: line 4: 21.0 mm across the track from the point before"),
        "{gap}"
    );
    let aside = message("10 25\n30 20\n50 9\n70 0\n90 -1\n110 -2", ProfileKind::Wheel);
    assert!(aside.contains("from 10.0 to 110.0 mm"), "{aside}");
    assert!(message("0 0\n1 1\n", ProfileKind::Wheel).contains("p.txt: only 2 points"));
    let column = message("0 0\n0 1\n0 2\n0 3\n0 4\n0 5\n", ProfileKind::Wheel);
    assert!(column.contains("only 1 points"), "{column}");
    let other = format!("header.begin\ntype = 0\nheader.end\npoint.begin\n{}point.end", text(1.0));
    let other = message(&other, ProfileKind::Wheel);
    assert!(other.contains("profile of a rail, not of a wheel"), "{other}");
    let missing = ProfileFile::read(Path::new("/nowhere/p.prr"), None, &Reading::default());
    assert!(missing.unwrap_err().to_string().contains("/nowhere/p.prr: No such file"));
}

/// A measurement in two parts that overlap, and one with both sides of the head down to its underside.
#[test]
fn outlines_as_gauges_give_them_are_followed() {
    let mut overlapping = wheel();
    let again: Vec<_> = overlapping[60..64].to_vec();
    overlapping.splice(64..64, again);
    is_s1002(&read(&lines(&overlapping), "w.txt").unwrap(), 6e-6);
    let mut around = vec![[-10.0, 41.0], [-25.0, 38.0], [-36.0, 34.0], [-36.7, 32.0]];
    around.extend(rail());
    around.extend([[36.7, 32.0], [36.0, 34.0], [25.0, 38.0], [10.0, 41.0]]);
    let file = read(&lines(&around), "r.prr").unwrap();
    let (begin, end) = file.profile.range();
    assert!(begin < -0.036 && end > 0.036, "{begin} to {end}");
    assert!((file.profile.gauge_depth() - 0.041).abs() < 1e-3);
}

/// MiniProf counts a rail from either side, and heights in either sense; the gauge side reaches deeper.
#[test]
fn the_gauge_side_of_a_measured_rail_is_the_deeper_one() {
    let deep: Vec<_> = rail().into_iter().filter(|[y, z]| *y < 0.0 || *z < 8.0).collect();
    let plain = read(&lines(&deep), "r.txt").unwrap().profile;
    for sign in [[1.0, 1.0], [-1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]] {
        let turned: Vec<_> = deep.iter().map(|[y, z]| [sign[0] * y, sign[1] * z]).collect();
        let file = read(&lines(&turned), "R.BAN").unwrap();
        assert_eq!(file.profile.outline().len(), plain.outline().len());
        assert!((file.profile.gauge_face(0.014) - plain.gauge_face(0.014)).abs() < 1e-9);
        assert!(!file.notes.iter().any(|note| note.contains("equally deep")));
    }
    let alike = read(&lines(&rail()), "r.ban").unwrap();
    assert!(alike.notes.iter().any(|note| note.contains("equally deep")), "{:?}", alike.notes);
}
