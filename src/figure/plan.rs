//! What a scene asks to show, resolved: layers and their options, moments, texts, the page, the views.
//!
//! Everything that can be wrong with a figure is found here and said with its place in the scene, so that
//! drawing a plan cannot fail.

use crate::geometry::sort_by;
use crate::scene::{self, Scene, Variant};

use super::asked_theme::theme_of;
use super::budget::Budget;
use super::default_picture;
use super::describe::Account;
use super::exercise;
use super::fault::{Fault, Problem};
use super::kept::Kept;
use super::label_keys::{called, label_keys, replaced};
use super::language::Language;
use super::layer::{EXPECTED, is_key};
use super::lettering::Lettering;
use super::limits::{MAX_POINTS, areas_within, within};
use super::out_of_view::out_of_view;
use super::page::{Layout, Measures, Page};
use super::panel::PanelPlan;
use super::placement::Sought;
use super::resolve::Resolver;
use super::runs::Runs;
use super::sketch::{Size, Sketched};
use super::text::{Across, Block, Wording, across, caption_of_words, check_texts, spoken};
use super::theme::{self, Theme};
use super::unseen_layer::noted;
use super::unset_words::unset;
use super::whole::of_the_whole;
use super::{narrow, view};

/// How many problems are told at most: a scene with more is none.
const MAX_PROBLEMS: usize = 50;

/// A figure, ready to be drawn in any theme.
#[derive(Debug)]
pub struct Plan<'s> {
    /// The scene that the figure shows.
    pub scene: &'s Scene,
    /// The theme that the scene asks for, or the default.
    pub theme: &'s Theme,
    /// The algorithm runs that the figure needed so far.
    pub(crate) runs: Runs,
    /// The panels, in the order of the scene.
    pub(crate) panels: Vec<PanelPlan<'s>>,
    /// What the figure claims, above the panels.
    pub(crate) headline: Across,
    /// The short alternative text that the scene gives.
    pub(crate) alt: Option<String>,
    /// The title in plain words, its values filled in.
    pub(crate) title: Option<String>,
    /// What leads through the figure, below the panels.
    pub(crate) caption: Across,
    /// What the page holds.
    pub(crate) layout: Layout,
    /// Where things lie on the page.
    pub(crate) page: Page,
    /// What should be better, with its place in the scene.
    pub(crate) warnings: Vec<Problem>,
    /// What the layers drew in the theme, for the first drawing in it.
    pub(super) kept: Kept,
}

/// Resolves what a scene asks to show, in the theme of the house that it names.
///
/// # Errors
///
/// Everything that is wrong with its panels, layers, options, labels, texts and theme, in the order of the
/// scene. A theme file is not read here: [`plan_in`] takes its theme.
///
/// ```
/// use tracefig::{figure::{draw, plan}, scene::{Source, read}};
/// let text = r#"
/// [shapes.A]
/// kind = "circle"
/// radius = 1
/// [query]
/// kind = "bounds"
/// of = ["A"]
/// [[panels]]
/// space = "world"
/// layers = ["shapes", "bounds"]
/// "#;
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let figure = draw(&plan, plan.theme, "circle");
/// assert_eq!(figure.drawing.width, 960.0);
/// assert!(figure.faults().is_empty());
/// ```
pub fn plan(scene: &Scene) -> Result<Plan<'_>, Vec<scene::Problem<Fault>>> {
    let mut problems = Vec::new();
    let theme = theme_of(scene, &mut problems);
    checked(scene, theme, problems)
}

/// Resolves what a scene asks to show, in a theme of the caller's, whichever the scene names.
///
/// # Errors
///
/// Everything that is wrong with the scene's panels, layers, options, labels and texts, in its order; a
/// theme by a name that the house does not have is wrong here too.
///
/// ```
/// use tracefig::{figure::{draw, plan_in, theme}, scene::{Source, read}};
/// let text = "canvas.theme = 'brand.toml'\nshapes.A = { kind = 'circle', radius = 1 }\n\
///             query = { kind = 'bounds', of = ['A'] }\n[[panels]]\nlayers = ['shapes']";
/// let scene = read(&Source::new("circle.toml", text)).unwrap();
/// let brand = theme::parse("[colors]\nbackground = '#FFF8E7'").unwrap();
/// let plan = plan_in(&scene, &brand).unwrap();
/// assert_eq!(draw(&plan, plan.theme, "circle").drawing.background.color.to_string(), "#FFF8E7");
/// ```
pub fn plan_in<'s>(scene: &'s Scene, theme: &'s Theme) -> Result<Plan<'s>, Vec<scene::Problem<Fault>>> {
    let mut problems = Vec::new();
    if !scene.canvas.theme.as_ref().is_some_and(|asked| theme::is_file(&asked.value)) {
        theme_of(scene, &mut problems);
    }
    checked(scene, theme, problems)
}

