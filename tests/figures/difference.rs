//! Figures of B ⊖ A at one moment: where its edges come from, the origin, the way out.

use tracefig::drawing::Path;
use tracefig::drawing::Role::{self, A, B, Difference, Ink, Muted, Now, Translation};

use super::seen::{Look, dotted};
use super::{figure, look};

type P = (f64, f64);

/// Every edge of a difference, counter-clockwise as `(vertex, source of the edge that leaves it)`, is drawn
/// in its source's colour, and so that it can be told without colour: B's are cased, A's plain.
fn edges_wear_their_source(panel: &Look, edges: &[(P, Role)]) {
    for (i, &(from, source)) in edges.iter().enumerate() {
        let to = edges[(i + 1) % edges.len()].0;
        let dashed = |path: &Path| path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty());
        let edge = panel.edge(source, from, to);
        assert!(edge.is_some_and(|e| !dashed(e)), "edge {i} from {from:?} to {to:?} of {source:?}");
    }
}

#[test]
fn figure_4_shrinks_b_to_a_point_while_a_grows_and_keeps_their_distance() {
    let f = figure("04-minkowski-difference");
    let triangle = |x: f64, y: f64| [(x - 1.5, y - 0.5), (x + 0.9, y - 1.1), (x + 0.7, y + 1.2)];
    let a = [(-1.0, 1.0), (-2.0, -1.0), (1.0, -3.0), (3.0, -2.0)];
    let [bodies, world] = [0, 1].map(|i| look(&f, i, [-3.35, -4.75, 4.95, 3.75]));
    // B's vertex (1.4, 1.7) is 2 from the line 3x + 4y = 1 of A's edge, along (3, 4)/5; and b from the edge of the
    // grown A.
    shows![
        world.polygon(A, &a).is_some_and(|p| p.fill.is_some()),
        bodies.polygon(A, &a).is_some_and(|p| p.fill.is_some()),
        bodies.polygon(B, &triangle(2.9, 2.2)).is_some_and(|p| p.fill.is_some()),
        bodies.marker(B, (2.9, 2.2)),
        world.polygon(B, &triangle(2.9, 2.2)).is_some_and(dotted),
        world.marker(B, (2.9, 2.2)),
        bodies.line(Translation, (1.4, 1.7), (0.2, 0.1)).is_some(),
        world.line(Translation, (2.9, 2.2), (1.7, 0.6)).is_some(),
        f.says("$b$"),
    ];
    // Each vertex of A less a vertex of B seen from b, whichever is farther out.
    let outline = [(-2.9, 0.1), (-2.7, -2.2), (0.3, -4.2), (2.3, -3.2), (4.5, -1.5), (0.5, 1.5), (-1.9, 2.1)];
    for (i, role) in [B, A, A, B, A, B, A].into_iter().enumerate() {
        let edge = world.edge(role, outline[i], outline[(i + 1) % 7]);
        assert!(edge.is_some(), "edge {i} of the grown A is {role:?}'s");
    }
    // Moved and not turned, B touches A with a vertex; its point is on the outline.
    shows![
        world.polygon(B, &triangle(-1.2, -3.2)).is_some_and(dotted) && world.marker(B, (-1.2, -3.2)),
        world.text_near("$b$", (-1.2, -3.2), 40.0) && world.text_near("$b$", (2.9, 2.2), 40.0),
    ];
    let conf = look(&f, 2, [-2.1, -1.3, 6.2, 7.2]);
    // (2.9, 2.2) less each vertex of the grown A.
    edges_wear_their_source(
        &conf,
        &[
            ((5.8, 2.1), B),
            ((5.6, 4.4), A),
            ((2.6, 6.4), A),
            ((0.6, 5.4), B),
            ((-1.6, 3.7), A),
            ((2.4, 0.7), B),
            ((4.8, 0.1), A),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.line(Translation, (0.0, 0.0), (1.2, 1.6)).is_some(),
        f.texts.iter().filter(|(t, _)| t == "$d = 2$").count() == 3,
        f.says(r"$B \ominus A$"),
        f.says("$O$"),
        // A as it lies in the grown A, turned half round about b.
        conf.polygon(A, &[(3.9, 1.2), (4.9, 3.2), (1.9, 5.2), (-0.1, 4.2)]).is_some_and(dotted),
        f.says("$A$ turned") && f.says("half a turn"),
        conf.text_near("from $A$", (1.6, 5.9), 60.0),
        conf.text_near("from $B$", (-0.5, 4.55), 60.0),
    ];
}

#[test]
fn demo_obb_shows_two_supporting_vertices_and_edges_that_are_part_red_part_green() {
    let f = figure("demo-obb");
    let world = look(&f, 0, [-3.65, -2.83, 3.15, 5.07]);
    // Vertices of A and B, whose x axes are (24, 7)/25.
    let turned = |x: f64, y: f64| (0.96 * x - 0.28 * y, 0.28 * x + 0.96 * y);
    let outline = [(-2.5, -1.25), (2.5, -1.25), (2.5, 1.25), (-2.5, 1.25)].map(|(x, y)| turned(x, y));
    let of_b = [(-1.1, 0.25), (1.9, 0.25), (1.9, 2.75), (-1.1, 2.75)].map(|(x, y)| turned(x, y));
    let ([b_0, b_1, ..], [.., a_2, a_3]) = (of_b, outline);
    shows![
        world.polygon(A, &outline).is_some(),
        world.polygon(B, &of_b).is_some(),
        // From the middle of what the parallel edges share, by 1 along (-7, 24)/25.
        world.arrow(Translation, turned(0.4, 0.25), turned(0.4, 1.25)),
        // Both vertices are equally deep.
        world.marker(B, b_0) && world.text_near("$b_0$", b_0, 40.0),
        world.marker(B, b_1) && world.text_near("$b_1$", b_1, 40.0),
        world.marker(A, a_2) && world.text_near("$a_2$", a_2, 40.0),
        world.marker(A, a_3) && world.text_near("$a_3$", a_3, 40.0),
    ];
    let conf = look(&f, 1, [-4.95, -2.55, 5.25, 5.35]);
    let edges = [
        ((-3.6, -1.0), B),
        ((-0.6, -1.0), A),
        ((4.4, -1.0), B),
        ((4.4, 1.5), A),
        ((4.4, 4.0), B),
        ((1.4, 4.0), A),
        ((-3.6, 4.0), B),
        ((-3.6, 1.5), A),
    ];
    edges_wear_their_source(&conf, &edges.map(|((x, y), side)| (turned(x, y), side)));
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, turned(0.0, -1.0), (0.0, 0.0)),
        conf.marker(Difference, turned(-0.6, -1.0)),
        conf.emphasised(A, turned(-0.6, -1.0), turned(4.4, -1.0)),
        f.texts.iter().filter(|(t, _)| t == "$d = 1$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
        // What the ends of both parts come from.
        conf.text_near("$b_0 - a_2$", turned(-3.6, -1.0), 60.0),
        conf.text_near("$b_1 - a_2$", turned(-0.6, -1.0), 60.0),
        conf.text_near("$b_1 - a_3$", turned(4.4, -1.0), 60.0),
    ];
}

