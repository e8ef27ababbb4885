//! Charts: series of points on logarithmic axes, in the look of the figures.
//!
//! A series is told apart by its colour, its marker and its dash, and is named beside its last point; names
//! that would collide are pushed apart.

mod axis;
mod marks;

use std::sync::Arc;

pub(crate) use axis::Axis;
pub(crate) use marks::Marker;

use crate::drawing::{
    Color, Contour, Drawing, Group, Item, Paint, Path, Point, Rect, Role, Shown, Stroke, Text,
};
use crate::typeset::{Line, Style, TypesetError, typeset};

/// Width and height of the page, page pixels: those of a figure.
const PAGE: (f64, f64) = (960.0, 540.0);
/// Type size of the words of a chart, page pixels an em.
const WORDS: f64 = 14.0;
/// Type size of what ticks are called, page pixels an em.
const TICK_WORDS: f64 = 12.0;
/// Space around the page, page pixels.
const MARGIN: f64 = 24.0;
/// Room left of the plot for tick labels and the axis's name, page pixels.
const LEFT: f64 = 84.0;
/// Room below the plot for tick labels and the axis's name, page pixels.
const BELOW: f64 = 60.0;
/// Room above the plot for the title, page pixels.
const ABOVE: f64 = 72.0;
/// Baseline of the title below the page's top, page pixels.
const TITLE: f64 = 30.0;
/// Baseline of tick labels and of the axis's name below the plot, page pixels.
const UNDER: [f64; 2] = [18.0, 44.0];
/// Distance of tick labels left of the plot, and of the axis's name above it, page pixels.
const BESIDE: [f64; 2] = [10.0, 14.0];
/// Baseline of a name below the middle of its letters, page pixels.
const MIDDLE: f64 = 4.5;
/// Distance of the names of two series, page pixels.
const NAME_PITCH: f64 = 18.0;
/// Distance of a series's name from the plot, page pixels; its leader begins beside the last point and ends
/// short of the name.
const NAME_GAP: f64 = 20.0;
/// Where a leader begins right of a point, and how far left of the name it ends, page pixels.
const LEADER: [f64; 2] = [7.0, 4.0];
/// Width of the lines of series, the axes, and the grid and leaders, page pixels.
const LINES: [f64; 3] = [1.75, 1.0, 0.75];

/// A named set of points, joined in order.
#[derive(Clone, Debug)]
pub(crate) struct Series {
    /// The name, markup.
    pub(crate) name: String,
    /// The colour of line and points.
    pub(crate) role: Role,
    /// The shape of its points.
    pub(crate) marker: Marker,
    /// Lengths of dashes and gaps, page pixels; empty for a solid line.
    pub(crate) dash: Vec<f64>,
    /// The points, in the axes' units.
    pub(crate) points: Vec<(f64, f64)>,
}

/// A chart.
#[derive(Clone, Debug)]
pub(crate) struct Chart {
    /// The prefix of ids in an SVG.
    pub(crate) id: String,
    /// The title, markup.
    pub(crate) title: String,
    /// The horizontal axis.
    pub(crate) x: Axis,
    /// The vertical axis.
    pub(crate) y: Axis,
    /// The series, each named beside its last point.
    pub(crate) series: Vec<Series>,
}

/// Draws a chart with the colours that `color` gives to roles.
///
/// # Errors
///
/// A [`TypesetError`] of the title, an axis's name or a series's name.
pub(crate) fn draw(chart: &Chart, color: &dyn Fn(Role) -> Color) -> Result<Drawing, TypesetError> {
    let set = |series: &Series| typeset(&series.name, Style::regular(WORDS));
    let names: Vec<Line> = chart.series.iter().map(set).collect::<Result<_, _>>()?;
    let widest = names.iter().map(|name| name.width).fold(0.0, f64::max);
    let (width, height) = PAGE;
    let plot = Rect { x0: LEFT, y0: ABOVE, x1: width - MARGIN - widest - MARGIN, y1: height - BELOW };
    let mut artist = Artist { plot, color, chart, items: Vec::new() };
    artist.words(&chart.title, Style::semibold(WORDS), Role::Ink, |_| Point::new(MARGIN, TITLE))?;
    artist.axes()?;
    artist.series();
    artist.names(names);
    Ok(Drawing {
        width,
        height,
        id: chart.id.clone(),
        lang: None,
        title: chart.title.clone(),
        is_titled: false,
        heading: None,
        desc: describe(chart),
        background: Paint::role(Role::Background, color(Role::Background)),
        ink: color(Role::Ink),
        words: Vec::new(),
        fill_opacity: 1.0,
        dark: None,
        metadata: String::new(),
        hash: String::new(),
        items: artist.items,
        steps: Vec::new(),
        motion: Vec::new(),
        narrow: None,
    })
}

/// The chart in words.
fn describe(chart: &Chart) -> String {
    let names: Vec<&str> = chart.series.iter().map(|s| s.name.as_str()).collect();
    format!("{} over {} for {}.", chart.y.name, chart.x.name, names.join(", "))
}

/// A chart being drawn.
struct Artist<'a> {
    /// The rectangle between the axes, page pixels.
    plot: Rect,
    /// The colour of each role.
    color: &'a dyn Fn(Role) -> Color,
    /// What is drawn.
    chart: &'a Chart,
    /// What was drawn so far.
    items: Vec<Item>,
}

