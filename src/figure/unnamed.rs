//! Words against picture: what the words name and no label shows, what a label shows and no word names, and
//! what a formula needs and nobody gives.
//!
//! A symbol is a letter of a formula with its script and primes, `$B \ominus A$` one of its own. The words
//! are headline, caption and notes; the picture has the other labels; titles of panels are both. A time is no
//! place and needs no label where its number stands beside it.

use std::collections::BTreeSet;
use std::fmt;

use crate::drawing::{Drawing, Item};
use crate::typeset::{Piece, pieces};

use super::text::{Symbol, plain, symbols};

/// The groups of a drawing whose texts are words for the whole figure.
const WORDS: [&str; 3] = ["headline", "caption", "label-note"];
/// The group of a title over a panel, which names what stands below it and so is words and picture at once.
const TITLE: &str = "title";
/// What the groups of labels begin with.
const LABEL: &str = "label-";
/// The letter of time.
const TIME: &str = "t";

/// What words and picture do not say of each other.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Unnamed {
    /// A symbol of the words that no label shows.
    NotShown(String),
    /// A symbol of a label that no word names, and that has no number beside it.
    NotNamed(String),
    /// A symbol that a formula with a result is made of, and whose value stands nowhere.
    NoValue(String),
}

impl fmt::Display for Unnamed {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotShown(symbol) => write!(f, "`{symbol}` is in the words and not on the picture"),
            Self::NotNamed(symbol) => write!(f, "`{symbol}` is on the picture and not in the words"),
            Self::NoValue(symbol) => write!(f, "`{symbol}` is part of a formula and has no value"),
        }
    }
}

/// Everything that words and picture of a drawing do not say of each other, sorted, each once.
///
/// ```
/// use tracefig::figure::{Unnamed, draw, plan, unnamed};
/// let text = r#"
/// caption = 'The ball A has the centre $c$.'
/// shapes.A = { kind = "circle", radius = 1 }
/// query = { kind = "bounds", of = ["A"] }
/// panels = [{ layers = ["shapes", "origin"] }]
/// "#;
/// let scene = tracefig::scene::open_text("ball.toml", text)?.scene;
/// let plan = plan(&scene).unwrap();
/// let found = unnamed(&draw(&plan, plan.theme, "ball").drawing);
/// assert_eq!(found, [Unnamed::NotShown("c".into()), Unnamed::NotNamed("O".into())]);
/// # Ok::<(), Box<tracefig::Refused>>(())
/// ```
#[must_use]
pub fn unnamed(drawing: &Drawing) -> Vec<Unnamed> {
    let mut texts = Texts::default();
    texts.gather(&drawing.items, "");
    let said =
        |all: &BTreeSet<String>| all.union(&texts.titles).map(|markup| plain(markup)).collect::<Vec<_>>();
    let (words, labels) = (said(&texts.words), said(&texts.labels));
    let formulas =
        |all: &BTreeSet<String>| all.iter().flat_map(|markup| relations(markup)).collect::<Vec<_>>();
    let (of_words, of_labels) = (formulas(&texts.words), formulas(&texts.labels));
    let valued: BTreeSet<Symbol> = of_words.iter().chain(&of_labels).flat_map(Relation::valued).collect();
    let mut found = BTreeSet::new();
    for symbol in of_words.iter().flat_map(Relation::symbols) {
        let needs_none = symbol.as_str() == TIME && valued.contains(&symbol);
        let is_shown = of_labels.iter().any(|r| r.symbols().any(|s| s == symbol));
        if !needs_none && !is_shown && !labels.iter().any(|text| names(text, &symbol)) {
            found.insert(Unnamed::NotShown(symbol));
        }
    }
    for relation in &of_labels {
        let own: BTreeSet<Symbol> = relation.valued().collect();
        let unknown = relation.symbols().filter(|symbol| {
            !own.contains(symbol)
                && !of_words.iter().any(|r| r.symbols().any(|s| s == *symbol))
                && !words.iter().any(|text| names(text, symbol))
        });
        found.extend(unknown.map(Unnamed::NotNamed));
    }
    let inputs = of_words.iter().chain(&of_labels).flat_map(Relation::inputs);
    found.extend(inputs.filter(|symbol| !valued.contains(symbol)).map(Unnamed::NoValue));
    found.into_iter().collect()
}

