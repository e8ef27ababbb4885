//! Figures of a moment: penetration, bounds, clamping, circles, boxes, frames.

use tracefig::drawing::Role::{A, B, Ink, Muted, Now, Translation};

use super::seen::dotted;
use super::{Look, figure, look};

/// 3/5 and 4/5: the box of `circle-obb` is turned by atan 4/3.
fn turned((x, y): (f64, f64)) -> (f64, f64) {
    (0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y)
}

#[test]
fn figure_1_shows_the_depth_the_normal_and_b_pushed_out() {
    let f = figure("01-penetration");
    let w = look(&f, 0, [-1.75, -3.75, 11.55, 4.35]);
    let a = [(5.0, -1.0), (1.25, 4.0), (-0.4, 3.2), (-1.2, 0.4), (-0.6, -2.2), (1.8, -3.4)];
    let b = [(1.6, 0.2), (5.2, -2.6), (8.2, -2.8), (9.4, 0.4), (7.0, 2.6)];
    // A's edges 4x + 3y = 17 and 3x − 4y = 19 are 10/5 and 15/5 from B's vertex (1.6, 0.2); along the normals
    // of B's edges there, 7x + 9y = 13 and 4x − 9y = 4.6, A reaches 31.75/√130 and 30.2/√97 past them.
    let pushed = b.map(|(x, y)| (x + 1.6, y + 1.2));
    let ghost = w.polygon(B, &pushed);
    shows![
        w.polygon(A, &a).is_some(),
        w.polygon(B, &b).is_some(),
        ghost.is_some_and(dotted),
        w.arrow(Translation, (1.6, 0.2), (3.2, 1.4)),
        // Halfway from the contact to the edge's far end.
        w.arrow(Ink, (2.225, 2.7), (3.025, 3.3)),
        // No edge of A is nearer to that vertex than 2, so that the disc lies within A.
        w.circle(Translation, (1.6, 0.2), 2.0).is_some_and(|disc| disc.fill.is_none()),
        f.says("$d = 2$"),
        f.says("$n$"),
        f.says(r"$B$ pushed out by $d\,n$"),
        f.says("any shorter push leaves $b$ in here"),
        w.text_near("$b$", (1.6, 0.2), 30.0),
        f.says("$A$"),
        f.says("$B$"),
    ];
}

#[test]
fn figure_2_shows_the_box_its_vertices_its_centre_and_who_touches_it() {
    let f = figure("02-bounding-box");
    let w = look(&f, 0, [-6.9, -3.7, 8.9, 5.75]);
    let a = [
        (-5.0, 0.5),
        (-2.5, -1.0),
        (-2.0, -3.0),
        (2.0, -1.5),
        (7.0, -1.0),
        (4.0, 1.5),
        (3.0, 5.0),
        (0.0, 1.5),
    ];
    shows![
        w.polygon(A, &a).is_some(),
        w.polygon(Now, &[(-5.0, -3.0), (7.0, -3.0), (7.0, 5.0), (-5.0, 5.0)]).is_some(),
        w.marker(Now, (-5.0, -3.0)),
        w.marker(Now, (7.0, 5.0)),
        w.marker(A, (-5.0, 0.5)),
        w.marker(A, (-2.0, -3.0)),
        w.marker(A, (7.0, -1.0)),
        w.marker(A, (3.0, 5.0)),
        w.marker(Now, (1.0, 1.0)),
        // From the centre to the edges.
        w.line(Translation, (1.0, 1.0), (7.0, 1.0)).is_some(),
        w.line(Translation, (1.0, 1.0), (1.0, -3.0)).is_some(),
        // The others, grey.
        [1, 3, 5, 7].iter().all(|&k: &usize| w.marker(Muted, a[k])),
        // One of them moved, inside the box.
        w.polygon(A, &[a[7], a[6], (-2.0, 4.0), a[0]]).is_some_and(dotted)
            && f.says("{muted|one vertex moved}"),
        w.arrow_toward(Muted, a[7], (-2.0, 4.0)),
        f.says("min $= (-5, -3)$"),
        f.says("max $= (7, 5)$"),
        f.says(r"{now|$x_{\min} = -5$}") && f.says(r"{now|$x_{\max} = 7$}"),
        f.says(r"{now|$y_{\min} = -3$}") && f.says(r"{now|$y_{\max} = 5$}"),
        f.says("$c = (1, 1)$"),
        f.says("$h_x = 6$"),
        f.says("$h_y = 4$"),
    ];
}

