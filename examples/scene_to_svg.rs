//! A scene file to an SVG and its answer: `cargo run --example scene_to_svg -- figures/01-penetration.toml out.svg`.

#![expect(clippy::print_stdout, reason = "an example for the terminal")]

use std::error::Error;
use std::path::Path;

use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::answer_json;
use tracefig::{open, solve};

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let (scene, svg) = (arguments.next(), arguments.next());
    let scene = scene.unwrap_or_else(|| "figures/01-penetration.toml".to_owned());
    let svg = svg.unwrap_or_else(|| "target/scene.svg".to_owned());

    // What is wrong with a scene, or with what it asks to show, comes with its place in the file.
    let file = open(Path::new(&scene))?;
    let plan = plan(&file.scene).map_err(|problems| format!("{problems:?}"))?;
    let figure = draw(&plan, plan.theme, "scene");
    for warning in &figure.warnings {
        println!("warning: {}", warning.fault);
    }

    let Some(Writer::One(write)) = format("svg").map(|format| format.write) else {
        return Err("no SVG".into());
    };
    std::fs::write(&svg, write(&figure.drawing, &Options::default())?)?;
    println!("{svg}: {}", answer_json(file.scene.query().kind, &solve(&file.scene)));
    Ok(())
}
