//! Which words of ours a language has, and what becomes of those that it lacks.

use super::*;
use crate::figure::default_picture::PICTURES;
use crate::scene::panels_of_text;
use crate::typeset::{Style, typeset};

fn label(tag: &str, key: &str, line: &str) -> String {
    Language::of_tag(tag).lines(key, &[line.to_owned()]).concat()
}

#[test]
fn a_label_has_the_words_of_its_language_and_the_formula_of_all() {
    let cases = [
        ("en-GB", "at $t = 0.5$", "at $t = 0.5$"),
        ("de", "at $t = 0.5$", "bei $t = 0.5$"),
        ("fr-CH", "$A$ at $t = 0.5$", "$A$ à $t = 0.5$"),
        ("es", "crate pushed out", "crate tras el empuje"),
        ("zh", "at $t = 0.5$", "$t = 0.5$"),
        ("zh", "depth $d = 2$", "$d = 2$"),
        ("zh", "crate pushed out", "crate"),
        ("fr", "edge of $A$, reversed", "arête de $A$, inversée"),
        ("de", "edge of $B$", "Kante von $B$"),
        ("es", "$2.5$ long", "longitud $2.5$"),
    ];
    for (tag, line, expected) in cases {
        assert_eq!(label(tag, "d", line), expected, "{tag}");
    }
    assert_eq!(label("de", "A'", "crate pushed out"), "crate hinausgeschoben");
    // All that a ghost says of itself, to the last row: a row before these made them English.
    assert_eq!(label("de", "A'", "looks the same"), "sieht gleich aus");
    assert_eq!(label("fr", "B'", "turned $720°$"), "rotation de $720°$");
    assert_eq!(label("de", "A'", "expected: hit"), "expected: hit", "a body of that name");
    assert_eq!(label("zh", "incident", "incident"), "");
    assert_eq!(label("de", "copy", "*b moved around box*"), "*b um box* geschoben");
}

#[test]
fn a_body_whose_name_is_a_word_of_ours_keeps_it() {
    for key in ["A", "B'", "context"] {
        assert_eq!(label("de", key, "tangent"), "tangent", "{key}");
    }
    assert_eq!(label("de", "tangent", "tangent"), "Tangente");
}

#[test]
fn every_title_of_a_default_picture_and_every_word_can_be_said_and_set() {
    let german = Language::of_tag("de");
    let panels = PICTURES.iter().flat_map(|row| panels_of_text(row.panels, &(0..0)));
    for title in panels.filter_map(|panel| panel.title) {
        assert_ne!(german.words(&title.value), title.value);
    }
    for &row in WORDS {
        let stars = row.map(|said| said.matches(STAR).count());
        assert!(stars[2..].iter().all(|count| *count == stars[0]), "{row:?}");
        for said in row {
            let markup = said.replace(STAR, " 2 ").replace("$=", "${} =");
            let whole = if markup.matches('$').count() % 2 == 1 { format!("{markup}$") } else { markup };
            assert!(typeset(&whole, Style::regular(16.0)).is_ok(), "{whole}");
        }
    }
}

#[test]
fn a_language_without_words_of_ours_has_no_english_ones() {
    let czech = Language::of_tag("cs");
    for english in ["dropped", "half a turn", "its normal", "light", r"slope $\theta$: every arc ends here"] {
        assert_eq!(czech.lines("label", &[english.to_owned()]), Vec::<String>::new(), "{english}");
    }
    assert_eq!(czech.lines("dropped", &["$w_{0}$ dropped".to_owned()]), ["$w_{0}$"]);
    for english in ["$n$ (not to scale)", "expected $n$ (not to scale)"] {
        assert_eq!(czech.lines("n", &[english.to_owned()]), ["$n$"]);
    }
}
