//! Shapes as other tools write them down: a box by its two corners, a circle by its diameter, a segment by
//! two ends. Such keys are refused, as they are none of ours, but in one message that says what to write.

use crate::geometry::shape::Kind;

use super::Spanned;
use super::checked::{as_number, as_pair};
use super::node::{Node, NodeValue, number};
use super::problem::{Fault, Problems};

/// What other keys come to here: values of ours, or `None` where theirs are not what they should be.
type Ours = fn(&[&Node]) -> Option<Vec<(&'static str, NodeValue)>>;

/// Keys of others that say one thing together.
struct Row {
    /// The keys, in the order in which their values are taken.
    theirs: &'static [&'static str],
    /// The field that a kind of shape has for them, or [`ANY`].
    field: &'static str,
    /// What they come to.
    ours: Ours,
    /// What their keys have to mean for that, where they may mean something else.
    provided: Option<&'static str>,
}

const fn row(theirs: &'static [&'static str], field: &'static str, ours: Ours) -> Row {
    Row { theirs, field, ours, provided: None }
}

/// What any shape has besides the fields of its kind.
const ANY: &str = "";

/// Every way of others to write down a shape that numbers of ours can be told for; of two rows that would
/// take the same key the first.
static ROWS: &[Row] = &[
    row(&["min", "max"], "half_extents", corners),
    row(&["lower", "upper"], "half_extents", corners),
    row(&["mins", "maxs"], "half_extents", corners),
    row(&["lowerBound", "upperBound"], "half_extents", corners),
    row(&["width", "height"], "half_extents", |v| Some(vec![("half_extents", halves(numbers(v)?))])),
    row(&["w", "h"], "half_extents", |v| Some(vec![("half_extents", halves(numbers(v)?))])),
    row(&["size"], "half_extents", |v| Some(vec![("half_extents", halves(as_pair(v[0])?.into()))])),
    row(&["hx", "hy"], "half_extents", |v| Some(vec![("half_extents", pair(numbers(v)?))])),
    row(&["half_width", "half_height"], "half_extents", |v| Some(vec![("half_extents", pair(numbers(v)?))])),
    row(&["diameter"], "radius", |v| Some(vec![("radius", NodeValue::Number(0.5 * as_number(v[0])?))])),
    row(&["from", "to"], "points", ends),
    row(&["start", "end"], "points", ends),
    row(&["a", "b"], "points", ends),
    row(&["p1", "p2"], "points", ends),
    row(&["point1", "point2"], "points", ends),
    row(&["center1", "center2"], "points", ends),
    Row {
        provided: Some("that is its centre"),
        ..row(&["x", "y"], "half_extents", |v| Some(vec![("position", pair(numbers(v)?))]))
    },
    row(&["x", "y"], ANY, |v| Some(vec![("position", pair(numbers(v)?))])),
    row(&["vx", "vy"], ANY, |v| Some(vec![("velocity", pair(numbers(v)?))])),
];

fn numbers(values: &[&Node]) -> Option<[f64; 2]> {
    Some([as_number(values.first()?)?, as_number(values.get(1)?)?])
}

fn list(values: Vec<NodeValue>) -> NodeValue {
    NodeValue::List(values.into_iter().map(|value| Node { value, span: 0..0 }).collect())
}

fn pair(both: [f64; 2]) -> NodeValue {
    list(both.map(NodeValue::Number).to_vec())
}

fn halves(both: [f64; 2]) -> NodeValue {
    pair(both.map(|x| 0.5 * x))
}

/// A box by its lower left and its upper right corner.
fn corners(values: &[&Node]) -> Option<Vec<(&'static str, NodeValue)>> {
    let (low, high) = (as_pair(values[0])?, as_pair(values[1])?);
    Some(vec![("position", pair((0.5 * (low + high)).into())), ("half_extents", halves((high - low).into()))])
}

/// A segment by its ends.
fn ends(values: &[&Node]) -> Option<Vec<(&'static str, NodeValue)>> {
    let [from, to] = [as_pair(values[0])?, as_pair(values[1])?].map(|point| pair(point.into()));
    Some(vec![("points", list(vec![from, to]))])
}