/// Resolves what a scene asks to show where what a program has set of it is what a file could say; `problems`
/// are those of its theme.
fn checked<'s>(
    scene: &'s Scene,
    theme: &'s Theme,
    problems: Vec<Problem>,
) -> Result<Plan<'s>, Vec<scene::Problem<Fault>>> {
    // A page reads all of its scenes.
    let set = if cfg!(tracefig_page) { Vec::new() } else { scene::set::wrong(scene) };
    if set.is_empty() {
        return resolve(scene, theme, problems.into_iter().chain(unset(scene)).collect());
    }
    Err(problems.into_iter().chain(set.into_iter().map(Problem::from)).collect())
}

/// Resolves what a scene asks to show; `problems` are those of its theme.
fn resolve<'s>(
    scene: &'s Scene,
    theme: &'s Theme,
    mut problems: Vec<Problem>,
) -> Result<Plan<'s>, Vec<scene::Problem<Fault>>> {
    let (runs, mut warnings) = (Runs::of(scene, called(scene)), Vec::new());
    let measures = Measures::of(&scene.canvas, theme.text);
    let (all, mut panels) = panels_of(scene, &runs, &measures, &[], (&mut problems, &mut warnings));
    let first = of_the_whole(scene, &panels).map(|panel| panel.context(scene, &runs));
    let on_page = first.as_ref().map(|first| (first, &measures));
    let mut set =
        |block| on_page.map(|at| across(block, at, (&mut problems, &mut warnings))).unwrap_or_default();
    let (headline, mut caption) = (set(Block::Headline), set(Block::Caption));
    let mut said = |text: &Option<_>| {
        first.as_ref().and_then(|first| spoken(text.as_ref(), first, (&mut problems, &mut warnings)))
    };
    let (alt, title) = (said(&scene.alt), said(&scene.title));
    if let Some(ours) = exercise::caption(scene, &runs, &measures, &mut problems) {
        caption = ours;
    } else if scene.panels.is_empty() && scene.caption.is_none() && Language::of(scene).has_sentences() {
        let run = runs.own(scene, scene.query.time);
        let account = Account::of(scene, &runs, &run);
        let [words, markup] = account.caption(&runs.called);
        caption = caption_of_words(&measures, words, &markup);
    }
    let mut layout = Layout {
        measures,
        columns: scene.canvas.columns,
        titles: panels.iter().flat_map(|panel| &panel.title).map(Lettering::len).max().unwrap_or(0),
        head: headline.lines(),
        lines: caption.lines(),
    };
    let mut page = None;
    if all {
        // Layers whose runs are too many need not be drawn to be refused.
        let fitted = runs.overflow(scene).map_or(Ok(()), Err);
        let fitted = fitted.and_then(|()| fit((scene, &runs), theme, &mut layout, &mut panels));
        let said = fitted.and_then(|(sketched, fitted)| {
            warnings.extend(noted((scene, &runs, theme), &panels, &sketched, &warnings));
            let in_look = (scene, theme, &layout.measures);
            let said = say(in_look, &runs, &panels, &sketched, (&mut problems, &mut warnings));
            said.map(|sought| page = Some((fitted, Kept::of(sketched, sought))))
        });
        problems.extend(said.err().into_iter().chain(runs.overflow(scene)).map(Problem::from));
    }
    if let Some((page, kept)) = page.filter(|_| problems.is_empty()) {
        warnings.extend(replaced(scene, &runs.called).into_iter().chain(out_of_view(scene, &runs, &panels)));
        return Ok(Plan {
            scene,
            theme,
            runs,
            panels,
            headline,
            alt,
            title,
            caption,
            layout,
            page,
            warnings,
            kept,
        });
    }
    sort_by(&mut problems, |p, q| (p.span.start, p.span.end).cmp(&(q.span.start, q.span.end)));
    problems.dedup_by_key(|told| (told.span.clone(), told.fault.to_string()));
    problems.truncate(MAX_PROBLEMS);
    Err(problems)
}

