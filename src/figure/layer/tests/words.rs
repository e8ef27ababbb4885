//! Labels are in the language of the scene: every word of ours has a row in the table of words, and every
//! number has the sign of the language.

use std::collections::BTreeSet;
use std::path::Path;

use crate::drawing::Item;
use crate::figure::layer::{Takes, find};
use crate::figure::name::Name;
use crate::figure::{Figure, draw, plan, random_scenes};
use crate::scene::{Scene, Spanned, Value, open, open_text};
use crate::typeset::{Piece, pieces};

/// The words of a markup outside of its formulas that may be English and are not in the names of bodies.
fn words(markup: &str, names: &[String]) -> Vec<String> {
    let words = |piece| if let Piece::Words(_, words) = piece { Some(words) } else { None };
    let outside: Vec<&str> = pieces(markup).unwrap_or_default().into_iter().filter_map(words).collect();
    // A long name is broken where its lines end.
    let outside = outside.join(" ").replace("-\n", "").replace('\n', "");
    let unbroken = outside.replace(' ', "");
    if names.contains(&unbroken) {
        return Vec::new();
    }
    let outside = names.iter().fold(outside, |text, name| text.replace(name.as_str(), " "));
    let words = outside.split(|c: char| !c.is_alphabetic()).filter(|word| word.len() > 1 && word.is_ascii());
    // The sign of a unit is the same in all languages.
    words.filter(|&word| word != "rad").map(str::to_owned).collect()
}

/// The words of ours on a figure whose language has none, each with the key of its label.
fn words_of_ours(scene: &Scene, figure: &Figure) -> Vec<String> {
    let mut names: Vec<String> = scene.shapes.iter().map(|(name, _)| name.value.clone()).collect();
    names.extend(scene.shapes.iter().flat_map(|(name, _)| name.value.split(' ').map(str::to_owned)));
    names.extend(scene.shapes.iter().map(|(name, _)| name.value.replace(' ', "")));
    names.extend(scene.shapes.iter().map(|(name, _)| Name::words(&name.value).shortened()));
    names.sort_by_key(|name| std::cmp::Reverse(name.len()));
    // What the scene says is in its own words.
    let is_given =
        |key: &str| ["note", "point"].contains(&key) || scene.labels.iter().any(|l| l.0.value == key);
    let placed = figure.panels.iter().chain(&figure.insets).flat_map(|panel| &panel.placed);
    let label = |key: &str, markup: &str| {
        words(markup, &names).into_iter().map(|word| format!("{key}: {word}")).collect::<Vec<_>>()
    };
    placed
        .filter(|label| !is_given(label.key))
        .flat_map(|placed| placed.lines.iter().flat_map(|(_, line)| label(placed.key, &line.markup)))
        .collect()
}

/// The scenes of the reference, one for each layer, in a language.
fn references(lang: &str) -> Vec<Scene> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("guide/src/reference/layers");
    let mut paths: Vec<_> = folder.read_dir().unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "toml") && !path.ends_with("tracefig.toml"));
    paths.sort();
    let scene = |path: &Path| {
        let mut scene = open(path).unwrap().scene;
        scene.lang = Some(Spanned { value: lang.to_owned(), span: 0..0 });
        scene
    };
    paths.iter().map(|path| scene(path)).collect()
}

/// A scene with each switch of each of its layers on, one at a time.
fn switched(scene: &Scene) -> impl Iterator<Item = Scene> {
    let layers = scene.panels.iter().enumerate().flat_map(|(i, panel)| {
        let layers = panel.layers.iter().flatten().enumerate();
        layers.map(move |(k, layer)| (i, k, layer.name.value.clone()))
    });
    let switches = layers.flat_map(|(i, k, name)| {
        let options = find(&name).map_or(&[][..], |layer| layer.options);
        let flags = options.iter().filter(|option| matches!(option.takes, Takes::Flag));
        flags.map(move |option| (i, k, option.name)).collect::<Vec<_>>()
    });
    switches.collect::<Vec<_>>().into_iter().map(|(i, k, name)| {
        let spanned = |name: &str| Spanned { value: name.to_owned(), span: 0..0 };
        let mut scene = scene.clone();
        let options = &mut scene.panels[i].layers.as_mut().unwrap()[k].options;
        options.retain(|(key, _)| key.value != name);
        options.push((spanned(name), Spanned { value: Value::Bool(true), span: 0..0 }));
        scene
    })
}

#[test]
fn in_a_language_without_words_of_ours_no_label_has_any_whatever_is_switched_on() {
    let (mut found, mut drawn) = (BTreeSet::new(), 0);
    for scene in references("ja").iter().flat_map(switched) {
        let Ok(plan) = plan(&scene) else { continue };
        drawn += 1;
        found.extend(words_of_ours(&scene, &draw(&plan, plan.theme, "words")));
    }
    assert!(drawn > 100, "{drawn}");
    assert_eq!(found, BTreeSet::new());
}

