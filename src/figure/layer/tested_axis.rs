//! What a test of an axis told of it.

use crate::collision::Answer;
use crate::figure::context::Context;
use crate::geometry::{DVec2, Enclosure, Feature, Side};
use crate::trace::{Event, so_far};

/// An axis that the algorithm tested.
#[derive(Clone, Copy)]
pub(super) struct Tested {
    /// The unit vector along the axis.
    pub(super) n: DVec2,
    /// The body whose edge or vertex gave it.
    pub(super) source: (Side, Feature),
    /// From the least to the largest n·x of A's points.
    pub(super) a: Enclosure,
    /// From the least to the largest n·x of B's points.
    pub(super) b: Enclosure,
    /// From A's upper end to B's lower one, negative where B begins before A ends.
    pub(super) gap: f64,
}

impl Tested {
    /// Whether the bodies are apart along it the other way round: all of B lies behind A.
    pub(super) fn is_behind(&self) -> bool {
        so_far::is_behind(self.a, self.b)
    }

    /// The gap of the intervals, from its start, or what both share, from its end: less than the depth where
    /// one reaches past the other's end.
    pub(super) fn between(&self) -> [f64; 2] {
        let Self { a, b, gap, .. } = self;
        if *gap > 0.0 { [a.hi, b.lo] } else { [a.hi.min(b.hi), b.lo.max(a.lo)] }
    }
}

/// What an event tells of an axis.
pub(super) fn told(event: &Event) -> Option<Tested> {
    match *event {
        Event::AxisTested { axis, source, interval_a, interval_b, gap } => {
            Some(Tested { n: axis, source, a: interval_a, b: interval_b, gap })
        }
        _ => None,
    }
}

/// The axis that ended a search among the edges of B ⊖ A, which tests none: the normal of the edge that it
/// had found last.
pub(super) fn stopped_at(context: &Context) -> Option<Tested> {
    let mut last = None;
    let (n, gap) = context.run().find_told(|event| match *event {
        Event::DifferenceEdgeFound { source, edge, .. } => {
            last = Some((source, Feature::Edge(edge)));
            None
        }
        Event::SeparatingAxisFound { normal, gap } => Some((normal, gap)),
        _ => None,
    })?;
    let interval = |side| shadow(context, side, n);
    Some(Tested { n, source: last?, a: interval(Side::A)?, b: interval(Side::B)?, gap })
}

/// Whether the search of this question ends at such an axis where bodies are apart: one that asks for the
/// support of an edge, and then has an edge of B ⊖ A.
pub(super) fn may_stop(context: &Context) -> bool {
    let is_support = |event: &&Event| matches!(event, Event::SupportFound { .. });
    let run = context.run();
    let mut found = run.events().skip_while(|event| !is_support(event)).skip(1);
    matches!(run.answer, Answer::Overlap(_))
        && matches!(found.next(), Some(Event::DifferenceEdgeFound { .. }))
}

/// From the least to the largest n·x of a body's points.
fn shadow(context: &Context, side: Side, n: DVec2) -> Option<Enclosure> {
    let radius = context.body(side)?.shape.radius;
    let corners = (0..).map_while(|i| Some(context.vertex(side, i, context.time)?.dot(n)));
    let (lo, hi) = corners.fold((f64::INFINITY, f64::NEG_INFINITY), |(lo, hi), x| (lo.min(x), hi.max(x)));
    Some(Enclosure { lo: lo - radius, hi: hi + radius })
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn where_b_lies_behind_a_nothing_is_lit_and_an_axis_of_b_ends_at_its_edge() {
        let drawn = |x: f64, axis: usize| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
                 shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [{x}, 0.5] }}
                 query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'separating-axes' }}
                 panels = [{{ layers = [{{ layer = 'projection', axis = {axis} }}] }}]"
            );
            let scene = open_text("axes", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            draw(&plan, plan.theme, "axes")
        };
        let lit = |figure: &crate::figure::Figure| paths(&figure.drawing.items, "lit").len();
        // Edges 1 to 4 are A's, counted from below: the second faces right, the fourth left.
        assert_eq!([lit(&drawn(4.0, 2)), lit(&drawn(4.0, 4))], [1, 0]);
        // The normal of B's left edge: its arrow comes from the left, and ends at x = 0.5.
        let figure = drawn(1.5, 8);
        let frame = &figure.panels[0].frame;
        let bounds = paths(&figure.drawing.items, "normal")[0].contour.bounds().unwrap();
        let edge = frame.page([0.5, 0.0].into()).x;
        assert!(bounds.x1 <= edge + 0.5 && bounds.x0 < edge - 5.0, "{bounds:?} {edge}");
    }
}