#[test]
fn demo_polygons_shows_the_way_out_to_the_nearest_edge() {
    let f = figure("demo-polygons");
    let world = look(&f, 0, [-4.0, -4.8, 8.3, 6.4]);
    // B's edge on the line 4x + 3y = -0.5 goes to A's vertex (2.4, 0.8), along (4, 3)/5 by 2.5.
    shows![
        world.polygon(A, &[(2.4, 0.8), (-2.0, 1.25), (-3.25, -1.5), (-0.25, -3.5)]).is_some(),
        world.polygon(B, &[(-1.25, 1.5), (1.75, -2.5), (4.5, 3.0)]).is_some(),
        world.polygon(B, &[(0.75, 3.0), (3.75, -1.0), (6.5, 4.5)]).is_some_and(dotted),
        world.arrow(Translation, (0.4, -0.7), (2.4, 0.8)),
        f.says("$B$ pushed out"),
    ];
    let conf = look(&f, 1, [-4.1, -4.2, 8.2, 7.0]);
    edges_wear_their_source(
        &conf,
        &[
            ((-0.65, -3.3), A),
            ((3.75, -3.75), B),
            ((6.5, 1.75), A),
            ((7.75, 4.5), A),
            ((4.75, 6.5), B),
            ((-1.0, 5.0), A),
            ((-3.65, 0.7), B),
        ],
    );
    // The next way out is square to the edge from (-0.65, -3.3) to (3.75, -3.75), 3.349008 away.
    let foot = (-0.340_734_824, -3.331_629_393);
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, (-2.0, -1.5), (0.0, 0.0)),
        f.texts.iter().filter(|(t, _)| t == "$d = 2.5$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
        conf.line(Muted, (0.0, 0.0), foot).is_some(),
        f.says("$3.35$, longer"),
    ];
}