#[test]
fn in_a_language_without_words_of_ours_no_label_has_any() {
    let random = (0..60).map(|seed| format!("lang = 'ja'\n{}", random_scenes::scene_text(seed)));
    let random = random.filter_map(|text| random_scenes::fed(open_text("random", &text).unwrap().scene));
    let mut found = BTreeSet::new();
    for scene in references("ja").into_iter().chain(random) {
        let plan = plan(&scene).unwrap();
        found.extend(words_of_ours(&scene, &draw(&plan, plan.theme, "words")));
    }
    assert_eq!(found, BTreeSet::new());
}

/// The markup of everything that is written.
fn texts(items: &[Item], all: &mut Vec<String>) {
    for item in items {
        match item {
            Item::Group(group) => texts(&group.items, all),
            Item::Text(text) => all.push(text.line.markup.clone()),
            Item::Path(_) => {}
        }
    }
}

#[test]
fn the_numbers_of_axes_and_points_have_the_comma_of_the_language() {
    let text = "lang = 'de'
        shapes.A = { kind = 'circle', radius = 0.7, position = [0.35, 0.25] }
        query = { kind = 'bounds', of = ['A'] }
        [[panels]]
        layers = [{ layer = 'axes', ticks = true }, 'shapes',
            { layer = 'point', at = [0.5, -0.25], text = 'P', coordinates = true },
            { layer = 'point', at = [-0.25, 0.5], coordinates = true }]";
    let scene = open_text("de", text).unwrap().scene;
    let plan = plan(&scene).unwrap();
    let mut all = Vec::new();
    texts(&draw(&plan, plan.theme, "de").drawing.items, &mut all);
    let has = |text: &str| all.iter().any(|markup| markup == text);
    assert!(has("0,5") && has("P $(0{,}5; -0{,}25)$") && has("$(-0{,}25; 0{,}5)$"), "{all:?}");
    assert!(!all.iter().any(|markup| markup.contains('.')), "{all:?}");
}

#[test]
fn the_point_that_a_body_with_a_word_for_a_name_shrinks_to_is_its_origin() {
    let labels = |name: &str, lang: &str| {
        let text = format!(
            "lang = '{lang}'
            shapes.hero = {{ kind = 'box', half_extents = [1, 0.6] }}
            shapes.{name} = {{ kind = 'box', half_extents = [0.5, 0.5], position = [3, 0.9] }}
            query = {{ kind = 'separation', of = ['hero', '{name}'] }}
            panels = [{{ layers = ['grown'] }}]"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "f");
        let of = |key: &str| {
            figure.panels[0].placed.iter().find(|l| l.key == key).unwrap().lines[0].1.markup.clone()
        };
        [of("b"), of("copy")]
    };
    assert_eq!(labels("Q", "en"), ["$q$", "$Q$ turned about $q$"]);
    assert_eq!(labels("rock", "en"), ["origin of rock", "rock turned about its origin"]);
    assert_eq!(labels("rock", "de"), ["Ursprung von rock", "rock um den eigenen Ursprung gedreht"]);
    // A name may be of either gender: what is said of it has none.
    assert_eq!(labels("rock", "fr"), ["origine de rock", "rock après rotation autour de son origine"]);
    assert_eq!(labels("rock", "es"), ["origen de rock", "rock tras girar alrededor de su origen"]);
}

#[test]
fn of_two_bodies_that_are_drawn_apart_either_is_pushed_and_not_both() {
    let labels = |lang: &str, of: &str| {
        let text = format!(
            "lang = '{lang}'
            shapes.rock = {{ kind = 'box', half_extents = [1, 0.6] }}
            shapes.hero = {{ kind = 'circle', radius = 0.5, position = [1.2, 0.2] }}
            query = {{ kind = 'separation', of = ['rock', 'hero'] }}
            panels = [{{ layers = ['shapes', {{ layer = 'ghosts', at = 'separated'{of} }}] }}]"
        );
        let scene = open_text("s.toml", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "f");
        let ghosts = figure.panels[0].placed.iter().filter(|l| l.key.ends_with('\''));
        // Each line of a name that is folded knows the whole.
        ghosts.map(|label| label.lines[0].1.markup.clone()).collect::<Vec<_>>()
    };
    assert_eq!(labels("en", ""), ["rock pushed out", "or hero pushed out"]);
    assert_eq!(labels("en", ", of = ['hero']"), ["hero pushed out"]);
    assert_eq!(labels("de", ""), ["rock hinausgeschoben", "oder hero hinausgeschoben"]);
}

#[test]
fn what_is_called_shared_is_no_more_than_both_radii_have() {
    // Up to 2.5 the circles overlap; up to 2 the larger one has the other's centre.
    for (x, word) in [(2.25, Some("shared")), (1.75, Some("depth")), (0.0, Some("depth")), (3.0, None)] {
        let text = format!(
            "shapes.A = {{ kind = 'circle', radius = 2 }}
            shapes.B = {{ kind = 'circle', radius = 0.5, position = [{x}, 0] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = 'circles' }}
            panels = [{{ layers = ['shapes', {{ layer = 'radii', as = 'lengths' }}] }}]"
        );
        let scene = open_text("shared", &text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        let labels = super::labels(&draw(&plan, plan.theme, "shared"));
        assert_eq!(labels.get("shared").map(|label| label.0.as_str()), word, "{x}");
    }
}
