//! HTML in steps: a page with the figure, a list of its steps, and what each says.
//!
//! The list is of radio buttons, so it works without a script: the style sheet reads which one is on as the
//! number `--step`, and what a step does not show has opacity 0 by arithmetic with it. A script of some lines
//! adds buttons and keys; the page names its hash, and no other script runs there. An address that ends in
//! `#step-3` opens at that step. On paper and in a reader without style sheets the whole figure stands.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use super::base64::base64;
use super::sha256::sha256;
use super::svg::searchable;
use super::svg::steps::{SINCE, UNTIL};
use super::xml::escape;
use super::{InSteps, Options, OutputError, page, validity};
use crate::drawing::{Drawing, Item, Shown};

/// Style sheet of the list.
const STYLE: &str = include_str!("stepper.css");
/// The buttons and keys.
const SCRIPT: &str = include_str!("stepper.js");
/// What the buttons are called, one step back, one on and back to the first, and the list, in each language
/// of which we have words; the first is for all others.
const WORDS: [(&str, ([&str; 3], &str)); page::LANGUAGES] = [
    (Drawing::OWN_LANG, (["Step back", "Next step", "First step"], "Steps")),
    ("de", (["Schritt zurück", "Nächster Schritt", "Erster Schritt"], "Schritte")),
    ("fr", (["Étape précédente", "Étape suivante", "Première étape"], "Étapes")),
    ("es", (["Paso anterior", "Paso siguiente", "Primer paso"], "Pasos")),
];

/// Writes the page.
pub(super) fn write(drawing: &Drawing, _: &Options, in_steps: InSteps) -> Result<Vec<u8>, OutputError> {
    validity::page(drawing)?;
    // The one script that may run, by the hash of its text.
    let hash = base64(&sha256(SCRIPT.as_bytes()));
    let mut out = page::head(drawing, &format!("; script-src 'sha256-{hash}'"));
    out.push_str(STYLE);
    push_rules(&mut out, drawing);
    out.push_str("</style>\n</head>\n<body>\n<main>\n");
    // Where an address leads is the top of the page: the picture is what one comes for.
    for number in 1..=drawing.steps.len() {
        let _ = write!(out, "<i id=\"step-{number}\"></i>");
    }
    let [of_title, of_desc] = drawing.languages_of_words();
    page::open(&mut out, "h1", of_title.filter(|_| drawing.heading.is_none()));
    escape(&mut out, drawing.heading.as_ref().unwrap_or(&drawing.title));
    out.push_str("</h1>\n<figure>\n");
    out.push_str(&searchable(drawing, Some(in_steps)));
    if let Some(narrow) = &drawing.narrow {
        out.push_str(&searchable(narrow, Some(in_steps)));
    }
    let ([back, next, again], list) = page::in_language(drawing, &WORDS);
    let _ = write!(out, "</figure>\n<nav hidden aria-label=\"{list}\">");
    let _ = write!(out, "<button type=\"button\" aria-label=\"{back}\">◀</button>");
    let _ = write!(out, "<button type=\"button\" aria-label=\"{next}\" data-again=\"{again}\">▶</button>");
    let _ = write!(out, "<output></output></nav>\n<fieldset>\n<legend>{list}</legend>\n<ol>\n");
    let last = drawing.steps.len();
    for (number, step) in (1..).zip(&drawing.steps) {
        let on = if number == last { " checked" } else { "" };
        let _ = write!(out, "<li><label><input type=\"radio\" name=\"step\" ");
        let _ = write!(out, "value=\"{number}\"{on}> ");
        page::push_words(&mut out, &step.title);
        out.push_str("<span>");
        page::push_words(&mut out, &step.sentences.join(" "));
        out.push_str("</span></label></li>\n");
    }
    out.push_str("</ol>\n</fieldset>\n");
    page::open(&mut out, "p", of_desc);
    page::push_words(&mut out, &drawing.desc);
    let _ = write!(out, "</p>\n</main>\n<script>{SCRIPT}</script>\n</body>\n</html>\n");
    Ok(out.into_bytes())
}

