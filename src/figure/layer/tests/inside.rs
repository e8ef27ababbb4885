//! What layers draw lies in their panel, where the scene gives it no view: the fit reckons with all of it.

use crate::drawing::Rect;
use crate::figure::sketch::{Cover, Weight};
use crate::figure::{draw, plan, random_scenes};
use crate::scene::{Source, read};

/// Scenes of a usual run.
const SCENES: u64 = 60;
/// An arc whose radius is measured below everything else.
const SECTOR: &str = "
    shapes.arm = { kind = 'polygon', vertices = [[-0.3, -0.3], [2.4, -0.2], [2.4, 0.2], [-0.3, 0.3]],
        position = [5, 5], angle_deg = -20, velocity = [1, 0], angular_velocity_rad = 1 }
    query = { kind = 'motion-bound', of = ['arm'] }
    panels = [{ time = 'start', layers = ['shapes', { layer = 'arc', sector = true, nearer = 3 }] }]
    canvas.width = 500";
/// How far a mark may reach over its panel's edge, page pixels: half of what an outline is wide.
const OVER: f64 = 2.0;

#[test]
fn every_mark_of_a_panel_without_a_view_lies_in_it() {
    let mut outside = Vec::new();
    let scene = |text: &str| read(&Source::new("inside", text)).unwrap();
    let random = (0..SCENES).filter_map(|seed| random_scenes::fed(scene(&random_scenes::scene_text(seed))));
    for (seed, mut scene) in random.chain([scene(SECTOR)]).enumerate() {
        scene.panels.iter_mut().for_each(|panel| panel.view = None);
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "random");
        for (i, panel) in figure.panels.iter().enumerate() {
            let cell = panel.frame.panel.grown(OVER);
            let covers = |cover: &Cover| match *cover {
                Cover::Stroke { from, to, .. } => Rect::new(from, to),
                Cover::Marker { at, .. } | Cover::Head { at, .. } => Rect::new(at, at),
            };
            let subject = panel.obstacles.iter().filter(|o| o.weight != Weight::Background);
            let beyond = subject.filter(|o| cell.union(covers(&o.cover)) != cell).count();
            if beyond > 0 {
                let layers = scene.panels[i].layers.iter().flatten().map(|layer| layer.name.value.as_str());
                outside.push(format!("{seed} {i}: {beyond} of {}", layers.collect::<Vec<_>>().join(" ")));
            }
        }
    }
    assert_eq!(outside, [""; 0]);
}
