//! What a picture calls the bodies: by the text of `[labels]`, else by the scene's name, else by a letter.
//!
//! A label that is made of a name, as `v_A` or "A pushed out", follows the text that the scene gives to the
//! name, as a reader of the picture knows no other. A name with a letter that the embedded faces lack is
//! replaced by a capital, as the article has them, and a note says so. Words that are never set in type keep
//! the scene's names.

use std::sync::atomic::{AtomicBool, Ordering};

use crate::geometry::{Names, Side, sort_by};
use crate::scene::{Scene, Spanned};
use crate::typeset::{Style, TypesetError, plain, typeset};

use super::name::Name;

/// The keys of the labels that name the query's bodies, which are also the letters that stand for them.
pub(super) const KEYS: [&str; 2] = ["A", "B"];
/// Letters for bodies that the query is not about: none that is a point or a vector of some layer.
const OTHERS: &str = "CEFGHJKLMPQRSTUWXYZ";

/// What a picture calls a body.
#[derive(Debug)]
struct Own {
    /// Its text: words, or a formula without its dollar signs.
    text: String,
    /// Whether the text is a formula.
    is_formula: bool,
    /// Why it is not the scene's name, where that can't be set in type.
    reason: Option<TypesetError>,
    /// Whether something on the picture is called so.
    is_used: AtomicBool,
}

/// What a picture calls the bodies of its scene, in the order of the file.
#[derive(Debug, Default)]
pub(crate) struct Called(Vec<Own>);

impl Called {
    /// What the picture of a scene calls its bodies; `label` is the text that the scene gives to a label of
    /// [`KEYS`].
    pub(crate) fn of<'s>(scene: &'s Scene, label: impl Fn(&str) -> Option<&'s str>) -> Self {
        let count = scene.shapes.len();
        let sides: Vec<Option<usize>> =
            (0..count).map(|i| scene.query.of.iter().position(|&asked| asked == i)).collect();
        let mut all: Vec<Result<Own, TypesetError>> = Vec::with_capacity(count);
        for ((name, _), side) in scene.shapes.iter().zip(&sides) {
            let text = side.and_then(|side| label(KEYS.get(side)?));
            let given = text.and_then(|text| given(&name.value, text.trim()));
            all.push(given.map_or_else(|| own(&name.value), Ok));
        }
        let mut taken: Vec<String> = all.iter().flatten().map(|own| own.text.clone()).collect();
        // The query's bodies first: their letters are those of the labels' keys.
        let mut order: Vec<usize> = (0..count).collect();
        let key = |i: usize| sides[i].unwrap_or(usize::MAX);
        sort_by(&mut order, |&i, &j| key(i).cmp(&key(j)));
        for i in order {
            if let Err(reason) = &all[i] {
                let text = letter(sides[i].and_then(|side| KEYS.get(side)).copied(), &taken);
                taken.push(text.clone());
                all[i] = Ok(Own { reason: Some(reason.clone()), ..Own::words(text) });
            }
        }
        Self(all.into_iter().flatten().collect())
    }

    /// What the picture calls the body of that index, which is on it from here on.
    pub(crate) fn name<'n>(&'n self, scene: &'n Scene, index: usize) -> Name<'n> {
        match self.0.get(index) {
            Some(own) => {
                own.is_used.store(true, Ordering::Relaxed);
                if own.is_formula { Name::formula(&own.text) } else { Name::words(&own.text) }
            }
            None => Name::words(scene.shapes.get(index).map_or("", |(name, _)| &name.value)),
        }
    }

    /// What the picture calls a body of the query; an empty name for the second one of a query about one.
    pub(crate) fn side<'n>(&'n self, scene: &'n Scene, side: Side) -> Name<'n> {
        let index = usize::from(side == Side::B);
        scene.query.of.get(index).map_or(Name::words(""), |&i| self.name(scene, i))
    }

    /// What the picture calls the bodies of the query, in plain words.
    pub(crate) fn names(&self, scene: &Scene) -> Names {
        let words = |side| self.side(scene, side).in_words();
        let b = (scene.query.of.len() > 1).then(|| words(Side::B));
        scene.known(Names::new(&words(Side::A), b.as_deref()))
    }

    /// The names on the picture that others stand for.
    pub(crate) fn replaced<'s>(&'s self, scene: &'s Scene) -> impl Iterator<Item = Replaced<'s>> {
        scene.shapes.iter().zip(&self.0).enumerate().filter_map(|(i, ((name, _), own))| {
            let reason = own.reason.as_ref().filter(|_| own.is_used.load(Ordering::Relaxed))?;
            let side = scene.query.of.iter().position(|&asked| asked == i);
            let key = side.and_then(|side| KEYS.get(side)).copied();
            Some(Replaced { name, shown: &own.text, key, reason: &reason.message })
        })
    }
}