/// Whether V, its components, what the half-extents leave of them, the closest point and D are drawn.
fn clamps(seen: &Look, v: (f64, f64), closest: (f64, f64)) -> bool {
    let origin = (0.0, 0.0);
    seen.arrow_toward(Ink, origin, v)
        && seen.arrow(Muted, origin, (v.0, 0.0))
        && seen.arrow(Muted, origin, (0.0, v.1))
        && seen.line(A, origin, (closest.0, 0.0)).is_some_and(thick)
        && seen.line(A, origin, (0.0, closest.1)).is_some_and(thick)
        && seen.marker(A, closest)
        && seen.arrow_toward(Translation, closest, v)
}

#[test]
fn figure_3_shows_v_its_clamped_components_and_the_distance() {
    let f = figure("03-circle-box");
    let w = look(&f, 0, [-2.85, -1.35, 3.5, 2.98]);
    let closest = (2.0, 0.8);
    shows![
        w.polygon(A, &[(-2.0, -0.8), (2.0, -0.8), closest, (-2.0, 0.8)]).is_some(),
        w.circle(B, (2.5, 2.0), 0.8).is_some(),
        clamps(&w, (2.5, 2.0), closest),
        w.any_line((2.5, 0.0), (2.5, 2.0)),
        w.any_line((0.0, 2.0), (2.5, 2.0)),
        w.text_near("$B_c$", closest, 40.0),
        f.says("$V = (2.5, 2)$") && f.says("$V_x = 2.5$") && f.says("$V_y = 2$"),
        f.says("cut to $h_x$") && f.says("cut to $h_y$"),
        f.says("$h_x = 2$") && f.says("$h_y = 0.8$"),
        f.says("$D$"),
        f.says("$r = 0.8$"),
        f.says("$0.5$"),
    ];
    // The part of D, (0.5, 1.2), that the circle leaves, 1.3 - 0.8, is thick; the radius goes another way.
    let rim = (2.0 + 0.25 / 1.3, 0.8 + 0.6 / 1.3);
    let out = 0.8 * std::f64::consts::FRAC_1_SQRT_2;
    shows![
        w.line(Translation, closest, rim).is_some_and(thick),
        w.line(B, (2.5, 2.0), (2.5 + out, 2.0 + out)).is_some(),
    ];
}

