//! `[query]`: what is asked, of which shapes, and by which algorithm.

use std::ops::{Range, RangeInclusive};

use crate::collision::{
    ALGORITHMS, Algorithm, Bodies, Motion, QUERIES, Query, Question, Shapes, When, of_one_scale,
};
use crate::geometry::Body;

use super::SceneQuery;
use super::body;
use super::checked::{Checked, as_list, as_text, check};
use super::expected;
use super::fields::QUERY;
use super::limits::{DEFAULT_ITERATIONS, DEFAULT_TOLERANCE, MAX_STEPS_OF_VERTICES};
use super::node::Node;
use super::problem::{Fault, Problems};
use super::suggest::quoted;

/// Reads the query; `None` where it, or a shape that it is of, is wrong.
pub(super) fn read(node: &Node, shapes: &[body::Read], p: &mut Problems) -> Option<SceneQuery> {
    let table = check(node, "query", QUERY.place, QUERY.fields, p)?;
    let question = table.text("kind").and_then(|word| QUERIES.iter().find(|q| q.word == word.value));
    let of = names(&table, shapes, p);
    if let Some(question) = question {
        count(question, &table, shapes, p);
        moment(question, &table, p);
    }
    let (question, of) = (question?, of?);
    let bodies: Vec<(&str, &Body)> = of
        .iter()
        .map(|&i| shapes[i].body.as_ref().map(|body| (shapes[i].name.value.as_str(), body)))
        .collect::<Option<_>>()?;
    let (&(_, a), b) = (bodies.first()?, bodies.get(1).map(|&(_, b)| b));
    let query = Query {
        kind: question.kind,
        a,
        b,
        time: table.number("time").map_or(0.0, |t| t.value),
        tolerance: table.number("tolerance").map_or(DEFAULT_TOLERANCE, |t| t.value),
        max_iterations: max_iterations(&bodies, &table, p),
    };
    if !fits(question, &bodies, &table, p) {
        return None;
    }
    Some(SceneQuery {
        kind: query.kind,
        algorithm: algorithm(&query, node, &table, p)?,
        time: query.time,
        tolerance: query.tolerance,
        max_iterations: query.max_iterations,
        expected: expected::read(&table, question, p),
        span: table.span.clone(),
        of,
    })
}

/// The step cap: the scene's, or the usual one, lower where the shapes have thousands of vertices.
fn max_iterations(bodies: &[(&str, &Body)], table: &Checked<'_>, p: &mut Problems) -> usize {
    let vertices = bodies.iter().map(|(_, body)| body.shape.core.len()).sum::<usize>();
    let most = MAX_STEPS_OF_VERTICES / vertices.max(1);
    let Some(given) = table.count("max_iterations") else { return DEFAULT_ITERATIONS.min(most) };
    if given.value > most {
        let expected = format!("at most {most} for shapes of {vertices} vertices");
        let (key, got) = ("max_iterations".to_owned(), given.value.to_string());
        p.add(Fault::OutOfRange { key, expected, got }, &given.span);
    }
    given.value
}

/// Where a key's value stands, or the table where it is left out.
fn span_of(table: &Checked<'_>, key: &str) -> Range<usize> {
    table.get(key).map_or(table.span.clone(), |node| node.span.clone())
}

/// Indices of the shapes of `of`; `None` where one doesn't exist or stands twice.
fn names(table: &Checked<'_>, shapes: &[body::Read], p: &mut Problems) -> Option<Vec<usize>> {
    let mut found = Vec::new();
    let mut all_known = true;
    for item in as_list(table.get("of")?)? {
        let name = as_text(item)?;
        if p.is_full() {
            return None;
        }
        match shapes.iter().position(|s| s.name.value == name) {
            Some(i) if found.contains(&i) => {
                let message = format!("`of`: expected different shapes, got `{name}` twice");
                let others = shapes.iter().filter(|s| s.name.value != name).map(|s| s.name.value.clone());
                let others: Vec<String> = others.collect();
                let help = match &others[..] {
                    [] => "add another body: [shapes.B]".to_owned(),
                    _ => format!("the scene has {} besides", quoted(&others)),
                };
                p.add(Fault::Conflict { message, help }, &item.span);
                all_known = false;
            }
            Some(i) => found.push(i),
            None => {
                let known: Vec<String> = shapes.iter().map(|s| s.name.value.clone()).collect();
                // Where there are none, that is what is wrong, and it has been told.
                if !known.is_empty() {
                    p.add(Fault::UnknownBody { got: name.to_owned(), known }, &item.span);
                }
                all_known = false;
            }
        }
    }
    all_known.then_some(found)
}

