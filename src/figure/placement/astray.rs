//! Lengths between bodies, whose labels keep out of those: who reads d in a body takes it for the body's.

use crate::drawing::{Offset, Rect};

use super::things::{ALIKE, Thing, Things};

/// Where along a label it is looked at whether it lies in a body, in halves of its width from the middle.
const ACROSS: [f64; 5] = [0.0, -0.5, 0.5, -1.0, 1.0];

impl Thing {
    /// The areas beside a length or a line between two points, where that lies between them: its middle is in
    /// none, nor on the outline of one. A depth is in a body, and its label may be in another one there.
    pub(super) fn beside<'t>(&self, all: &'t [Self]) -> Vec<&'t Self> {
        let &[from, to] = self.line().points() else { return Vec::new() };
        let middle = from + (to - from) * 0.5;
        let is_on = |area: &Self| area.line().square_within(middle, f64::INFINITY) <= ALIKE * ALIKE;
        let areas: Vec<&Self> = all.iter().filter(|thing| self.has_ends() && thing.is_area()).collect();
        let within = areas.iter().any(|area| area.holds(middle) || is_on(area));
        if within { Vec::new() } else { areas }
    }
}

impl Things<'_> {
    /// The part of a box, along its middle, that lies in an area which what it names lies beside.
    pub(super) fn astray(&self, rect: &Rect) -> f64 {
        if self.beside.is_empty() {
            return 0.0;
        }
        let look = |part: f64| rect.center() + Offset::new(0.5 * part * rect.width(), 0.0);
        let found = ACROSS.map(|part| self.beside.iter().any(|area| area.holds(look(part))));
        let share = 1.0 / f64::from(u8::try_from(ACROSS.len()).unwrap_or(u8::MAX));
        found.iter().filter(|&&is_in| is_in).map(|_| share).sum()
    }
}

#[cfg(test)]
mod tests {
    use super::super::rect::about;
    use super::super::things::Kind;
    use super::*;
    use crate::drawing::Point;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    fn thing(kind: Kind, points: &[(f64, f64)]) -> Thing {
        Thing::new(kind, points.iter().map(|&(x, y)| Point::new(x, y)).collect(), 0.0).unwrap()
    }

    #[test]
    fn a_length_is_astray_by_the_part_of_its_label_that_is_in_a_body_beside_it() {
        let body = thing(Kind::Area, &[(0.0, 0.0), (80.0, 0.0), (80.0, 80.0), (0.0, 80.0), (0.0, 0.0)]);
        let all = [body];
        let panel = Rect { x0: -200.0, y0: -200.0, x1: 200.0, y1: 200.0 };
        let astray = |from: (f64, f64), to: (f64, f64), x: f64| {
            let things = Things::among(&all, Some(thing(Kind::Line, &[from, to])), &panel);
            things.astray(&about(Point::new(x, 40.0), (40.0, 12.0)))
        };
        let gap = ((-30.0, 40.0), (0.0, 40.0));
        assert_eq!([-60.0, -15.0, 1.0].map(|x| (5.0 * astray(gap.0, gap.1, x)).round()), [0.0, 1.0, 3.0]);
        assert!((astray(gap.0, gap.1, 40.0) - 1.0).abs() < 1e-9);
        let radius = ((40.0, 40.0), (80.0, 40.0));
        assert_eq!(astray(radius.0, radius.1, 40.0), 0.0, "what is in the body is at home there");
        let edge = ((80.0, 0.0), (80.0, 80.0));
        assert_eq!(astray(edge.0, edge.1, 40.0), 0.0, "and so is an edge of it");
    }

    #[test]
    fn the_distance_of_bodies_stands_in_neither_where_there_is_room_beside_the_gap() {
        let scene = "shapes.A = { kind = 'aabb', half_extents = [1.25, 0.5] }
            shapes.B = { kind = 'circle', radius = 0.6, position = [1.9, 0.9] }
            query = { kind = 'overlap', of = ['A', 'B'] }";
        let scene = open_text("gap", scene).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "gap");
        let panel = &figure.panels[0];
        let d = panel.placed.iter().find(|label| label.key == "d").unwrap();
        let corner = panel.frame.page(DVec2::new(1.25, 0.5));
        let in_a = d.bounds.x0 < corner.x && d.bounds.y1 > corner.y;
        assert!(!in_a, "{:?} reaches into the box whose corner is {corner:?}", d.bounds);
    }
}
