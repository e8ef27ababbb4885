//! Where labels may stand about points, lines and notes.

use super::super::{rect::distance_to, weights::TUNED};
use super::*;

const W: &Places = &Places::TUNED;
#[test]
fn places_about_a_point_keep_clear_of_its_marker() {
    let at = Point::new(100.0, 100.0);
    for candidate in around(at, 5.0, None, (30.0, 12.0), W) {
        assert!(distance_to(&candidate.rect, at) >= 5.0, "{candidate:?}");
    }
}

#[test]
fn the_number_of_a_tick_stays_in_line_with_it_however_near_another_is() {
    let panel = Rect::new(Point::default(), Point::new(100.0, 100.0));
    let frame = Frame::fit(None, DVec2::ZERO, DVec2::splat(10.0), panel);
    let tick = Anchor::Tick { at: DVec2::splat(5.0), toward: DVec2::NEG_Y };
    let mut all = offered(&tick, (30.0, 12.0), &Things::among(&[], None, &panel), &frame, W);
    all.sort_by(|p, q| p.reluctance.total_cmp(&q.reluctance));
    let aside = all.iter().find(|place| (place.rect.center().x - 50.0).abs() > 1e-9).unwrap();
    let most = TUNED.costs.close * (1.0 - TUNED.costs.label_room / TUNED.costs.label_comfort);
    assert!(all[0].rect.y0 > 50.0 && aside.reluctance - all[0].reluctance > most, "{aside:?}");
}

#[test]
fn a_place_over_the_edge_is_moved_within_more_reluctantly() {
    let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
    let place = |x: f64, y: f64, width: f64| Candidate::new(about(Point::new(x, y), (width, 12.0)), 1.0);
    let kept = kept_in(&place(97.0, 1.0, 30.0), &panel, W).unwrap();
    assert_eq!(kept.rect, about(Point::new(82.0, 9.0), (30.0, 12.0)), "and {} px from the edge", W.from_edge);
    assert!(kept.reluctance > 1.0 + 12.0 * W.kept_in);
    assert!(kept_in(&place(85.0, 50.0, 30.0), &panel, W).is_none(), "it lies within");
    let wide = place(50.0, 50.0, 120.0);
    assert_eq!(kept_in(&wide, &panel, W).unwrap().rect, wide.rect, "it is too wide");
    // What reaches over by a few pixels may stay there, too.
    let nearly =
        [place(86.0, 50.0, 30.0), place(97.0, 1.0, 30.0)].map(|place| nearly_fits(&place, &panel, W));
    assert_eq!(nearly, [true, false]);
}

#[test]
fn what_the_view_cuts_off_is_not_in_view() {
    let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
    let frame = Frame::fit(None, DVec2::ZERO, DVec2::new(10.0, 10.0), panel);
    assert!(is_in_view(&Anchor::point(DVec2::new(9.0, 1.0)), &frame, W));
    assert!(!is_in_view(&Anchor::point(DVec2::new(12.0, 1.0)), &frame, W));
    assert!(is_in_view(&Anchor::tip(DVec2::ONE, DVec2::new(30.0, 1.0)), &frame, W), "its tail is");
    assert!(is_in_view(&Anchor::Corner(Corner::Top), &frame, W));
    let triangle = |x: f64, y: f64| {
        let area = [(0.0, 0.0), (30.0, -30.0), (30.0, 0.0), (0.0, 0.0)];
        Anchor::Inside { area: area.map(|(dx, dy)| DVec2::new(x + dx, y + dy)).to_vec() }
    };
    assert!(is_in_view(&triangle(1.0, 5.0), &frame, W));
    assert!(is_in_view(&triangle(-15.0, 12.0), &frame, W), "the view is within");
    assert!(!is_in_view(&triangle(-8.0, 32.0), &frame, W), "only the box around it is in view");
}

#[test]
fn a_dimension_has_its_label_on_the_far_side() {
    let best = beside((Point::new(0.0, 0.0), Point::new(100.0, 0.0)), -20.0, (30.0, 12.0), W)
        .into_iter()
        .min_by(|p, q| p.reluctance.total_cmp(&q.reluctance))
        .unwrap();
    assert!(best.rect.y0 > 20.0, "to the right of east is down: {best:?}");
}

#[test]
fn a_label_in_trouble_is_offered_a_square_of_places_about_its_own() {
    let panel = Rect { x0: 0.0, y0: 0.0, x1: 100.0, y1: 100.0 };
    let place = Candidate::new(about(Point::default(), (30.0, 12.0)), 1.0);
    let all = nudged(&place, &Things::among(&[], None, &panel), &TUNED);
    assert_eq!(all.len(), 13 * 13);
    assert!(all.contains(&place), "its own place is among them, at no further reluctance");
}

#[test]
fn a_line_that_the_view_cuts_off_has_its_label_at_the_middle_of_what_is_seen() {
    let panel = Rect::new(Point::default(), Point::new(100.0, 100.0));
    let frame = Frame::fit(None, DVec2::ZERO, DVec2::splat(10.0), panel);
    let [from, to] = [DVec2::new(6.0, 5.0), DVec2::new(46.0, 5.0)];
    let things = Things::among(&[], None, &panel);
    for anchor in [Anchor::Beside { from, to, offset: 0.0 }, Anchor::Along { from, to, best: Best::Middle }] {
        let all = offered(&anchor, (20.0, 12.0), &things, &frame, W).into_iter();
        let best = all.min_by(|p, q| p.reluctance.total_cmp(&q.reluctance)).unwrap();
        assert!((best.rect.center().x - 80.0).abs() < 1e-9, "{best:?}");
    }
}
