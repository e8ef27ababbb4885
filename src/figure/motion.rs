//! A figure that plays: its panels at moments from the start of the motion on, then the figure itself.
//!
//! Which panels play is one rule ([`Played`]). All others stand still, as does all that is said of the
//! figure.
//!
//! Labels rest where they stand in the finished figure, from picture to picture, beginning with the one that
//! is like it.

use crate::drawing::{Drawing, MotionFrame};
use crate::scene::{Scene, Spanned};

use super::clock::{self, Clock};
use super::draw::{Figure, draw, draw_after};
use super::fault::{Fault, Problem};
use super::frame::{Frame, union};
use super::kept::Kept;
use super::label_keys::called;
use super::limits::{MAX_POINTS, within};
use super::plan::{Plan, panels_of, say};
use super::play::Play;
use super::played::Played;
use super::runs::Runs;
use super::sketch::Sketched;
use super::text::{Across, Decimal};
use super::theme::Theme;
use super::view;

/// Points of all lines of all pictures of a figure that plays, at most: 40 pictures of the largest figure
/// that is drawn would be 10 million, and take 3 GB.
const MOST_POINTS: usize = 8 * MAX_POINTS;
/// Moments at which a panel without a `view` is looked at, so that it has room for what plays there.
const LOOKS: usize = 8;

/// How a value begins that tells the moment.
const MOMENT: &str = "{=moment";

/// The plan of a figure on its way, at `time`, with what its layers draw; what does not play, and the page,
/// is as in the figure.
fn at<'s>(still: &Plan<'s>, played: &Played, time: f64) -> Result<(Plan<'s>, Vec<Sketched>), Vec<Problem>> {
    let (scene, theme, layout) = (still.scene, still.theme, still.layout);
    let runs = Runs::of(scene, called(scene));
    let (mut problems, mut notes) = (Vec::new(), Vec::new());
    let (moments, told) = (played.moments(still.panels.len(), time), (&mut problems, &mut notes));
    let (_, mut panels) = panels_of(scene, &runs, &layout.measures, &moments, told);
    if !problems.is_empty() {
        return Err(problems);
    }
    for ((panel, before), own) in panels.iter_mut().zip(&still.panels).zip(&moments) {
        panel.play = if own.is_none() { Play::Stands(time) } else { Play::Moves };
        panel.frame = Frame { pose: view::pose(scene, panel), ..before.frame };
    }
    let sketched = view::sketch(scene, &runs, theme, &panels).map_err(one)?;
    let in_look = (scene, theme, &layout.measures);
    say(in_look, &runs, &panels, &sketched, (&mut problems, &mut notes)).map_err(one)?;
    if let Some(problem) = runs.overflow(scene) {
        return Err(one(problem));
    }
    let plan = Plan {
        scene,
        theme,
        runs,
        panels,
        headline: still.headline.clone(),
        alt: still.alt.clone(),
        title: still.title.clone(),
        caption: told_by(time, still, played),
        layout,
        page: still.page.clone(),
        warnings: Vec::new(),
        kept: Kept::default(),
    };
    if problems.is_empty() { Ok((plan, sketched)) } else { Err(problems) }
}

/// The caption of a figure on its way: the answer is told where it is seen.
fn told_by(time: f64, still: &Plan, played: &Played) -> Across {
    let is_there = |caption: &&Across| !caption.is_answer || played.tells_answer(still, time);
    Some(&still.caption).filter(is_there).cloned().unwrap_or_default()
}

/// A problem of the scene as a list.
fn one(problem: crate::scene::Problem) -> Vec<Problem> {
    vec![problem.into()]
}

