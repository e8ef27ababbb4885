//! Figures of motion: sweeps, advancement, the conservative bound, arcs.

use tracefig::drawing::Path;
use tracefig::drawing::Role::{A, B, Difference, Ink, Muted, Now, Translation};

use super::{figure, look};

type P = (f64, f64);

fn dashed(path: &Path) -> bool {
    path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty())
}

fn moved<const N: usize>(points: [P; N], by: P) -> [P; N] {
    points.map(|(x, y)| (x + by.0, y + by.1))
}

#[test]
fn figure_5_moves_both_bodies_in_the_world_and_the_origin_alone_along_the_ray() {
    let f = figure("05-linear-sweep");
    let a = [(-5.0, 0.0), (-7.5, -0.5), (-7.5, -2.5), (-5.0, -3.0), (-4.0, -1.5)];
    let b = [(-3.0, 4.25), (1.0, 2.25), (2.5, 4.25), (1.0, 6.25), (-1.5, 6.25)];
    let world = look(&f, 0, [-8.4, -4.9, 4.6, 6.8]);
    // After three quarters of (6, -1) and (2, -6), A's vertex (-5, 0) is on B's lower edge.
    shows![
        world.polygon(A, &a).is_some_and(|p| p.fill.is_some()),
        world.polygon(B, &b).is_some_and(|p| p.fill.is_some()),
        world.polygon(A, &moved(a, (4.5, -0.75))).is_some_and(dashed),
        world.polygon(B, &moved(b, (1.5, -4.5))).is_some_and(dashed),
        // From the points that will touch, through the contact.
        world.arrow(A, (-5.0, 0.0), (1.0, -1.0)),
        world.arrow(B, (-2.0, 3.75), (0.0, -2.25)),
        world.line(Now, (-5.0, 0.0), (-0.5, -0.75)).is_some(),
        world.line(Now, (-2.0, 3.75), (-0.5, -0.75)).is_some(),
        world.marker(Now, (-0.5, -0.75)),
        f.says("$A$ at $t = 0.75$") && f.says("$B$ at $t = 0.75$"),
        f.says("$v_A$ $= (6, -1)$") && f.says("$v_B$ $= (2, -6)$"),
    ];
    let conf = look(&f, 1, [-1.8, -1.85, 11.2, 9.85]);
    let edges = [
        ((2.0, 4.25), B),
        ((6.0, 2.25), A),
        ((8.5, 2.75), B),
        ((10.0, 4.75), A),
        ((10.0, 6.75), B),
        ((8.5, 8.75), A),
        ((6.0, 9.25), B),
        ((3.5, 9.25), B),
        ((2.0, 7.25), A),
        ((1.0, 5.75), A),
    ];
    for (i, &(from, role)) in edges.iter().enumerate() {
        assert!(conf.edge(role, from, edges[(i + 1) % 10].0).is_some_and(|e| !dashed(e)), "edge {i}");
    }
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.line(Now, (0.0, 0.0), (3.0, 3.75)).is_some(),
        conf.arrow(Ink, (0.0, 0.0), (4.0, 5.0)),
        conf.marker(Now, (3.0, 3.75)),
        f.says("$t = 0$") && f.says("$t = 1$"),
        f.says("$v$ $= (4, 5)$"),
        f.says("$t = 0.75$"),
    ];
}

