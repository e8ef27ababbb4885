//! A trace as JSON lines: a header, then a line for each event, in order.
//!
//! ```json
//! {"tracefig_trace":2,"algorithms":["minkowski"],"events":42}
//! {"event":"started","algorithm":"minkowski","at":{"time":0.0,"angle_a":0.0,"angle_b":0.0}}
//! ```
//!
//! Every event has its name under `event` and its fields under their own names; a point is a pair, a feature
//! is `{"vertex": i}` or `{"edge": i}`, an interval `{"lo": …, "hi": …}`. Numbers are written so that they
//! read back bit for bit. A field may be added; the 2 changes when one is renamed or changes its meaning.

use serde::Serialize;

use super::{Event, Trace};

/// Version of the format, in the header of every trace: since 2 an advancement counts its steps from 1.
const TRACE_FORMAT: u32 = 2;

/// The first line of a trace.
#[derive(Serialize)]
struct Header<'t> {
    /// Version of the format, under a key that tells the file apart from others.
    tracefig_trace: u32,
    /// Names of the algorithms, in the order in which they began, each once.
    algorithms: Vec<&'t str>,
    /// How many lines of events follow.
    events: usize,
}

/// The keys of the first line, and what they hold.
pub static HEADER: [(&str, &str); 3] = [
    ("tracefig_trace", "version of the format: it changes when a field is renamed or changes its meaning"),
    ("algorithms", "names of the algorithms, in the order in which they began, each once"),
    ("events", "how many lines follow, an event each"),
];

/// The forms of values in events that are no numbers, and what they are.
pub static VALUES: [(&str, &str); 5] = [
    ("[x, y]", "a point or a vector"),
    ("{\"time\": t, \"angle_a\": α, \"angle_b\": β}", "a moment, with the angles of A and B in degrees"),
    ("{\"lo\": s, \"hi\": t}", "an interval"),
    ("{\"vertex\": i} or {\"edge\": i}", "a feature of a body, numbered from 0 in the order of the file"),
    ("{\"index\": i, \"point\": [x, y]}", "a vertex, with its place in the world"),
];

/// The whole trace as JSON lines, each ended by a line feed.
///
/// # Errors
/// When a value has no form in JSON, which no event has.
///
/// ```
/// use tracefig::trace::{Event, Trace, Tracer, json_lines};
/// let mut trace = Trace::default();
/// trace.record(|| Event::Finished { outcome: "apart" });
/// let expected =
///     [r#"{"tracefig_trace":2,"algorithms":[],"events":1}"#, r#"{"event":"finished","outcome":"apart"}"#];
/// assert!(json_lines(&trace)?.lines().eq(expected));
/// # Ok::<(), serde_json::Error>(())
/// ```
pub fn json_lines(trace: &Trace) -> Result<String, serde_json::Error> {
    let mut algorithms = Vec::new();
    for event in &trace.events {
        if let Event::Started { algorithm, .. } = event
            && !algorithms.contains(algorithm)
        {
            algorithms.push(*algorithm);
        }
    }
    let header = Header { tracefig_trace: TRACE_FORMAT, algorithms, events: trace.events.len() };
    let mut lines = serde_json::to_string(&header)?;
    lines.push('\n');
    for event in &trace.events {
        lines.push_str(&serde_json::to_string(event)?);
        lines.push('\n');
    }
    Ok(lines)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{DVec2, Feature, Side};
    use crate::trace::{Goal, Tracer};

    #[test]
    fn numbers_read_back_bit_for_bit() {
        let mut trace = Trace::default();
        let foot = DVec2::new(0.1 + 0.2, -5e-324);
        trace.record(|| Event::CandidateImproved {
            goal: Goal::LeastPenetrating,
            distance: -1.0 / 3.0,
            foot,
            source: (Side::B, Feature::Edge(3)),
        });
        let lines = json_lines(&trace).unwrap();
        let event: serde_json::Value = serde_json::from_str(lines.lines().nth(1).unwrap()).unwrap();
        assert_eq!(event["event"], "candidate-improved");
        assert_eq!(event["goal"], "least-penetrating");
        assert_eq!(event["distance"].as_f64(), Some(-1.0 / 3.0));
        assert_eq!(event["foot"][0].as_f64(), Some(foot.x));
        assert_eq!(event["foot"][1].as_f64().map(f64::to_bits), Some(foot.y.to_bits()));
        assert_eq!(event["source"], serde_json::json!(["B", {"edge": 3}]));
    }
}