/// Draws a figure with the pictures that lead to it: `count` of them from the start of its motion on, in
/// [`Drawing::motion`]. Where nothing moves there are none, and [`Figure::warnings`] says so.
///
/// # Errors
/// Where the pictures together draw more than a figure that plays may.
///
/// ```
/// use tracefig::{figure::{draw, draw_in_motion, plan}, scene::{Source, read}};
/// let text = r#"
/// shapes.A = { kind = "circle", radius = 1, velocity = [4, 0] }
/// shapes.B = { kind = "circle", radius = 1, position = [4, 0] }
/// query = { kind = "linear-sweep", of = ["A", "B"] }
/// panels = [{ time = "hit", view = [-2, -2, 6, 2], layers = ["shapes", "contact"] }]
/// "#;
/// let scene = read(&Source::new("circles.toml", text)).unwrap();
/// let plan = plan(&scene).unwrap();
/// let figure = draw_in_motion(&plan, plan.theme, "circles", 12).unwrap();
/// // The last picture on the way is the figure itself.
/// assert_eq!(figure.drawing.motion.len(), 11);
/// assert_eq!(figure.drawing.items, draw(&plan, plan.theme, "circles").drawing.items);
/// ```
pub fn draw_in_motion(plan: &Plan, theme: &Theme, id: &str, count: usize) -> Result<Figure, Vec<Problem>> {
    let mut finished = draw(plan, theme, id);
    let played = match Played::of(plan) {
        Ok(played) => played,
        Err(why) => {
            let span = plan.scene.query.span.clone();
            finished.warnings.push(Problem::new(Fault::NothingPlays { why }, span));
            return Ok(finished);
        }
    };
    finished.warnings.extend(still_texts(plan.scene));
    let (end, is_shown) = (played.end(), played.is_shown(plan));
    let parts = u32::try_from(count.max(2) - 1).unwrap_or(u32::MAX);
    let time = |k: u32| end * (f64::from(k) / f64::from(parts));
    // Labels are taken from the moment that the figure shows, so the way is drawn from there.
    let on_the_way: Vec<u32> = if is_shown { (0..parts).rev().collect() } else { (0..=parts).collect() };
    let decimal = Decimal::of(plan.scene);
    let (mut way, mut points) = (Vec::<OnTheWay>::new(), 0_usize);
    for k in on_the_way {
        let (plan, sketched) = at(plan, &played, time(k))?;
        points = sketched.iter().fold(points, |all, sketched| all.saturating_add(sketched.points));
        let span = &plan.scene.query.span;
        within("the lines of all pictures", "points", points, MOST_POINTS, span).map_err(one)?;
        let before = way.last().map_or(&finished, |before| &before.figure);
        let figure = draw_after(&plan, theme, id, Some(before));
        let size = plan.layout.measures.caption_size();
        let clock = |&(i, _): &(usize, _)| Clock::of([plan.panels[i].moment.time, end], size, decimal);
        let clocks = played.0.iter().map(clock).collect();
        way.push(OnTheWay { figure, clocks, rests: k == parts });
    }
    if is_shown {
        way.reverse();
    }
    let frames = with_clocks(way, &finished.drawing, &played, theme);
    finished.drawing.motion = frames;
    Ok(finished)
}

/// Notes on the texts of a figure that tell a moment: they are those of the finished picture in each.
fn still_texts(scene: &Scene) -> impl Iterator<Item = Problem> + '_ {
    let all = [("headline", &scene.headline), ("caption", &scene.caption)];
    let told = |text: &Spanned<String>| text.value.contains(MOMENT);
    all.into_iter().filter_map(move |(what, text)| {
        let text = text.as_ref().filter(|text| told(text))?;
        Some(Problem::new(Fault::StillText { what }, text.span.clone()))
    })
}

/// A picture on the way.
struct OnTheWay {
    /// What is drawn at its moment.
    figure: Figure,
    /// The times of the panels that play, in their order.
    clocks: Vec<Option<Clock>>,
    /// Whether it stays for a while.
    rests: bool,
}

