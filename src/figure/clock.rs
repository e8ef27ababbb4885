//! The time in a panel that plays: in one corner through all pictures, where the fewest of them have
//! something.

use std::sync::Arc;

use crate::drawing::{Halo, Item, Point, Rect, Role};
use crate::typeset::{Line, Style, typeset};

use super::lettering::lettered;
use super::placement::Labelled;
use super::text::{Decimal, exponent};
use super::theme::Theme;

/// How far the clock stands from the edges of its panel, page pixels.
const ASIDE: f64 = 6.0;
/// How far its halo reaches, page pixels.
const HALO: f64 = 2.5;
/// The corners, as whether they are on the right and whether they are at the bottom; of as good ones the
/// first is taken.
const CORNERS: [(bool, bool); 4] = [(true, true), (true, false), (false, true), (false, false)];

/// A time, set in type.
pub(super) struct Clock(Arc<Line>);

impl Clock {
    /// A time on the way to the last one in letters of a size, with the sign that is decimal in a scene;
    /// `None` where it can't be set.
    pub(super) fn of([time, last]: [f64; 2], size: f64, decimal: Decimal) -> Option<Self> {
        // As many digits all the way, so that it does not jump: two, or of a short way three of its end.
        let first = exponent(last);
        let places = usize::try_from(-first).ok().filter(|first| *first > 1).map_or(2, |first| first + 2);
        let markup = decimal.in_number(format!("$t = {time:.places$}$"));
        let line = typeset(&markup, Style::regular(size)).ok()?;
        Some(Self(Arc::new(line)))
    }

    /// Where its baseline begins in a corner of a panel.
    fn origin(&self, panel: &Rect, (is_right, is_bottom): (bool, bool)) -> Point {
        let x = if is_right { panel.x1 - ASIDE - self.0.width } else { panel.x0 + ASIDE };
        Point::new(x, if is_bottom { panel.y1 - ASIDE } else { panel.y0 + ASIDE + self.0.ascent })
    }

    /// Whether nothing of a panel lies under it in a corner, and no inset.
    fn is_free(&self, panel: &Labelled, insets: &[Labelled], corner: (bool, bool)) -> bool {
        let (p, line) = (self.origin(&panel.frame.panel, corner), &self.0);
        let bounds = Rect { x0: p.x, y0: p.y - line.ascent, x1: p.x + line.width, y1: p.y + line.descent };
        let bounds = bounds.grown(HALO);
        let has_inset = insets.iter().any(|inset| inset.frame.panel.intersection(bounds).is_some());
        !has_inset && panel.is_free(&bounds)
    }

    /// What is drawn of it in a corner of a panel.
    pub(super) fn drawn(&self, panel: &Rect, corner: (bool, bool), theme: &Theme) -> Vec<Item> {
        let halo = Some(Halo::plain(theme.paint(Role::Background), HALO));
        lettered(&self.0, self.origin(panel, corner), Role::Now, (theme, halo))
    }
}

/// The corner of a panel in which the clock hides something in the fewest pictures: each the panel, the
/// insets of all panels, and the clock.
pub(super) fn corner(pictures: &[(&Labelled, &[Labelled], &Clock)]) -> (bool, bool) {
    let hides = |corner| {
        pictures.iter().filter(|(panel, insets, clock)| !clock.is_free(panel, insets, corner)).count()
    };
    CORNERS.into_iter().min_by_key(|&corner| hides(corner)).unwrap_or(CORNERS[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn a_short_way_has_as_many_digits_as_its_end_needs() {
        let said =
            |time: f64, last: f64| Clock::of([time, last], 14.0, Decimal::Point).unwrap().0.markup.clone();
        assert_eq!(said(0.25, 1.0), "$t = 0.25$");
        assert_eq!(said(0.25, 0.5), "$t = 0.25$");
        assert_eq!(said(0.001, 0.00375), "$t = 0.00100$");
        assert_eq!(said(0.0461, 0.0922), "$t = 0.0461$");
    }

    #[test]
    fn the_clock_goes_where_no_picture_has_anything() {
        let corner_of = |layers: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'circle', radius = 1 }}
                query = {{ kind = 'bounds', of = ['A'] }}
                canvas = {{ width = 400 }}
                panels = [{{ view = [-5, -5, 5, 5], layers = ['shapes', {layers}] }}]"
            );
            let scene = open_text("s", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "f");
            let clock = Clock::of([0.25, 1.0], 14.0, Decimal::Point).unwrap();
            corner(&[(&figure.panels[0], &figure.insets, &clock)])
        };
        assert_eq!(corner_of("'origin'"), (true, true), "lower right");
        let ticks = "{ layer = 'axes', ticks = true, lines = false, step = 1 }";
        assert_eq!(corner_of(ticks), (true, false), "numbers stand along the lower edge");
        let note = "{ layer = 'note', at = 'bottom-right', lines = ['a note'] }";
        assert_eq!(corner_of(note), (true, false), "over a note");
        let both = format!("{ticks}, {{ layer = 'note', at = 'top-right', lines = ['a note'] }}");
        assert_eq!(corner_of(&both), (false, false), "the one that is left");
        let inset = "'origin'], inset = [-1.1, -0.1, -0.9, 0.1], inset_at = 'SE' }, { layers = ['grid'";
        assert_eq!(corner_of(inset), (true, false), "over an inset");
    }
}
