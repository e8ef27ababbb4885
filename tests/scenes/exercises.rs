//! A question's files hold its answer nowhere: not in words, not in numbers of any length, not in bytes.

#![expect(clippy::unwrap_used, reason = "a test may panic wherever it is")]

use std::collections::BTreeSet;
use std::fmt::Write;
use std::io::Read;

use tracefig::drawing::{Drawing, Item};
use tracefig::drift::{facts, fingerprint, metadata, text_chunk};
use tracefig::figure::exercise::{Asked, asked, variant};
use tracefig::figure::{draw, plan};
use tracefig::output::{FORMATS, Options, Writer};
use tracefig::scene::{Scene, Variant, open_text};
use tracefig_reference::random::Random;

/// Digits of the shortest form that is looked for in bytes: fewer stand somewhere by chance.
const DIGITS: usize = 6;

/// Questions, and the values that each is asked for.
const ASKED: [(&str, &str); 5] = [
    ("separation", "'d', 'separation', 'n.x', 'n.y'"),
    ("contact", "'separation'"),
    ("linear-sweep", "'time', 'hit.n.x', 'hit.n.y'"),
    ("time-of-impact", "'time'"),
    ("bounds", "'min.x', 'max.y', 'h.x'"),
];

/// A scene whose numbers have many digits, so that its answers have.
fn scene_text(r: &mut Random, (kind, ask): (&str, &str)) -> String {
    let mut long = |from: f64, to: f64| {
        let part = f64::from(u32::try_from(r.below(1 << 30)).unwrap()) / f64::from(1 << 30);
        from + (to - from) * part
    };
    let mut text = String::new();
    let _ =
        writeln!(text, "title = 'One of many'\nheadline = 'They are {{=d}} apart'\nexercise.ask = [{ask}]");
    if kind == "bounds" {
        text = text.replace("headline = 'They are {=d} apart'", "headline = 'Up to {=max.x}'");
    }
    let moves = kind == "linear-sweep" || kind == "time-of-impact";
    let velocity = if moves { format!(", velocity = [{}, 0.1]", long(5.0, 9.0)) } else { String::new() };
    let spin = if kind == "time-of-impact" { ", angular_velocity_deg = 40" } else { "" };
    let (radius, x, y, turn) = (long(0.3, 1.2), long(2.5, 5.0), long(-0.5, 0.5), long(1.0, 80.0));
    let _ = writeln!(text, "shapes.A = {{ kind = 'circle', radius = {radius}{velocity} }}");
    let _ = writeln!(
        text,
        "shapes.B = {{ kind = 'box', half_extents = [{}, {}], position = [{x}, {y}], angle_deg = {turn}{spin} }}",
        long(0.4, 1.5),
        long(0.4, 1.5),
    );
    let of = if kind == "bounds" { "'B'" } else { "'A', 'B'" };
    let _ = writeln!(text, "query = {{ kind = '{kind}', of = [{of}] }}");
    text
}

/// The drawing of a variant as `render` has it written, its stamp included.
fn drawing(text: &str, as_variant: Variant) -> (Drawing, Vec<Asked>) {
    let file = open_text("s.toml", text).unwrap();
    let scene: Scene = variant(&file.scene, as_variant).unwrap();
    let plan = plan(&scene).unwrap();
    let mut drawing = draw(&plan, plan.theme, "abcd").drawing;
    let hash = fingerprint(&file.meaning, as_variant.word());
    drawing.hash = text_chunk(&hash);
    drawing.metadata = metadata(&hash, &facts(&plan));
    (drawing, asked(&plan))
}

/// The bytes of a drawing in the first formats, packed streams also unpacked; a letter a byte.
fn files(drawing: &Drawing, first: usize) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    for format in FORMATS.iter().take(first) {
        let Writer::One(write) = format.write else { continue };
        let bytes = write(drawing, &Options { scale: 0.5, ..Options::default() }).unwrap();
        let mut unpacked = bytes.clone();
        for at in 0..bytes.len().saturating_sub(2) {
            // The first two bytes of a stream of zlib.
            if bytes[at] == 0x78 && (usize::from(bytes[at]) * 256 + usize::from(bytes[at + 1])) % 31 == 0 {
                let mut part = Vec::new();
                let _ = flate2::read::ZlibDecoder::new(&bytes[at..]).read_to_end(&mut part);
                unpacked.extend(part);
            }
        }
        all.push((format.name, letters(&unpacked)));
    }
    all
}

/// Bytes as letters, one each: a text is searched faster.
fn letters(bytes: &[u8]) -> String {
    bytes.iter().map(|&byte| char::from(byte)).collect()
}

