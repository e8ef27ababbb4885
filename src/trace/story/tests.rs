//! Events in sentences.

use super::{Event, Voice, sentence, step};
use crate::geometry::{DVec2, Enclosure, Feature, Names, Side};
use crate::trace::{Goal, Moment, SupportVertex, Trace};

#[test]
fn the_only_vertex_of_a_circle_is_its_centre() {
    let event = Event::DifferenceEdgeFound {
        source: Side::B,
        edge: 2,
        vertex: 0,
        from: DVec2::ZERO,
        to: DVec2::X,
        normal: DVec2::NEG_Y,
        distance: 1.0,
    };
    let [plain, circle] = [[false; 2], [true, false]].map(|circles| {
        let names = Names::new("puck", Some("goal")).of_circles(circles);
        sentence(&event, &names)
    });
    assert!(plain.starts_with("Edge 2 of goal with vertex 0 of puck is"), "{plain}");
    assert!(circle.starts_with("Edge 2 of goal with the centre of puck is"), "{circle}");
}

#[test]
fn a_tie_is_told_with_both_vertices() {
    let at = |index, x, y| SupportVertex { index, point: DVec2::new(x, y) };
    let event = Event::SupportFound {
        body: Side::B,
        direction: DVec2::new(0.6, -0.8),
        vertices: vec![at(0, 0.3, -0.4), at(1, 3.5, 2.0)],
    };
    let expected =
        "Farthest along (0.6, -0.8) on B: vertex 0 at (0.3, -0.4) and vertex 1 at (3.5, 2), a tie.";
    assert_eq!(sentence(&event, &Names::default()), expected);
}

#[test]
fn bodies_have_the_names_of_the_scene_in_words_and_in_formulas() {
    let names = Names::new("bullet", Some("the wall"));
    let at = Moment { time: 0.5, angle_a: 0.0, angle_b: 90.0 };
    let compared = Event::ExtentsCompared {
        centers: [DVec2::ZERO, DVec2::splat(3.0)],
        half_extents: [DVec2::ONE; 2],
        gap: DVec2::ONE,
    };
    let overlapping = Event::AxisTested {
        axis: DVec2::X,
        source: (Side::B, Feature::Edge(3)),
        interval_a: Enclosure { lo: 0.0, hi: 2.0 },
        interval_b: Enclosure { lo: 1.5, hi: 4.0 },
        gap: -0.5,
    };
    let told = [
        (
            overlapping,
            "Along (1, 0), against the normal of edge 3 of \"the wall\": bullet spans 0 to 2, \"the wall\" \
             spans 1.5 to 4, where \"the wall\" begins 0.5 before bullet ends.",
        ),
        (
            Event::Started { algorithm: "any", at },
            "any looks at bullet and \"the wall\" at t = 0.5 \
             (bullet at 0 deg, \"the wall\" at 90 deg).",
        ),
        (
            compared,
            "D = |c(\"the wall\") - c(bullet)| - (h(bullet) + h(\"the wall\")) \
             = (3, 3) - ((1, 1) + (1, 1)) = (1, 1).",
        ),
    ];
    for (event, expected) in told {
        assert_eq!(sentence(&event, &names), expected);
    }
}

#[test]
fn a_query_about_one_body_does_not_speak_of_another() {
    let at = Moment { time: 0.0, angle_a: 30.0, angle_b: 0.0 };
    let event = Event::Started { algorithm: "any", at };
    let told = sentence(&event, &Names::new("crate_1", None));
    assert_eq!(told, "any looks at crate_1 at t = 0 (crate_1 at 30 deg).");
}

#[test]
fn what_rounding_leaves_of_a_place_on_a_line_has_no_digits_and_no_side() {
    let edge = |distance| Event::DifferenceEdgeFound {
        source: Side::A,
        edge: 1,
        vertex: 3,
        from: DVec2::new(0.0, 1.5),
        to: DVec2::new(0.0, -0.5),
        normal: DVec2::NEG_X,
        distance,
    };
    let told = |distance| sentence(&edge(distance), &Names::default());
    assert!(told(f64::EPSILON).ends_with("the origin is less than 1e-15 from its line."), "{}", told(1e-16));
    assert!(told(-1e-9).ends_with("the origin is 1e-9 inside its line."), "{}", told(-1e-9));
}

#[test]
fn a_polytope_tells_the_vertices_that_no_sentence_before_it_told() {
    let told = |count: usize| {
        let vertices = [[2.0, 0.0], [0.0, 2.0], [-2.0, -1.0], [1.0, -3.0]].map(DVec2::from);
        let event = Event::PolytopeExpanded {
            vertices: vertices[..count].to_vec(),
            edge: 0,
            nearest: 0.5,
            normal: DVec2::X,
            support: DVec2::new(1.0, -3.0),
            beyond: 0.5,
        };
        sentence(&event, &Names::default())
    };
    assert!(
        told(3)
            .starts_with("The polytope has 3 vertices, (2, 0), (0, 2) and (-2, -1); its nearest edge is 0.5")
    );
    assert!(told(4).starts_with("The polytope has 4 vertices; its nearest edge is 0.5 from"), "{}", told(4));
}

#[test]
fn a_simplex_around_the_origin_looks_nowhere_further() {
    let (vertices, direction) = (vec![DVec2::X, DVec2::NEG_X], DVec2::ZERO);
    let event = Event::SimplexUpdated { vertices, closest: DVec2::ZERO, direction };
    let expected = "The simplex is (1, 0) and (-1, 0); the origin is in it.";
    assert_eq!(sentence(&event, &Names::default()), expected);
}