/// The table of a shape with what others write down otherwise in our words, so that nothing else is found
/// wrong with it; each such group of keys is noted, with what is to be written instead.
pub(super) fn translated(kind: &Kind, place: &str, node: &Node, p: &mut Problems) -> Option<Node> {
    let mut entries = node.entries()?.to_vec();
    let takes = |field: &str| field == ANY || kind.fields.iter().any(|f| f.name == field);
    let mut found = false;
    for row in ROWS.iter().filter(|row| takes(row.field)) {
        let at = |key: &&str| entries.iter().position(|(k, _)| k.value == **key);
        let Some(places) = row.theirs.iter().map(at).collect::<Option<Vec<_>>>() else {
            continue;
        };
        let values: Vec<&Node> = places.iter().map(|&i| &entries[i].1).collect();
        let is_ours = |key: &str| entries.iter().any(|(k, _)| k.value == key);
        let Some(ours) = (row.ours)(&values).filter(|ours| !ours.iter().any(|(key, _)| is_ours(key))) else {
            continue;
        };
        let keys = places.iter().map(|&i| entries[i].0.value.clone()).collect();
        let instead = ours.iter().map(|(key, value)| ((*key).to_owned(), written(value))).collect();
        let span = entries[places[0]].0.span.clone();
        let place = place.to_owned();
        p.add(Fault::ForeignKeys { keys, place, instead, provided: row.provided }, &span);
        entries.retain(|(k, _)| !row.theirs.contains(&k.value.as_str()));
        entries.extend(ours.into_iter().map(|(key, value)| {
            (Spanned { value: key.to_owned(), span: span.clone() }, Node { value, span: span.clone() })
        }));
        found = true;
    }
    found.then(|| Node { value: NodeValue::Table(entries), span: node.span.clone() })
}

/// A number, or a list of them, as TOML and JSON write it.
fn written(value: &NodeValue) -> String {
    match value {
        NodeValue::Number(x) => number(*x),
        NodeValue::List(items) => {
            let all: Vec<String> = items.iter().map(|item| written(&item.value)).collect();
            format!("[{}]", all.join(", "))
        }
        _ => String::new(),
    }
}

#[cfg(test)]
mod tests {
    use crate::scene::{Explain, open_text};

    /// What is wrong with a shape, and what would help.
    fn told(shape: &str) -> Vec<(String, String)> {
        let text = format!(
            "[shapes.B]\nkind = 'circle'\nradius = 1\n[query]\nkind = 'separation'\nof = ['A', 'B']\n\
             [shapes.A]\n{shape}"
        );
        let Err(refused) = open_text("s.toml", &text) else { return Vec::new() };
        let told = |fault: &crate::scene::Fault| (fault.to_string(), fault.remedy().unwrap_or_default());
        refused.problems.iter().map(|p| told(&p.fault)).collect()
    }

    #[test]
    fn what_others_write_is_told_once_with_the_numbers_to_write() {
        let cases = [
            ("kind = 'aabb'\nmin = [1, 3]\nmax = [2.5, 3.5]", "[1.75, 3.25] as `position`"),
            ("kind = 'aabb'\nmin = [1, 3]\nmax = [2.5, 3.5]", "[0.75, 0.25] as `half_extents`"),
            ("kind = 'box'\nwidth = 2\nheight = 3\nposition = [1, 1]", "[1, 1.5] as `half_extents`"),
            ("kind = 'box'\nsize = [2, 3]", "[1, 1.5] as `half_extents`"),
            ("kind = 'circle'\ndiameter = 3", "1.5 as `radius`"),
            ("kind = 'circle'\nradius = 1\nx = -2\ny = 3", "[-2, 3] as `position`"),
            ("kind = 'capsule'\nfrom = [0, 1]\nto = [2, 1]\nradius = 1", "[[0, 1], [2, 1]] as `points`"),
        ];
        for (shape, expected) in cases {
            let told = told(shape);
            assert_eq!(told.len(), 1, "{shape}: {told:?}");
            assert!(told[0].1.contains(expected), "{shape}: {told:?}");
            assert!(told[0].0.starts_with("unknown key"), "{shape}: {told:?}");
        }
    }

    #[test]
    fn what_stands_beside_ours_or_is_of_another_type_is_an_unknown_key() {
        let beside = told("kind = 'circle'\nradius = 1\ndiameter = 2");
        assert_eq!(beside[0].0, "unknown key `diameter` in a circle");
        let words = told("kind = 'aabb'\nmin = 'low'\nmax = 'high'");
        assert_eq!(words.len(), 3, "{words:?}");
    }

    #[test]
    fn numbers_in_one_row_and_a_type_for_a_kind_are_told_once() {
        let row = told("kind = 'polygon'\nvertices = [0, 0, 1, 0, 0, 1]");
        assert_eq!(row.len(), 1, "{row:?}");
        assert!(
            row[0].0.ends_with("got 6 numbers in one row") && row[0].1.contains("[[0, 0], [1, 0], [0, 1]]")
        );
        let kind = told("type = 'circle'\nradius = 1");
        assert_eq!(kind, [("unknown key `type` in a shape".to_owned(), "did you mean `kind`?".to_owned())]);
    }

    #[test]
    fn a_list_of_shapes_and_a_box_at_a_corner_are_answered_with_what_is_meant() {
        let corner = told("kind = 'aabb'\nx = 1\ny = 2\nwidth = 3\nheight = 4");
        assert_eq!(corner.len(), 2, "{corner:?}");
        assert_eq!(corner[0].1, "write [1, 2] as `position`, if that is its centre");
        let refused =
            open_text("s.toml", "[[shapes]]\nname = 'A'\n[query]\nkind = 'bounds'\nof = ['A']").unwrap_err();
        assert!(refused.problems[0].fault.help().unwrap().contains("shapes.A ="), "{refused:?}");
    }
}
