//! What EPA tells of its polytope holds together, step by step.

use tracefig::trace::Event;

/// Each polytope is the one before, split at its nearest edge by the vertex told as beyond it; the last has
/// none beyond.
pub(crate) fn grows_by_what_it_tells(seed: u64, grown: &[&Event], slack: f64) {
    for (k, event) in grown.iter().enumerate() {
        let Event::PolytopeExpanded { vertices, nearest, edge, normal, support, beyond } = event else {
            continue;
        };
        let n = vertices.len();
        let [p, q] = [vertices[*edge], vertices[(edge + 1) % n]];
        assert!((normal.length() - 1.0).abs() < 1e-14 && (q - p).dot(*normal).abs() <= slack, "seed {seed}");
        assert!((normal.dot(p) - nearest).abs() <= slack, "seed {seed}: {event:?}");
        assert!((normal.dot(*support) - nearest - beyond).abs() <= slack, "seed {seed}: {event:?}");
        let Some(Event::PolytopeExpanded { vertices: next, .. }) = grown.get(k + 1) else {
            assert!(*beyond <= 0.0, "seed {seed}: it stopped before {event:?}");
            continue;
        };
        assert!(*beyond > 0.0, "seed {seed}: it went on after {event:?}");
        let mut split = vertices.clone();
        split.insert(edge + 1, *support);
        assert_eq!(&split, next, "seed {seed}");
    }
}