impl Artist<'_> {
    /// The opaque paint of a role.
    fn paint(&self, role: Role) -> Paint {
        Paint::role(role, (self.color)(role))
    }

    /// Draws a straight line; `width` in page pixels.
    fn line(&mut self, from: Point, to: Point, role: Role, width: f64) {
        let stroke = Stroke::solid(self.paint(role), width);
        self.items.push(Item::Path(Path::stroked(Contour::line(from, to), stroke)));
    }

    /// Draws words whose baseline starts where `place` says, given the set line.
    fn words(
        &mut self,
        markup: &str,
        style: Style,
        role: Role,
        place: impl Fn(&Line) -> Point,
    ) -> Result<(), TypesetError> {
        let line = typeset(markup, style)?;
        let origin = place(&line);
        self.write(line, origin, role);
        Ok(())
    }

    /// Writes a set line from the start of its baseline on.
    fn write(&mut self, line: Line, origin: Point, role: Role) {
        let paint = self.paint(role);
        self.items.push(Item::Text(Text {
            line: Arc::new(line),
            origin,
            paint,
            halo: None,
            shown: Shown::ALWAYS,
        }));
    }

    /// Where a point in the axes' units lies on the page.
    fn at(&self, (x, y): (f64, f64)) -> Point {
        let Rect { x0, y0, x1, y1 } = self.plot;
        let fx = self.chart.x.fraction(x);
        let fy = self.chart.y.fraction(y);
        Point::new(x0 + fx * (x1 - x0), y1 - fy * (y1 - y0))
    }

    /// Draws the axes with their grid, ticks and names.
    fn axes(&mut self) -> Result<(), TypesetError> {
        let plot = self.plot;
        for tick in self.chart.x.ticks() {
            let x = self.at((tick.value, self.chart.y.lo)).x;
            self.line(Point::new(x, plot.y0), Point::new(x, plot.y1), Role::Grid, LINES[2]);
            self.words(&tick.label, Style::regular(TICK_WORDS), Role::Muted, |l| {
                Point::new(x - l.width / 2.0, plot.y1 + UNDER[0])
            })?;
        }
        for tick in self.chart.y.ticks() {
            let y = self.at((self.chart.x.lo, tick.value)).y;
            self.line(Point::new(plot.x0, y), Point::new(plot.x1, y), Role::Grid, LINES[2]);
            self.words(&tick.label, Style::regular(TICK_WORDS), Role::Muted, |l| {
                Point::new(plot.x0 - BESIDE[0] - l.width, y + TICK_WORDS / 3.0)
            })?;
        }
        self.line(Point::new(plot.x0, plot.y1), Point::new(plot.x1, plot.y1), Role::Ink, LINES[1]);
        self.line(Point::new(plot.x0, plot.y0), Point::new(plot.x0, plot.y1), Role::Ink, LINES[1]);
        let (x, y) = (self.chart.x.name.clone(), self.chart.y.name.clone());
        self.words(&x, Style::regular(WORDS), Role::Ink, |l| {
            Point::new((plot.x0 + plot.x1 - l.width) / 2.0, plot.y1 + UNDER[1])
        })?;
        self.words(&y, Style::regular(WORDS), Role::Ink, |_| Point::new(MARGIN, plot.y0 - BESIDE[1]))
    }

    /// Draws every series.
    fn series(&mut self) {
        for series in &self.chart.series {
            let points: Vec<Point> = series.points.iter().map(|&p| self.at(p)).collect();
            let paint = self.paint(series.role);
            let mut group = Group::new("series");
            group.role = Some(series.role);
            group.label = Some(series.name.clone());
            let stroke = Stroke { dash: series.dash.clone(), ..Stroke::solid(paint, LINES[0]) };
            group.items.push(Item::Path(Path::stroked(Contour::polyline(&points), stroke)));
            let background = self.paint(Role::Background);
            for &point in &points {
                group.items.push(Item::Path(series.marker.path(point, paint, background)));
            }
            self.items.push(Item::Group(group));
        }
    }

    /// Writes each name right of its series's last point, pushed down where it would meet the one above.
    fn names(&mut self, names: Vec<Line>) {
        let x = self.plot.x1 + NAME_GAP;
        let last = |(series, name): (&Series, Line)| Some((self.at(*series.points.last()?), name));
        let mut ends: Vec<(Point, Line)> = self.chart.series.iter().zip(names).filter_map(last).collect();
        ends.sort_by(|(p, _), (q, _)| p.y.total_cmp(&q.y));
        let mut free_from = self.plot.y0;
        let mut places = Vec::new();
        for (end, _) in &ends {
            places.push(end.y.max(free_from));
            free_from = end.y.max(free_from) + NAME_PITCH;
        }
        let over = (free_from - NAME_PITCH - self.plot.y1).max(0.0);
        for ((end, name), y) in ends.into_iter().zip(places) {
            let y = y - over;
            let leader = Stroke { dash: vec![2.0, 3.0], ..Stroke::solid(self.paint(Role::Muted), LINES[2]) };
            let line = Contour::line(Point::new(end.x + LEADER[0], end.y), Point::new(x - LEADER[1], y));
            self.items.push(Item::Path(Path::stroked(line, leader)));
            self.write(name, Point::new(x, y + MIDDLE), Role::Ink);
        }
    }
}
