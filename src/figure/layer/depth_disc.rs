//! The disc of the depth about the deepest point of bodies that overlap.
//!
//! A push of the length of the depth, whichever way, takes the point to the disc's rim. Where the disc lies
//! within the other body, no shorter push takes the point out of it: the depth is that of the point too.

use std::f64::consts::PI;

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{Anchor, Label, Outline, Pen, Rank, Size, Sketch, Wash, Weight, angle_of};
use crate::geometry::{DVec2, Side, perp};

/// Opacity of the disc's line, and of its area, through which the colours of both bodies are still seen.
const DISC: f64 = 0.7;
const TINT: f64 = 0.08;

/// By what part of its radius the disc may leave the body: a rounding, or the chord of an arc; less than is
/// seen.
const UNSEEN: f64 = 1e-3;

/// The deepest point about which the disc of the depth lies within the other body, and that body; `None`
/// where both discs leave it.
pub(super) fn disc_place(context: &Context, time: f64, answer: &Separation) -> Option<(DVec2, Side)> {
    let (depth, [p, q]) = (-answer.separation, answer.points);
    let lies_in = |&(center, side): &(DVec2, Side)| {
        let Some(outline) = context.outline(side, time) else { return false };
        let points = outline.sampled();
        let next = points.iter().cycle().skip(1);
        points.iter().zip(next).all(|(&from, &to)| off(center, [from, to]) >= depth * (1.0 - UNSEEN))
    };
    [(q, Side::A), (p, Side::B)].into_iter().find(lies_in)
}

/// Draws the disc of the depth about the deepest point, where it lies within the other body: a shorter push,
/// whichever way, leaves the point inside. Its rim alone, or with a tint.
pub(super) fn disc(sketch: &mut Sketch, (context, time): (&Context, f64), answer: &Separation, rim: bool) {
    let Some((center, side)) = disc_place(context, time, answer) else { return };
    let depth = -answer.separation;
    let (role, pen) = (Role::Translation, Pen::dimension(Role::Translation).opacity(DISC));
    sketch.part("disc").weight(Weight::Background);
    let area = Outline::circle(center, depth);
    sketch.area(&area, (!rim).then(|| Wash::faint(role, TINT)), Some(pen));
    // In the half that the push, an arrow from B's deepest point to A's, does not lie in.
    let away = if side == Side::A { -*answer.normal } else { *answer.normal };
    let half = Outline::sector(center, depth, angle_of(-perp(away)), PI);
    let label = Label::new("disc", "", Anchor::inside(&half), role);
    // The body's own name in the disc would be the disc's.
    sketch.label(label.rank(Rank::Word).size(Size::Note)).unnamed(Anchor::inside(&area));
}

/// How far a point is from a straight piece.
fn off(point: DVec2, [from, to]: [DVec2; 2]) -> f64 {
    let along = to - from;
    let share = ((point - from).dot(along) / along.length_squared()).clamp(0.0, 1.0);
    point.distance(if share.is_nan() { from } else { from + along * share })
}

#[cfg(test)]
mod tests {
    use crate::drawing::Contour;
    use crate::figure::layer::tests::paths;
    use crate::figure::{draw, plan};
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    #[test]
    fn the_disc_of_the_depth_is_drawn_where_it_lies_within_the_other_body() {
        // A's vertex (-0.5, 0) lies 0.5 deep in B, whose other edges are farther from it, or nearer.
        for (high, drawn) in [(2.0, true), (0.25, false)] {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-0.5, 0], [1, -0.2], [1, 0.2]] }}
                shapes.B = {{ kind = 'polygon', vertices = [[0, -2], [0, {high}], [-4, {high}], [-4, -2]] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ layers = [{{ layer = 'separation', disc = true }}] }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            let disc = paths(&figure.drawing.items, "disc").into_iter().next();
            assert_eq!(disc.is_some(), drawn, "{high}");
            let Some(Contour::Circle { center, radius }) = disc.map(|disc| &disc.contour) else { continue };
            let frame = &figure.panels[0].frame;
            let [at, rim] = [-0.5, 0.0].map(|x| frame.page(DVec2::new(x, 0.0)));
            assert!((*center - at).length() < 1e-6 && (radius - (rim - at).length()).abs() < 1e-6);
        }
    }

    #[test]
    fn a_rim_alone_has_no_tint() {
        let tinted = |options: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'polygon', vertices = [[-0.5, 0], [1, -0.2], [1, 0.2]] }}
                shapes.B = {{ kind = 'polygon', vertices = [[0, -2], [0, 2], [-4, 2], [-4, -2]] }}
                query = {{ kind = 'separation', of = ['A', 'B'] }}
                panels = [{{ layers = [{{ layer = 'separation', disc = true{options} }}] }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "s");
            paths(&figure.drawing.items, "disc")[0].fill.is_some()
        };
        assert!(tinted("") && !tinted(", rim = true"));
    }

    #[test]
    fn what_has_nothing_to_draw_is_told() {
        let told = |options: &str, at: f64| {
            let text = format!(
                "shapes.plate = {{ kind = 'box', half_extents = [2, 1] }}
                shapes.coin = {{ kind = 'circle', radius = 0.5, position = [0.3, {at}] }}
                query = {{ kind = 'separation', of = ['plate', 'coin'] }}
                panels = [{{ layers = ['shapes', {{ layer = 'separation', {options} = true }}] }}]"
            );
            let scene = open_text("s.toml", &text).unwrap().scene;
            let warnings = plan(&scene).unwrap().warnings;
            warnings.iter().map(|note| note.fault.to_string()).collect::<Vec<_>>()
        };
        let apart = |option| [format!("`{option}` of `separation` draws nothing: the bodies do not overlap")];
        assert_eq!(told("disc", 4.0), apart("disc"));
        assert_eq!(told("rival", 4.0), apart("rival"));
        // Deep in the plate the coin's lowest point would be out below sooner than above.
        assert!(told("disc", 0.2)[0].ends_with("the deepest point alone is out sooner another way"));
        assert!(told("disc", 1.2).is_empty() && told("rival", 0.2).is_empty());
    }
}