#[test]
fn figure_6_steps_from_the_estimate_to_the_tangent_and_starts_again_there() {
    let f = figure("06-advancement");
    let one = look(&f, 0, [-0.9, -1.1, 8.5, 4.9]);
    let two = look(&f, 1, [3.6, -0.8, 8.3, 2.2]);
    for panel in [&one, &two] {
        shows![panel.circle(Difference, (8.0, 6.0), 6.25).is_some(), panel.head(Ink, (7.5, 0.0))];
        shows![panel.marker(Now, (6.25, 0.0))];
    }
    shows![
        f.says("$v$ $= (7.5, 0)$"),
        one.marker(Ink, (0.0, 0.0)),
        one.text_near("$t = 0.833$", (6.25, 0.0), 60.0) && two.text_near("$t = 0.833$", (6.25, 0.0), 60.0),
        one.marker(B, (3.0, 2.25)),
        one.line(Translation, (0.0, 0.0), (3.0, 2.25)).is_some(),
        one.marker(Now, (4.6875, 0.0)),
        one.head(B, (3.0 + 0.8, 2.25 + 0.6)),
        two.marker(Ink, (4.6875, 0.0)),
        two.marker(B, (4.979_260, 0.528_471)),
        two.line(Translation, (4.6875, 0.0), (4.979_260, 0.528_471)).is_some(),
        two.marker(Now, (5.936_490, 0.0)),
        two.head(B, (4.979_260 + 0.483_318, 0.528_471 + 0.875_445)),
        one.through((3.0, 2.25), (4.6875, 0.0)),
        two.through((4.979_260, 0.528_471), (5.936_490, 0.0)),
        one.text_near("$t = 0.625$", (4.6875, 0.0), 60.0)
            && two.text_near("$t = 0.625$", (4.6875, 0.0), 60.0),
        two.text_near("$t = 0.792$", (5.936_490, 0.0), 60.0),
        f.says("closest point") && f.says("tangent"),
        f.says("$n = (0.8, 0.6)$") && f.says("$n = (0.483, 0.875)$"),
        f.says("$d = 3.75$") && f.says("$d = 0.604$"),
        f.texts.iter().any(|(text, _)| text.contains("3.75 / 6 = 0.625$")),
        f.texts.iter().any(|(text, _)| text.contains("$t = 0.625 + 0.604 / 3.62 = 0.792$")),
    ];
}

#[test]
fn figure_7_adds_up_the_fastest_approach_and_shows_what_is_left_at_the_bound() {
    let f = figure("07-conservative-bound");
    let [moving, turning, then, at_last] =
        [(0, [-2.35, 3.15]), (1, [-2.35, 3.15]), (2, [-3.6, 3.2]), (3, [-3.6, 3.2])]
            .map(|(k, [from, to])| look(&f, k, [-5.1, from, 6.7, to]));
    let shape_a = [(1.0, -1.6), (1.0, 1.4), (-0.4, 2.2), (-2.2, 1.0), (-1.8, -2.4)];
    let shape_b = [(-2.0, 0.3), (-1.0, -1.7), (2.0, -1.5), (1.9, 0.9), (0.0, 1.8)];
    let turned = |(c, s): P| move |(x, y): P| (c * x - s * y, s * x + c * y);
    // cos and sin of 0.5 · 0.4, of -0.4, and of both angles at the hit, t = 0.777972598205.
    let t = 0.777_972_598_205;
    let [a, a_hit] = [(0.980_066_577_841, 0.198_669_330_795), (0.925_293_981_915, 0.379_250_638_801)]
        .map(|angle| shape_a.map(turned(angle)));
    let [b, b_hit] = [(0.921_060_994_003, -0.389_418_342_309), (0.712_337_905_938, -0.701_836_667_440)]
        .map(|angle| shape_b.map(turned(angle)));
    let (at_a, at_b) = ((-2.2, 0.5), (4.0, 0.0));
    // A's vertex (1, -1.6) then, on B's edge.
    let contact = (0.888_040_200_408, -0.212_233_433_161);
    for now in [&moving, &turning] {
        shows![
            now.polygon(A, &moved(shape_a, at_a)).is_some_and(|p| p.fill.is_some()),
            now.polygon(B, &moved(shape_b, at_b)).is_some_and(|p| p.fill.is_some()),
        ];
    }
    shows![
        // From A's edge to B's vertex; both velocities.
        moving.along(Translation, (-1.2, 0.3), (2.0, 0.3)),
        moving.arrow(A, at_a, (-0.2, 1.0)) && moving.arrow(B, at_b, (2.0, -1.0)),
        // The farthest vertices, 3 and 2.5 out, and the way that either turns.
        turning.line(A, at_a, (-4.0, -1.9)).is_some() && turning.line(B, at_b, (6.0, -1.5)).is_some(),
        turning.round(at_a, 0.6) && turning.round(at_b, 0.6),
        then.polygon(A, &moved(a, (-1.4, 0.7))).is_some_and(|p| p.fill.is_some()),
        then.polygon(B, &moved(b, (3.2, -0.4))).is_some_and(|p| p.fill.is_some()),
        // From A's vertex to the foot on B's edge.
        then.along(Translation, (-0.102_062_493, -0.669_437_194), (1.552_404_251, -0.563_991_916)),
        at_last.polygon(A, &moved(a_hit, (2.0 * t - 2.2, 0.5 * t + 0.5))).is_some_and(|p| p.fill.is_some()),
        at_last.polygon(B, &moved(b_hit, (4.0 - 2.0 * t, -t))).is_some_and(|p| p.fill.is_some()),
        then.polygon(A, &moved(shape_a, at_a)).is_some_and(dashed),
        at_last.polygon(A, &moved(shape_a, at_a)).is_some_and(dashed),
        at_last.polygon(B, &moved(shape_b, at_b)).is_some_and(dashed),
        at_last.marker(Ink, contact),
        f.says("$d = 3.2$"),
        f.says("$x_1$, $x_2$") && f.says("$r_A = 3$") && f.says("$r_B = 2.5$"),
        f.says(r"$\omega_A = 0.5$") && f.says(r"$\omega_B = -1$"),
        f.says("$v_A$ $= (2, 0.5)$") && f.says("$v_B$ $= (-2, -1)$"),
        // 2 + 2 along x by moving, 3 · 0.5 + 2.5 · 1 by turning; 3.2 / 8 = 0.4, and what is left then.
        f.texts.iter().any(|(t, _)| t.contains("nearer by 4 in a unit of time")),
        f.texts.iter().any(|(t, _)| t.contains(r"r_B|\omega_B| = 4$ at most")),
        f.texts.iter().any(|(t, _)| t.contains("$4 + 4 = 8$") && t.contains("d / 8 = 0.4$")),
        f.says("$1.66$"),
    ];
}