/// The pictures as drawings, in the words of the finished figure, with the time in the panels that play.
fn with_clocks(way: Vec<OnTheWay>, finished: &Drawing, played: &Played, theme: &Theme) -> Vec<MotionFrame> {
    let corners: Vec<(bool, bool)> = (played.0.iter().enumerate())
        .map(|(k, &(i, _))| {
            clock::corner(
                &way.iter()
                    .filter_map(|on| {
                        Some((&on.figure.panels[i], &on.figure.insets[..], on.clocks[k].as_ref()?))
                    })
                    .collect::<Vec<_>>(),
            )
        })
        .collect();
    let drawn = |OnTheWay { figure, clocks, rests }: OnTheWay| {
        let mut items = figure.drawing.finished().items;
        for ((&(i, _), clock), &corner) in played.0.iter().zip(&clocks).zip(&corners) {
            let panel = &figure.panels[i].frame.panel;
            items.extend(clock.iter().flat_map(|clock| clock.drawn(panel, corner, theme)));
        }
        MotionFrame { drawing: Drawing { items, motion: Vec::new(), ..finished.clone() }, rests }
    };
    way.into_iter().map(drawn).collect()
}

impl Plan<'_> {
    /// Makes room on the page for what plays: a panel without a `view` shows the whole way. Where
    /// the figure shows it anyway, or has a `view`, nothing changes.
    ///
    /// # Errors
    /// Where the panels draw more than a figure may show.
    ///
    /// ```
    /// use tracefig::{figure::{Plan, draw, plan}, geometry::DVec2, scene::{Source, read}};
    /// let text = r#"
    /// shapes.A = { kind = "circle", radius = 1, velocity = [40, 0] }
    /// shapes.B = { kind = "circle", radius = 1, position = [40, 0] }
    /// query = { kind = "linear-sweep", of = ["A", "B"] }
    /// panels = [{ time = "hit", layers = ["shapes"] }]
    /// "#;
    /// let scene = read(&Source::new("circles.toml", text)).unwrap();
    /// let shows_start = |plan: Plan| {
    ///     let frame = draw(&plan, plan.theme, "f").panels[0].frame;
    ///     frame.page(DVec2::ZERO).x > frame.panel.x0
    /// };
    /// assert!(!shows_start(plan(&scene).unwrap()));
    /// assert!(shows_start(plan(&scene).unwrap().with_room_to_move().unwrap()));
    /// ```
    pub fn with_room_to_move(mut self) -> Result<Self, Vec<Problem>> {
        let Ok(played) = Played::of(&self) else { return Ok(self) };
        if played.0.iter().all(|&(i, _)| self.panels[i].source.view.is_some()) {
            return Ok(self);
        }
        let mut all = vec![None; self.panels.len()];
        let parts = u32::try_from(LOOKS).unwrap_or(u32::MAX);
        for k in 0..=parts {
            let time = played.end() * (f64::from(k) / f64::from(parts));
            let (_, sketched) = at(&self, &played, time)?;
            for (all, sketched) in all.iter_mut().zip(sketched) {
                *all = union(*all, sketched.extent);
            }
        }
        for &(i, _) in &played.0 {
            self.panels[i].reach = all[i];
        }
        let (_, page) =
            view::fit(self.scene, &self.runs, self.theme, &self.layout, &mut self.panels).map_err(one)?;
        self.page = page;
        Ok(self)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::drawing::Item;
    use crate::figure::plan;
    use crate::geometry::DVec2;
    use crate::scene::open_text;

    /// Two discs, of which the first one meets the other at t = 0.5, in panels; `more` is said of the query.
    fn discs(more: &str, panels: &str) -> String {
        format!(
            "shapes.A = {{ kind = 'circle', radius = 1, velocity = [8, 0] }}
            shapes.B = {{ kind = 'circle', radius = 1, position = [6, 0] }}
            query = {{ of = ['A', 'B'], {more} }}
            canvas = {{ width = 600 }}
            panels = [{panels}]"
        )
    }

    const SWEEP: &str = "kind = 'linear-sweep'";

    /// The figure of a scene with its pictures, and the moment that each panel of each of them shows.
    fn played(text: &str, count: usize) -> (Figure, Vec<Vec<f64>>) {
        let scene = open_text("s", text).unwrap().scene;
        let still = plan(&scene).unwrap().with_room_to_move().unwrap();
        let figure = draw_in_motion(&still, still.theme, "f", count).unwrap();
        let Ok(played) = Played::of(&still) else { return (figure, Vec::new()) };
        let step = u32::try_from(count - 1).unwrap();
        let time = |k: usize| played.end() * f64::from(u32::try_from(k).unwrap()) / f64::from(step);
        let rounded = |time: f64| (1000.0 * time).round() / 1000.0;
        let moments = |(plan, _): (Plan, _)| plan.panels.iter().map(|p| rounded(p.moment.time)).collect();
        let all = (0..figure.drawing.motion.len()).map(|k| moments(at(&still, &played, time(k)).unwrap()));
        (figure, all.collect())
    }

    fn panel(drawing: &Drawing, number: usize) -> &Item {
        let name = format!("panel-{number}");
        drawing.items.iter().find(|item| matches!(item, Item::Group(group) if group.name == name)).unwrap()
    }

    #[test]
    fn a_ghost_is_drawn_until_its_body_has_come_there() {
        let panel = "{ time = 'hit', layers = ['shapes', { layer = 'ghosts', at = 'start' }] }";
        let (figure, _) = played(&discs(SWEEP, panel), 400);
        let has_ghost = |frame: &MotionFrame| format!("{:?}", frame.drawing.items).contains("ghost-A");
        let without = figure.drawing.motion.iter().filter(|frame| !has_ghost(frame)).count();
        assert_eq!(without, 1, "that of the start");
    }

    #[test]
    fn panels_of_a_moment_of_the_answer_play_up_to_it_and_the_others_stand() {
        let panels = "{ time = 'start', layers = ['shapes'] }, { time = 'hit', layers = ['shapes'] },
            { time = 0.25, layers = ['shapes'] }, { layers = ['shapes'] }";
        let (figure, moments) = played(&discs(SWEEP, panels), 3);
        assert_eq!(moments, [[0.0, 0.0, 0.25, 0.0], [0.0, 0.25, 0.25, 0.0]]);
        let frames = &figure.drawing.motion;
        assert!(frames.iter().all(|frame| !frame.rests));
        for number in [1, 3, 4] {
            assert_eq!(panel(&frames[0].drawing, number), panel(&figure.drawing, number));
        }
        assert!(panel(&frames[0].drawing, 2) != panel(&figure.drawing, 2));
    }

    #[test]
    fn without_such_panels_those_play_that_say_none_and_else_the_first_of_the_world() {
        let two = "{ layers = ['shapes'] }, { time = 'start', layers = ['shapes'] }";
        let (figure, moments) = played(&discs(SWEEP, two), 3);
        assert_eq!(moments, [[0.0, 0.0], [0.25, 0.0], [0.5, 0.0]]);
        // The bodies have arrived, and the figure shows the start.
        let rests: Vec<bool> = figure.drawing.motion.iter().map(|frame| frame.rests).collect();
        assert_eq!(rests, [false, false, true]);
        let pinned = "{ space = 'configuration', time = 'start', layers = ['ray'] },
            { time = 'start', layers = ['shapes'] }, { time = 'start', layers = ['shapes'] }";
        let (figure, moments) = played(&discs(SWEEP, pinned), 2);
        assert_eq!(moments, [[0.0, 0.0, 0.0], [0.0, 0.5, 0.0]]);
        // A dot goes along the ray, from the origin to the place of the hit.
        let [first, last] = [0, 1].map(|k| format!("{:?}", panel(&figure.drawing.motion[k].drawing, 1)));
        assert!(first != last && first.contains("\"now\""));
        assert!(!format!("{:?}", figure.drawing.items).contains("\"now\""));
    }

    #[test]
    fn a_question_of_a_moment_plays_up_to_it_and_a_miss_to_the_closest_approach() {
        let moments = |more: &str| {
            let (_, moments) = played(&discs(more, "{ layers = ['shapes'] }"), 2);
            moments.concat()
        };
        // The figure is the picture at the end.
        assert_eq!(moments("kind = 'separation', time = 0.25"), [0.0]);
        assert_eq!(moments("kind = 'separation'"), [0.0, 1.0]);
        let miss = discs(SWEEP, "{ layers = ['shapes'] }").replace("position = [6, 0]", "position = [4, 3]");
        assert_eq!(played(&miss, 2).1.concat(), [0.0, 0.5]);
    }

    #[test]
    fn what_does_not_play_is_drawn_with_the_reason() {
        let told = |text: &str| {
            let (figure, _) = played(text, 5);
            assert_eq!(figure.drawing.motion, []);
            figure.warnings.iter().map(|problem| problem.fault.to_string()).collect::<Vec<_>>()
        };
        let moving = discs(SWEEP, "{ time = 0.25, layers = ['shapes'] }");
        assert!(told(&moving)[0].starts_with("nothing plays: each panel is pinned"));
        let still = discs("kind = 'separation'", "{ layers = ['shapes'] }");
        let still = still.replace(", velocity = [8, 0]", "");
        assert_eq!(told(&still), ["nothing plays: no body moves that the question is about"]);
    }

    #[test]
    fn a_panel_without_a_view_has_room_for_the_whole_way_and_one_with_room_stays_as_it_is() {
        let text = discs(SWEEP, "{ time = 'hit', layers = ['shapes'] }");
        let scene = open_text("s", &text).unwrap().scene;
        let still = plan(&scene).unwrap();
        let begin = |plan: &Plan| {
            let frame = plan.panels[0].frame;
            frame.page(DVec2::new(-1.0, 0.0)).x - frame.panel.x0
        };
        assert!(begin(&still) < 0.0, "the disc begins outside of the figure's own view");
        assert!(begin(&plan(&scene).unwrap().with_room_to_move().unwrap()) > 0.0);
        let ghosts =
            discs(SWEEP, "{ time = 'hit', layers = ['shapes', { layer = 'ghosts', at = 'start' }] }");
        let scene = open_text("s", &ghosts).unwrap().scene;
        let [before, after] = [plan(&scene).unwrap(), plan(&scene).unwrap().with_room_to_move().unwrap()];
        assert_eq!(before.panels[0].frame, after.panels[0].frame);
    }

    #[test]
    fn a_label_may_say_the_moment_of_each_picture() {
        let named = "{ time = 'hit', layers = [{ layer = 'shapes', text = 'at $t = {=moment}$' }] }";
        let (figure, _) = played(&discs(SWEEP, named), 3);
        let way = figure.drawing.motion.iter().map(|frame| &frame.drawing).chain([&figure.drawing]);
        let said: Vec<String> = way.map(|drawing| format!("{:?}", drawing.items)).collect();
        assert_eq!(said.len(), 3);
        for (said, moment) in said.iter().zip(["0", "0.25", "0.5"]) {
            assert!(said.contains(&format!("at $t = {moment}$")), "{moment}");
        }
    }

    #[test]
    fn labels_of_what_rests_rest() {
        let text = include_str!("../../figures/frames-continuous.toml");
        let (figure, _) = played(text, 20);
        let label = |drawing: &Drawing| {
            let Item::Group(group) = panel(drawing, 2) else { panic!("a panel is a group") };
            let text = format!("{:?}", group.items.last());
            let at = text.find("\"label-B\"").unwrap();
            text[at..].split("Group").next().unwrap().to_owned()
        };
        let all: Vec<String> = figure.drawing.pictures().into_iter().map(|(one, _)| label(one)).collect();
        let moved = all.windows(2).filter(|pair| pair[0] != pair[1]).count();
        // A comes near once.
        assert!(moved <= 1, "{moved}");
    }

    #[test]
    fn a_text_of_the_figure_that_tells_the_moment_is_said_to_stand_still() {
        let panels = "{ time = 'hit', view = [-2, -2, 8, 2], layers = ['shapes'] }";
        for (text, notes) in [("Now {=moment}.", 1), ("Apart by {=d}.", 0)] {
            let text = format!("headline = '{text}'\n{}", discs(SWEEP, panels));
            let (figure, _) = played(&text, 6);
            let said = |problem: &&Problem| matches!(problem.fault, Fault::StillText { what: "headline" });
            assert_eq!(figure.warnings.iter().filter(said).count(), notes, "{text}");
        }
    }
}