/// The markup of a drawing: what is said across the figure, and what stands at a thing.
#[derive(Default)]
struct Texts {
    /// Headline, caption and notes.
    words: BTreeSet<String>,
    /// Titles of panels.
    titles: BTreeSet<String>,
    /// Labels.
    labels: BTreeSet<String>,
}

impl Texts {
    /// Takes the texts of items that are in the group of a name.
    fn gather(&mut self, items: &[Item], within: &str) {
        for item in items {
            match item {
                Item::Group(group) => self.gather(&group.items, &group.name),
                Item::Text(text) if WORDS.contains(&within) => {
                    self.words.insert(text.line.markup.clone());
                }
                Item::Text(text) if within == TITLE => {
                    self.titles.insert(text.line.markup.clone());
                }
                Item::Text(text) if within.starts_with(LABEL) => {
                    self.labels.insert(text.line.markup.clone());
                }
                Item::Text(_) | Item::Path(_) => {}
            }
        }
    }
}

/// A formula, cut at its signs of relation: `d = v t = 3` has three terms.
struct Relation {
    /// The symbols of each term, in order, and whether it is a symbol alone or numbers alone.
    terms: Vec<Term>,
}

/// A side of a relation.
struct Term {
    /// The symbols in it.
    symbols: Vec<Symbol>,
    /// What else is in it.
    form: Form,
}

/// What a term is made of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Form {
    /// One symbol and nothing else.
    Symbol,
    /// A number, or several in brackets.
    Number,
    /// Anything else.
    Other,
}

/// Signs between the terms of a relation, as LaTeX.
const RELATIONS: [&str; 9] = [r"\geq", r"\leq", r"\ge", r"\le", r"\approx", r"\to", "=", "<", ">"];

/// The formulas of a markup; of two with nothing but blanks between them, one of which goes on over an equals
/// sign, one.
fn relations(markup: &str) -> Vec<Relation> {
    let (mut formulas, mut beside) = (Vec::<String>::new(), false);
    for piece in pieces(markup).unwrap_or_default() {
        match piece {
            Piece::Formula(_, latex) => {
                match formulas.last_mut() {
                    Some(last) if beside && (last.ends_with('=') || latex.starts_with('=')) => {
                        last.push_str(latex);
                    }
                    _ => formulas.push(latex.to_owned()),
                }
                beside = true;
            }
            Piece::Words(_, words) => beside &= words.trim().is_empty(),
            Piece::Role(..) | Piece::Plain => {}
        }
    }
    let relation = |latex: &String| Relation { terms: terms(latex).into_iter().map(Term::of).collect() };
    formulas.iter().map(relation).collect()
}

/// A formula cut at its signs of relation.
fn terms(latex: &str) -> Vec<&str> {
    let mut terms = Vec::new();
    let (mut from, mut at) = (0, 0);
    while at < latex.len() {
        let rest = &latex[at..];
        let sign = RELATIONS.iter().find(|sign| {
            rest.strip_prefix(**sign).is_some_and(|after| {
                // A command ends where its letters end: `\left` is none of these.
                !sign.starts_with('\\') || !after.starts_with(|c: char| c.is_ascii_alphabetic())
            })
        });
        match sign {
            Some(sign) => {
                terms.push(&latex[from..at]);
                at += sign.len();
                from = at;
            }
            None => at += rest.chars().next().map_or(1, char::len_utf8),
        }
    }
    terms.push(&latex[from..]);
    terms
}

impl Term {
    fn of(latex: &str) -> Self {
        let found = symbols(latex);
        let text = plain(&format!("${latex}$"));
        let form = match &found[..] {
            [only] if only.as_str() == text => Form::Symbol,
            [] if text.contains(|c: char| c.is_ascii_digit()) => Form::Number,
            _ => Form::Other,
        };
        Self { symbols: found, form }
    }
}