/// Complains where `of` names too few or too many shapes.
fn count(question: &Question, table: &Checked<'_>, shapes: &[body::Read], p: &mut Problems) {
    let Some(node) = table.get("of") else { return };
    let got = as_list(node).unwrap_or_default().len();
    if !numbers(question.bodies).contains(&got) {
        let expected = match question.bodies {
            Bodies::OneOrTwo => "one or two shapes",
            Bodies::Two => "two shapes",
        };
        let known = shapes.iter().map(|shape| shape.name.value.clone()).collect();
        p.add(Fault::WrongCount { kind: question.word, expected, got, known }, &node.span);
    }
}

/// How many names `of` may have.
fn numbers(bodies: Bodies) -> RangeInclusive<usize> {
    match bodies {
        Bodies::OneOrTwo => 1..=2,
        Bodies::Two => 2..=2,
    }
}

/// Complains where a time is given to a question about all of the motion.
fn moment(question: &Question, table: &Checked<'_>, p: &mut Problems) {
    if let Some(time) = table.number("time").filter(|_| question.when == When::OverTheMotion) {
        let message = format!("`time` does not apply to a `{}`, which is about all of [0, 1]", question.word);
        let help = "leave it out; a moment is a panel's: [[panels]] with `time`".to_owned();
        p.add(Fault::Conflict { message, help }, &time.span);
    }
}

/// Whether the question can be asked of these shapes at all, by whatever algorithm.
fn fits(question: &Question, bodies: &[(&str, &Body)], table: &Checked<'_>, p: &mut Problems) -> bool {
    if !numbers(question.bodies).contains(&bodies.len()) {
        return false;
    }
    let mut fits = true;
    for (name, body) in bodies {
        if question.motion == Motion::Unturning && body.turns() {
            p.add(Fault::TurningBody { body: (*name).to_owned() }, &span_of(table, "kind"));
            fits = false;
        }
        if question.shapes == Shapes::Convex && body.shape.core.is_empty() {
            let words = QUERIES.iter().filter(|q| q.shapes == Shapes::Any).map(|q| format!("`{}`", q.word));
            let words = words.collect::<Vec<_>>().join(", ");
            let reason = format!(
                "an `{}` is for {words} only; a `polygon` with `hull = true` is its convex hull, and it may \
                 be cut into convex pieces",
                body.shape.kind
            );
            p.add(Fault::UnsuitedShape { body: (*name).to_owned(), reason }, &span_of(table, "of"));
            fits = false;
        }
    }
    fits && suits_proofs(question, bodies, table, p)
}

/// Whether the sizes of two shapes are near enough each other for bounds to be proved, and where the question
/// is about a motion their distance and speed too.
fn suits_proofs(
    question: &Question,
    bodies: &[(&str, &Body)],
    table: &Checked<'_>,
    p: &mut Problems,
) -> bool {
    let &[(first, a), (second, b)] = bodies else { return true };
    let Err([least, largest]) = of_one_scale(a, b, question.when == When::OverTheMotion) else { return true };
    let ratio = "sizes of the two shapes, and distance and speed of a motion, span at most a factor of 1e100";
    let reason = format!("expected that {ratio}, got {least:e} and {largest:e}");
    // One whose own sizes span too much is wrong beside any other.
    let name = if of_one_scale(a, a, false).is_err() { first } else { second };
    p.add(Fault::UnsuitedShape { body: name.to_owned(), reason }, &span_of(table, "of"));
    false
}

/// The algorithm asked for, or the first that takes the query.
fn algorithm(
    query: &Query<'_>,
    node: &Node,
    table: &Checked<'_>,
    p: &mut Problems,
) -> Option<&'static Algorithm> {
    let takes = |a: &&Algorithm| a.takes(query);
    let Some(name) = table.text("algorithm") else {
        if node.get("algorithm").is_some() {
            // It was wrong, and that has been told.
            return None;
        }
        let found = ALGORITHMS.iter().find(takes);
        if found.is_none() {
            let reason = format!("no algorithm answers `{}` of these shapes", query.kind.word());
            p.add(Fault::UnsuitedShape { body: kinds(query), reason }, &span_of(table, "kind"));
        }
        return found;
    };
    let asked = ALGORITHMS.iter().find(|a| a.name == name.value)?;
    let reason = if asked.kinds.contains(&query.kind) {
        (asked.shapes)(query).err().map(str::to_owned)
    } else {
        let kinds: Vec<_> = asked.kinds.iter().map(|k| format!("`{}`", k.word())).collect();
        Some(format!("it answers {}, not `{}`", kinds.join(", "), query.kind.word()))
    };
    let Some(reason) = reason else { return Some(asked) };
    let suited = ALGORITHMS.iter().filter(takes).map(|a| a.name.to_owned()).collect();
    p.add(Fault::UnsuitedAlgorithm { algorithm: asked.name, reason, suited }, &name.span);
    None
}

