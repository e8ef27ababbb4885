//! Radii: one as a line from a circle's centre to its rim, or r₁ and r₂ laid under the distance of the
//! centres.

use crate::collision::Separation;
use crate::drawing::Role;
use crate::figure::context::Context;
use crate::figure::sketch::{
    Anchor, Label, Marker, Outline, Pen, Rank, SMALL_MARKER, Size, Sketch, Wash, Weight, on_circle,
};
use crate::figure::text::{number, whole_and_parts};
use crate::geometry::{DVec2, Side, perp};
use crate::trace::{Event, phrase};

use crate::scene::COMPASS;

use super::half_extents::GUIDE;
use super::reach::reaches;
use super::{Fed, LabelKey, Layer, OptionSpec, Options, Shows, Takes, Tells, number_of, part};

/// The least depth that both radii are seen to share, page pixels: their bars end in ticks as wide.
const UNSEEN: f64 = 2.25;

/// Distance of the lengths from each other, page pixels: a label of 16 fits between.
const TRACK: f64 = 32.0;

/// Distance of the first length from the larger circle, in distances of tracks.
const FIRST: f64 = 0.75;

pub(super) const LAYER: Layer = Layer {
    name: "radii",
    in_words: phrase(["radii", "Radien", "rayons", "radios"]),
    about: "radii, as lines in the circles or as lengths under the distance of the centres",
    shows: Shows::World,
    tells: Tells::Given,
    options: &[
        OptionSpec { name: "of", takes: Takes::Bodies, default: "all that are round", about: "which bodies" },
        OptionSpec {
            name: "as",
            takes: Takes::Word(&["line", "lengths", "reach", "dimension"]),
            default: "\"line\"",
            about: "a line in the circle, bars of all lengths on tracks, a body's reach from its origin \
                    (its core's, where the question is for a hit), or a dimension line at the closest point",
        },
        OptionSpec {
            name: "offset",
            takes: Takes::Number,
            default: "0",
            about: "of a dimension line: page px to the right of the way from A to B, as of `separation`",
        },
        OptionSpec {
            name: "touching",
            takes: Takes::Flag,
            default: "false",
            about: "the lengths once B is moved until both circles touch: then the radii add up to the first",
        },
        OptionSpec {
            name: "toward",
            takes: Takes::Word(&COMPASS),
            default: "square to the normal",
            about: "direction of the line",
        },
    ],
    labels: &[
        LabelKey { key: "r", about: "the radius, of one circle" },
        LabelKey { key: "r1", about: "radius of A" },
        LabelKey { key: "r2", about: "radius of B" },
        LabelKey { key: "centers", about: "distance of the centres" },
        LabelKey { key: "shared", about: "the depth; shared, where neither circle has the other's centre" },
    ],
    needs: "a round body; for lengths the algorithm \"circles\"",
    fed: |context, options| match options.word("as", "line") {
        "lengths" => Fed::by_the_scene(compared(context).is_some()),
        "reach" => Fed::Yes,
        _ => Fed::by_the_scene(!round(context, options).is_empty()),
    },
    draw,
};

/// Two circles as the algorithm compared them, in world units.
struct Compared {
    /// Centres of A and B.
    centers: [DVec2; 2],
    /// Radii of A and B.
    radii: [f64; 2],
    /// The distance of the centres.
    apart: f64,
    /// What the algorithm answered.
    answer: Separation,
}

impl Compared {
    /// Both circles once B is moved along the line of the centres until they touch.
    fn touching(mut self) -> Self {
        let n = *self.answer.normal;
        self.apart = self.radii[0] + self.radii[1];
        self.centers[1] = self.centers[0] + self.apart * n;
        self.answer.points = [self.centers[0] + self.radii[0] * n; 2];
        self
    }
}

/// What the algorithm compared.
fn compared(context: &Context) -> Option<Compared> {
    let run = context.separation_at(context.time)?;
    let answer = *run.separation()?;
    run.find_told(|event| match *event {
        Event::CirclesCompared { centers, radii, distance_squared, .. } => {
            Some(Compared { centers, radii, apart: distance_squared.sqrt(), answer })
        }
        _ => None,
    })
}

