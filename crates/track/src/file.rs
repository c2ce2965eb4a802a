//! The track file: read once, and compiled into track, irregularities, support and friction.

use std::path::{Path, PathBuf};

use files::{Document, Mistake};

use crate::content::Content;
use crate::friction::Friction;
use crate::irregularity::Irregularity;
use crate::speed_limit::SpeedLimit;
use crate::support::Support;
use crate::track::Track;

/// A track file (`content.rs` has its keys).
#[derive(Debug)]
pub struct TrackFile {
    document: Document,
    content: Content,
    /// Folder of the file, in which the file with measured irregularities lies.
    folder: PathBuf,
}

impl TrackFile {
    /// Reads a file.
    ///
    /// # Errors
    /// When it cannot be read, or has an unknown key or a value of another type.
    pub fn read(file: &Path) -> Result<Self, Mistake> {
        let folder = file.parent().unwrap_or(Path::new("")).to_owned();
        Self::of(Document::read(file)?, folder)
    }

    /// Takes a text; `name` stands in the error messages.
    ///
    /// # Errors
    /// When it has an unknown key or a value of another type.
    pub fn new(text: &str, name: &str) -> Result<Self, Mistake> {
        Self::of(Document::new(name, text), PathBuf::new())
    }

    fn of(document: Document, folder: PathBuf) -> Result<Self, Mistake> {
        let content = document.parse()?;
        Ok(Self { document, content, folder })
    }

    /// The JSON schema of such files.
    pub fn schema() -> schemars::Schema {
        schemars::schema_for!(Content)
    }

    /// Its text.
    pub fn text(&self) -> &str {
        self.document.text()
    }

    /// The designed line.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn track(&self) -> Result<Track, Mistake> {
        let check = self.document.check();
        self.content.check(&check)?;
        self.content.compile(&check)
    }

    /// The irregularities of the rails, with the file of measured ones that the track file may name.
    ///
    /// # Errors
    /// When that file cannot be read, or a value is not possible.
    pub fn irregularity(&self) -> Result<Irregularity, Mistake> {
        let check = self.document.check().section("irregularity");
        self.content.irregularity.compile(&check, &self.folder)
    }

    /// The support of the rails; none: the rails do not give way.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn support(&self) -> Result<Option<Support>, Mistake> {
        let check = self.document.check().section("support");
        self.content.support.as_ref().map(|section| section.compile(&check)).transpose()
    }

    /// How slippery the rails are.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn friction(&self) -> Result<Friction, Mistake> {
        Friction::compile(&self.content.friction, &self.document.check())
    }

    /// The speed limits; [`Self::track`] says whether their values are possible.
    pub fn speed_limits(&self) -> &[SpeedLimit] {
        &self.content.speed_limit
    }

    /// The file with measured irregularities that it names, if it names one.
    pub fn measured(&self) -> Option<PathBuf> {
        self.content.irregularity.file().map(|file| self.folder.join(file))
    }
}

impl Track {
    /// Reads the designed line of a track file.
    ///
    /// # Errors
    /// When the file cannot be read or a value in it is not possible.
    pub fn from_file(file: &Path) -> Result<Self, Mistake> {
        TrackFile::read(file)?.track()
    }

    /// Compiles the designed line of the text of a track file; `name` stands in the error messages.
    ///
    /// # Errors
    /// When a value is not possible.
    pub fn from_toml(text: &str, name: &str) -> Result<Self, Mistake> {
        TrackFile::new(text, name)?.track()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    use crate::TrackPoint;

    const CURVE: &str = "
        start_m = 300.0
        alignment = [
            { length_m = 50.0, transition = true },
            { length_m = 600.0, radius_m = 800.0, cant_mm = 75.0 },
            { length_m = 50.0, transition = true },
        ]
        gradient = [
            { chainage_m = 0.0, permille = 0.0 },
            { chainage_m = 100.0, permille = 10.0 },
        ]";

    fn at(track: &Track, chainage: f64) -> TrackPoint {
        track.at(chainage, &mut 0)
    }

    /// A transition of length l to radius R turns the heading by l/2R (clothoid).
    #[test]
    fn analytic_heading_of_a_curve_with_transitions() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        assert_eq!(at(&track, 299.0).curvature, 0.0);
        assert!((at(&track, 325.0).curvature - 0.5 / 800.0).abs() < 1e-15);
        assert!((at(&track, 350.0).heading - 25.0 / 800.0).abs() < 1e-15);
        assert!((at(&track, 2000.0).heading - 650.0 / 800.0).abs() < 1e-12);
        assert_eq!(at(&track, 1001.0).curvature, 0.0);
        assert!((at(&track, 500.0).cant_angle - 0.05_f64.asin()).abs() < 1e-15);
    }