#[test]
fn figure_8_shows_the_arc_of_the_extreme_point_and_its_sector() {
    let f = figure("08-arc-length");
    // cos 0.8 and sin 0.8, of the point 5 from the origin.
    let (c, s) = (0.696_706_709_347, 0.717_356_090_900);
    let turned = |(x, y): P| (c * x - s * y, s * x + c * y);
    let p = (4.8, 1.4);
    let q = turned(p);
    let one = look(&f, 0, [-1.6, -1.5, 5.6, 5.0]);
    let vertices = [(-0.8, -0.7), (3.6, -0.7), p, (-0.7, 0.6)];
    // Half as far out, on the way to p.
    let [near, far] = [p, q].map(|(x, y)| (0.5 * x, 0.5 * y));
    shows![
        one.polygon(A, &vertices).is_some(),
        one.polygon(A, &vertices.map(turned)).is_some_and(dashed),
        one.any_line((0.0, 0.0), p) && one.any_line((0.0, 0.0), q),
        one.arc(Now, (0.0, 0.0), p, q),
        one.head(Now, q) || one.marker(A, q),
        one.marker(A, p) && one.marker(A, q),
        one.arc(A, (0.0, 0.0), near, far) && one.marker(A, near) && one.marker(A, far),
    ];
    // Straightened, as far out as they were: 0.8 times as long as that.
    let two = look(&f, 1, [-0.75, -1.95, 6.45, 4.55]);
    shows![
        two.any_line((0.0, 0.0), (5.0, 0.0)) && two.any_line((0.0, 0.0), (5.0, 4.0)),
        two.arrow(Now, (5.0, 0.0), (5.0, 4.0)) && two.arrow(A, (2.5, 0.0), (2.5, 2.0)),
        [(5.0, 0.0), (2.5, 0.0)].iter().all(|&at| two.marker(A, at)),
        // Between the two, every arc ends on the line to the longest.
        [3.125, 3.75, 4.375].iter().all(|&r| two.any_line((r, 0.0), (r, 0.8 * r))),
        f.says(r"slope $\theta$: every arc ends here"),
        f.says("$r_q = 2.5$") && f.says(r"$\theta\,r_q = 2$") && f.says("pivot"),
        f.says("$q$") && f.says("$q'$"),
        f.says(r"$\theta = 0.8$"),
        f.says("radius $r = 5$"),
        f.says("$L$") && f.says(r"$L = \theta\,r = 4$"),
        f.says("$p$"),
        f.says("$p'$"),
    ];
}