/// All that a number may be written as, where it is long enough not to stand there by chance.
fn forms(value: f64) -> BTreeSet<String> {
    let mut texts = vec![format!("{value}"), format!("{value:?}"), format!("{value:e}")];
    for digits in 4..16 {
        texts.push(format!("{value:.digits$}"));
        texts.push(format!("{value:.digits$e}"));
    }
    let commas: Vec<String> = texts.iter().map(|text| text.replace('.', ",")).collect();
    texts.extend(commas);
    let is_long = |text: &String| text.bytes().filter(u8::is_ascii_digit).count() >= DIGITS;
    let unsigned = |text: String| text.trim_start_matches('-').to_owned();
    let mut forms: BTreeSet<String> = texts.into_iter().filter(is_long).map(unsigned).collect();
    forms.extend([letters(&value.to_le_bytes()), letters(&value.to_be_bytes())]);
    forms.insert(format!("{:016x}", value.to_bits()));
    forms
}

/// Every word of a drawing: title, description, metadata, names, labels and texts as they are set.
fn words(drawing: &Drawing) -> String {
    fn of(items: &[Item], all: &mut String) {
        for item in items {
            match item {
                Item::Group(group) => {
                    let _ = write!(all, " {} {}", group.name, group.label.as_deref().unwrap_or_default());
                    of(&group.items, all);
                }
                Item::Text(text) => {
                    let _ = write!(all, " {}", text.line.markup);
                }
                Item::Path(_) => {}
            }
        }
    }
    let mut all = format!("{} {} {} {}", drawing.title, drawing.desc, drawing.metadata, drawing.id);
    of(&drawing.items, &mut all);
    all
}

/// Whether a number of three digits stands among words, not as a part of a longer one.
fn says(words: &str, value: f64) -> bool {
    let number = |c: char| c.is_ascii_digit() || c == '.';
    (2..=3).any(|digits| {
        let text = tracefig::figure::plain(&format!("{:.*}", digits, value.abs()));
        words.split(|c| !number(c)).any(|token| token.trim_end_matches('.') == text)
    })
}

#[test]
fn a_question_holds_its_answer_nowhere() {
    let mut r = Random::new(19);
    let (mut asked_for, mut found_in_keys) = (0, 0);
    for (i, of) in (0..20).zip(ASKED.iter().cycle()) {
        let text = scene_text(&mut r, *of);
        // A miss has no time.
        let file = open_text("s.toml", &text).unwrap();
        if plan(&variant(&file.scene, Variant::Key).unwrap()).is_err() {
            continue;
        }
        let (question, _) = drawing(&text, Variant::Question);
        let (key, answers) = drawing(&text, Variant::Key);
        let (words, bytes) = (words(&question), files(&question, FORMATS.len()));
        assert!(question.metadata.ends_with("\"variant\":\"question\"}"), "{}", question.metadata);
        assert!(words.contains("Find ") && !words.contains("headline  They"), "{words}");
        for answer in answers {
            let is_given = text.contains(&format!("{}", answer.value().abs()));
            if is_given
                || answer.value().abs() < 1e-3
                || answer.value().abs() > 0.9999 && answer.name.contains('n')
            {
                continue;
            }
            asked_for += 1;
            for value in [answer.value(), answer.lo, answer.hi] {
                assert!(!says(&words, value), "scene {i}, {}: {value}\n{words}", answer.name);
                for (format, bytes) in &bytes {
                    for form in forms(value) {
                        assert!(!bytes.contains(&form), "scene {i}, {format}, {}: {form}", answer.name);
                    }
                }
            }
            let svg = &files(&key, 1)[0].1;
            found_in_keys += usize::from(forms(answer.hi).iter().any(|form| svg.contains(form)));
        }
    }
    assert!(asked_for >= 25, "{asked_for}");
    assert!(found_in_keys * 2 > asked_for, "the search finds what is there: {found_in_keys} of {asked_for}");
}

#[test]
fn a_question_is_as_long_whoever_answers_it() {
    let sizes = |algorithm: &str| {
        let text = format!(
            "title = 'One'\nexercise.ask = 'd'
            shapes.A = {{ kind = 'box', half_extents = [1, 0.7], angle_deg = 17 }}
            shapes.B = {{ kind = 'box', half_extents = [1.1, 0.4], position = [3.1, 0.2] }}
            query = {{ kind = 'separation', of = ['A', 'B'], algorithm = '{algorithm}' }}"
        );
        let (mut question, _) = drawing(&text, Variant::Question);
        // The hash of the scene, in which the algorithm is given.
        question.hash = String::new();
        question.metadata = String::new();
        files(&question, FORMATS.len())
    };
    let all: Vec<_> = ["minkowski", "gjk", "separating-axes"].map(sizes).into();
    assert!(all.iter().all(|files| *files == all[0]));
}
