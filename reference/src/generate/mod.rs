//! Cases: ordinary ones, and every kind of hard one that is known to break collision code, from a seed.
//!
//! A case is a scene as JSON, so that a failure prints what reproduces it: `tracefig solve case.json`. Case i of a seed does not
//! depend on how many cases are asked for. A category is one row of a table.

mod draft;
mod extremes;
mod impact;
mod lattice;
mod separation;
mod stillness;

pub use draft::{Draft, Shape};

use crate::json::Json;
use crate::random::Random;

/// A row of a table of categories.
pub struct Category {
    /// Its word; the id of a case is this, `/` and its number.
    pub name: &'static str,
    /// Draws a case, without its id.
    pub draw: fn(&mut Random) -> Json,
}

/// Which table of categories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Questions at one moment: separation, overlap, bounds; and the motion bound.
    Separation,
    /// Linear sweeps and times of impact.
    Impact,
}

impl Family {
    /// Its categories.
    #[must_use]
    pub fn categories(self) -> &'static [Category] {
        match self {
            Self::Separation => separation::CATEGORIES,
            Self::Impact => impact::CATEGORIES,
        }
    }

    /// Case number `i` of a seed: its category's turn comes round.
    #[must_use]
    pub fn case(self, seed: u64, i: u64) -> Json {
        let categories = self.categories();
        let count = categories.len() as u64;
        let category = &categories[usize::try_from(i % count).unwrap_or(0)];
        let mut random = Random::of_case(seed ^ (self as u64).wrapping_mul(0x9e37), i);
        let mut scene = (category.draw)(&mut random);
        if let Json::Object(fields) = &mut scene {
            fields.insert(0, ("id".to_owned(), Json::Text(format!("{}/{seed}-{i}", category.name))));
        }
        scene
    }
}

/// A scene of two bodies and a question. One time in eight their names are swapped, and with them their order in the file.
pub(crate) fn scene(random: &mut Random, kind: &str, [a, b]: [Draft; 2], more: &[(&str, Json)]) -> Json {
    let names = if random.once_in(8) { ["B", "A"] } else { ["A", "B"] };
    let of = names.map(|name| Json::Text(name.to_owned())).to_vec();
    let mut query = Json::object([("kind", Json::Text(kind.to_owned())), ("of", Json::List(of))]);
    for (key, value) in more {
        query.set(key, value.clone());
    }
    let mut shapes = vec![(names[0].to_owned(), a.json()), (names[1].to_owned(), b.json())];
    shapes.sort_by(|x, y| x.0.cmp(&y.0));
    Json::object([("shapes", Json::Object(shapes)), ("query", query)])
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Family;
    use crate::placement::convex_core;
    use crate::scene::Scene;

    #[test]
    fn every_case_is_a_scene_and_the_same_one_again() {
        for family in [Family::Separation, Family::Impact] {
            let mut texts = BTreeSet::new();
            for i in 0..600 {
                let text = family.case(5, i).to_string();
                assert_eq!(text, family.case(5, i).to_string());
                let scene = Scene::parse(&text).unwrap_or_else(|error| panic!("{error}: {text}"));
                assert!(scene.bodies.iter().all(|body| !convex_core(&body.vertices).is_empty()), "{text}");
                texts.insert(text);
            }
            assert_eq!(texts.len(), 600);
        }
    }
}