#[test]
fn gjk_steps_shows_the_simplex_its_closest_point_and_the_vertex_that_comes_next() {
    let f = figure("gjk-steps");
    let view = [-2.2, -2.75, 11.2, 8.55];
    let panels = [0, 1, 2, 3].map(|i| look(&f, i, view));
    for panel in &panels {
        // (2, 5) − (3, −2), and so on: faint, as no vertex is known before it is asked for.
        let all = [(-1.0, 7.0), (1.0, 3.0), (5.0, 0.0), (9.0, 2.0), (8.0, 5.0), (2.0, 7.0)];
        let faint = |p: &Path| p.stroke.as_ref().is_some_and(|s| s.paint.opacity < 1.0 && s.width < 2.0);
        shows![panel.polygon(Difference, &all).is_some_and(faint), !panel.marker(Difference, (8.0, 5.0))];
    }
    shows![
        // b₁ − a₀ = (9, 2) is farthest to the right; then b₀ − a₁ = (−1, 7), b₁ − a₂ = (5, 0) and
        // b₀ − a₂ = (1, 3), which with (5, 0) is on the line 3x + 4y = 15, 3 from the origin.
        panels[0].marker(Now, (9.0, 2.0)) && panels[0].text_near("$w_{0} = (9, 2)$", (9.0, 2.0), 60.0),
        panels[0].arrow_toward(Translation, (0.0, 0.0), (9.0, 2.0)),
        panels[0].text_near("$w_{1} = (-1, 7)$", (-1.0, 7.0), 70.0),
        panels[1].line(Now, (9.0, 2.0), (-1.0, 7.0)).is_some(),
        panels[1].arrow_toward(Translation, (0.0, 0.0), (2.6, 5.2)),
        panels[1].text_near("$w_{2} = (5, 0)$", (5.0, 0.0), 70.0),
        panels[2].line(Now, (-1.0, 7.0), (5.0, 0.0)).is_some(),
        panels[2].arrow_toward(Translation, (0.0, 0.0), (245.0 / 85.0, 210.0 / 85.0)),
        panels[2].text_near("$w_{3} = (1, 3)$", (1.0, 3.0), 70.0),
        panels[2].text_near("$w_{0}$ dropped", (9.0, 2.0), 60.0),
        panels[3].line(Now, (5.0, 0.0), (1.0, 3.0)).is_some(),
        panels[3].arrow_toward(Translation, (0.0, 0.0), (1.8, 2.4)),
        panels[3].text_near("$w_{1}$ dropped", (-1.0, 7.0), 60.0),
        // The supporting line through w, square to v: x + 2y = 5 in the second.
        panels[1].through((5.0, 0.0), (1.0, 2.0)),
    ];
    // ‖v‖ is √85, 13/√5, 35/√85 and 3, and w · v/‖v‖ is 5/√85, 5/√5 and 25/√85: ever larger; what is
    // written is a bound too.
    for number in [r"\le 9.22", r"\le 5.82", r"\le 3.80", r"\ge 0.542", r"\ge 2.23", r"\ge 2.71"] {
        assert!(f.says(&format!("${number}$")), "{number}");
    }
    assert!(f.says("distance $= 3$"));
}
