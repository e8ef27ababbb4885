//! A figure that plays, as an animation: how long each of its pictures is shown, and how many there may be.

use super::{Format, Options, OutputError, raster};
use crate::drawing::Drawing;

/// How the motion of a figure is written.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InMotion {
    /// How many pictures the way has; the finished figure follows them.
    pub frames: usize,
    /// How many pictures a second shows.
    pub fps: f64,
    /// Seconds that the finished figure stays.
    pub hold: f64,
}

impl Default for InMotion {
    /// Two seconds of 20 pictures each, and two seconds to look at the figure.
    fn default() -> Self {
        Self { frames: 40, fps: 20.0, hold: 2.0 }
    }
}

/// The most dots that an animation may have, over all its pictures: 2³⁰, ten times those of the usual one. To
/// paint and pack them takes some 20 s.
pub const MOST_DOTS: f64 = 1_073_741_824.0;

/// Makes one file of all pictures of a figure that plays.
pub(crate) type InMotionWriter = fn(&Drawing, &Options, InMotion) -> Result<Vec<u8>, OutputError>;

impl InMotion {
    /// What tells it apart in the key of a file.
    pub(super) fn key(self) -> String {
        let Self { frames, fps, hold } = self;
        format!(" motion frames={frames} fps={fps} hold={hold}")
    }

    /// How long each picture is shown, in parts of a second. Errors do not add up: the k-th picture ends
    /// where it should, rounded.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates, and NaN is 0")]
    fn times(self, rests: impl Iterator<Item = bool>, parts: f64) -> Vec<u32> {
        let (mut now, mut shown) = (0.0_f64, 0.0_f64);
        let time = |rests| {
            now += if rests { self.hold } else { 1.0 / self.fps };
            let before = std::mem::replace(&mut shown, (parts * now).round());
            (shown - before) as u32
        };
        rests.map(time).collect()
    }
}

/// The pictures of a drawing that plays, and how long each is shown, in parts of a second.
pub(super) fn played<'d>(
    drawing: &'d Drawing,
    options: &Options,
    (in_motion, parts): (InMotion, f64),
) -> Result<(Vec<&'d Drawing>, Vec<u32>), OutputError> {
    let pictures = drawing.pictures();
    let (width, height) = raster::size(drawing, options.scale)?;
    let dots = f64::from(width) * f64::from(height);
    let most = MOST_DOTS / dots;
    if pictures.iter().fold(0.0, |count, _| count + 1.0) > most {
        return Err(OutputError::TooLong { pictures: pictures.len(), most });
    }
    let times = in_motion.times(pictures.iter().map(|(_, rests)| *rests), parts);
    Ok((pictures.into_iter().map(|(drawing, _)| drawing).collect(), times))
}

impl Format {
    /// Whether one file of this format can play the motion of a figure. Of the others each picture is a file.
    ///
    /// ```
    /// use tracefig::output::format;
    /// assert!(format("gif").unwrap().holds_motion() && !format("svg").unwrap().holds_motion());
    /// ```
    #[must_use]
    pub fn holds_motion(&self) -> bool {
        self.in_motion.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::MotionFrame;
    use crate::output::samples::everything;

    #[test]
    fn pictures_come_when_they_should_however_a_format_counts() {
        let rests = || [false, false, false, true, false, true].into_iter();
        let thirty = InMotion { fps: 30.0, hold: 1.0, ..InMotion::default() };
        assert_eq!(thirty.times(rests(), 1000.0), [33, 34, 33, 1000, 33, 1000]);
        assert_eq!(thirty.times(rests(), 100.0), [3, 4, 3, 100, 3, 100]);
    }

    #[test]
    fn an_animation_with_too_many_dots_is_refused_and_how_many_pictures_fit_is_said() {
        let one = everything();
        let frame = MotionFrame { drawing: everything(), rests: false };
        let drawing = crate::drawing::Drawing { motion: vec![frame; 32], ..one };
        let options = Options { scale: 8.0, ..Options::default() };
        let error = played(&drawing, &options, (InMotion::default(), 100.0)).unwrap_err();
        let OutputError::TooLong { pictures: 33, most } = error else { panic!("{error}") };
        assert!((32.0..33.0).contains(&most), "{most}");
        let options = Options { scale: 4.0, ..options };
        assert!(played(&drawing, &options, (InMotion::default(), 100.0)).is_ok());
    }
}
