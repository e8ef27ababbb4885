//! What the fuzz target `pair` holds of any two bodies: which is called the first makes no difference.

use serde_json::Value;
use tracefig::scene::{answer_json, open_text, solve};

use super::choices::Choices;

/// Two orders of a pair have the same verdict, unless one of them ran out of steps, and bounds that both can
/// be true of one number. Separations of hits are of two moments, each the last that its order proved free.
pub(crate) fn holds(bytes: &[u8]) {
    let kinds = ["separation", "overlap", "linear-sweep", "time-of-impact"];
    let text = Choices::new(bytes).question(&kinds);
    let swapped = text.replace("[\"A\", \"B\"]", "[\"B\", \"A\"]");
    let answer = |text: &str| {
        let scene = open_text("fuzz", text).ok()?.scene;
        Some(answer_json(scene.query().kind, &solve(&scene)))
    };
    let (Some(one), Some(other)) = (answer(&text), answer(&swapped)) else { return };
    let gave_up = |answer: &Value| answer["reason"] == "iteration-limit";
    if gave_up(&one) || gave_up(&other) {
        return;
    }
    for verdict in ["outcome", "overlap"] {
        assert_eq!(one[verdict], other[verdict], "{verdict} of\n{text}{one}\n{other}");
    }
    let both = ["time_bounds", "separation_bounds"];
    for bounds in &both[..if one["outcome"] == "hit" { 1 } else { 2 }] {
        if let (Some([a, b]), Some([c, d])) = (ends(&one[*bounds]), ends(&other[*bounds])) {
            assert!(a <= d && c <= b, "{bounds} of\n{text}{one}\n{other}");
        }
    }
}

/// Both ends of an interval.
fn ends(value: &Value) -> Option<[f64; 2]> {
    let [lo, hi] = value.as_array()?.as_slice() else { return None };
    Some([lo.as_f64()?, hi.as_f64()?])
}