impl Relation {
    /// All symbols, in order.
    fn symbols(&self) -> impl Iterator<Item = Symbol> + '_ {
        self.terms.iter().flat_map(|term| term.symbols.iter().cloned())
    }

    /// Whether some term is a number.
    fn has_number(&self) -> bool {
        self.terms.iter().any(|term| term.form == Form::Number)
    }

    /// The symbols that stand beside their own number.
    fn valued(&self) -> impl Iterator<Item = Symbol> + '_ {
        let alone = self.terms.iter().filter(|term| self.has_number() && term.form == Form::Symbol);
        alone.flat_map(|term| term.symbols.iter().cloned())
    }

    /// The symbols that a result is computed from: those of terms that are no single symbol, where the
    /// formula has a number.
    fn inputs(&self) -> impl Iterator<Item = Symbol> + '_ {
        let computed = self.terms.iter().filter(|term| self.has_number() && term.form == Form::Other);
        // `‖D‖ = 2` is the value of a length, and no formula of D.
        let several = self.terms.len() > 2;
        computed.filter(move |_| several).flat_map(|term| term.symbols.iter().cloned())
    }
}

/// Whether a text in words has a symbol as a word of its own.
fn names(text: &str, symbol: &str) -> bool {
    let is_part = |c: Option<char>| c.is_some_and(|c| c.is_alphanumeric() || matches!(c, '_' | '′'));
    text.match_indices(symbol).any(|(at, found)| {
        !is_part(text[..at].chars().next_back()) && !is_part(text[at + found.len()..].chars().next())
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::{draw, plan};
    use crate::scene::{Source, read};

    /// What words and labels do not say of each other; the label of B's circle is `label`.
    fn found(caption: &str, note: &str, label: &str) -> Vec<String> {
        let text = format!(
            r"shapes.A = {{ kind = 'circle', radius = 1 }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [4, 0] }}
            query = {{ kind = 'separation', of = ['A', 'B'] }}
            caption = '{caption}'
            labels.B = '{label}'
            panels = [{{ layers = ['shapes', {{ layer = 'note', lines = ['{note}'] }}] }}]"
        );
        let scene = read(&Source::new("words.toml", &text)).unwrap();
        let plan = plan(&scene).unwrap();
        let figure = draw(&plan, plan.theme, "words");
        assert!(figure.faults().is_empty(), "every label has a place");
        unnamed(&figure.drawing).iter().map(ToString::to_string).collect()
    }

    #[test]
    fn words_and_picture_name_the_same() {
        let none: [&str; 0] = [];
        assert_eq!(found("{a|A} and $B$.", "so", "$B$"), none);
        assert_eq!(found("A and $q$", "so", "$q$"), none);
        assert_eq!(
            found("A moves by $v_A$ to B.", "so", "$r_B$"),
            ["`v_A` is in the words and not on the picture", "`r_B` is on the picture and not in the words"]
        );
    }

    #[test]
    fn a_label_beside_its_number_needs_no_words_and_a_time_in_the_words_no_label() {
        let none: [&str; 0] = [];
        assert_eq!(found("A at $t = 0.5$.", "so", "$d = 2.5$"), none);
        assert_eq!(found("A at $t$.", "so", "$d = (1, 2)$"), ["`t` is in the words and not on the picture"]);
        assert_eq!(
            found("A.", "so", r"$\|D\| = 2.5$"),
            ["`D` is on the picture and not in the words"],
            "a length is named by its vector"
        );
    }

    #[test]
    fn what_a_formula_is_made_of_has_a_value_somewhere() {
        let formula = r"$p = d - (r_1 + r_2) = 3$";
        let caption = "A: $p$ of $d = 5$, $r_1 = 1$ and $r_2$";
        let said = found(caption, formula, "$B$ $p$ $d$ $r_1$ $r_2$");
        assert_eq!(
            said,
            ["`B` is on the picture and not in the words", "`r_2` is part of a formula and has no value"]
        );
    }
}
