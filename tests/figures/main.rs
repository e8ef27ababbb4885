//! The parts that each of the seventeen figures must show are in its `Drawing`, at the places that the
//! storyboard's exact answers give after the panel's world → page transform.
//!
//! The numbers here are transcribed from the storyboard, where they were computed with 256 bits; none comes
//! from a solver of this crate. A golden picture can be accepted wrong; these can not.

#![expect(clippy::panic, reason = "a test fails by panicking")]

/// Every claim must hold; all that do not are told at once.
macro_rules! shows {
    ($($claim:expr),+ $(,)?) => {{
        let failed: Vec<&str> = [$((stringify!($claim), $claim)),+].iter().filter(|(_, ok)| !ok).map(|(s, _)| *s).collect();
        assert!(failed.is_empty(), "not shown:\n  {}", failed.join("\n  "));
    }};
}

mod difference;
mod golden;
mod grammar;
mod motion;
mod numbers;
mod overlap;
mod seen;
mod unnamed;
mod witness;

use std::path::Path;

use tracefig::scene::Ink;

use seen::{Figure, Look, Panel};

/// The figure of a scene in `figures/`, drawn in the light theme.
fn figure(stem: &str) -> Figure {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("figures").join(format!("{stem}.toml"));
    let file = tracefig::open(&path).unwrap_or_else(|e| panic!("{}", e.render(Ink::Plain)));
    let plan = tracefig::figure::plan(&file.scene).unwrap_or_else(|e| panic!("{stem}: {e:?}"));
    let drawn = tracefig::figure::draw(&plan, plan.theme, stem);
    let panels = drawn.panels.iter().map(|panel| panel.frame.panel).collect();
    Figure { panels, ..Figure::of(&drawn.drawing) }
}

/// A figure through its panel of an index, which shows `view`.
fn look(figure: &Figure, index: usize, view: [f64; 4]) -> Look<'_> {
    Look { figure, panel: Panel::new(figure.panels[index], view) }
}

#[test]
fn every_demo_of_the_article_is_dragged_by_what_its_scene_names() {
    for name in ["demo-polygons", "demo-obb", "demo-linear-sweep", "demo-angular-sweep"] {
        let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("figures/{name}.toml"));
        let scene = tracefig::scene::open(&path).unwrap().scene;
        let plan = tracefig::figure::plan(&scene).unwrap();
        let handles = tracefig::figure::draw(&plan, plan.theme, name).handles;
        assert!(handles.len() >= 3, "{name}: {} handles", handles.len());
    }
}
