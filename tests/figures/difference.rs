//! Figures of B ⊖ A at one moment: where its edges come from, the origin, the way out.

use tracefig::drawing::Path;
use tracefig::drawing::Role::{self, A, B, Difference, Ink, Muted, Now, Translation};

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
fn figure_4_shrinks_b_to_a_point_while_a_grows_and_keeps_their_distance() {
    let f = figure("04-minkowski-difference");
    let view = [-5.2, -7.2, 6.2, 5.7];
    let triangle = |x: f64, y: f64| [(x - 1.0, y - 1.0), (x + 2.0, y - 0.5), (x + 0.5, y + 2.0)];
    let a = [(-1.0, 1.0), (-2.0, -2.0), (0.0, -4.0), (3.0, -2.0)];
    let world = look(&f, 0, view);
    // B's lowest vertex (2, 2.5) is 3 from the line 3x + 4y = 1 of A's edge, along (3, 4)/5.
    shows![
        world.polygon(A, &a).is_some(),
        world.polygon(B, &triangle(3.0, 3.5)).is_some(),
        world.marker(B, (3.0, 3.5)),
        world.line(Translation, (2.0, 2.5), (0.2, 0.1)).is_some(),
        f.says("$b$"),
    ];
    let grown = look(&f, 1, view);
    let dotted = |p: &Path| p.stroke.as_ref().is_some_and(|s| !s.dash.is_empty()) && p.fill.is_none();
    // Each vertex of A less a vertex of B seen from b, whichever is farther out.
    let outline =
        [(0.0, 2.0), (-3.0, 1.5), (-4.0, -1.5), (-2.5, -4.0), (-0.5, -6.0), (2.5, -4.0), (4.0, -1.0)];
    for (i, role) in [B, A, B, A, A, B, A].into_iter().enumerate() {
        let edge = grown.edge(role, outline[i], outline[(i + 1) % 7]);
        assert!(edge.is_some(), "edge {i} of the grown A is {role:?}'s");
    }
    // Moved and not turned, B touches the middle of an edge of A with a vertex; its point is on the outline.
    let around = |p: P| grown.polygon(B, &triangle(p.0, p.1)).is_some_and(dotted) && grown.marker(B, p);
    shows![
        grown.polygon(A, &a).is_some_and(|p| p.fill.is_some()),
        grown.polygon(B, &triangle(3.0, 3.5)).is_some_and(dotted),
        grown.marker(B, (3.0, 3.5)),
        grown.line(Translation, (3.0, 3.5), (1.2, 1.1)).is_some(),
        around((-3.5, 0.0)),
        around((1.0, -5.0)),
    ];
    let conf = look(&f, 2, [-2.7, -2.1, 8.7, 10.8]);
    edges_wear_their_source(
        &conf,
        &[
            ((3.0, 1.5), B),
            ((6.0, 2.0), A),
            ((7.0, 5.0), B),
            ((5.5, 7.5), A),
            ((3.5, 9.5), A),
            ((0.5, 7.5), B),
            ((-1.0, 4.5), A),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.line(Translation, (0.0, 0.0), (1.8, 2.4)).is_some(),
        f.texts.iter().filter(|(t, _)| t == "$d = 3$").count() == 3,
        f.says(r"$B \ominus A$"),
        f.says("$O$"),
        conf.text_near("from $A$", (2.0, 8.5), 60.0),
        conf.text_near("from $B$", (6.25, 6.25), 60.0),
    ];
}

#[test]
fn demo_obb_shows_two_supporting_vertices_and_edges_that_are_part_red_part_green() {
    let f = figure("demo-obb");
    let world = look(&f, 0, [-5.8, -4.45, 5.8, 6.55]);
    shows![
        world.polygon(A, &[(-1.5, -3.0), (3.3, 0.6), (1.5, 3.0), (-3.3, -0.6)]).is_some(),
        world.polygon(B, &[(0.7, -0.1), (2.3, 1.1), (0.5, 3.5), (-1.1, 2.3)]).is_some(),
        // From the middle of what the parallel edges share, along (-3, 4)/5.
        world.arrow(Translation, (1.5, 0.5), (0.3, 2.1)),
        world.marker(Now, (0.7, -0.1)),
        world.marker(Now, (2.3, 1.1)),
        world
            .line(Now, (0.7, -0.1), (2.3, 1.1))
            .is_some_and(|p| p.stroke.as_ref().is_some_and(|s| s.dash.is_empty())),
        world.text_near("$b_1$", (0.7, -0.1), 40.0),
        world.text_near("$b_2$", (2.3, 1.1), 40.0),
    ];
    let conf = look(&f, 1, [-5.2, -3.8, 6.4, 7.2]);
    edges_wear_their_source(
        &conf,
        &[
            ((-0.8, -3.1), B),
            ((0.8, -1.9), A),
            ((5.6, 1.7), B),
            ((3.8, 4.1), A),
            ((2.0, 6.5), B),
            ((0.4, 5.3), A),
            ((-4.4, 1.7), B),
            ((-2.6, -0.7), A),
        ],
    );
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, (1.2, -1.6), (0.0, 0.0)),
        conf.marker(Now, (0.8, -1.9)),
        f.texts.iter().filter(|(t, _)| t == "depth $d = 2$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
        conf.line(Muted, (0.0, 0.0), (-2.0, -1.5)).is_some(),
        f.says("$2.5$: longer"),
    ];
}

