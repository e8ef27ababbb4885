//! Cases: ordinary ones, and every kind of hard one that is known to break collision code, from a seed.
//!
//! A case is a scene as JSON, so that a failure prints what reproduces it: `tracefig solve case.json`. Case i
//! of a seed does not depend on how many cases are asked for. A category is one row of a table.

mod draft;
mod edge_slide;
mod extremes;
mod flat_pairs;
mod impact;
mod lattice;
mod logged;
mod near_vertices;
mod pair;
mod passing;
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

/// Cases at one moment.
const AT_ONE_MOMENT: &[Category] = &[
    Category { name: "ordinary", draw: separation::ordinary },
    Category { name: "rounded", draw: separation::rounded },
    Category { name: "lattice", draw: separation::on_lattice },
    Category { name: "identical", draw: separation::identical },
    Category { name: "near-parallel", draw: separation::near_parallel },
    Category { name: "sliver", draw: separation::sliver },
    Category { name: "near-touching", draw: separation::near_touching },
    Category { name: "hair", draw: separation::hair },
    Category { name: "far", draw: separation::far },
    Category { name: "mixed-sizes", draw: separation::mixed_sizes },
    Category { name: "denormal", draw: separation::denormal },
    Category { name: "turns", draw: separation::turns },
    Category { name: "many-corners", draw: separation::many_vertices },
    Category { name: "collinear-duplicate", draw: separation::collinear },
    Category { name: "flat", draw: separation::flat },
    Category { name: "circles", draw: separation::circles },
    Category { name: "moment", draw: separation::moment },
    Category { name: "overlap", draw: stillness::overlap },
    Category { name: "bounds", draw: stillness::bounds },
    Category { name: "motion-bound", draw: stillness::motion_bound },
];

/// Cases of bodies in motion.
const IN_MOTION: &[Category] = &[
    Category { name: "sweep", draw: impact::sweep },
    Category { name: "sweep-lattice", draw: impact::sweep_lattice },
    Category { name: "sweep-graze", draw: impact::sweep_graze },
    Category { name: "turning", draw: impact::turning },
    Category { name: "turning-tolerance", draw: impact::tolerances },
    Category { name: "spinning-bar", draw: impact::spinning_bar },
    Category { name: "rod-past-peg", draw: impact::rod_past_peg },
    Category { name: "arm", draw: impact::arm },
    Category { name: "flat", draw: impact::flat },
    Category { name: "stops-above", draw: impact::stops_above },
    Category { name: "no-relative-motion", draw: impact::no_relative_motion },
    Category { name: "starts-near", draw: impact::starts_near },
    Category { name: "near-graze", draw: impact::near_graze },
    Category { name: "far", draw: extremes::far },
    Category { name: "sizes", draw: extremes::sizes },
    Category { name: "sliver", draw: extremes::sliver },
    Category { name: "parallel-slide", draw: impact::parallel_slide },
    Category { name: "many-corners", draw: extremes::many_vertices },
    Category { name: "many-turns", draw: extremes::many_turns },
    Category { name: "near-parallel", draw: extremes::near_parallel },
    Category { name: "sweep-extreme", draw: extremes::sweep },
    Category { name: "passing", draw: passing::passing },
    Category { name: "sliding", draw: passing::sliding },
    Category { name: "turning-beside", draw: passing::turning_beside },
    Category { name: "edge-slide", draw: edge_slide::edge_slide },
];

/// Cases as an engine logs them, at one moment.
const LOGGED: &[Category] = &[
    Category { name: "logged", draw: logged::separation },
    Category { name: "logged-resting", draw: logged::resting },
    Category { name: "logged-stacked", draw: logged::stacked },
    Category { name: "logged-bounds", draw: logged::bounds },
    Category { name: "logged-motion-bound", draw: logged::motion_bound },
];

/// Cases as an engine logs them, in motion.
const LOGGED_IN_MOTION: &[Category] = &[
    Category { name: "logged-sweep", draw: logged::sweep },
    Category { name: "logged-turning", draw: logged::impact },
];

/// Which table of categories.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Family {
    /// Questions at one moment: separation, overlap, bounds; and the motion bound.
    Separation,
    /// Linear sweeps and times of impact.
    Impact,
    /// Questions at one moment, as an engine's log has the bodies.
    Logged,
    /// Linear sweeps and times of impact of such bodies.
    LoggedImpact,
}

impl Family {
    /// Its categories.
    #[must_use]
    pub fn categories(self) -> &'static [Category] {
        match self {
            Self::Separation => AT_ONE_MOMENT,
            Self::Impact => IN_MOTION,
            Self::Logged => LOGGED,
            Self::LoggedImpact => LOGGED_IN_MOTION,
        }
    }

    /// Points and segments on one line, which are asked of every algorithm.
    #[must_use]
    pub fn flat_pairs(self) -> Category {
        let draw = match self {
            Self::Impact | Self::LoggedImpact => flat_pairs::moving,
            _ => flat_pairs::at_rest,
        };
        Category { name: "flat-pairs", draw }
    }

    /// Points and vertices within a hair of a vertex, at rest.
    #[must_use]
    pub fn near_vertices() -> Category {
        Category { name: "near-vertices", draw: near_vertices::at_rest }
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

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::Family;
    use crate::placement::convex_core;
    use crate::scene::Scene;

    #[test]
    fn every_case_is_a_scene_and_the_same_one_again() {
        for family in [Family::Separation, Family::Impact, Family::Logged, Family::LoggedImpact] {
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
