//! `[live]`: what a reader may move in a live figure, and by which steps.
//!
//! Nothing has to be said of it: bodies and their velocities are held where a layer draws them.

use crate::geometry::Body;
use crate::geometry::shape::{KINDS, VertexKey};

use super::Spanned;
use super::body::{self, with_article};
use super::checked::{Checked, as_list, as_text, check};
use super::fields::LIVE;
use super::problem::{Fault, Problems};

/// The key of the table.
pub(super) const KEY: &str = "live";

/// The step that what is dragged snaps to where nobody says another, world units.
const SNAP: f64 = 0.25;

/// What a reader may do with a live figure.
#[derive(Clone, Debug, PartialEq)]
pub struct Live {
    /// What may be dragged, in file order; `None` is each body and velocity of the query.
    pub drag: Option<Vec<Spanned<Drag>>>,
    /// The step that places, vertices, velocities and radii snap to, world units; 0 is none.
    pub snap: f64,
    /// Whether there are buttons that lead through the algorithm's steps.
    pub steps: bool,
    /// Whether there is a playhead; `None` is where something moves in a panel whose moment is not pinned.
    pub time: Option<bool>,
}

impl Default for Live {
    /// Bodies and velocities, by a quarter of a unit, with steps, and with a playhead where it moves
    /// something.
    fn default() -> Self {
        Self { drag: None, snap: SNAP, steps: true, time: None }
    }
}

/// Something of a body that may be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Drag {
    /// The body's index into [`Scene::shapes`](super::Scene::shapes).
    pub body: usize,
    /// What of it.
    pub grip: Grip,
}

/// What of a body may be dragged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Grip {
    /// The body itself, by its place.
    Position,
    /// Each of its vertices.
    Vertices,
    /// The tip of its velocity, where a layer draws the arrow.
    Velocity,
    /// Its angle at t = 0.
    Angle,
    /// Its radius.
    Radius,
}

impl Grip {
    /// Every word with what it names; a name alone is the first.
    const WORDS: [(&'static str, Self); 5] = [
        ("position", Self::Position),
        ("vertices", Self::Vertices),
        ("velocity", Self::Velocity),
        ("angle", Self::Angle),
        ("radius", Self::Radius),
    ];

    /// The words after a shape's name and a dot, as `vertices` of "A.vertices".
    ///
    /// ```
    /// use tracefig::scene::Grip;
    /// assert_eq!(Grip::words().next(), Some("position"));
    /// assert!(Grip::words().any(|word| word == "radius"));
    /// ```
    pub fn words() -> impl Iterator<Item = &'static str> {
        Self::WORDS.iter().map(|(word, _)| *word)
    }

    /// Its word.
    pub(crate) fn word(self) -> &'static str {
        Self::WORDS.iter().find(|(_, grip)| *grip == self).map_or("", |(word, _)| word)
    }

    /// Whether a body has it.
    fn is_of(self, body: &Body) -> bool {
        let kind = KINDS.iter().find(|kind| kind.name == body.shape.kind);
        kind.is_some_and(|kind| match self {
            Self::Position | Self::Velocity => true,
            Self::Vertices => kind.vertices != VertexKey::None,
            Self::Angle => kind.turns && body.shape.is_as_written(),
            Self::Radius => kind.fields.iter().any(|field| field.name == "radius"),
        })
    }
}

/// Reads what may be done with the live figure; what is wrong is told and left out.
pub(super) fn read(top: &Checked<'_>, bodies: &[body::Read], p: &mut Problems) -> Live {
    let table = top.get(KEY).and_then(|node| check(node, KEY, LIVE.place, LIVE.fields, p));
    let Some(table) = table else { return Live::default() };
    let usual = Live::default();
    Live {
        drag: table.get("drag").and_then(as_list).map(|items| {
            let word = |item| Some(Spanned { value: drag(as_text(item)?, bodies)?, span: item.span.clone() });
            let found = |item| {
                let found = word(item);
                if found.is_none() && !p.is_full() {
                    p.add(no_such_thing(as_text(item).unwrap_or_default(), bodies), &item.span);
                }
                found
            };
            // What is named again is known.
            let mut named = Vec::new();
            items
                .iter()
                .filter_map(found)
                .filter(|it| {
                    let is_new = !named.contains(&it.value);
                    named.extend(is_new.then_some(it.value));
                    is_new
                })
                .collect()
        }),
        snap: table.number("snap").map_or(usual.snap, |snap| snap.value),
        steps: table.switch("steps").unwrap_or(usual.steps),
        time: table.switch("time"),
    }
}

/// What a word names: a shape, or something of one.
fn drag(word: &str, bodies: &[body::Read]) -> Option<Drag> {
    let shape = |name: &str| bodies.iter().position(|read| read.name.value == name);
    if let Some(body) = shape(word) {
        return Some(Drag { body, grip: Grip::Position });
    }
    let (name, part) = word.rsplit_once('.')?;
    let body = shape(name)?;
    let &(_, grip) = Grip::WORDS.iter().find(|(known, _)| *known == part)?;
    // Of a shape that is wrong, which is told elsewhere, everything may be said.
    bodies[body].body.as_ref().is_none_or(|it| grip.is_of(it)).then_some(Drag { body, grip })
}

