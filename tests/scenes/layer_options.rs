//! Random scenes whose layers have random options, from the table that `tracefig list layers` prints: each is
//! drawn or refused, with finite marks and no two names at each other's things.
//!
//! `TRACEFIG_SCENES=10000 cargo test --release --test scenes layer_options -- --nocapture` draws as many as one
//! likes and prints what they took; with `TRACEFIG_PICTURES=FOLDER` it leaves the scene and the picture of
//! every fiftieth there, to be looked at, and the scene of each that took the longest so far.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::fmt::Write;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::time::{Duration, Instant};

use tracefig::figure::layer::LAYERS;
use tracefig::figure::{COMMON, LabelFault, OptionSpec, Takes, draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Source, read};
use tracefig_reference::random::Random;

use crate::label_faults::random_scenes::{fed, scene_text};

/// Scenes of a usual run; few enough for a debug build.
const SCENES: u64 = 150;
/// How long a picture of a few bodies and layers may take, in a debug build on a busy machine; the slowest of
/// 10,000 takes a hundredth of it in a release build.
const LONGEST: Duration = Duration::from_secs(20);

/// A value that an option takes; `names` are those of the bodies.
fn value(r: &mut Random, option: &OptionSpec, names: &[String]) -> String {
    match option.takes {
        Takes::Flag => r.pick(&["true", "false"]).to_string(),
        Takes::Number => r.quarter(-40, 40).to_string(),
        Takes::Positive => r.one_of(&[0.05, 0.5, 1.0, 2.5, 12.0]).to_string(),
        Takes::Point => format!("[{}, {}]", r.quarter(-3, 3), r.quarter(-3, 3)),
        Takes::Counts => r.pick(&["0", "1", "[0, 2]", "[1, 2, 3]"]).to_string(),
        Takes::Word(words) => format!("{:?}", r.pick(words)),
        Takes::Words(words) => format!("[{:?}]", r.pick(words)),
        Takes::Bodies => format!("[{:?}]", r.pick(names)),
        Takes::When(words) if r.once_in(2) => format!("{:?}", r.pick(words)),
        Takes::When(_) => r.pick(&["0", "0.25", "0.5", "1"]).to_string(),
        Takes::Role => r.pick(&["\"a\"", "\"b\"", "\"now\"", "\"ink\"", "\"muted\""]).to_string(),
        Takes::Lines => r.pick(&["\"a line\"", "[\"two lines:\", \"$x^2 = {=time}$\"]", "\"\""]).to_string(),
    }
}

/// A random scene in which two of three layers have some of their options.
fn with_options(seed: u64) -> String {
    let text = scene_text(seed);
    let mut r = Random::new(seed ^ 0x6f70_7469_6f6e);
    let names: Vec<String> = text
        .lines()
        .filter_map(|line| Some(line.strip_prefix("[shapes.\"")?.strip_suffix("\"]")?.to_owned()))
        .collect();
    let asked =
        if text.contains("kind = \"bounds\"") || text.contains("kind = \"motion-bound\"") { 1 } else { 2 };
    let mut layer = |name: &str| {
        let row = LAYERS.iter().find(|layer| layer.name == name).unwrap();
        let mut said = format!("{{ layer = {name:?}");
        for option in COMMON.iter().chain(row.options) {
            if r.once_in(3) {
                let given = value(&mut r, option, &names[..asked]);
                write!(said, ", {} = {given}", option.name).unwrap();
            }
        }
        said + " }"
    };
    let line = |line: &str| match line.strip_prefix("layers = [").and_then(|rest| rest.strip_suffix(']')) {
        Some(all) => {
            let all: Vec<String> = all.split(", ").map(|name| layer(name.trim_matches('"'))).collect();
            format!("layers = [{}]\n", all.join(", "))
        }
        None => format!("{line}\n"),
    };
    text.lines().map(line).collect()
}

/// What became of a scene: whether it was drawn; `Err` with what is wrong with the picture.
fn drawn(seed: u64, text: &str, keeps: bool) -> Result<bool, String> {
    let Ok(scene) = read(&Source::new("random", text)) else { return Ok(false) };
    let Some(scene) = fed(scene) else { return Ok(false) };
    let plan = plan(&scene).map_err(|problems| format!("{problems:?}"))?;
    let figure = draw(&plan, plan.theme, "random");
    if let Some(swapped) = figure.faults().iter().find(|fault| matches!(fault, LabelFault::Swapped { .. })) {
        return Err(swapped.to_string());
    }
    let written = |name: &str| {
        let Some(Writer::One(write)) = format(name).map(|f| f.write) else { return Err(name.to_owned()) };
        write(&figure.drawing, &Options { scale: 1.0, ..Options::default() }).map_err(|e| e.to_string())
    };
    let svg = String::from_utf8(written("svg")?).map_err(|e| e.to_string())?;
    // Words may hold it, attributes of places not.
    if ["\"NaN", " NaN", "\"inf", " inf ", "-inf"].iter().any(|wrong| svg.contains(wrong)) {
        return Err("a mark without a place".to_owned());
    }
    if let Some(folder) = std::env::var_os("TRACEFIG_PICTURES").filter(|_| keeps) {
        std::fs::write(Path::new(&folder).join(format!("{seed}.png")), written("png")?).unwrap();
        std::fs::write(Path::new(&folder).join(format!("{seed}.toml")), text).unwrap();
    }
    Ok(true)
}

#[test]
fn every_option_of_every_layer_is_drawn_or_refused() {
    let scenes: u64 = std::env::var("TRACEFIG_SCENES").ok().and_then(|n| n.parse().ok()).unwrap_or(SCENES);
    let (mut figures, mut failed, mut longest) = (0_u64, Vec::new(), Duration::ZERO);
    for seed in 0..scenes {
        let text = with_options(seed);
        let began = Instant::now();
        let fate = catch_unwind(AssertUnwindSafe(|| drawn(seed, &text, seed % 50 == 0)));
        let took = began.elapsed();
        match fate {
            Ok(Ok(is_drawn)) => figures += u64::from(is_drawn),
            Ok(Err(wrong)) => failed.push(format!("seed {seed}: {wrong}\n{text}")),
            Err(_) => failed.push(format!("seed {seed}: a panic\n{text}")),
        }
        if took > longest {
            longest = took;
            println!("seed {seed}: {took:?}");
            if let Some(folder) = std::env::var_os("TRACEFIG_PICTURES") {
                std::fs::write(Path::new(&folder).join(format!("slow-{seed}.toml")), &text).unwrap();
            }
        }
        if took > LONGEST {
            failed.push(format!("seed {seed}: {took:?}\n{text}"));
        }
    }
    println!("{figures} of {scenes} are drawn; the slowest took {longest:?}");
    assert!(failed.is_empty(), "{} failed\n{}", failed.len(), failed.join("\n"));
    assert!(2 * figures > scenes, "only {figures} of {scenes} show anything");
}