/// Appends the rules by which a step shows what it shows; before a choice is made, and on paper, the last
/// one.
fn push_rules(out: &mut String, drawing: &Drawing) {
    let last = drawing.steps.len();
    let _ = writeln!(out, "main{{--step:{last}}}");
    for step in 1..last {
        let _ = writeln!(out, "main:has([name=step][value=\"{step}\"]:checked){{--step:{step}}}");
        // Without a script: until the list says otherwise.
        let linked =
            format!("main:not([data-script]):has([value=\"{last}\"]:checked):has(#step-{step}:target)");
        let _ = writeln!(out, "{linked}{{--step:{step}}}");
        let _ =
            writeln!(out, "{linked} li{{font-weight:400}}{linked} li:nth-child({step}){{font-weight:600}}");
    }
    let _ = writeln!(out, "@media print{{main{{--step:{last}!important}}}}");
    let mut used = BTreeSet::new();
    let narrow = drawing.narrow.iter().flat_map(|narrow| &narrow.items);
    drawing.items.iter().chain(narrow).for_each(|item| collect(item, &mut used));
    for (since, until) in used {
        let _ = write!(out, "[{SINCE}=\"{since}\"]");
        let come = format!("var(--step) - {}", since - 1);
        let _ = match until {
            Some(until) => {
                writeln!(out, "[{UNTIL}=\"{until}\"]{{opacity:min({come},{until} - var(--step))}}")
            }
            None => writeln!(out, ":not([{UNTIL}]){{opacity:calc({come})}}"),
        };
    }
}

/// When items come and go, where they do.
fn collect(item: &Item, used: &mut BTreeSet<(usize, Option<usize>)>) {
    match item {
        Item::Group(group) => group.items.iter().for_each(|item| collect(item, used)),
        Item::Path(_) | Item::Text(_) if item.shown() == Shown::ALWAYS => {}
        Item::Path(_) | Item::Text(_) => {
            let Shown { since, until } = item.shown();
            used.insert((since, until));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::output::samples::everything;

    #[test]
    fn buttons_and_list_are_called_in_the_language_of_the_scene() {
        let mut drawing = everything();
        for (lang, said) in [
            (None, ["First step", "<legend>Steps<"]),
            (Some("pl"), ["Step back", "<legend>Steps<"]),
            (Some("de-AT"), ["Schritt zurück", "<legend>Schritte<"]),
            (Some("fr"), ["Étape précédente", "<legend>Étapes<"]),
            (Some("es"), ["Paso anterior", "<legend>Pasos<"]),
        ] {
            drawing.lang = lang.map(str::to_owned);
            let page = write(&drawing, &Options::default(), InSteps::default()).unwrap();
            let page = String::from_utf8(page).unwrap();
            assert!(said.iter().all(|word| page.contains(word)), "{lang:?}");
        }
    }

    #[test]
    fn every_step_has_its_rule_and_its_sentence() {
        let mut drawing = everything();
        let step =
            |title: &str| crate::drawing::Step { title: title.into(), sentences: vec!["a < b".into()] };
        drawing.steps = ["first", "second", "third"].map(step).to_vec();
        drawing.items[0].for_each_shown(&|shown| *shown = Shown { since: 2, until: None });
        drawing.items[1].for_each_shown(&|shown| *shown = Shown { since: 2, until: Some(3) });
        let page = write(&drawing, &Options::default(), InSteps::default()).unwrap();
        let page = String::from_utf8(page).unwrap();
        assert_eq!(page.matches("a &lt; b").count(), 3);
        assert!(page.contains("value=\"3\" checked"));
        assert!(page.contains("[data-step=\"2\"]:not([data-until]){opacity:calc(var(--step) - 1)}"));
        assert!(
            page.contains(
                "[data-step=\"2\"][data-until=\"3\"]{opacity:min(var(--step) - 1,3 - var(--step))}"
            )
        );
        assert!(page.contains("<g data-step=\"2\" data-until=\"3\" opacity=\"0\">"));
        // On a phone the same steps of a picture of its own.
        let narrow = Drawing { id: "on-a-phone".into(), width: 360.0, ..drawing.clone() };
        let both = Drawing { narrow: Some(Box::new(narrow)), ..drawing };
        let both = String::from_utf8(write(&both, &Options::default(), InSteps::default()).unwrap()).unwrap();
        assert_eq!([&page, &both].map(|page| page.matches("<svg").count()), [1, 2]);
        assert!(both.contains("id=\"on-a-phone"));
    }
}