fn draw(sketch: &mut Sketch, context: &Context, options: &Options) {
    match options.word("as", "line") {
        "lengths" => lengths(sketch, context, options.flag("touching", false)),
        "reach" => reaches(sketch, context, options),
        "dimension" => dimensions(sketch, context, options),
        _ => lines(sketch, context, options),
    }
}

/// The round bodies that the scene wants.
fn round(context: &Context, options: &Options) -> Vec<Side> {
    let is_round = |side: &Side| context.body(*side).is_some_and(|body| body.shape.radius > 0.0);
    options.of(&context.sides()).into_iter().filter(is_round).collect()
}

/// Draws a radius as a line from the centre to the rim of each round body.
fn lines(sketch: &mut Sketch, context: &Context, options: &Options) {
    let sides = round(context, options);
    for &side in &sides {
        let (Some(body), Some(pose)) = (context.body(side), context.pose(side, context.time)) else {
            continue;
        };
        // Out of the vertex that is farthest that way, where the rim of a round body is a circle's.
        let out = direction(context, options);
        let vertices = body.shape.vertices.iter().map(|&v| pose.point(v));
        let Some(center) = vertices.max_by(|p, q| p.dot(out).total_cmp(&q.dot(out))) else { continue };
        let rim = center + out * body.shape.radius;
        let role = options.role(side.into());
        let number = number(body.shape.radius);
        let (key, text) = named(context, sides.len(), side, &number);
        sketch.part(part("radius", side)).line(center, rim, Pen::dimension(role).width(1.5));
        sketch.label(Label::new(key, text, Anchor::middle(center, rim), role));
    }
}

/// Key and text of the label of a radius, one of so many.
fn named(context: &Context, count: usize, side: Side, number: &str) -> (&'static str, String) {
    let (key, symbol) = match (count, side) {
        (1, _) => ("r", "r".to_owned()),
        (_, Side::A) => ("r1", context.numbered("r", side)),
        (_, Side::B) => ("r2", context.numbered("r", side)),
    };
    (key, format!("${symbol} = {number}$"))
}

/// Draws a radius as a dimension line from the closest point of each round body inwards, so that it goes on
/// where the line of their separation ends.
fn dimensions(sketch: &mut Sketch, context: &Context, options: &Options) {
    let answer = context.separation_at(context.time).and_then(|run| run.separation().copied());
    let Some(answer) = answer else { return };
    let offset = sketch.fitted(options.number("offset").unwrap_or(0.0));
    sketch.since(context.separation_at(context.time).map(|run| run.end()));
    let sides = round(context, options);
    for &side in &sides {
        let Some(body) = context.body(side) else { continue };
        // From A to B, whichever body it is, so that the line lies on the same side.
        let inward = answer.normal * body.shape.radius;
        let (from, to) = match side {
            Side::A => (answer.points[0] - inward, answer.points[0]),
            Side::B => (answer.points[1], answer.points[1] + inward),
        };
        let role = options.role(side.into());
        let (key, text) = named(context, sides.len(), side, &number(body.shape.radius));
        sketch.part(part("radius", side)).dimension(from, to, -offset, Pen::dimension(role).width(1.5));
        sketch.label(Label::new(key, text, Anchor::Beside { from: to, to: from, offset }, role));
    }
}

/// The direction of such a line, a unit vector: as asked for, else square to the normal, on its right, beside
/// everything that runs between the bodies.
fn direction(context: &Context, options: &Options) -> DVec2 {
    let word = options.word("toward", "");
    if let Some(eighth) = COMPASS.iter().position(|w| *w == word) {
        return on_circle(DVec2::ZERO, 1.0, std::f64::consts::FRAC_PI_4 * number_of(eighth));
    }
    context
        .separation_at(context.time)
        .and_then(|run| run.separation().map(|s| -perp(*s.normal)))
        .unwrap_or(DVec2::X)
}

/// A length on a track beside the circles, in the world.
struct Length {
    /// Key of its label.
    key: &'static str,
    /// Text of its label, markup.
    text: String,
    /// What it lies between, on the line of the centres.
    ends: [DVec2; 2],
    /// Colour of its label.
    role: Role,
    /// How it is drawn.
    weight: Pen,
}

