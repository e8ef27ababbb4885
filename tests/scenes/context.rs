//! Bodies that the query is not about are context: drawn muted beside the others, asked nothing.

#![expect(clippy::unwrap_used, clippy::panic, reason = "a test may panic wherever it is")]

use tracefig::drawing::{Group, Item, Role};
use tracefig::figure::{Figure, draw, plan};
use tracefig::geometry::DVec2;
use tracefig::scene::{Scene, open_text, solve};

const PAIR: &str = "[shapes.A]\nkind = 'circle'\nradius = 1\nvelocity = [3, 0]\n[shapes.B]\nkind = 'box'\n\
                    half_extents = [1, 1]\nposition = [4, 0]\n";

/// A sweep of the pair beside another body, with these panels.
fn scene(context: &str, panels: &str) -> Scene {
    let text = format!("{PAIR}{context}[query]\nkind = 'linear-sweep'\nof = ['A', 'B']\n{panels}");
    open_text("s.toml", &text)
        .unwrap_or_else(|refused| panic!("{}", refused.render(tracefig::scene::Ink::Plain)))
        .scene
}

fn figure(scene: &Scene) -> Figure {
    let plan = plan(scene).unwrap_or_else(|problems| panic!("{problems:?}"));
    draw(&plan, plan.theme, "s")
}

/// The groups of a name, at any depth.
fn groups<'d>(items: &'d [Item], name: &str) -> Vec<&'d Group> {
    let mut found = Vec::new();
    for item in items {
        if let Item::Group(group) = item {
            if group.name == name {
                found.push(group);
            }
            found.extend(groups(&group.items, name));
        }
    }
    found
}

/// Where the name of the context stands in the first panel, in the world; `None` where it does not.
fn named(figure: &Figure) -> Option<(f64, Role)> {
    let panel = &figure.panels[0];
    let label = panel.placed.iter().find(|label| label.key == "context")?;
    let x = |x: f64| panel.frame.page(DVec2::new(x, 0.0)).x;
    let role = groups(&figure.drawing.items, "label-context")[0].role.unwrap();
    Some(((label.bounds.center().x - x(0.0)) / (x(1.0) - x(0.0)), role))
}

#[test]
fn another_body_is_drawn_and_named_in_muted_ink_and_changes_no_answer() {
    let bird =
        "[shapes.bird]\nkind = 'box'\nhalf_extents = [0.8, 0.8]\nposition = [1, 3]\nvelocity = [2, 0]\n";
    let (with, without) = (scene(bird, ""), scene("", ""));
    assert_eq!(solve(&with), solve(&without));
    let drawn = figure(&with);
    assert_eq!(groups(&drawn.drawing.items, "context-1").len(), 1, "in the world alone");
    let (at, role) = named(&drawn).unwrap();
    assert!((at - 1.0).abs() < 0.5 && role == Role::Muted, "{at} {role:?}");
    assert!(
        drawn.drawing.desc.contains("Beside, and asked nothing: bird (a box)."),
        "{}",
        drawn.drawing.desc
    );
    assert!(groups(&figure(&without).drawing.items, "context-1").is_empty());
    let end = figure(&scene(bird, "[[panels]]\ntime = 'end'\nlayers = ['shapes']"));
    let (at, _) = named(&end).unwrap();
    assert!((at - 3.0).abs() < 0.5, "it moves with its velocity: {at}");
}

#[test]
fn context_can_be_hidden_and_is_left_out_where_bodies_are_named() {
    let wall = "[shapes.wall]\nkind = 'outline'\nvertices = [[-1, 2], [2, 2], [2, 4], [0, 3]]\n";
    for (layer, times) in [
        ("'shapes'", 1),
        ("{ layer = 'shapes', context = false }", 0),
        ("{ layer = 'shapes', of = 'A' }, { layer = 'shapes', of = 'B' }", 0),
        ("{ layer = 'shapes', of = 'A', context = true }", 1),
    ] {
        let drawn = figure(&scene(wall, &format!("[[panels]]\nlayers = [{layer}]")));
        assert_eq!(groups(&drawn.drawing.items, "context-1").len(), times, "{layer}");
    }
}

#[test]
fn a_body_far_away_does_not_make_the_pair_small() {
    let at = |x: f64| format!("[shapes.other]\nkind = 'circle'\nradius = 1\nposition = [{x}, 0]\n");
    let width = |scene: &Scene| {
        let panel = &figure(scene).panels[0];
        panel.frame.page(DVec2::X).x - panel.frame.page(DVec2::ZERO).x
    };
    let panels = "[[panels]]\nlayers = ['shapes']";
    let alone = width(&scene("", panels));
    let near = width(&scene(&at(8.0), panels));
    assert!(near < 0.9 * alone && near > 0.4 * alone, "one beside is in view: {near} {alone}");
    for far in [100.0, 1e6, 1e300] {
        let scene = scene(&at(far), panels);
        assert!((width(&scene) / alone - 1.0).abs() < 1e-9, "{far}");
        assert_eq!(named(&figure(&scene)), None, "out of view: no name");
    }
}

#[test]
fn context_may_carry_a_panel_and_no_option_asks_about_it() {
    let bird = "[shapes.bird]\nkind = 'circle'\nradius = 0.5\nposition = [1, 3]\nvelocity = [2, 0]\n";
    let drawn = figure(&scene(
        bird,
        "[[panels]]\nspace = 'body'\nframe = 'bird'\n[[panels]]\nspace = 'configuration'",
    ));
    assert_eq!(groups(&drawn.drawing.items, "context-1").len(), 1);
    let wrong = scene(bird, "[[panels]]\nlayers = [{ layer = 'ghosts', of = 'bird' }]");
    let problems = plan(&wrong).map(|_| ()).unwrap_err();
    assert_eq!(
        problems[0].fault.to_string(),
        "`of`: expected a shape of the query, got `bird`, which is context"
    );
    let many: Vec<String> = (0..63).map(|i| format!("[shapes.x{i}]\nkind = 'circle'\nradius = 1")).collect();
    let many = many.join("\n");
    let text = format!("{PAIR}{many}\n[query]\nkind = 'separation'\nof = ['A', 'B']\n");
    let refused = open_text("s.toml", &text).unwrap_err();
    assert_eq!(refused.problems[0].fault.to_string(), "`shapes`: expected at most 64 shapes, got 65");
}
