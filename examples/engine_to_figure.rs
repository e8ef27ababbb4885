//! A pair as an engine holds it, 32-bit floats with [c, s] for rotations, to figures of its first contact
//! and of its distance, without a scene file: `cargo run --example engine_to_figure -- target/engine`.

#![expect(clippy::print_stdout, reason = "an example for the terminal")]

use std::error::Error;
use std::path::Path;

use tracefig::collision::QueryKind;
use tracefig::figure::{draw, plan};
use tracefig::geometry::shape::FieldValue;
use tracefig::geometry::{Angle, Body, DVec2, Rotation, Shape};
use tracefig::output::{Options, format};
use tracefig::scene::{LayerSpec, Panel, Refused, Scene, Space, Value, answer_json};
use tracefig::solve;

/// What an engine knows of a body.
struct EngineBody {
    vertices: &'static [[f32; 2]],
    position: [f32; 2],
    rotation: [f32; 2],
    velocity: [f32; 2],
    spin: f32,
}

impl EngineBody {
    /// The body: each number is the double that the float is, the rotation not made longer or shorter.
    fn body(&self) -> Result<Body, Box<dyn Error>> {
        let point = |[x, y]: [f32; 2]| DVec2::new(x.into(), y.into());
        let vertices = self.vertices.iter().copied().map(point).collect();
        // Vertices that floats made concave by an ulp are taken by their hull.
        let fields = [("vertices", FieldValue::Points(vertices)), ("hull", FieldValue::Switch(true))];
        let [cos, sin] = self.rotation.map(f64::from);
        Ok(Body {
            shape: Shape::of_kind("polygon", &fields)?.multiplied(Rotation { cos, sin })?,
            position: point(self.position),
            angle: Angle::ZERO,
            velocity: point(self.velocity),
            spin: Angle::Radians(self.spin.into()),
        })
    }
}

/// Draws a scene into a file, and tells its answer.
fn write(scene: &Scene, path: &Path) -> Result<(), Box<dyn Error>> {
    let plan = plan(scene).map_err(Refused::from)?;
    let figure = draw(&plan, plan.theme, "engine");
    let svg = format("svg").ok_or("no SVG")?.encode(&figure.drawing, &Options::default())?;
    std::fs::write(path, svg)?;
    println!("{}: {}", path.display(), answer_json(scene.query().kind, &solve(scene)));
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let out = std::env::args().nth(1).unwrap_or_else(|| "target/engine".to_owned());
    std::fs::create_dir_all(&out)?;
    let ground = EngineBody {
        vertices: &[[-3.0, -0.5], [3.0, -0.5], [3.0, 0.5], [-3.0, 0.5]],
        position: [0.0, 0.0],
        rotation: [1.0, 0.0],
        velocity: [0.0, 0.0],
        spin: 0.0,
    };
    let falling = EngineBody {
        vertices: &[[-0.6, -0.4], [0.6, -0.4], [0.7, 0.4], [-0.7, 0.4]],
        position: [0.4, 2.2],
        rotation: [0.98, 0.198_997_5],
        velocity: [0.3, -2.0],
        spin: 0.7,
    };
    let pair = [("ground", ground.body()?), ("crate", falling.body()?)];
    // Without panels a figure shows what suits the answer.
    let mut scene = Scene::asking(QueryKind::TimeOfImpact, &pair).map_err(Refused::from)?;
    scene.headline = Some("The {b|crate} touches the {a|ground} at $t$ = {=time:.4}.".to_owned().into());
    write(&scene, &Path::new(&out).join("impact.svg"))?;

    // Panels and layers are values too.
    let mut scene = Scene::asking(QueryKind::Separation, &pair).map_err(Refused::from)?;
    let distance = LayerSpec::named("separation").with("style", Value::Text("dimension".to_owned()));
    scene.panels.push(Panel::showing(Space::World, vec![LayerSpec::named("shapes"), distance]));
    write(&scene, &Path::new(&out).join("separation.svg"))
}
