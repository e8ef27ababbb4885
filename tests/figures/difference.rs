//! Figures of B ⊖ A at one moment: where its edges come from, the origin, the way out.

use tracefig::drawing::Path;
use tracefig::drawing::Role::{self, A, B, Difference, Ink, Now, Translation};

use super::seen::Look;
use super::{figure, look};

type P = (f64, f64);

/// Every edge of a difference, counter-clockwise as `(vertex, source of the edge that leaves it)`, is drawn
/// in its source's colour, and so that it can be told without colour: B's are cased, A's plain; every vertex
/// is a diamond.
fn edges_wear_their_source(panel: &Look, edges: &[(P, Role)]) {
    for (i, &(from, source)) in edges.iter().enumerate() {
        let to = edges[(i + 1) % edges.len()].0;
        let dashed = |path: &Path| path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty());
        let edge = panel.edge(source, from, to);
        assert!(edge.is_some_and(|e| !dashed(e)), "edge {i} from {from:?} to {to:?} of {source:?}");
        assert!(panel.marker(Difference, from), "a diamond at {from:?}");
    }
}

#[test]
fn figure_4_shrinks_b_to_a_point_while_a_grows_and_gives_each_edge_its_colour() {
    let f = figure("04-minkowski-difference");
    let rhombus = |x: f64, y: f64| [(x + 1.5, y), (x, y + 2.0), (x - 1.5, y), (x, y - 2.0)];
    let a = [(-3.0, -4.0), (1.0, -4.0), (1.0, -2.0), (-3.0, -2.0)];
    let world = look(&f, 0, [-5.5, -7.0, 3.5, 6.0]);
    shows![
        world.polygon(A, &a).is_some(),
        world.polygon(B, &rhombus(0.5, 3.0)).is_some(),
        world.marker(B, (0.5, 3.0)),
        f.says("$b$"),
    ];
    let grown = look(&f, 1, [-5.5, -7.0, 3.5, 6.0]);
    let dotted = |p: &Path| p.stroke.as_ref().is_some_and(|s| !s.dash.is_empty()) && p.fill.is_none();
    for (x, y) in a {
        let copy = grown.polygon(B, &rhombus(x, y));
        assert!(copy.is_some_and(dotted), "a dotted copy of B on A's vertex ({x}, {y})");
    }
    let outline = [
        (-3.0, 0.0),
        (1.0, 0.0),
        (2.5, -2.0),
        (2.5, -4.0),
        (1.0, -6.0),
        (-3.0, -6.0),
        (-4.5, -4.0),
        (-4.5, -2.0),
    ];
    for (i, &from) in outline.iter().enumerate() {
        let role = if i % 2 == 0 { A } else { B };
        assert!(
            grown.edge(role, from, outline[(i + 1) % 8]).is_some(),
            "edge {i} of the grown A is {role:?}'s"
        );
    }
    shows![
        grown.polygon(A, &a).is_some_and(|p| p.fill.is_some()),
        grown.polygon(B, &rhombus(0.5, 3.0)).is_some_and(dotted),
        grown.marker(B, (0.5, 3.0)),
    ];
    let conf = look(&f, 2, [-3.0, -2.0, 6.0, 11.0]);
    edges_wear_their_source(
        &conf,
        &[
            ((-0.5, 3.0), A),
            ((3.5, 3.0), B),
            ((5.0, 5.0), A),
            ((5.0, 7.0), B),
            ((3.5, 9.0), A),
            ((-0.5, 9.0), B),
            ((-2.0, 7.0), A),
            ((-2.0, 5.0), B),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        f.says(r"$B \ominus A$"),
        f.says("$O$"),
        conf.text_near("from $A$", (1.5, 9.0), 60.0) || conf.text_near("from $A$", (1.5, 3.0), 60.0),
        f.says("from $B$"),
    ];
}

#[test]
fn demo_obb_shows_two_supporting_vertices_and_edges_that_are_part_red_part_green() {
    let f = figure("demo-obb");
    let world = look(&f, 0, [-6.1, -5.3, 6.3, 6.6]);
    shows![
        world.polygon(A, &[(-1.5, -3.0), (3.3, 0.6), (1.5, 3.0), (-3.3, -0.6)]).is_some(),
        world.polygon(B, &[(0.3, -0.4), (3.5, 2.0), (1.7, 4.4), (-1.5, 2.0)]).is_some(),
        world.arrow(Translation, (1.5, 0.5), (0.3, 2.1)),
        world.marker(Now, (0.3, -0.4)),
        world.marker(Now, (3.5, 2.0)),
        world
            .line(Now, (0.3, -0.4), (3.5, 2.0))
            .is_some_and(|p| p.stroke.as_ref().is_some_and(|s| s.dash.is_empty())),
        world.text_near("$b_1$", (0.3, -0.4), 40.0),
        world.text_near("$b_2$", (3.5, 2.0), 40.0),
    ];
    let conf = look(&f, 1, [-5.2, -3.9, 7.2, 8.0]);
    edges_wear_their_source(
        &conf,
        &[
            ((-1.2, -3.4), B),
            ((2.0, -1.0), A),
            ((6.8, 2.6), B),
            ((5.0, 5.0), A),
            ((3.2, 7.4), B),
            ((0.0, 5.0), A),
            ((-4.8, 1.4), B),
            ((-3.0, -1.0), A),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, (1.2, -1.6), (0.0, 0.0)),
        conf.marker(Now, (2.0, -1.0)),
        f.texts.iter().filter(|(t, _)| t == "$d = 2$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
    ];
}

#[test]
fn demo_polygons_shows_the_way_out_to_the_nearest_edge() {
    let f = figure("demo-polygons");
    let world = look(&f, 0, [-6.0, -5.45, 7.0, 6.95]);
    shows![
        world.polygon(A, &[(2.5, 2.0), (-1.0, 3.0), (-4.0, 1.0), (-3.0, -2.0), (1.0, -2.5)]).is_some(),
        world.polygon(B, &[(0.0, 2.0), (3.0, -2.0), (5.0, 4.0)]).is_some(),
        world.arrow(Translation, (0.9, 0.8), (2.5, 2.0)),
    ];
    let conf = look(&f, 1, [-3.6, -5.4, 9.4, 7.0]);
    edges_wear_their_source(
        &conf,
        &[
            ((4.0, -5.0), A),
            ((7.0, -3.0), B),
            ((9.0, 3.0), A),
            ((8.0, 6.0), A),
            ((4.0, 6.5), B),
            ((-1.0, 4.5), A),
            ((-2.5, 0.0), B),
            ((0.5, -4.0), A),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, (-1.6, -1.2), (0.0, 0.0)),
        f.texts.iter().filter(|(t, _)| t == "$d = 2$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
    ];
}

#[test]
fn gjk_steps_shows_the_simplex_its_closest_point_and_the_vertex_that_comes_next() {
    let f = figure("gjk-steps");
    let view = [-1.5, -1.5, 12.5, 10.5];
    let panels = [0, 1, 2].map(|i| look(&f, i, view));
    shows![
        // b₀ − a₀ = (8.5, 3.5) − (−3, −1); then b₂ − a₃ and b₃ − a₃, on the line 4x + 3y = 25, 5 from the
        // origin.
        panels[0].marker(Now, (11.5, 4.5)),
        panels[0].arrow_toward(Translation, (0.0, 0.0), (11.5, 4.5)),
        panels[0].text_near("$w$", (2.5, 5.0), 40.0),
        panels[1].arrow_toward(Translation, (0.0, 0.0), (2.5, 5.0)),
        panels[1].text_near("$w$", (5.5, 1.0), 40.0),
        panels[2].line(Now, (2.5, 5.0), (5.5, 1.0)).is_some(),
        panels[2].arrow_toward(Translation, (0.0, 0.0), (4.0, 3.0)),
        // The supporting line through w, square to v: 11.5x + 4.5y = 51.25 in the first.
        panels[0].through((2.5, 5.0), (3.864_754, 1.512_295)),
    ];
}