/// Draws ‖A − B‖, r₁ and r₂ on tracks along the line of centres, below the circles: the radii overlap by the
/// depth.
fn lengths(sketch: &mut Sketch, context: &Context, touching: bool) {
    let Some(compared) = compared(context) else { return };
    let compared = if touching { compared.touching() } else { compared };
    let Compared { centers, radii, answer, .. } = compared;
    let n = answer.normal;
    let side = perp(*n);
    let onto = context.in_space(side) - context.in_space(DVec2::ZERO);
    let down = if onto.y > 0.0 { -side } else { side };
    let is_told = |event: &Event| matches!(event, Event::CirclesCompared { .. });
    let beside = || context.separation_at(context.time)?.last_cue(is_told);
    sketch.since(context.cue(is_told).or_else(beside));
    let tracks = tracks(context, &compared, touching);
    if answer.separation < -sketch.px(UNSEEN) && !touching {
        let track = |i: f64| down * (radii[0].max(radii[1]) + sketch.px(TRACK * (i + FIRST)));
        let [p, q] = answer.points;
        let strip = Outline::polygon(&[p + track(1.0), q + track(1.0), q + track(2.0), p + track(2.0)]);
        let wash = Wash::faint(Role::Overlap, 1.0);
        sketch.part("shared").weight(Weight::Background).area(&strip, Some(wash), None);
        // Beyond a centre one radius has it alone.
        let word = if compared.apart < radii[0].max(radii[1]) { "depth" } else { "shared" };
        let label = Label::new("shared", word, Anchor::inside(&strip), Role::Ink);
        sketch.label(label.rank(Rank::Word).size(Size::Note));
    }
    for (i, length) in tracks.iter().enumerate() {
        let out = down * (radii[0].max(radii[1]) + sketch.px(TRACK * (number_of(i) + FIRST)));
        let [p, q] = length.ends.map(|end| end + out);
        sketch.part("lengths").bar(p, q, 0.0, length.weight);
        // Between the lines that come down is no room for words, and between the radii is what they share.
        sketch.label(Label::new(length.key, length.text.clone(), Anchor::tip(p, q), length.role));
    }
    let last = |point: DVec2| {
        tracks.iter().rposition(|l| {
            l.ends.iter().any(|end| end.distance(point) <= f64::EPSILON * radii[0].max(radii[1]))
        })
    };
    let [p, q] = answer.points;
    let points = [centers[0], centers[1], p, q];
    for &point in &points[..if touching { 3 } else { 4 }] {
        let deepest = last(point).unwrap_or(tracks.len() - 1);
        let out = down * (radii[0].max(radii[1]) + sketch.px(TRACK * (number_of(deepest) + FIRST)));
        // Below both discs, through which no line need run.
        let rim = |center: DVec2, radius: f64| {
            let beside = (point - center).dot(*n);
            (radius * radius - beside * beside).max(0.0).sqrt()
        };
        let below = centers.iter().zip(radii).map(|(&center, radius)| rim(center, radius));
        let start = below.fold(0.0, f64::max);
        sketch.part("lengths").weight(Weight::Light).line(
            point + down * start,
            point + out,
            Pen::extension().opacity(GUIDE),
        );
    }
    if touching {
        sketch.part("touch").marker(p, Marker::Disc, Role::Ink, SMALL_MARKER);
    }
}

/// ‖A − B‖, or r₁ + r₂ where that is as much, r₁ and r₂, each where it lies on the line of the centres.
fn tracks(context: &Context, compared: &Compared, touching: bool) -> [Length; 3] {
    let Compared { centers, radii, apart, answer } = *compared;
    let n = answer.normal;
    let bar = |key, text, ends, role: Role, weight| Length { key, text, ends, role, weight };
    let [a, b] = Side::BOTH.map(|side| context.named(side).term());
    let [r, q] = Side::BOTH.map(|side| context.numbered("r", side));
    // What is left of the distance is p, which the separation's line bears.
    let rest = if touching { 0.0 } else { answer.separation };
    let texts = whole_and_parts(apart, &radii, rest);
    let [whole, first, second] = [0, 1, 2].map(|i| texts.get(i).map_or("", String::as_str));
    [
        bar(
            "centers",
            if touching {
                format!("${r} + {q} = {whole}$")
            } else if context.has_letters() {
                format!(r"$\|{a} - {b}\| = {whole}$")
            } else {
                format!("centres ${whole}$ apart")
            },
            centers,
            Role::Ink,
            Pen::dimension(Role::Ink).width(1.5),
        ),
        bar(
            "r1",
            format!("${r} = {first}$"),
            [centers[0], centers[0] + n * radii[0]],
            Role::A,
            Pen::highlighted(Role::A),
        ),
        bar(
            "r2",
            format!("${q} = {second}$"),
            [centers[1] - n * radii[1], centers[1]],
            Role::B,
            Pen::highlighted(Role::B),
        ),
    ]
}

