//! What layers drew while a figure was planned, with its labels, kept for its first drawing: a frame of a
//! drag would let them all draw, and set all texts, a second time.

use std::fmt::{self, Debug, Formatter};
use std::sync::{Mutex, PoisonError};

use super::frame::Frame;
use super::placement::Sought;
use super::sketch::Sketched;

/// What the layers of a panel drew in the plan's theme, and the labels of all of it.
type Panel = (Sketched, Vec<Sought>);

/// What each panel has, until someone takes it.
#[derive(Default)]
pub(super) struct Kept(Mutex<Vec<Option<Panel>>>);

impl Kept {
    /// What the layers drew and its labels, panel by panel.
    pub(super) fn of(sketched: Vec<Sketched>, sought: Vec<Vec<Sought>>) -> Self {
        Self(Mutex::new(sketched.into_iter().zip(sought).map(Some).collect()))
    }

    /// What the layers of a panel drew, if they drew in this frame; none where it was taken.
    pub(super) fn take(&self, panel: usize, frame: &Frame) -> Option<Panel> {
        let taken = self.0.lock().unwrap_or_else(PoisonError::into_inner).get_mut(panel)?.take();
        taken.filter(|(sketched, _)| sketched.frame == *frame)
    }
}

impl Debug for Kept {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.debug_struct("Kept").finish_non_exhaustive()
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_figure_that_is_drawn_a_second_time_is_the_same() {
        let text = "shapes.A = { kind = 'circle', radius = 1 }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [3, 1] }
            query = { kind = 'separation', of = ['A', 'B'] }";
        let scene = open_text("kept", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let first = draw(&plan, plan.theme, "kept");
        assert!(plan.kept.take(0, &plan.panels[0].frame).is_none(), "it was drawn");
        assert_eq!(draw(&plan, plan.theme, "kept"), first);
    }
}
