//! What is said of each fault, and that its code is listed.

use super::*;
use crate::scene::{ERRORS, Ink, Source, message};

/// What an answer lacks, with its message; no help is needed.
fn notes() -> Vec<(Fault, &'static str, &'static str)> {
    vec![
        (
            Fault::OtherMoment {
                shown: "the closest approach",
                asked: "the hit",
                why: "the answer is a miss",
            },
            "the panel shows the closest approach in place of the hit: the answer is a miss",
            "",
        ),
        (
            Fault::OtherStep { asked: 9, last: 3 },
            "the panel shows step 3 in place of step 9: the algorithm took 3",
            "",
        ),
        (
            Fault::NothingToDraw { layer: "one", why: "the answer is a miss" },
            "`one` draws nothing: the answer is a miss",
            "",
        ),
        (
            Fault::NothingForOption { layer: "one", option: "two", why: "the bodies are apart" },
            "`two` of `one` draws nothing: the bodies are apart",
            "",
        ),
        (
            Fault::NotHeld { what: "A.velocity".to_owned() },
            "no layer draws `A.velocity`, so that nobody can drag it",
            "a page has its numbers all the same",
        ),
        (
            Fault::NoStepLeft { count: 3 },
            "no step is left for these words: the figure has 3",
            "`until` counts the figure's own steps, from 1",
        ),
        (
            Fault::OutOfView { name: "house".to_owned() },
            "`house` is not on the picture: it is far from the bodies of the query",
            "a panel's `view = [x0, y0, x1, y1]` reaches as far as it says",
        ),
        (
            Fault::NoValue { value: "time".to_owned(), why: "the answer is a miss" },
            "a dash stands for `{=time}`: the answer is a miss",
            "",
        ),
        (
            Fault::BadName {
                name: "木".to_owned(),
                shown: "A".to_owned(),
                key: Some("A"),
                reason: "no glyph".to_owned(),
            },
            "the picture calls `木` A: no glyph",
            "the fonts have Latin, Greek and Cyrillic letters; `A = \"…\"` in `[labels]` calls it \
             otherwise",
        ),
    ]
}

/// What a page has no room for, with its message and its help.
fn without_room() -> Vec<(Fault, &'static str, &'static str)> {
    vec![
        (
            Fault::TextDropped { what: "caption", lines: 9, room: 4 },
            "the caption takes 9 lines and the page has room for 4: it is left out",
            "it stays in the alternative text; a larger canvas or a shorter text shows it",
        ),
        (
            Fault::OffPage { group: "body-A".to_owned() },
            "`body-A` has a place that is not on any page",
            "give the panel a wider `view`, or none, or leave out the layer that draws it",
        ),
        (
            Fault::LabelClash {
                fault: LabelFault::Dropped { key: "d", span: 0..1 },
                panel: None,
                in_inset: true,
                has_view: true,
                is_pinned: false,
            },
            "the label `d` found no place and is left out (in an inset)",
            "give the figure a larger `width` in `[canvas]`",
        ),
        (
            Fault::LabelClash {
                fault: LabelFault::Dropped { key: "d", span: 0..1 },
                panel: None,
                in_inset: false,
                has_view: true,
                is_pinned: false,
            },
            "the label `d` found no place and is left out",
            "pin it: `d = { at = \"NE\" }` in `[labels]`, or give the panel a wider `view`",
        ),
        (
            Fault::LabelClash {
                fault: LabelFault::Dropped { key: "d", span: 0..1 },
                panel: Some(2),
                in_inset: false,
                has_view: true,
                is_pinned: true,
            },
            "the label `d` found no place and is left out (panel 2)",
            "pin it elsewhere or let it find a place, shorten its text, or give the panel a wider `view`",
        ),
        (
            Fault::LabelClash {
                fault: LabelFault::Dropped { key: "d", span: 0..1 },
                panel: None,
                in_inset: false,
                has_view: false,
                is_pinned: false,
            },
            "the label `d` found no place and is left out",
            "pin it: `d = { at = \"NE\" }` in `[labels]`, or give the figure a larger `width` in \
             `[canvas]`",
        ),
    ]
}

/// Everything else but what scenes and labels say of themselves, with its message and its help.
fn others() -> Vec<(Fault, &'static str, &'static str)> {
    vec![
        (
            Fault::NoSuchStep { step: 9, took: 3 },
            "expected a step of the algorithm, got 9: it took 3",
            "they are numbered from 1 to 3",
        ),
        (
            Fault::NoHit,
            "the panel shows the moment of a hit or a miss, but the question is not for one",
            "`kind = \"linear-sweep\"` and `kind = \"time-of-impact\"` ask for one; a `time` is a number too",
        ),
        (
            Fault::NoLayers,
            "the panel stays empty: its list of layers has none",
            "without the key `layers` it shows what suits the answer",
        ),
        (
            Fault::EmptyView { what: "view", reach: [[-1.0, 0.5], [2.0, 3.0]] },
            "the panel's `view` is empty: all that it draws is from (-1, 0.5) to (2, 3)",
            "without the key `view` it shows all of it",
        ),
        (
            Fault::UnsuitedLayer { layer: "one", space: "world" },
            "the layer `one` is of the space `world`, and the panel of another",
            "such a panel has `space = \"world\"`",
        ),
        (
            Fault::SharedChart { layer: "graph" },
            "`graph` has axes of its own, and its lines run through the other layers",
            "give it a panel of its own: `[[panels]]` with `layers = [\"graph\"]`",
        ),
        (
            Fault::UnfedLayer { layer: "one", needs: "a hit".to_owned() },
            "this scene can't feed the layer `one`",
            "it needs a hit",
        ),
        (
            Fault::BadTheme { name: "own.toml".to_owned(), reason: "it is a folder".to_owned() },
            "the theme `own.toml` can't be used: it is a folder",
            "`tracefig list themes` has those that are built in",
        ),
        (
            Fault::BadMarkup { markup: "$x".to_owned(), reason: "no end".to_owned() },
            "`$x` can't be typeset: no end",
            "values stand as `{=time}`, words in a colour as `{a|words}`, formulas as `$x$`; `\\$` is a \
             dollar",
        ),
    ]
}

#[test]
fn what_an_answer_lacks_is_a_note() {
    assert!(notes().iter().all(|(fault, ..)| fault.severity() == Severity::Note));
    let others = [others(), without_room()].concat();
    assert!(others.iter().all(|(fault, ..)| fault.severity() != Severity::Note));
    assert!(others.iter().all(|(.., help)| !help.is_empty()), "and every error says what would help");
}

#[test]
fn every_fault_says_what_is_wrong_and_what_would_help_under_a_listed_code() {
    let source = Source::new("s.toml", "title = 1");
    for (fault, text, help) in notes().into_iter().chain(others()).chain(without_room()) {
        assert_eq!((fault.to_string().as_str(), fault.help().unwrap_or_default().as_str()), (text, help));
        assert!(ERRORS.iter().any(|row| row.code == fault.code()), "{} is in no list", fault.code());
        let shown = message(&source, &Problem::new(fault.clone(), 8..9), Severity::Warning, Ink::Plain);
        let head = format!("warning[{}]: {text}\n --> s.toml:1:9\n", fault.code());
        assert!(shown.starts_with(&head), "{shown}");
    }
}
