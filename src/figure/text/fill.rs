//! Fills in the values of a text: `{=time}`, `{=separation:.3}`, `{=D.x}` … in captions, labels and notes.

use std::ops::Range;

use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::scene::{self, Spanned};
use crate::typeset::ends_in_formula;

use super::decimal::Decimal;
use super::digits::Digits;
use super::givers::{NO_OTHER, givers};
use super::number::{USUAL, in_math, in_words};
use super::outcome::another_answer_has;
use super::values::{VALUES, Value, value_of};

/// What stands for a value that this answer lacks and another one has, in words and in formulas.
const LACKING: [&str; 2] = ["–", r"\text{–}"];

/// What the names of values of a panel's step begin with.
const OF_A_STEP: &str = "step.";

/// How much of a text is quoted where a value in it has no end, in letters.
const QUOTED: usize = 24;

/// The text with every `{=name}` replaced by its value, and the names of those that this answer lacks: a
/// dash stands for them. Braces alone belong to LaTeX.
///
/// # Errors
/// Where the query of this context has no such value, or its digits are asked for in no way that there is, or
/// the `{=` is not closed; `at` is the text's place in the scene.
pub(crate) fn fill(
    text: &str,
    context: &Context,
    at: &Range<usize>,
) -> Result<(String, Vec<String>), Problem> {
    let (mut out, mut lacking) = (String::with_capacity(text.len()), Vec::new());
    let decimal = Decimal::of(context.scene);
    let mut rest = text;
    while let Some(start) = rest.find("{=") {
        let (before, from) = rest.split_at(start);
        out.push_str(before);
        let (written, after) = closed(from).map_err(|fault| Problem::new(fault, at.clone()))?;
        let here = || within(at, text, text.len() - from.len()..text.len() - after.len());
        let (name, digits) = match written.split_once(':') {
            None => (written, Some(USUAL)),
            Some((name, asked)) => (name, Digits::asked(asked)),
        };
        let quantity = value_of(name, context);
        rest = after;
        let [in_text, in_formula] = LACKING;
        let Some(quantity) = quantity else {
            if another_answer_has(name, context) {
                out.push_str(if ends_in_formula(&out) { in_formula } else { in_text });
                lacking.push(name.to_owned());
                continue;
            }
            let fault = lacking_fault(name, context);
            return Err(Problem::new(fault.into(), here()));
        };
        let Some(digits) = digits else {
            let reason =
                "after the colon stands `.3` for three digits after the point, or `.3g` for three in all";
            let fault = Fault::BadMarkup { markup: format!("{{={written}}}"), reason: reason.to_owned() };
            return Err(Problem::new(fault, here()));
        };
        let number = quantity.written(digits);
        out.push_str(&if ends_in_formula(&out) {
            decimal.in_latex(in_math(&number))
        } else {
            decimal.in_number(in_words(&number))
        });
    }
    out.push_str(rest);
    Ok((out, lacking))
}

/// Where in the scene a part of a text stands that is at `at` with its quotes; all of that where the text is
/// written otherwise than it reads.
fn within(at: &Range<usize>, text: &str, part: Range<usize>) -> Range<usize> {
    let quotes = 2;
    if at.len() != text.len() + quotes {
        return at.clone();
    }
    let begin = at.start + 1;
    begin + part.start..begin + part.end
}

/// What is wrong with a value that no answer to the question has.
fn lacking_fault(name: &str, context: &Context) -> scene::Fault {
    let (message, help) = match givers(name, context) {
        Some(_) if name.starts_with(OF_A_STEP) && context.step.is_none() => {
            let help = "write it in a text of a panel that has a `step`".to_owned();
            (format!("`{name}` is of a step, and this text is of none"), help)
        }
        Some(givers) => {
            let or = if givers == NO_OTHER { "" } else { ", or ask a question that has it" };
            let help = format!("leave `{{={name}}}` out of the text{or}");
            (format!("this answer has no `{name}`: {givers}"), help)
        }
        None => {
            let known = known(context);
            return scene::Fault::UnknownWord { what: "value", got: name.to_owned(), known };
        }
    };
    scene::Fault::Conflict { message, help }
}

/// What stands in the braces at the beginning of a text, and what comes after them.
fn closed(text: &str) -> Result<(&str, &str), Fault> {
    let inner = text.strip_prefix("{=").unwrap_or(text);
    match inner.split_once('}') {
        Some((written, after)) if !written.contains('{') => Ok((written, after)),
        _ => {
            let markup = text.chars().take(QUOTED).collect();
            Err(Fault::BadMarkup { markup, reason: "expected `}` to close it".to_owned() })
        }
    }
}