/// Gives every panel its frame, in fewer columns where labels would not fit, and says what layers draw there.
fn fit(
    (scene, runs): (&Scene, &Runs),
    theme: &Theme,
    layout: &mut Layout,
    panels: &mut [PanelPlan],
) -> Result<(Vec<Sketched>, Page), scene::Problem> {
    let found = view::fit(scene, runs, theme, layout, panels)?;
    let Some(columns) = narrow::columns((scene, runs), layout, panels, &found) else { return Ok(found) };
    layout.columns = Some(columns);
    view::fit(scene, runs, theme, layout, panels)
}

/// Whether all panels of a scene can be, and those that can: one that can't be is left out and told. In
/// `moments` some of them may have another moment than the scene says.
pub(super) fn panels_of<'s>(
    scene: &'s Scene,
    runs: &Runs,
    measures: &Measures,
    moments: &[Option<f64>],
    (problems, warnings): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> (bool, Vec<PanelPlan<'s>>) {
    let mut sheets = default_picture::sheets(scene, runs, EXPECTED.name, problems);
    for (sheet, time) in sheets.iter_mut().zip(moments) {
        if let Some(time) = time {
            sheet.pin(*time);
        }
    }
    let count = sheets.len();
    let columns = sheets.iter().map(|sheet| sheet.panel.columns.unwrap_or(1)).collect();
    let mut resolver = Resolver::of(scene, runs, (measures, columns), std::mem::take(problems));
    let panels: Vec<PanelPlan> =
        sheets.into_iter().enumerate().filter_map(|(i, sheet)| resolver.panel(i, sheet)).collect();
    (*problems, *warnings) = (resolver.problems, resolver.notes);
    // The labels of a question are those of the figure, some of which it has no layer for.
    if scene.variant != Variant::Question {
        label_keys(scene, runs, &panels, problems);
    }
    (panels.len() == count, panels)
}

/// Sets the texts of all labels that the layers asked for, panel by panel, so that drawing the plan cannot
/// fail.
pub(super) fn say(
    (scene, theme, measures): (&Scene, &Theme, &Measures),
    runs: &Runs,
    panels: &[PanelPlan],
    sketched: &[Sketched],
    (problems, notes): (&mut Vec<Problem>, &mut Vec<Problem>),
) -> Result<Vec<Vec<Sought>>, scene::Problem> {
    let mut budget = Budget::default();
    let mut of_panel = |panel: &PanelPlan, sketched: &Sketched| {
        let context = panel.context(scene, runs);
        let type_size = |size: Size| measures.size(size.kind());
        let marked = !theme.counts_on_color();
        let wording = Wording { context: &context, type_size: &type_size, is_key, marked };
        if let Some((inset, enlarged)) = panel.asked_inset(sketched)? {
            let enlarged = panel.sketch_inset(&enlarged, sketched, (&context, theme));
            within("the lines of the inset", "points", enlarged.points, MAX_POINTS, inset)?;
            areas_within(enlarged.painted, inset)?;
            budget.take(&enlarged, inset)?;
            let requests = enlarged.requests.iter().map(|request| (request, panel.span_of(request)));
            check_texts(&wording, requests, &mut budget, (problems, &mut Vec::new()))?;
        }
        budget.take(sketched, &panel.source.span)?;
        let requests = sketched.requests.iter().map(|request| (request, panel.span_of(request)));
        check_texts(&wording, requests, &mut budget, (problems, notes))
    };
    panels.iter().zip(sketched).map(|(panel, sketched)| of_panel(panel, sketched)).collect()
}

#[cfg(test)]
mod tests {
    use super::Problem;
    use crate::scene::{Explain, Source, read};

    const BODIES: &str = r#"
        shapes.A = { kind = "circle", radius = 1, position = [-2, 0] }
        shapes.B = { kind = "box", half_extents = [1, 1], position = [2, 0] }
        query = { kind = "separation", of = ["A", "B"] }
    "#;

    /// What is wrong with a scene of a circle and a box, and the text that each problem points at.
    fn problems(rest: &str) -> Vec<(Problem, String)> {
        let text = format!("{BODIES}{rest}");
        let scene = read(&Source::new("test", &text)).unwrap();
        let found = super::plan(&scene).map(|_| ()).unwrap_err();
        found.into_iter().map(|p| (p.clone(), text[p.span.clone()].to_owned())).collect()
    }

    fn one(rest: &str) -> (&'static str, String, String) {
        let found = problems(rest);
        assert_eq!(found.len(), 1, "{found:#?}");
        let (problem, quoted) = found.into_iter().next().unwrap();
        (problem.fault.code(), quoted, problem.fault.help().unwrap_or_default())
    }