#[test]
fn a_centre_inside_its_box_is_not_clamped_and_leaves_by_the_nearest_side() {
    let v = DVec2::new(0.3, 0.1);
    let event = Event::Clamped {
        body: Side::B,
        v,
        half_extents: DVec2::new(1.5, 0.9),
        clamped: v,
        closest: DVec2::new(0.2, 0.95),
        d: DVec2::new(0.0, -0.8),
        radius: 0.25,
    };
    let names = Names::new("ball", Some("crate"));
    let told = sentence(&event, &names);
    assert!(
        told.contains("V = (0.3, 0.1), within the half-extents (1.5, 0.9): the centre is inside."),
        "{told}"
    );
    assert!(!told.contains("clamped"), "{told}");
    let voice = Voice::english(&names);
    let part = |of| step::sentence_of_part(&event, of, voice);
    let within = "It is within the half-extents (1.5, 0.9): the centre of ball is inside crate.";
    assert_eq!(part(step::clamped::CUT), within);
    let side = "The point of the nearest side is (0.2, 0.95) of crate; from there D = (0, -0.8).";
    assert_eq!(part(step::clamped::CLOSEST), side);
    assert_eq!(step::title(&event, step::clamped::CUT, voice), "Within the half-extents");
}

#[test]
fn an_axis_along_which_the_second_body_lies_behind_has_no_gap() {
    let tested = |side, [lo, hi]: [f64; 2]| Event::AxisTested {
        axis: DVec2::X,
        source: (side, Feature::Edge(3)),
        interval_a: Enclosure { lo: 0.0, hi: 1.0 },
        interval_b: Enclosure { lo, hi },
        gap: lo - 1.0,
    };
    let told = |side, b| sentence(&tested(side, b), &Names::default());
    let behind = "Along (1, 0), the normal of edge 3 of A: A spans 0 to 1, B spans -3 to -2, with all of B \
                  behind A: no gap this way.";
    assert_eq!(told(Side::A, [-3.0, -2.0]), behind);
    assert!(told(Side::A, [0.5, 2.0]).ends_with("where B begins 0.5 before A ends."));
    // An axis of the second body points into its edge.
    assert!(told(Side::B, [0.5, 2.0]).starts_with("Along (1, 0), against the normal of edge 3 of B: "));
}

#[test]
fn a_search_by_simplices_ends_with_the_distance_of_the_bodies_with_their_radii() {
    let simplex = Event::SimplexUpdated { vertices: vec![DVec2::X], closest: DVec2::X, direction: -DVec2::X };
    let improved = |goal, distance| Event::CandidateImproved {
        goal,
        distance,
        foot: DVec2::X,
        source: (Side::A, Feature::Vertex(2)),
    };
    let last = |event, has_radius| {
        let trace = Trace { events: vec![simplex.clone(), event], left_out: 0 };
        let told = super::story(&trace, &Names::default().of_rounds([has_radius; 2]));
        told.lines().last().unwrap().to_owned()
    };
    let apart = improved(Goal::LeastPositive, 0.5);
    assert_eq!(
        last(apart.clone(), false),
        "The distance is 0.5, from the origin to B ⊖ A at (1, 0), by vertex 2 of A."
    );
    assert_eq!(last(apart, true), "Less the radii the distance is 0.5, at (1, 0), by vertex 2 of A.");
    let deep = improved(Goal::LeastPenetrating, -0.5);
    assert_eq!(
        last(deep.clone(), false),
        "The depth is 0.5, from the origin to the outline of B ⊖ A at (1, 0), by vertex 2 of A."
    );
    assert_eq!(last(deep, true), "With the radii the depth is 0.5, at (1, 0), by vertex 2 of A.");
}

#[test]
fn a_polytope_whose_edge_holds_the_origin_is_no_way_out() {
    let told = |nearest| {
        let event = Event::PolytopeExpanded {
            vertices: [[2.0, 0.0], [0.0, 2.0], [-2.0, -1.0]].map(DVec2::from).to_vec(),
            edge: 0,
            nearest,
            normal: DVec2::X,
            support: DVec2::X,
            beyond: 0.0,
        };
        sentence(&event, &Names::default())
    };
    assert!(told(0.0).ends_with("no vertex is beyond it."), "{}", told(0.0));
    assert!(told(0.5).ends_with("it is the way out."), "{}", told(0.5));
}

#[test]
fn bodies_that_move_apart_come_nearer_by_turning_alone() {
    let event = |closing_speed| Event::Advanced {
        step: 1,
        at: Moment { time: 0.0, angle_a: 0.0, angle_b: 0.0 },
        separation: 1.0,
        normal: DVec2::X,
        points: [DVec2::ZERO, DVec2::X],
        closest: DVec2::X,
        estimate: DVec2::ZERO,
        closing_speed,
        bound: 2.0,
        next: Some(0.5),
    };
    let names = Names::default();
    let told = |speed| step::sentence_of_part(&event(speed), step::advanced::NEXT, Voice::english(&names));
    let turning = "They come nearer by turning alone, at most at 2: nothing touches before t = 0.5.";
    assert_eq!(told(-0.25), turning);
    assert!(told(0.25).starts_with("They close in at 0.25, at most 2 with the turning"), "{}", told(0.25));
}