    /// In a circle the lateral offset from the tangent is s²/2R (small angles).
    #[test]
    fn analytic_offset_from_the_tangent() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        let (from, to) = (at(&track, 500.0), at(&track, 510.0));
        let offset = to.heading_integral - from.heading_integral - 10.0 * from.heading;
        assert!((offset - 100.0 / 1600.0).abs() < 1e-12);
    }

    #[test]
    fn analytic_elevation_is_the_integral_of_the_gradient() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        assert!((at(&track, 100.0).elevation - 0.5).abs() < 1e-12);
        assert!((at(&track, 1100.0).elevation - 10.5).abs() < 1e-12);
        assert_eq!(at(&track, -100.0).elevation, 0.0);
    }

    /// A spline through (0, 0), (100, 10), (300, 0) permille, and a step to 5 permille.
    #[test]
    fn analytic_gradient_by_a_spline_and_a_step() {
        let text = "gradient_interpolation = 'cubic'
            gradient = [
                { chainage_m = 0, permille = 0 }, { chainage_m = 100, permille = 10 },
                { chainage_m = 300, permille = 0 }, { chainage_m = 300, permille = 5 },
            ]";
        let track = Track::from_toml(text, "spline").unwrap();
        // By hand: the slopes at the ends are 0.1 and -0.05, so the slope m at 100 m follows from
        // 0.1/100 + 2 m (1/100 + 1/200) - 0.05/200 = 3 (0.1/100 - 0.05/200): m = 0.05 permille/m.
        let slope = at(&track, 100.0).gradient_slope;
        assert!((slope - 0.05e-3).abs() < 1e-15, "{slope}");
        assert!((at(&track, 100.0).gradient - 10e-3).abs() < 1e-15);
        assert_eq!(at(&track, 300.0).gradient, 5e-3);
        // The elevation is the integral of the gradient: Simpson's rule is exact for a cubic.
        let mean = |a: f64, b: f64| {
            let at = |x: f64| at(&track, x).gradient;
            (at(a) + 4.0 * at((a + b) / 2.0) + at(b)) / 6.0
        };
        let expected = mean(100.0, 250.0) * 150.0;
        let rise = at(&track, 250.0).elevation - at(&track, 100.0).elevation;
        assert!((rise - expected).abs() < 1e-13);
    }

    /// The mean elevation over a length is what a vehicle's potential energy needs.
    #[test]
    fn analytic_elevation_integral_of_a_constant_slope() {
        let track = Track::from_toml(CURVE, "curve").unwrap();
        let (from, to) = (at(&track, 200.0), at(&track, 300.0));
        let mean = (to.elevation_integral - from.elevation_integral) / 100.0;
        assert!((mean - at(&track, 250.0).elevation).abs() < 1e-12);
    }

    #[test]
    fn analytic_curvature_by_points() {
        let text = "curvature = [
            { chainage_m = -50, per_km = 0 }, { chainage_m = 0, per_km = 2, cant_mm = 75 },
            { chainage_m = 100, per_km = 2, cant_mm = 75 }, { chainage_m = 150, per_km = 0 }]";
        let track = Track::from_toml(text, "points").unwrap();
        assert!((at(&track, -25.0).curvature - 1e-3).abs() < 1e-15);
        assert_eq!(at(&track, 50.0).curvature, 2e-3);
        assert!((at(&track, 50.0).cant_angle - 0.05_f64.asin()).abs() < 1e-15);
        assert!((at(&track, 200.0).heading - 0.3).abs() < 1e-14);
    }

    #[test]
    fn curvature_twice_is_refused() {
        let text = "alignment = [{ length_m = 1 }]\ncurvature = [{ chainage_m = 0, per_km = 1 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        assert!(message.contains("curvature[1].per_km = 1: leave either"), "{message}");
    }

    #[test]
    fn a_step_at_the_first_point_is_refused() {
        let text =
            "gradient = [{ chainage_m = 0, permille = 1 }, { chainage_m = 0, permille = 2 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        assert!(message.contains("gradient[2].chainage_m = 0: a step needs"), "{message}");
    }

    #[test]
    fn a_chainage_that_goes_back_is_refused() {
        let text =
            "gradient = [{ chainage_m = 9, permille = 1 }, { chainage_m = 8, permille = 1 }]";
        let message = Track::from_toml(text, "t.toml").err().unwrap().to_string();
        let wanted = "t.toml:1:62: gradient[2].chainage_m = 8: must not be less than 9";
        assert!(message.starts_with(wanted), "{message}");
    }

    #[test]
    fn radius_of_zero_is_refused_with_key_and_remedy() {
        let error = Track::from_toml("alignment = [{ length_m = 1.0, radius_m = 0.0 }]", "t.toml");
        let message = error.unwrap_err().to_string();
        assert!(
            message.starts_with("t.toml:1:43: alignment[1].radius_m = 0.0: must be at least 50 m")
        );
    }

    #[test]
    fn unknown_key_is_refused_with_its_line() {
        let error = Track::from_toml("start_m = 0.0\nlenght = 3\n", "t.toml");
        let message = error.unwrap_err().to_string();
        assert!(message.starts_with("t.toml:2:1: there is no key `lenght`"), "{message}");
    }
}