#[cfg(test)]
mod tests {
    use crate::drawing::Rect;
    use crate::figure::layer::tests::{labels, paths, points};
    use crate::figure::{draw, plan};
    use crate::scene::open_text;

    #[test]
    fn the_distance_of_slanted_circles_is_named_beyond_its_end_and_not_at_a_radius() {
        for (place, radius) in [("[100, 50]", 90), ("[100, -60]", 80), ("[-80, 90]", 70)] {
            let text = format!(
                "shapes.Small = {{ kind = 'circle', radius = 40 }}
                shapes.Large = {{ kind = 'circle', radius = {radius}, position = {place} }}
                query = {{ kind = 'overlap', of = ['Small', 'Large'], algorithm = 'circles' }}"
            );
            let scene = open_text("slanted", &text).unwrap().scene;
            let plan = plan(&scene).unwrap();
            let figure = draw(&plan, plan.theme, "slanted");
            let label = figure.panels[0].placed.iter().find(|label| label.key == "centers").unwrap();
            let ends = points(paths(&figure.drawing.items, "lengths")[0]);
            let near = label.bounds.grown(30.0);
            assert!(
                ends.iter().any(|&end| near.union(Rect::new(end, end)) == near),
                "{place}: {:?} {ends:?}",
                label.bounds
            );
            assert_eq!(figure.faults(), [], "{place}");
        }
    }

    #[test]
    fn the_radii_and_p_add_up_to_the_distance_as_they_are_written() {
        let text = "shapes.Sun = { kind = 'circle', radius = 696 }
            shapes.Moon = { kind = 'circle', radius = 2.44, position = [700, -3] }
            query = { kind = 'separation', of = ['Sun', 'Moon'], algorithm = 'circles' }";
        let scene = open_text("sum", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        assert_eq!(labels(&draw(&plan, plan.theme, "sum"))["centers"].1, 700.01, "p is 1.57");
    }

    #[test]
    fn once_they_touch_the_radii_lie_end_to_end_under_their_sum() {
        let text = "shapes.A = { kind = 'circle', radius = 3 }
            shapes.B = { kind = 'circle', radius = 4, position = [4, 3] }
            query = { kind = 'separation', of = ['A', 'B'], algorithm = 'circles' }
            panels = [{ layers = ['shapes', { layer = 'radii', as = 'lengths', touching = true }] }]";
        let scene = open_text("touching", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "touching");
        assert_eq!(labels(&figure)["centers"].1, 7.0);
        let scale = figure.panels[0].frame.scale;
        let long = |path: &crate::drawing::Path| {
            let p = points(path);
            libm::hypot(p[1].x - p[0].x, p[1].y - p[0].y) / scale
        };
        let lengths: Vec<f64> = paths(&figure.drawing.items, "lengths").into_iter().map(long).collect();
        for wanted in [7.0, 3.0, 4.0] {
            assert!(lengths.iter().any(|l| (l - wanted).abs() < 0.01), "{wanted} in {lengths:?}");
        }
        assert!(paths(&figure.drawing.items, "shared").is_empty());
    }

    #[test]
    fn circles_whose_overlap_is_asked_have_the_step_with_their_lengths() {
        let text = "shapes.A = { kind = 'circle', radius = 2 }
            shapes.B = { kind = 'circle', radius = 3, position = [3, 4] }
            query = { kind = 'overlap', of = ['A', 'B'], algorithm = 'circles' }";
        let scene = open_text("touching", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let steps = crate::figure::draw_in_steps(&plan, plan.theme, "touching").drawing.steps;
        assert!(steps.iter().any(|step| step.sentences.join(" ").contains("squared")), "{steps:?}");
    }
}
