//! A figure that plays: the pictures that lead to it.

use super::Drawing;

/// A picture of a figure that plays, before the figure itself.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionFrame {
    /// What it shows, on a page of the figure's size.
    pub drawing: Drawing,
    /// Whether it stays as long as the finished figure does: where the bodies have arrived, and the figure
    /// shows another moment.
    pub rests: bool,
}

impl Drawing {
    /// Every picture of a figure that plays, in order, each with whether it stays; the figure itself is the
    /// last one, and the only one where nothing moves.
    ///
    /// ```
    /// use tracefig::{figure::{draw, plan}, scene::{Source, read}};
    /// let text = "shapes.A = { kind = 'circle', radius = 1 }\nquery = { kind = 'bounds', of = ['A'] }";
    /// let scene = read(&Source::new("circle.toml", text)).unwrap();
    /// let plan = plan(&scene).unwrap();
    /// let drawing = draw(&plan, plan.theme, "circle").drawing;
    /// assert_eq!(drawing.pictures(), [(&drawing, true)]);
    /// ```
    #[must_use]
    pub fn pictures(&self) -> Vec<(&Self, bool)> {
        let frames = self.motion.iter().map(|frame| (&frame.drawing, frame.rests));
        frames.chain([(self, true)]).collect()
    }
}