#[test]
fn frames_continuous_tests_the_whole_way_and_stops_a_where_it_touches() {
    let f = figure("frames-continuous");
    let view = [-5.55, -2.12, 5.13, 2.12];
    let b = super::overlap::WALL;
    let one = look(&f, 0, view);
    let (start, end) = ((-4.2125, 0.8), (3.7875, -0.2));
    // The band's edges are 1 from the way, square to (8, -1): by (1, 8)/√65.
    let (x, y) = (1.0 / 65.0_f64.sqrt(), 8.0 / 65.0_f64.sqrt());
    // After 0.3 of the way the centre (-1.8125, 0.5) is 1 from the line 24x + 7y = -15, at (-0.8525, 0.78).
    let (hit, contact) = ((-1.8125, 0.5), (-0.8525, 0.78));
    shows![
        one.circle(A, start, 1.0).is_some_and(|p| p.fill.is_some()),
        one.polygon(B, &b).is_some(),
        one.circle(Now, hit, 1.0).is_some_and(dashed),
        one.circle(A, end, 1.0).is_some_and(dashed),
        one.any_line((start.0 + x, start.1 + y), (end.0 + x, end.1 + y)),
        one.any_line((start.0 - x, start.1 - y), (end.0 - x, end.1 - y)),
        one.marker(Ink, contact),
        f.says("$A$ at $t = 0$") && one.text_near("$t = 0.3$", hit, 40.0),
        one.text_near("$t = 1$", end, 40.0),
        // The way that is gone ends where A stops.
        one.along(Now, start, hit) && one.head(Now, hit),
    ];
    let two = look(&f, 1, [-5.52, -2.12, 1.441, 2.12]);
    shows![
        two.circle(A, hit, 1.0).is_some_and(|p| p.fill.is_some()),
        two.circle(A, start, 1.0).is_some_and(dashed),
        two.along(A, start, hit) && two.head(A, hit),
        two.polygon(B, &b).is_some(),
        two.marker(Ink, contact),
        two.text_near("$p$", contact, 40.0),
    ];
    let unit =
        |l: &super::seen::Look| super::seen::distance(l.panel.page((0.0, 0.0)), l.panel.page((1.0, 0.0)));
    assert!((unit(&one) - unit(&two)).abs() < 0.01, "{} and {}", unit(&one), unit(&two));
}

#[test]
fn demo_linear_sweep_tells_the_edges_that_face_the_ray_by_their_normals() {
    let f = figure("demo-linear-sweep");
    let world = look(&f, 0, [-7.4, -1.0, 8.4, 9.3]);
    let a = [(3.5, 6.5), (7.5, 5.5), (7.0, 8.0)];
    // After 0.8 of (-7.5, -5), A's vertex (3.5, 6.5) is on B's edge from (-1.75, 0.25) to (-3.5, 5.5).
    shows![
        world.polygon(A, &a).is_some(),
        world.polygon(B, &[(-6.5, 1.0), (-1.75, 0.25), (-3.5, 5.5)]).is_some(),
        world.polygon(A, &moved(a, (-6.0, -4.0))).is_some_and(dashed),
        world.line(Now, (3.5, 6.5), (-2.5, 2.5)).is_some(),
        world.arrow(A, (3.5, 6.5), (-4.0, 1.5)),
        world.marker(Now, (-2.5, 2.5)),
        f.says("$A$ at $t = 0.8$"),
        f.says("$v_A$"),
    ];
    let conf = look(&f, 1, [-15.1, -9.05, 0.9, 1.4]);
    // Edges that face the ray have a normal against (-7.5, -5).
    let edges = [
        ((-14.0, -4.5), A, true),
        ((-13.5, -7.0), B, true),
        ((-8.75, -7.75), A, true),
        ((-5.25, -6.25), B, false),
        ((-7.0, -1.0), A, false),
        ((-11.0, 0.0), B, true),
    ];
    for (i, &(from, role, is_behind)) in edges.iter().enumerate() {
        let to = edges[(i + 1) % 6].0;
        assert!(conf.edge(role, from, to).is_some(), "edge {i} of {role:?}");
        // Its outward normal, on the right of the way around.
        let middle = |p: f64, q: f64| 0.5 * (p + q);
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        let size = libm::hypot(dx, dy);
        let (x, y) = (middle(from.0, to.0), middle(from.1, to.1));
        let role = if is_behind { Muted } else { Ink };
        // That of the edge that the ray enters, at (-6, -4), stands clear of there.
        let (x, y) = if i == 3 { (-6.5, -2.5) } else { (x, y) };
        let tip = (x + dy / size, y - dx / size);
        assert!(conf.arrow(role, (x, y), tip), "the normal of edge {i}");
    }
    shows![
        conf.marker(Ink, (0.0, 0.0)),
        conf.line(Now, (0.0, 0.0), (-6.0, -4.0)).is_some(),
        conf.arrow(Ink, (0.0, 0.0), (-7.5, -5.0)),
        f.says("$n$") && f.says("$v$"),
        conf.text_near("the last: $t = 0.8$", (-6.0, -4.0), 90.0),
        // The line of the other that looks against it, x + 4y = -11, is met before, at 0.4.
        conf.line(Muted, (-7.0, -1.0), (-3.0, -2.0)).is_some_and(dashed),
        conf.text_near("its line: $t = 0.4$", (-3.0, -2.0), 90.0),
        f.says(r"$B \ominus A$"),
    ];
}

