//! The outward unit normals nᵢ of the edges of B ⊖ A. A ray enters only through edges whose normal looks
//! against it, v · nᵢ < 0: those that it was not tested against for that have their normals muted. The letter
//! n without a number is the normal from A to B, which is against that of the edge that faces.

use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::difference::{Difference, Edge};
use crate::figure::sketch::{Anchor, Label, Pen, Rank, Size, Sketch, Weight};
use crate::geometry::{DVec2, Side};

use super::difference::{culled, difference};
use super::edge_cues::EdgeCues;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells};

/// Width, page pixels, and opacity of the normals of edges that face away: one of either kind has words.
const AWAY: (f64, f64) = (1.0, 0.6);
/// The length of a normal on the page at least, page pixels, where 1 is shorter.
const LEAST: f64 = 22.0;

pub(super) const LAYER: Layer = Layer {
    name: "edge-normals",
    about: "outward unit normals of the edges of B ⊖ A; muted where the edge faces away from the ray",
    shows: Shows::Configuration,
    tells: Tells::Built,
    options: &[
        OptionSpec {
            name: "length",
            takes: Takes::Positive,
            default: "1, or 22 px",
            about: "drawn length, units of configuration space",
        },
        OptionSpec {
            name: "signs",
            takes: Takes::Flag,
            default: "false",
            about: "says of one normal of either kind whether n · v is less or more than 0",
        },
    ],
    labels: &[
        LabelKey {
            key: "n", about: "the normal nᵢ that looks most against the ray; without one, the first"
        },
        LabelKey { key: "away", about: "the normal that looks most along the ray, with signs" },
    ],
    needs: "two convex bodies, one of them with edges",
    fed: |context, _| Fed::by_the_scene(found(context).is_some()),
    draw,
};

/// B ⊖ A at the panel's moment, if it has edges.
fn found(context: &Context) -> Option<Difference> {
    difference(context, context.difference_time()).filter(|found| !found.edges.is_empty())
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    let Some(found) = found(context) else { return };
    let length = options.number("length").unwrap_or(1.0_f64.max(sketch.px(LEAST)));
    let role = options.role(Role::Ink);
    let (skipped, v) = (culled(context), context.closing_velocity());
    let cues = EdgeCues::at(context, context.difference_time());
    let arrow = |edge: &Edge| {
        let (p, q) = found.drawn(edge);
        let middle = 0.5 * (p + q);
        (middle, middle + edge.normal * length)
    };
    for edge in &found.edges {
        let away = skipped.contains(&(edge.source == Side::B, edge.index));
        let pen = Pen::vector(if away { Role::Muted } else { role });
        let (from, tip) = arrow(edge);
        sketch.since(cues.of(edge)).part(if away { "away" } else { "facing" }).weight(Weight::Light);
        sketch.arrow(from, tip, if away { pen.width(AWAY.0).opacity(AWAY.1) } else { pen });
    }
    let against = |edge: &&Edge| edge.normal.dot(v);
    let signs = options.flag("signs", false) && v != DVec2::ZERO;
    if let Some(edge) = found.edges.iter().min_by(|e, f| against(e).total_cmp(&against(f))) {
        let (from, tip) = arrow(edge);
        sketch.since(cues.of(edge));
        let text = if signs { r"$n_i \cdot v < 0$" } else { "$n_i$" };
        let label = Label::new("n", text, Anchor::tip(from, tip), role);
        sketch.label(label.rank(Rank::Measure).size(Size::Point));
    }
    let along = found.edges.iter().max_by(|e, f| against(e).total_cmp(&against(f)));
    if let Some(edge) = along.filter(|edge| signs && against(edge) > 0.0) {
        let (from, tip) = arrow(edge);
        sketch.since(cues.of(edge));
        let label = Label::new("away", r"$n_i \cdot v > 0$", Anchor::tip(from, tip), Role::Muted);
        sketch.label(label.rank(Rank::Measure).size(Size::Point));
    }
}

#[cfg(test)]
mod tests {
    use crate::figure::layer::tests::{labels, paths};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn the_normals_that_look_along_the_ray_are_muted_and_without_a_ray_none_is() {
        let squares = "shapes.A = { kind = 'box', half_extents = [1, 1], velocity = [4, 3] }
            shapes.B = { kind = 'box', half_extents = [1, 1], position = [4, 3] }
            panels = [{ space = 'configuration', layers = ['edge-normals'] }]
            query = { of = ['A', 'B'], kind = ";
        for (kind, away) in [("'linear-sweep' }", 4), ("'separation', algorithm = 'minkowski' }", 0)] {
            let scene = open_text("normals", &format!("{squares}{kind}")).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "normals");
            // B ⊖ A has an edge of each square in every direction; an arrow is a shaft and a head.
            let count = |part| paths(&figure.drawing.items, part).len() / 2;
            assert_eq!((count("away"), count("facing")), (away, 8 - away), "{kind}");
            assert!(labels(&figure).contains_key("n"));
        }
    }

    #[test]
    fn signs_stand_at_one_normal_of_either_kind_where_there_is_a_ray() {
        for (velocity, signs) in [("[4, 3]", true), ("[0, 0]", false)] {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1], velocity = {velocity} }}
                shapes.B = {{ kind = 'box', half_extents = [1, 1], position = [4, 3] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
                panels = [{{ space = 'configuration',
                    layers = [{{ layer = 'edge-normals', signs = true }}] }}]"
            );
            let scene = open_text("normals", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let said = labels(&draw(&plan, plan.theme, "normals"));
            let [n, away] = ["n", "away"].map(|key| said.get(key).map(|label| label.0.as_str()));
            assert_eq!((n == Some(r"$n_i \cdot v < 0$"), away == Some(r"$n_i \cdot v > 0$")), (signs, signs));
        }
    }
}