/// A name that can't be set in type.
pub(crate) struct Replaced<'s> {
    /// The name, and where the scene has it.
    pub(crate) name: &'s Spanned<String>,
    /// What the picture calls the body.
    pub(crate) shown: &'s str,
    /// The key of the label that calls it otherwise; `None` for a body that the query is not about.
    pub(crate) key: Option<&'static str>,
    /// Which letter is lacking.
    pub(crate) reason: &'s str,
}

impl Own {
    /// A body that is called by words.
    fn words(text: String) -> Self {
        Self { text, is_formula: false, reason: None, is_used: AtomicBool::new(false) }
    }
}

/// The scene's own name of a body; `Err` where it can't be set in type, in words or within a formula.
fn own(name: &str) -> Result<Own, TypesetError> {
    settable(Name::words(name)).map(|()| Own::words(name.to_owned()))
}

/// Whether a name can be set in type, in words and within a formula.
fn settable(name: Name) -> Result<(), TypesetError> {
    for form in [name.primed(0), format!("${}$", name.script())] {
        typeset(&form, Style::regular(1.0))?;
    }
    Ok(())
}

/// The text that `[labels]` gives to the name of a body, where that is another name: not one with a value of
/// the answer in it, and none that has words beside the name.
fn given(name: &str, text: &str) -> Option<Own> {
    if text.contains("{=") {
        return None;
    }
    let formula = text.strip_prefix('$').and_then(|rest| rest.strip_suffix('$'));
    let given = match formula.filter(|inner| !inner.contains('$')) {
        Some(inner) => Own { is_formula: true, ..Own::words(inner.trim().to_owned()) },
        None => Own::words(plain(text).split_whitespace().collect::<Vec<_>>().join(" ")),
    };
    let called = if given.is_formula { Name::formula(&given.text) } else { Name::words(&given.text) };
    let words = called.in_words();
    let mut parts = words.split(|c: char| !c.is_alphanumeric() && c != '_');
    let is_about_it = words != name && (words.contains(' ') && parts.any(|part| part == name));
    let is_name = !words.trim().is_empty() && !is_about_it && settable(called).is_ok();
    is_name.then_some(given)
}

/// A capital that nothing else is called by: the letter of a body of the query where it is free.
fn letter(key: Option<&str>, taken: &[String]) -> String {
    let is_free = |name: &String| !taken.contains(name);
    let others = OTHERS.chars().map(String::from);
    let numbered = (1..).map(|k: usize| format!("C{k}"));
    let mut all = key.into_iter().map(str::to_owned).chain(others).chain(numbered);
    all.find(is_free).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    /// What the picture calls three circles, of which the second and the first are asked about, as markup.
    fn called(names: [&str; 3], labels: &str) -> Vec<String> {
        let shape = |(i, name): (usize, &&str)| {
            format!("shapes.\"{name}\" = {{ kind = 'circle', radius = 1, position = [{i}, 0] }}\n")
        };
        let shapes: String = names.iter().enumerate().map(shape).collect();
        let of = format!("of = ['{}', '{}']", names[1], names[0]);
        let text = format!("{shapes}query = {{ kind = 'overlap', {of} }}\n{labels}");
        let scene = open_text("called.toml", &text).unwrap().scene;
        let own = |key: &str| {
            let label = scene.labels.iter().find(|(word, _)| word.value == key);
            label.and_then(|(_, label)| Some(label.text.as_ref()?.value.as_str()))
        };
        let called = Called::of(&scene, own);
        (0..3).map(|i| called.name(&scene, i).primed(0)).collect()
    }

    #[test]
    fn names_without_glyphs_are_capitals_that_nothing_else_is_called() {
        assert_eq!(called(["箱", "円", "🚀"], ""), ["$B$", "$A$", "$C$"]);
        assert_eq!(called(["箱", "円", "A"], ""), ["$B$", "$C$", "$A$"]);
        assert_eq!(called(["箱", "Ящик", "ملف"], ""), ["$B$", "Ящик", "$C$"]);
        assert_eq!(called(["箱", "円", "z"], "labels.A = 'B'"), ["$C$", "$B$", "$z$"]);
    }

    #[test]
    fn the_text_of_a_label_is_the_name_unless_it_says_more_than_that() {
        for (text, name) in [
            ("Kreis", "Kreis"),
            ("$A_1$", "$A_1$"),
            ("{a|the ball}", "the ball"),
            ("$Q$", "$Q$"),
            ("circle2 at rest", "circle2"),
            ("{=time}", "circle2"),
            ("", "circle2"),
            ("円", "circle2"),
        ] {
            assert_eq!(called(["x", "circle2", "y"], &format!("labels.A = '{text}'"))[1], name);
        }
    }
}
