//! The text of a label: the layer's own or the scene's, with its values filled in, set in type.

use std::ops::Range;

use crate::figure::budget::Budget;
use crate::figure::context::Context;
use crate::figure::fault::{Fault, Problem};
use crate::figure::language::Language;
use crate::figure::lettering::{role_words, unknown, with_markers};
use crate::figure::name::Name;
use crate::figure::placement::{Fold, Reserve, Sought};
use crate::figure::sketch::{Anchor, Label, Rank, Request, Size};
use crate::figure::standing::lacking;
use crate::geometry::Side;
use crate::scene;
use crate::typeset::{self, Line, Style, TypesetError};

use super::decimal::Decimal;
use super::fill::fill;
use super::fold::{chain, difference, folds, in_names, wordy};
use super::letters::letters;
use super::overrides::{IsKey, overridden};

/// Sets the labels of one panel.
pub(crate) struct Wording<'w> {
    /// The panel's moment and runs, where values are read.
    pub(crate) context: &'w Context<'w>,
    /// The size in page pixels at which a size of the usual page is set here.
    pub(crate) type_size: &'w dyn Fn(Size) -> f64,
    /// Whether some layer has a label of a key.
    pub(crate) is_key: IsKey,
    /// Whether the words of a note that wear a role have its marker before them.
    pub(crate) marked: bool,
}

impl Wording<'_> {
    /// A label with its text; none where the scene hides it or nobody gives it a text.
    ///
    /// `origin` is the place of its layer in the scene; what the answer lacks for it is in `notes`.
    ///
    /// # Errors
    /// Where the text names a value that the query does not have, or can't be typeset.
    pub(crate) fn set(
        &self,
        request: &Request,
        origin: &Range<usize>,
        notes: &mut Vec<Problem>,
    ) -> Result<Option<Sought>, Problem> {
        let label = &request.label;
        let given = overridden(self.context.scene, label.key, self.is_key);
        if given.is_some_and(|(_, o)| o.hide) {
            return Ok(None);
        }
        let text = given.and_then(|(_, o)| o.text.as_ref());
        let place = text.map_or_else(|| origin.clone(), |t| t.span.clone());
        let own = text.map(|t| vec![t.value.clone()]);
        let is_given = own.is_some() || label.is_given;
        let ours = || Language::of(self.context.scene).lines(label.key, &label.lines);
        let lines = &own.unwrap_or_else(|| if is_given { label.lines.clone() } else { ours() });
        if lines.iter().all(String::is_empty) {
            return Ok(None);
        }
        let size = if is_given { letters(label.size, lines) } else { label.size };
        let style = Style::regular((self.type_size)(size));
        let decimal = Decimal::of(self.context.scene);
        // The same words may stand in several labels: the key tells which one it is.
        let of_label = |error: TypesetError, markup| {
            let message = format!("{} (label `{}`)", error.message, label.key);
            bad_markup(TypesetError { message, ..error }, markup, &place)
        };
        let mut set = |line: &String| {
            if !is_given {
                let own = decimal.in_formulas(line);
                return typeset::line(&own, style).map_err(|e| of_label(e, line.clone()));
            }
            let (filled, values) = fill(line, self.context, &place)?;
            notes.extend(values.into_iter().map(|value| no_value(value, self.context, &place)));
            if let Some(problem) = bad_role(&filled, &place) {
                return Err(problem);
            }
            // What stands at its thing needs no marker of it.
            let marked = self.marked && label.rank == Rank::Note;
            let filled = if marked { with_markers(&filled) } else { filled };
            typeset::line(&filled, style).map_err(|e| of_label(e, filled.clone()))
        };
        let lines = lines.iter().map(&mut set).collect::<Result<Vec<_>, _>>()?;
        let mut folds = if let [line] = &lines[..] { folds_of(label, line, style) } else { Vec::new() };
        if let [line] = &lines[..]
            && !is_given
        {
            folds.extend(in_names(line, style, &briefs(self.context)));
        }
        Ok(Some(Sought {
            key: label.key,
            lines,
            folds,
            anchor: label.anchor.clone(),
            role: label.role,
            rank: label.rank,
            part: request.part,
            pin: given.and_then(|(_, o)| o.at.as_ref()).map(|at| at.value),
            loose: false,
            room: Reserve::default(),
            shown: request.shown,
            span: given.map_or_else(|| origin.clone(), |(key, _)| key.span.clone()),
        }))
    }
}

/// Sets every label of a panel, so that a text that can't be set is said before anything is drawn.
/// `requests` come with the places of their layers in the scene.
///
/// # Errors
/// When the labels are more than can be set.
pub(crate) fn check_texts<'r>(
    wording: &Wording,
    requests: impl Iterator<Item = (&'r Request, &'r Range<usize>)>,
    budget: &mut Budget,
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Result<Vec<Sought>, scene::Problem> {
    let mut all = Vec::new();
    for (request, span) in requests {
        match wording.set(request, span, notes) {
            Ok(Some(sought)) => {
                budget.letters(&sought.lines, span)?;
                all.push(sought);
            }
            Ok(None) => {}
            Err(problem) => problems.push(problem),
        }
    }
    Ok(all)
}

/// The scripts of the asked bodies with long names, each with a few letters that stand for it.
fn briefs(context: &Context) -> Vec<(String, String)> {
    let names = Side::BOTH.map(|side| context.named(side));
    let shown = names.map(Name::in_words);
    let all = context.scene.shapes.iter().map(|(name, _)| name.value.as_str());
    let all: Vec<&str> = all.chain(shown.iter().map(String::as_str)).collect();
    names.iter().filter_map(|name| Some((name.script(), name.brief(&all)?))).collect()
}

/// The ways to set the one line of a label on several, by what it is.
fn folds_of(label: &Label, line: &Line, style: Style) -> Vec<Fold> {
    match label.rank {
        _ if matches!(label.anchor, Anchor::Inside { .. }) => folds(line, style),
        Rank::Point => {
            let formulas = difference(line, style).into_iter().chain(chain(line, style));
            folds(line, style).into_iter().chain(formulas).collect()
        }
        Rank::Word => wordy(line, style).into_iter().chain(difference(line, style)).collect(),
        Rank::Measure => chain(line, style).into_iter().collect(),
        _ => Vec::new(),
    }
}

/// A value that a text at `at` names and this answer lacks.
pub(crate) fn no_value(value: String, context: &Context, at: &Range<usize>) -> Problem {
    Problem::new(Fault::NoValue { value, why: lacking(&context.run().answer) }, at.clone())
}

/// What is wrong with the roles that words of a text at `at` wear, if anything is.
pub(crate) fn bad_role(markup: &str, at: &Range<usize>) -> Option<Problem> {
    let got = unknown(markup)?.to_owned();
    let fault = scene::Fault::UnknownWord { what: "role", got, known: role_words() };
    Some(Problem::new(fault.into(), at.clone()))
}

/// A text that can't be typeset: `markup` is the text with its values filled in.
pub(crate) fn bad_markup(error: TypesetError, markup: String, at: &Range<usize>) -> Problem {
    Problem::new(Fault::BadMarkup { markup, reason: error.message }, at.clone())
}