#[test]
fn demo_polygons_shows_the_way_out_to_the_nearest_edge() {
    let f = figure("demo-polygons");
    let world = look(&f, 0, [-5.5, -5.1, 8.2, 7.9]);
    // B's edge on the line 4x + 3y = 6 goes to A's vertex (2.5, 2), along (4, 3)/5 by 2.
    shows![
        world.polygon(A, &[(2.5, 2.0), (-1.0, 3.5), (-4.0, 1.0), (-3.0, -2.0), (0.0, -2.5)]).is_some(),
        world.polygon(B, &[(-0.75, 3.0), (3.0, -2.0), (5.0, 4.0)]).is_some(),
        world.polygon(B, &[(0.85, 4.2), (4.6, -0.8), (6.6, 5.2)]).is_some_and(|p| p.fill.is_none()),
        world.arrow(Translation, (0.9, 0.8), (2.5, 2.0)),
        f.says("$B$ pushed out"),
    ];
    let conf = look(&f, 1, [-4.0, -6.0, 9.7, 7.0]);
    edges_wear_their_source(
        &conf,
        &[
            ((4.0, -5.5), A),
            ((7.0, -3.0), B),
            ((9.0, 3.0), A),
            ((8.0, 6.0), A),
            ((5.0, 6.5), B),
            ((-0.75, 5.5), A),
            ((-3.25, 1.0), B),
            ((0.5, -4.0), A),
        ],
    );
    // The next way out is square to the edge from (-0.75, 5.5) to (-3.25, 1): 17.125 / √26.5 = 3.327 long.
    let foot = (-4.5 * 17.125 / 26.5, 2.5 * 17.125 / 26.5);
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.arrow_toward(Translation, (-1.6, -1.2), (0.0, 0.0)),
        f.texts.iter().filter(|(t, _)| t == "depth $d = 2$").count() == 2,
        f.says(r"$B \ominus A$") && f.says("$O$"),
        conf.line(Muted, (0.0, 0.0), foot).is_some(),
        f.says("$3.33$: longer"),
    ];
}

#[test]
fn gjk_steps_shows_the_simplex_its_closest_point_and_the_vertex_that_comes_next() {
    let f = figure("gjk-steps");
    let view = [-0.8, -0.9, 12.2, 10.4];
    let panels = [0, 1, 2, 3].map(|i| look(&f, i, view));
    shows![
        // b₁ − a₂ = (8, 7) − (−3, 2) is farthest to the right; then b₂ − a₁ = (2, 6), b₀ − a₂ = (10, 0), and
        // b₀ − a₁ = (5, 2), which with (2, 6) is on the line 4x + 3y = 26, 5.2 from the origin.
        panels[0].marker(Now, (11.0, 5.0)),
        panels[0].arrow_toward(Translation, (0.0, 0.0), (11.0, 5.0)),
        panels[0].text_near("$w$", (2.0, 6.0), 40.0),
        panels[1].arrow_toward(Translation, (0.0, 0.0), (2.0, 6.0)),
        panels[1].text_near("$w$", (10.0, 0.0), 40.0),
        panels[1].text_near("dropped", (11.0, 5.0), 60.0),
        panels[2].line(Now, (2.0, 6.0), (10.0, 0.0)).is_some(),
        panels[2].arrow_toward(Translation, (0.0, 0.0), (3.6, 4.8)),
        panels[3].line(Now, (2.0, 6.0), (5.0, 2.0)).is_some(),
        panels[3].arrow_toward(Translation, (0.0, 0.0), (4.16, 3.12)),
        panels[3].text_near("dropped", (10.0, 0.0), 60.0),
        // The supporting line through w, square to v: 11x + 5y = 52 in the first, 0.356 of v from O.
        panels[0].through((2.0, 6.0), (3.917_808, 1.780_822)),
    ];
    // ‖v‖ is √146, √40, 6 and 5.2, and w · v/‖v‖ is 52/√146, 20/√40 and 27.6/6.
    for number in ["12.1", "6.32", "6", "5.2"] {
        assert!(f.says(&format!(r"$\|v\| = {number}$")), "{number}");
    }
    for number in ["4.3", "3.16", "4.6"] {
        assert!(f.says(&format!("${number}$")), "{number}");
    }
}