/// The kinds of a query's shapes, for messages.
fn kinds(query: &Query<'_>) -> String {
    match query.b {
        Some(b) => format!("{} and {}", query.a.shape.kind, b.shape.kind),
        None => query.a.shape.kind.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use crate::collision::QueryKind;
    use crate::scene::{Source, read};

    /// The codes of what is wrong with a query of a box and a sliver, of half a width `sliver`, `far` apart.
    fn codes(kind: &str, sliver: f64, far: f64) -> Vec<&'static str> {
        let text = format!(
            "shapes.A = {{ kind = \"box\", half_extents = [1, 1] }}
             shapes.B = {{ kind = \"box\", half_extents = [{sliver:e}, 1], position = [{far:e}, 0] }}
             query = {{ kind = \"{kind}\", of = [\"A\", \"B\"] }}"
        );
        let wrong = read(&Source::new("test", &text)).err().unwrap_or_default();
        wrong.iter().map(|problem| problem.fault.code()).collect()
    }

    #[test]
    fn the_body_whose_own_sizes_span_too_much_is_named() {
        let told = |sizes: [&str; 2]| {
            let [a, b] =
                sizes.map(|half| format!("{{ kind = 'box', half_extents = {half}, position = [9, 0] }}"));
            let query = "query = { kind = 'separation', of = ['crate', 'hall'] }";
            let text = format!("shapes.crate = {a}\nshapes.hall = {b}\n{query}");
            crate::scene::open_text("s.toml", &text).unwrap_err().problems[0].fault.to_string()
        };
        let sound = "[1, 1]";
        for (sizes, body) in [(["[1e-300, 1e250]", sound], "crate"), ([sound, "[1e-300, 1e250]"], "hall")] {
            assert!(told(sizes).contains(body), "{}", told(sizes));
        }
    }

    #[test]
    fn a_circle_may_spin_about_its_own_centre_in_a_sweep_and_clamps_in_any_matrix() {
        let codes = |disc: &str, kind: &str| {
            let text = format!(
                "shapes.A = {{ kind = 'box', half_extents = [1, 1] }}
                 shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0], velocity = [-4, 0], {disc} }}
                 query = {{ of = ['A', 'B'], {kind} }}"
            );
            let wrong = read(&Source::new("test", &text)).err().unwrap_or_default();
            wrong.iter().map(|problem| problem.fault.code()).collect::<Vec<_>>()
        };
        let sweep = "kind = 'linear-sweep'";
        assert_eq!(codes("angular_velocity_deg = 90", sweep), [""; 0]);
        assert_eq!(codes("center = [0.5, 0], angular_velocity_deg = 90", sweep), ["turning-body"]);
        let clamp = "kind = 'separation', algorithm = 'clamp'";
        assert_eq!(codes("rotation = [0.6, 0.8]", clamp), [""; 0]);
    }

    #[test]
    fn sizes_whose_products_underflow_are_refused() {
        let [still, moving] = [QueryKind::Separation, QueryKind::LinearSweep].map(QueryKind::word);
        assert_eq!(codes(still, 1e-99, 3.0), [""; 0]);
        assert_eq!(codes(still, 1e-101, 3.0), ["unsuited-shape"]);
        assert_eq!(codes(moving, 5e-324, 3.0), ["unsuited-shape"]);
        assert_eq!(codes(still, 1.0, 1e200), [""; 0]);
        assert_eq!(codes(moving, 1.0, 1e99), [""; 0]);
        assert_eq!(codes(moving, 1.0, 1e145), ["unsuited-shape"]);
    }

    /// A miss was "proved" of a segment that spins past a box beside it, by 1e138 degrees and more.
    #[test]
    fn turning_so_fast_that_products_underflow_is_refused() {
        let codes = |kind: &str, spin: f64| {
            let text = format!(
                "shapes.A = {{ kind = 'capsule', points = [[0, 3.3125], [0, 0]], radius = 0,
                    position = [6.0625, -0.01], angular_velocity_deg = {spin:e} }}
                 shapes.B = {{ kind = 'aabb', half_extents = [5.625, 3.3125], position = [0, -0.625] }}
                 query = {{ kind = '{kind}', of = ['A', 'B'] }}"
            );
            let wrong = read(&Source::new("test", &text)).err().unwrap_or_default();
            wrong.iter().map(|problem| problem.fault.code()).collect::<Vec<_>>()
        };
        let [still, moving] = [QueryKind::Separation, QueryKind::TimeOfImpact].map(QueryKind::word);
        assert_eq!(codes(moving, -1e99), [""; 0]);
        assert_eq!(codes(moving, -1e138), ["unsuited-shape"]);
        assert_eq!(codes(still, -1e138), [""; 0]);
    }
}