#[test]
fn demo_angular_sweep_shows_a_new_difference_at_each_of_its_two_steps() {
    let f = figure("demo-angular-sweep");
    let b = [(-1.5, -1.25), (1.0, -1.5), (1.5, 0.0), (-0.5, 0.75)];
    // A's vertices at t = 0 and 0.597676 later, the closest points, and where the panel looks.
    let steps = [
        (
            [
                (-3.373_661_140, 2.997_966_043),
                (-0.439_218_338, 3.621_701_116),
                (-0.626_338_860, 4.502_033_957),
                (-3.560_781_662, 3.878_298_884),
            ],
            [(-1.081_385_611, 3.485_204_248), (-0.5, 0.75)],
            "$d_1 = 2.80$",
            [-1.8, -6.5, 5.8, 0.7],
        ),
        (
            [
                (0.439_808_248, 3.755_843_545),
                (2.759_124_210, 1.853_010_534),
                (3.329_974_113, 2.548_805_323),
                (1.010_658_151, 4.451_638_333),
            ],
            [(2.759_124_210, 1.853_010_534), (1.5, 0.0)],
            "$d_2 = 2.24$",
            [-5.9, -6.5, 1.7, 0.7],
        ),
    ];
    let world = look(&f, 0, [-3.85, -2.1, 3.75, 5.1]);
    for (i, (a, [p, q], said, view)) in steps.into_iter().enumerate() {
        let conf = look(&f, i + 1, view);
        shows![
            world.polygon(A, &a).is_some_and(|path| path.fill.is_some()),
            world.along(Translation, p, q),
            conf.along(Translation, (0.0, 0.0), (q.0 - p.0, q.1 - p.1)),
            f.says(said),
        ];
        let unit =
            |l: &super::seen::Look| super::seen::distance(l.panel.page((0.0, 0.0)), l.panel.page((1.0, 0.0)));
        assert!((unit(&world) - unit(&conf)).abs() < 0.01, "{} and {}", unit(&world), unit(&conf));
        edges_are_those_of_the_bodies(&conf, &a, &b);
    }
    shows![
        world.polygon(B, &b).is_some(),
        // The way of A's centre: 0.597676 of (6.5, -1).
        world.along(A, (-2.0, 3.75), (1.884_891_180, 3.152_324_434)),
        f.says("$A$ at $t_1$") && f.says("$A$ at $t_2$") && f.says("$d_1$") && f.says("$d_2$"),
    ];
}

/// The point at which something is least.
fn least(points: &[P; 4], of: impl Fn(&P) -> f64) -> P {
    points.iter().fold(points[0], |best, p| if of(p) < of(&best) { *p } else { best })
}

/// Holds that B ⊖ A has every edge of both bodies, as these lie: B's as they always did, A's turned with it.
fn edges_are_those_of_the_bodies(conf: &super::seen::Look, a: &[P; 4], b: &[P; 4]) {
    for (k, &from) in b.iter().enumerate() {
        let to = b[(k + 1) % 4];
        let far = |v: &P| v.0 * (to.1 - from.1) - v.1 * (to.0 - from.0);
        let (x, y) = least(a, far);
        let [from, to] = [from, to].map(|(u, v)| (u - x, v - y));
        assert!(conf.edge(B, from, to).is_some(), "edge {k} of B");
    }
    for (k, &(x, y)) in a.iter().enumerate() {
        let (u, v) = a[(k + 1) % 4];
        let far = |w: &P| w.0 * (v - y) - w.1 * (u - x);
        let (s, t) = least(b, far);
        assert!(conf.edge(A, (s - x, t - y), (s - u, t - v)).is_some(), "edge {k} of A");
    }
}