/// A text whose values can all be filled in, with them; `None` where it names none.
pub(crate) fn filled(text: &Spanned<String>, context: &Context) -> Option<String> {
    let (filled, _) = fill(&text.value, context, &text.span).ok()?;
    (filled != text.value).then_some(filled)
}

/// The names of the values that this query has, or has where it is answered otherwise, in the order of the
/// table.
fn known(context: &Context) -> Vec<String> {
    let has = |value: &&Value| (value.of)(context).is_some() || another_answer_has(value.name, context);
    VALUES.iter().filter(has).map(|value| value.name.to_owned()).collect()
}

#[cfg(test)]
mod tests {
    use crate::drawing::{Drawing, Item};
    use crate::figure::{draw, plan};
    use crate::scene::{Source, read};

    /// The drawing of a ball that meets a wall at t = 0.343 and a bit, with the keys of a scene before it.
    fn drawn(keys: &str) -> Result<Drawing, Vec<String>> {
        let text = format!(
            "{keys}
            shapes.A = {{ kind = 'circle', radius = 1, velocity = [7, 0] }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [4.4, 0] }}
            query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}
            panels = [{{ time = 0, layers = ['shapes', 'separation'] }}]"
        );
        let scene = read(&Source::new("values.toml", &text)).unwrap();
        let plan = plan(&scene).map_err(|all| all.iter().map(|p| p.fault.to_string()).collect::<Vec<_>>())?;
        Ok(draw(&plan, plan.theme, "values").drawing)
    }

    /// The caption in words.
    fn caption(keys: &str, text: &str) -> String {
        let drawing = drawn(&format!("caption = '{text}'\n{keys}")).unwrap();
        let mut groups = drawing.items.iter().filter_map(|item| match item {
            Item::Group(group) if group.name == "caption" => group.label.clone(),
            _ => None,
        });
        groups.next().unwrap()
    }

    /// Whether a text with that markup stands somewhere.
    fn says(items: &[Item], markup: &str) -> bool {
        items.iter().any(|item| match item {
            Item::Group(group) => says(&group.items, markup),
            Item::Text(text) => text.line.markup == markup,
            Item::Path(_) => false,
        })
    }

    #[test]
    fn a_value_that_is_not_closed_is_refused_where_it_begins() {
        for text in ["they touch at {=time", "{=time and {a|b}", "{=time:.3", "at {=time\\{x}"] {
            let problems = drawn(&format!("caption = '{text}'")).unwrap_err();
            assert!(problems[0].contains("`{=time") && problems[0].contains("close"), "{text}: {problems:?}");
        }
    }

    #[test]
    fn a_wrong_value_is_pointed_at_and_not_all_of_its_text() {
        for (written, marked) in [
            ("caption = 'they touch at {=tim}, then stop'", "{=tim}"),
            ("caption = \"they touch at {=time:3}\"", "{=time:3}"),
            ("caption = \"a \\u0041 at {=tim}\"", "\"a \\u0041 at {=tim}\""),
        ] {
            let text = format!(
                "{written}
                shapes.A = {{ kind = 'circle', radius = 1, velocity = [7, 0] }}
                shapes.B = {{ kind = 'circle', radius = 1, position = [4.4, 0] }}
                query = {{ kind = 'linear-sweep', of = ['A', 'B'] }}"
            );
            let scene = read(&Source::new("values.toml", &text)).unwrap();
            let problems = plan(&scene).unwrap_err();
            assert_eq!(&text[problems[0].span.clone()], marked);
        }
    }

    #[test]
    fn a_value_has_as_many_digits_as_are_asked_for_and_proved() {
        assert_eq!(caption("", "{=time} {=time:.2} {=time:.5} {=time:.5g}"), "0.343 0.34 0.34286 0.34286");
        assert_eq!(caption("", "{a|$t = {=time:.4}$}, {=hit.n.x:.2}"), "t = 0.3429, 1.00");
        let most = caption("", "{=time:.99}");
        assert!(most.starts_with("0.34285714285") && most.len() <= 14, "{most}");
        let problems = drawn("caption = '{=time:3}'").unwrap_err();
        assert!(problems[0].contains("`{=time:3}`") && problems[0].contains("`.3g`"), "{problems:?}");
        let problems = drawn("caption = '{=tim:.3}'").unwrap_err();
        assert!(problems[0].contains("unknown value `tim`"), "{problems:?}");
    }

    #[test]
    fn a_value_of_a_step_in_a_text_of_none_says_where_it_has_one() {
        let told = drawn("caption = '{=step.separation}'").unwrap_err();
        assert_eq!(told, ["`step.separation` is of a step, and this text is of none"]);
        let told = drawn("caption = '{=foo}'").unwrap_err();
        assert_eq!(told, ["unknown value `foo`"]);
    }

    #[test]
    fn numbers_of_texts_and_labels_follow_the_language_and_so_do_our_sentences() {
        assert_eq!(caption("lang = 'de'", "{=time}, $t = {=time}$"), "0,343, t = 0,343");
        assert_eq!(caption("lang = 'de-CH'", "{=time}"), "0.343");
        let drawing = drawn("lang = 'fr'\nheadline = 'Touche à {=time}.'").unwrap();
        assert!(says(&drawing.items, "$d = 2{,}4$"));
        assert!(drawing.desc.contains("B pour la première fois à t = 0,343"), "{}", drawing.desc);
        assert_eq!(drawing.languages_of_words(), [None, None]);
        // In a language that we have no sentences in they are English, and their numbers too.
        let drawing = drawn("lang = 'pl'").unwrap();
        assert!(drawing.desc.contains("first touches B at t = 0.343"), "{}", drawing.desc);
        assert_eq!(drawing.languages_of_words(), [Some("en"), Some("en")]);
        assert!(says(&drawn("").unwrap().items, "$d = 2.4$"));
    }

    #[test]
    fn a_motion_bound_is_never_rounded_down() {
        let text = "caption = '{=bound} {=bound:.1} {=bound:.4g}'
            shapes.A = { kind = 'circle', radius = 0.5, velocity = [1, 2.651] }
            query = { kind = 'motion-bound', of = ['A'] }";
        let scene = crate::scene::open_text("s.toml", text).unwrap().scene;
        let plan = plan(&scene).unwrap();
        // It is √(1 + 2.651²) = 2.83332…, which a third digit has below itself.
        assert_eq!(plan.caption.words.as_deref(), Some("2.84 2.9 2.834"));
    }

    #[test]
    fn titles_are_said_with_the_values_that_stand_in_them() {
        let drawing = drawn("title = 'Touch at $t = {=time}$'").unwrap();
        assert!(drawing.title.starts_with("Touch at t = 0.343: "), "{}", drawing.title);
        assert!(drawn("title = '{=tim}'").is_err());
        let text = "shapes.A = { kind = 'circle', radius = 2 }
            query = { kind = 'bounds', of = ['A'] }
            panels = [{ title = 'To {=max.x}', layers = ['shapes'] }]";
        let scene = read(&Source::new("titled.toml", text)).unwrap();
        let plan = plan(&scene).unwrap();
        let drawing = draw(&plan, plan.theme, "titled").drawing;
        assert!(drawing.desc.contains("The picture (To 2) shows"), "{}", drawing.desc);
        let Item::Group(panel) = &drawing.items[1] else { panic!("a panel") };
        assert_eq!(panel.label.as_deref(), Some("To 2"));
    }

    #[test]
    fn a_headline_without_a_full_stop_is_said_with_one() {
        for headline in ["The ball is late", "The ball is late."] {
            let drawing = drawn(&format!("headline = '{headline}'")).unwrap();
            assert!(drawing.desc.starts_with("The ball is late. A is a circle"), "{}", drawing.desc);
        }
        assert!(drawn("headline = 'Late?'").unwrap().desc.starts_with("Late? A"));
    }

    #[test]
    fn a_scene_can_give_its_alternative_text_in_its_language() {
        let drawing = drawn("lang = 'de'\nalt = 'Der {a|Ball} trifft bei $t = {=time:.2}$.'").unwrap();
        assert_eq!(drawing.title, "Der Ball trifft bei t = 0,34.");
        assert_eq!(drawing.languages_of_words(), [None, None]);
        assert!(drawn("alt = '{=tim}'").is_err());
        let british = drawn("lang = 'EN-gb'").unwrap();
        assert_eq!(british.languages_of_words(), [None, None]);
        assert!(
            read(&Source::new("s.toml", "lang = 'german!'"))
                .unwrap_err()
                .iter()
                .any(|p| { p.fault.to_string().contains("\"german!\"") })
        );
    }
}
