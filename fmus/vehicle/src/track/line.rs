//! What a vehicle runs on: the designed track, where its rails really lie, and what carries them.

use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

use files::Mistake;
use track::{Friction, Irregularity, Support, Track, TrackFile};

/// A line.
#[derive(Clone, Debug)]
pub struct Line {
    /// Designed track.
    pub track: Track,
    /// Irregularities of both rails.
    pub irregularity: Irregularity,
    /// Elastic support; none: the rails do not give way.
    pub support: Option<Support>,
    /// How slippery the rails are.
    pub friction: Friction,
}

/// The lines read so far: a train of 250 vehicles needs one. Those that nobody uses any more go.
static LINES: Mutex<Vec<(PathBuf, String, Arc<Line>)>> = Mutex::new(Vec::new());

impl Line {
    /// Smooth stiff rails on this track.
    pub fn smooth(track: Track) -> Self {
        Self {
            track,
            irregularity: Irregularity::default(),
            support: None,
            friction: Friction::default(),
        }
    }

    /// All that a track file says.
    ///
    /// # Errors
    /// When a value in it is not possible.
    pub fn new(file: &TrackFile) -> Result<Self, Mistake> {
        Ok(Self {
            track: file.track()?,
            irregularity: file.irregularity()?,
            support: file.support()?,
            friction: file.friction()?,
        })
    }

    /// Reads all of a track file. Instances in one process share the line of a file that has not
    /// changed.
    ///
    /// # Errors
    /// When a file cannot be read or a value is not possible.
    pub fn shared(file: &Path) -> Result<Arc<Self>, Mistake> {
        let content = TrackFile::read(file)?;
        let mut lines = LINES.lock().unwrap_or_else(PoisonError::into_inner);
        lines.retain(|(_, _, line)| Arc::strong_count(line) > 1);
        if let Some((.., line)) =
            lines.iter().find(|(path, old, _)| path == file && *old == content.text())
        {
            return Ok(Arc::clone(line));
        }
        let line = Arc::new(Self::new(&content)?);
        lines.push((file.to_owned(), content.text().to_owned(), Arc::clone(&line)));
        Ok(line)
    }

    /// Whether the rails lie as designed and stay there.
    #[inline]
    pub fn is_stiff_and_smooth(&self) -> bool {
        self.support.is_none() && self.irregularity.is_none()
    }
}