    #[test]
    fn what_a_program_has_set_is_checked_before_anything_is_resolved() {
        let mut scene = read(&Source::new("test", BODIES)).unwrap();
        scene.canvas.columns = Some(0);
        assert_eq!(super::plan(&scene).map(|_| ()).unwrap_err()[0].fault.code(), "out-of-range");
    }

    #[test]
    fn an_unknown_layer_is_quoted_and_the_nearest_one_named() {
        let (code, quoted, help) =
            one(r#"panels = [{ space = "world", layers = ["shapes", "seperation"] }]"#);
        assert_eq!((code, quoted.as_str()), ("unknown-word", "\"seperation\""));
        assert!(help.contains("`separation`"), "{help}");
    }

    #[test]
    fn an_unknown_option_is_quoted_and_the_nearest_one_named() {
        let (code, quoted, help) =
            one(r#"panels = [{ space = "world", layers = [{ layer = "shapes", centres = true }] }]"#);
        assert_eq!((code, quoted.as_str()), ("unknown-key", "centres"));
        assert!(help.contains("`centers`"), "{help}");
    }

    #[test]
    fn an_option_of_another_type_says_what_was_expected() {
        let found =
            problems(r#"panels = [{ space = "world", layers = [{ layer = "shapes", centers = 3 }] }]"#);
        assert_eq!(found[0].0.fault.to_string(), "`centers`: expected true or false, got 3");
        assert_eq!(found[0].1, "3");
    }

    #[test]
    fn a_layer_of_another_space_or_without_its_events_is_refused() {
        let (code, quoted, _) = one(r#"panels = [{ space = "world", layers = ["difference"] }]"#);
        assert_eq!((code, quoted.as_str()), ("unsuited-layer", "\"difference\""));
        let (code, quoted, help) = one(r#"panels = [{ space = "world", layers = ["bounds"] }]"#);
        assert_eq!((code, quoted.as_str()), ("unfed-layer", "\"bounds\""));
        assert!(help.starts_with("it needs"), "{help}");
    }

    #[test]
    fn a_label_that_no_layer_writes_is_refused() {
        let (code, quoted, _) =
            one("labels = { A1 = \"x\" }\npanels = [{ space = \"world\", layers = [\"shapes\"] }]");
        assert_eq!((code, quoted.as_str()), ("unknown-key", "A1"));
    }

    #[test]
    fn a_label_is_found_by_the_name_of_its_body_and_only_once() {
        let bodies = BODIES.replace("shapes.B", "shapes.wall").replace("\"B\"", "\"wall\"");
        let problems = |labels: &str| {
            let text = format!("{bodies}{labels}\npanels = [{{ space = \"world\", layers = [\"shapes\"] }}]");
            let scene = read(&Source::new("test", &text)).unwrap();
            super::plan(&scene).map(|_| ()).err().unwrap_or_default()
        };
        assert_eq!(problems("labels = { wall = \"x\" }"), []);
        let twice = problems("labels = { B = \"y\", wall = \"x\" }");
        assert_eq!(twice[0].fault.to_string(), "`B` and `wall` are the same label");
        let help = problems("labels = { wal = \"x\" }")[0].fault.help().unwrap_or_default();
        assert!(help.contains("`wall`"), "{help}");
    }

    #[test]
    fn texts_that_cannot_be_set_are_quoted_wherever_they_stand() {
        let rest = r#"
            caption = '{=tiem}'
            labels = { A = '$\frac{1}$' }
            panels = [{ space = "world", layers = ["shapes"], title = '$x' }]
        "#;
        let codes: Vec<_> = problems(rest).iter().map(|(p, q)| (p.fault.code(), q.clone())).collect();
        assert_eq!(
            codes,
            [
                ("unknown-word", "{=tiem}".to_owned()),
                ("bad-markup", r"'$\frac{1}$'".to_owned()),
                ("bad-markup", "'$x'".to_owned()),
            ]
        );
    }

    #[test]
    fn a_theme_that_does_not_exist_is_told_and_so_are_layers_for_which_no_picture_is_there() {
        let found = problems("canvas.theme = \"drak\"\npanels = [{ space = \"configuration\" }]");
        let codes: Vec<_> = found.iter().map(|(p, _)| p.fault.code()).collect();
        assert_eq!(codes, ["unknown-word"]);
        let text = BODIES.replace("separation", "bounds").replace("[\"A\", \"B\"]", "[\"A\"]")
            + "panels = [{ space = \"configuration\" }]";
        let scene = read(&Source::new("test", &text)).unwrap();
        let found = super::plan(&scene).map(|_| ()).unwrap_err();
        assert_eq!(found[0].fault.code(), "missing-key");
    }
}