#[test]
fn circle_circle_shows_centres_radii_and_the_shortfall() {
    let f = figure("circle-circle");
    let one = look(&f, 0, CIRCLES[0]);
    shows![
        one.circle(A, (0.0, 0.0), 3.0).is_some(),
        one.circle(B, (5.0, 0.0), 4.0).is_some(),
        one.marker(A, (0.0, 0.0)) && one.marker(B, (5.0, 0.0)),
        one.horizontal(Ink, 0.0, 5.0),
        one.horizontal(A, 0.0, 3.0),
        one.horizontal(B, 1.0, 5.0),
        f.says(r"$\|A - B\| = 5$"),
        f.says("$r_1 = 3$") && f.says("$r_2 = 4$"),
        one.line(Translation, (1.0, 0.0), (3.0, 0.0)).is_some() && f.says("$|p| = 2$"),
    ];
    let two = look(&f, 1, CIRCLES[1]);
    shows![
        two.circle(A, (0.0, 0.0), 3.0).is_some(),
        // Solid where it is pushed to, dotted where it was.
        two.circle(B, (5.0, 0.0), 4.0).is_some_and(dotted) && two.marker(B, (5.0, 0.0)),
        two.circle(B, (7.0, 0.0), 4.0).is_some_and(|path| path.fill.is_some()),
        two.arrow(Now, (5.0, 0.0), (7.0, 0.0)),
        // A unit vector, from B to A.
        two.arrow(Ink, (5.0, 0.0), (4.0, 0.0)),
        f.says("$N$") && f.says("$P = N p$") && f.says("$B$ pushed out") && f.says("$B$ before"),
        // Pushed out, the radii lie end to end.
        two.horizontal(Ink, 0.0, 7.0) && two.horizontal(A, 0.0, 3.0) && two.horizontal(B, 3.0, 7.0),
        f.says("$r_1 + r_2 = 7$"),
    ];
    let unit =
        |l: &super::seen::Look| super::seen::distance(l.panel.page((0.0, 0.0)), l.panel.page((1.0, 0.0)));
    assert!((unit(&one) - unit(&two)).abs() < 0.01, "{} and {}", unit(&one), unit(&two));
}

/// What both panels of `circle-circle` show, at one scale.
const CIRCLES: [[f64; 4]; 2] = [[-3.45, -7.4, 9.45, 4.4], [-3.45, -7.4, 12.185, 4.4]];

#[test]
fn box_box_lays_out_half_extents_gaps_and_centre_distance_axis_by_axis() {
    let f = figure("box-box");
    let w = look(&f, 0, [-6.9, -5.7, 13.3, 4.0]);
    shows![
        w.polygon(A, &[(-6.25, -0.5), (-0.25, -0.5), (-0.25, 3.5), (-6.25, 3.5)]).is_some(),
        w.polygon(B, &[(1.75, -3.5), (6.75, -3.5), (6.75, 0.5), (1.75, 0.5)]).is_some(),
        w.marker(A, (-3.25, 1.5)),
        w.marker(B, (4.25, -1.5)),
        w.horizontal(A, -3.25, -0.25),
        w.horizontal(Now, -0.25, 1.75),
        w.horizontal(B, 1.75, 4.25),
        w.horizontal(Ink, -3.25, 4.25),
        w.vertical(A, -0.5, 1.5),
        w.vertical(B, -1.5, 0.5),
        w.vertical(Ink, -1.5, 1.5),
        // What they share of y has a bar of its own.
        w.vertical(Muted, -0.5, 0.5),
        f.says("$h_{A,x} = 3$") && f.says("$h_{B,x} = 2.5$"),
        f.says("$h_{A,y} = 2$") && f.says("$h_{B,y} = 2$"),
        f.says("$D_x = 2$") && f.says("$D_y = -1$"),
        f.says("$|c_B - c_A|_x = 7.5$") && f.says("$|c_B - c_A|_y = 3$"),
        f.says("$c_A$") && f.says("$c_B$"),
        // Lit from A's edge to B's, up to the top.
        w.strip(Now, (-0.25, 3.5), (1.75, 3.5)),
        // What they share of y, across both.
        w.strip(Muted, (-6.25, -0.5), (-6.25, 0.5)),
    ];
}

