//! The line under a vehicle: at its middle, or the mean over its length.

use track::{Track, TrackPoint};

/// What the track does to a vehicle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LocalLine {
    /// Gradient dz/ds, positive uphill.
    pub gradient: f64,
    /// Elevation, m.
    pub elevation: f64,
    /// Curvature, positive in a right-hand curve, 1/m.
    pub curvature: f64,
}

impl LocalLine {
    /// The line at a chainage, m; `index` holds the last lookups in the track.
    #[inline]
    pub fn at(chainage: f64, track: &Track, index: &mut [usize; 2]) -> Self {
        let location = track.locate(chainage, &mut index[0]);
        Self {
            gradient: location.gradient(),
            elevation: location.elevation(),
            curvature: location.curvature(),
        }
    }

    /// The means over a length, m, around a chainage, m. A vehicle across a change of hand counts the
    /// curvature that is left of both.
    pub fn mean(chainage: f64, length: f64, track: &Track, index: &mut [usize; 2]) -> Self {
        let [front, rear] = ends(chainage, length, track, index);
        Self {
            gradient: (front.elevation - rear.elevation) / length,
            elevation: (front.elevation_integral - rear.elevation_integral) / length,
            curvature: (front.heading - rear.heading) / length,
        }
    }
}

/// Mean heading of the track over a length, m, around a chainage, m, in rad.
pub(crate) fn mean_heading(
    chainage: f64,
    length: f64,
    track: &Track,
    index: &mut [usize; 2],
) -> f64 {
    let [front, rear] = ends(chainage, length, track, index);
    (front.heading_integral - rear.heading_integral) / length
}

/// The track at the front and at the rear of a length around a chainage.
fn ends(chainage: f64, length: f64, track: &Track, index: &mut [usize; 2]) -> [TrackPoint; 2] {
    let [first, second] = index;
    [track.at(chainage + length / 2.0, first), track.at(chainage - length / 2.0, second)]
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A gradient that begins at 100 m with 10 permille, and a curve of 500 m from 200 m on.
    fn track() -> Track {
        let text = "alignment = [{ length_m = 200 }, { length_m = 100, radius_m = 500 }]
            gradient = [{ chainage_m = 0, permille = 0 }, { chainage_m = 100, permille = 0 },
                        { chainage_m = 100, permille = 10 }]";
        Track::from_toml(text, "track.toml").unwrap()
    }

    #[test]
    fn analytic_line_at_the_middle_is_that_of_the_track() {
        let line = LocalLine::at(250.0, &track(), &mut [0; 2]);
        assert_eq!((line.gradient, line.curvature), (0.01, 1.0 / 500.0));
        assert!((line.elevation - 1.5).abs() < 1e-14);
    }

    /// A vehicle of 20 m, a quarter of it behind the change: a quarter of the gradient and of the
    /// curvature, and of the elevation the mean of a ramp over 5 m, 5/20 · 0.01 · 5/2 m.
    #[test]
    fn analytic_means_across_a_change() {
        let mean = |chainage| LocalLine::mean(chainage, 20.0, &track(), &mut [0; 2]);
        let line = mean(95.0);
        assert!((line.gradient - 0.0025).abs() < 1e-15, "{line:?}");
        assert!((line.elevation - 0.00625).abs() < 1e-14, "{line:?}");
        assert!((mean(195.0).curvature - 0.25 / 500.0).abs() < 1e-15);
    }

    /// In a circle the mean heading over a length is the heading of its middle.
    #[test]
    fn analytic_mean_heading_in_a_circle() {
        let heading = mean_heading(250.0, 20.0, &track(), &mut [0; 2]);
        assert!((heading - 50.0 / 500.0).abs() < 1e-13, "{heading}");
    }
}