/// What is wrong with a word that names nothing, or what a shape of its kind has not.
fn no_such_thing(got: &str, bodies: &[body::Read]) -> Fault {
    let known = known(bodies);
    let of_a_body = |(name, part): (&str, &str)| {
        let read = bodies.iter().find(|read| read.name.value == name)?;
        Grip::words().find(|word| *word == part).and(read.body.as_ref())
    };
    match got.rsplit_once('.').and_then(|parts| Some((parts, of_a_body(parts)?))) {
        // A page has a scene in which it names something.
        Some(((name, part), body)) if !cfg!(tracefig_page) => {
            let own = |word: &&String| word.strip_prefix(name).is_some_and(|end| end.starts_with('.'));
            let own: Vec<String> = known.iter().filter(own).map(|word| format!("`{word}`")).collect();
            Fault::Conflict {
                message: format!("{} has no {part} that could be dragged", with_article(body.shape.kind)),
                help: format!("drag `{name}`, or of it {}", own.join(", ")),
            }
        }
        _ => Fault::UnknownWord { what: "thing to drag", got: got.to_owned(), known },
    }
}

/// Every word that names something.
fn known(bodies: &[body::Read]) -> Vec<String> {
    let words = |read: &body::Read| {
        let name = read.name.value.clone();
        let parts = Grip::WORDS[1..].iter().filter(|(_, g)| read.body.as_ref().is_some_and(|b| g.is_of(b)));
        let parts: Vec<_> = parts.map(|(word, _)| format!("{name}.{word}")).collect();
        std::iter::once(name).chain(parts).collect::<Vec<_>>()
    };
    bodies.iter().flat_map(words).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{Source, read};

    fn scene(live: &str) -> String {
        format!(
            "{live}\n[shapes.A]\nkind = 'circle'\nradius = 2\n[shapes.'b.c']\nkind = 'aabb'\n\
             half_extents = [1, 1]\n[query]\nkind = 'separation'\nof = ['A', 'b.c']\n"
        )
    }

    fn said(live: &str) -> Live {
        read(&Source::new("test", &scene(live))).unwrap().live
    }

    /// The message, its help and the text that it points at.
    fn refused(live: &str) -> (String, String, String) {
        let text = scene(live);
        let problems = read(&Source::new("test", &text)).unwrap_err();
        assert_eq!(problems.len(), 1, "{problems:?}");
        let quoted = text[problems[0].span.clone()].to_owned();
        (problems[0].fault.to_string(), problems[0].fault.help().unwrap_or_default(), quoted)
    }

    #[test]
    fn what_is_named_again_is_named_once() {
        let named = said("live.drag = ['A', 'b.c.velocity', 'A']").drag.unwrap();
        assert_eq!(named.iter().map(|it| it.value.body).collect::<Vec<_>>(), [0, 1]);
    }

    #[test]
    fn a_scene_that_says_nothing_has_the_usual() {
        assert_eq!(said(""), Live::default());
        assert_eq!(said("[live]\nsteps = false"), Live { steps: false, ..Live::default() });
    }

    #[test]
    fn a_name_alone_is_a_place_and_names_may_have_dots() {
        let live = said("live = { drag = ['b.c', 'b.c.vertices', 'A.radius'], snap = 0, time = true }");
        let drags: Vec<_> = live.drag.unwrap().into_iter().map(|d| (d.value.body, d.value.grip)).collect();
        assert_eq!(drags, [(1, Grip::Position), (1, Grip::Vertices), (0, Grip::Radius)]);
        assert_eq!((live.snap, live.time), (0.0, Some(true)));
    }

    #[test]
    fn a_word_for_nothing_is_quoted_and_the_nearest_one_named() {
        let (message, help, quoted) = refused("live.drag = ['A', 'A.velocty']");
        assert_eq!(message, "unknown thing to drag `A.velocty`");
        assert_eq!((help.as_str(), quoted.as_str()), ("did you mean `A.velocity`?", "'A.velocty'"));
        // A circle has no vertices, and an axis-aligned box does not turn.
        assert!(!refused("live.drag = ['A.vertices']").1.contains("`A.vertices`"));
        assert!(!refused("live.drag = ['b.c.angle']").1.contains("`b.c.angle`"));
    }

    #[test]
    fn what_is_no_list_of_words_and_an_unknown_key_are_refused() {
        assert_eq!(refused("live.drag = 'A'").2, "'A'");
        assert_eq!(refused("live.drag = [1]").2, "[1]");
        assert_eq!(refused("live.snapp = 1").1, "did you mean `snap`?");
        assert_eq!(refused("live.snap = -1").2, "-1");
    }
}