#[test]
fn circle_obb_goes_into_the_frame_clamps_and_comes_back() {
    let f = figure("circle-obb");
    let view = [-4.55, -3.6, 3.45, 5.1];
    let vertices = [(-2.8, -1.6), (2.8, -1.6), (2.8, 1.6), (-2.8, 1.6)];
    let tilted = vertices.map(turned);
    // (-2.3, 3.6) in the world.
    let center = turned((1.5, 4.0));
    let world = look(&f, 0, view);
    shows![
        world.polygon(A, &tilted).is_some(),
        world.circle(B, (-2.3, 3.6), 1.1).is_some(),
        world.arrow_toward(Ink, (0.0, 0.0), center) && f.says("$V = (-2.3, 3.6)$"),
        world.arrow(Muted, (0.0, 0.0), turned((3.3, 0.0))) && f.says("$x$ axis"),
        world.any_line((0.0, 0.0), (3.3, 0.0)),
        f.says("$53.1°$"),
    ];
    let body = look(&f, 1, [-4.5, -3.15, 3.5, 5.55]);
    let kept = |seen: &Look, x: (f64, f64), y: (f64, f64)| {
        seen.line(A, (0.0, 0.0), x).is_some_and(thick) && seen.line(A, (0.0, 0.0), y).is_some_and(thick)
    };
    shows![
        body.polygon(A, &vertices).is_some(),
        body.circle(B, (1.5, 4.0), 1.1).is_some(),
        body.arrow_toward(Ink, (0.0, 0.0), (1.5, 4.0)) && body.arrow(Muted, (0.0, 0.0), (0.0, 4.0)),
        // V_y is cut, V_x stays.
        kept(&body, (1.5, 0.0), (0.0, 1.6)),
        body.marker(A, (1.5, 1.6)),
        f.says("$h_x$") && f.says("$h_y$"),
        f.texts.iter().any(|(t, _)| t.contains("$h_y = 1.6$") && t.contains("$h_x = 2.8$")),
    ];
    let back = look(&f, 2, view);
    // Of D = (0, 2.4) the circle takes 1.1.
    let closest = turned((1.5, 1.6));
    shows![
        back.polygon(A, &tilted).is_some(),
        back.marker(A, closest),
        kept(&back, turned((1.5, 0.0)), turned((0.0, 1.6))),
        f.says("$V$") && f.says("$V_x = 1.5$") && f.says("$V_y = 4$"),
        f.says("cut to $h_y$") && f.says("$B_c$"),
        f.says("$r$"),
        f.says("$1.3$"),
    ];
    // On the way to the centre, 1.3 up to the circle, and r.
    let unit = super::seen::distance(back.panel.page((0.0, 0.0)), back.panel.page((1.0, 0.0)));
    for (role, part) in [(Translation, 1.3), (B, 1.1)] {
        let along = back.lengths(role, (back.panel.page(closest), back.panel.page(center)));
        assert!(along.iter().any(|&x| (x - part * unit).abs() < 0.25), "{part} of {role:?}: {along:?}");
    }
}

/// The vertices of the wall B of both frames: ±0.6 along (24, 7)/25, ±1.7 along (-7, 24)/25.
pub(crate) const WALL: [(f64, f64); 4] = [(-0.1, -1.8), (1.052, -1.464), (0.1, 1.8), (-1.052, 1.464)];

#[test]
fn frames_discrete_finds_the_overlap_late_and_with_a_longer_step_never() {
    let f = figure("frames-discrete");
    let late = look(&f, 0, [-5.52, -2.12, 1.441, 2.12]);
    let never = look(&f, 1, [-5.55, -2.12, 5.13, 2.12]);
    let solid = |panel: &super::seen::Look, at| panel.circle(A, at, 1.0).is_some_and(|p| !dotted(p));
    // The wall's long edges lie on 24x + 7y = ±15. Along (24, 7)/25, the rim of A touches the one at t = 0.3,
    // is 1.48 beyond it at 0.5, and has left the other 1.98 behind at 1.
    let (start, middle, end) = ((-4.2125, 0.8), (-0.2125, 0.3), (3.7875, -0.2));
    shows![
        late.polygon(B, &WALL).is_some() && never.polygon(B, &WALL).is_some(),
        // Frames that are tested are solid, moments that are not are dotted.
        solid(&late, start) && solid(&late, middle),
        late.head(A, middle) && never.head(A, end),
        // The way begins in a dot; so does the touch that no test saw, at A's point nearest to B's line.
        late.marker(A, start) && never.marker(A, start),
        never.marker(Ink, (-0.8525, 0.78)) && never.text_near("$p$", (-0.8525, 0.78), 40.0),
        solid(&never, start) && solid(&never, end),
        never.circle(A, (-1.8125, 0.5), 1.0).is_some_and(dotted),
        f.texts.iter().filter(|(t, _)| t == "$A$ at $t = 0$").count() == 2,
        f.says("$A$ at $t = 0.5$") && f.says("$A$ at $t = 1$"),
        f.says("first touch, $t = 0.3$:") && f.says("not tested"),
    ];
    let unit =
        |l: &super::seen::Look| super::seen::distance(l.panel.page((0.0, 0.0)), l.panel.page((1.0, 0.0)));
    assert!((unit(&late) - unit(&never)).abs() < 0.01, "{} and {}", unit(&late), unit(&never));
}

fn thick(path: &tracefig::drawing::Path) -> bool {
    path.stroke.as_ref().is_some_and(|s| s.width >= 2.75)
}

#[test]
fn separating_axes_shows_shadows_that_overlap_and_shadows_with_a_gap() {
    let f = figure("separating-axes");
    let length = |l: &super::seen::Look, p: (f64, f64), q: (f64, f64)| {
        super::seen::distance(l.panel.page(p), l.panel.page(q))
    };
    let has = |l: &super::seen::Look, role, wanted: f64| {
        let (n, o) = ((1.0, 0.0), (0.0, 0.0));
        let (bars, unit) = (l.lengths(role, (l.panel.page(n), l.panel.page(o))), length(l, n, o));
        assert!(bars.iter().any(|&b| (b - wanted * unit).abs() < 0.25), "{wanted} units: {bars:?}");
    };
    // In the frame of A, whose x axis is (24, −7)/25, where light falls along A's edge.
    let one = look(&f, 0, [-1.0, -3.7, 13.0, 11.2]);
    shows![
        one.polygon(A, &[(5.4, -0.3), (5.4, 4.7), (2.1, 4.1), (1.5, 1.2)]).is_some(),
        one.polygon(B, &[(3.5, 8.0), (11.5, 2.0), (11.74, 4.32), (6.4, 9.7)]).is_some(),
        one.line(Now, (5.4, -0.3), (5.4, 4.7)).is_some(),
        f.says("overlap $= 5.4 - 3.5 = 1.9$") && f.says("gap $= 8.5 - 7 = 1.5$"),
        f.texts.iter().filter(|(t, _)| t == "$n$").count() == 2,
        f.texts.iter().filter(|(t, _)| t == "light").count() == 2,
        f.says("$0$") && f.says("$5.4$") && f.says("$3.5$") && f.says("$7$") && f.says("$8.5$"),
    ];
    // A spans 1.5 to 5.4, where its edge lies, and B 3.5 to 11.74.
    has(&one, A, 3.9);
    has(&one, B, 8.24);
    has(&one, Ink, 1.9);
    // In that of B, whose x axis is (4, 3)/5, A spans 1.86 to 7, at its vertex (7, −1.5), and B 8.5, where its edge
    // lies, to 11.6.
    let two = look(&f, 1, [-1.0, -11.4, 13.0, 3.5]);
    let from = 2.0 + 38.0 / two.panel.scale;
    shows![
        two.polygon(A, &[(3.0, -4.5), (7.0, -1.5), (4.54, 0.78), (1.86, -0.48)]).is_some(),
        two.polygon(B, &[(8.5, 2.0), (8.5, -8.0), (10.5, -6.8), (11.6, 0.7)]).is_some(),
        two.line(Now, (8.5, 2.0), (8.5, -8.0)).is_some(),
        // The gap is lit up to where light falls from, over B's upper end, and light goes through its middle.
        two.strip(Translation, (7.0, from), (8.5, from)),
        two.arrow(Translation, (7.75, from), (7.75, -8.0 - 26.0 / two.panel.scale)),
    ];
    has(&two, A, 5.14);
    has(&two, B, 3.1);
    has(&two, Translation, 1.5);
}
