//! Charts: series of points on linear or logarithmic axes, in the look of the figures.
//!
//! A series is told apart by its colour, its marker and its dash, and is named beside its last point; names
//! that would collide are pushed apart.

mod axis;
mod marks;

pub(crate) use axis::Axis;
pub(crate) use marks::Marker;

use crate::drawing::{Color, Contour, Drawing, Group, Item, Paint, Path, Point, Rect, Role, Stroke, Text};
use crate::typeset::{Style, TypesetError, typeset};

/// Type size of the words of a chart, page pixels an em.
const WORDS: f64 = 14.0;
/// Space around the page, page pixels.
const MARGIN: f64 = 24.0;
/// Room left of the plot for tick labels and the axis's name, page pixels.
const LEFT: f64 = 84.0;
/// Room below the plot for tick labels and the axis's name, page pixels.
const BELOW: f64 = 60.0;
/// Room above the plot for the title, page pixels.
const ABOVE: f64 = 72.0;
/// Distance of the names of two series, page pixels.
const NAME_PITCH: f64 = 18.0;

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
    /// Width of the page, page pixels.
    pub(crate) width: f64,
    /// Height of the page, page pixels.
    pub(crate) height: f64,
}

/// Draws a chart with the colours that `color` gives to roles.
///
/// # Errors
///
/// A [`TypesetError`] of the title, an axis's name or a series's name.
pub(crate) fn draw(chart: &Chart, color: &dyn Fn(Role) -> Color) -> Result<Drawing, TypesetError> {
    let names: Vec<Name> = chart.series.iter().map(Name::set).collect::<Result<_, _>>()?;
    let widest = names.iter().map(|n| n.line.width).fold(0.0, f64::max);
    let plot =
        Rect { x0: LEFT, y0: ABOVE, x1: chart.width - MARGIN - widest - 24.0, y1: chart.height - BELOW };
    let mut artist = Artist { plot, color, chart, items: Vec::new() };
    artist.words(&chart.title, Style::semibold(WORDS), Role::Ink, |_| Point::new(MARGIN, 30.0))?;
    artist.axes()?;
    artist.series();
    artist.names(&names);
    Ok(Drawing {
        width: chart.width,
        height: chart.height,
        id: chart.id.clone(),
        title: chart.title.clone(),
        desc: describe(chart),
        background: Paint::role(Role::Background, color(Role::Background)),
        fill_opacity: 1.0,
        dark: None,
        metadata: String::new(),
        hash: String::new(),
        items: artist.items,
    })
}

/// The chart in words.
fn describe(chart: &Chart) -> String {
    let names: Vec<&str> = chart.series.iter().map(|s| s.name.as_str()).collect();
    format!("{} over {} for {}.", chart.y.name, chart.x.name, names.join(", "))
}

/// A series's name, set.
struct Name {
    /// The name, set.
    line: std::sync::Arc<crate::typeset::Line>,
}

impl Name {
    /// Sets the name of a series.
    fn set(series: &Series) -> Result<Self, TypesetError> {
        Ok(Self { line: std::sync::Arc::new(typeset(&series.name, Style::regular(WORDS))?) })
    }
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
        place: impl Fn(&crate::typeset::Line) -> Point,
    ) -> Result<(), TypesetError> {
        let line = typeset(markup, style)?;
        let origin = place(&line);
        let paint = self.paint(role);
        self.items.push(Item::Text(Text { line: std::sync::Arc::new(line), origin, paint, halo: None }));
        Ok(())
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
            self.line(Point::new(x, plot.y0), Point::new(x, plot.y1), Role::Grid, 0.75);
            self.words(&tick.label, Style::regular(12.0), Role::Muted, |l| {
                Point::new(x - l.width / 2.0, plot.y1 + 18.0)
            })?;
        }
        for tick in self.chart.y.ticks() {
            let y = self.at((self.chart.x.lo, tick.value)).y;
            self.line(Point::new(plot.x0, y), Point::new(plot.x1, y), Role::Grid, 0.75);
            self.words(&tick.label, Style::regular(12.0), Role::Muted, |l| {
                Point::new(plot.x0 - 10.0 - l.width, y + 4.0)
            })?;
        }
        self.line(Point::new(plot.x0, plot.y1), Point::new(plot.x1, plot.y1), Role::Ink, 1.0);
        self.line(Point::new(plot.x0, plot.y0), Point::new(plot.x0, plot.y1), Role::Ink, 1.0);
        let (x, y) = (self.chart.x.name.clone(), self.chart.y.name.clone());
        self.words(&x, Style::regular(WORDS), Role::Ink, |l| {
            Point::new((plot.x0 + plot.x1 - l.width) / 2.0, plot.y1 + 44.0)
        })?;
        self.words(&y, Style::regular(WORDS), Role::Ink, |_| Point::new(MARGIN, plot.y0 - 14.0))
    }

    /// Draws every series.
    fn series(&mut self) {
        for series in &self.chart.series {
            let points: Vec<Point> = series.points.iter().map(|&p| self.at(p)).collect();
            let paint = self.paint(series.role);
            let mut group = Group::new("series");
            group.role = Some(series.role);
            group.label = Some(series.name.clone());
            let stroke = Stroke { dash: series.dash.clone(), ..Stroke::solid(paint, 1.75) };
            group.items.push(Item::Path(Path::stroked(Contour::polyline(&points), stroke)));
            let background = self.paint(Role::Background);
            for &point in &points {
                group.items.push(Item::Path(series.marker.path(point, paint, background)));
            }
            self.items.push(Item::Group(group));
        }
    }

    /// Writes each name right of its series's last point, pushed down where it would meet the one above.
    fn names(&mut self, names: &[Name]) {
        let x = self.plot.x1 + 20.0;
        let mut wanted: Vec<(f64, usize)> = self
            .chart
            .series
            .iter()
            .enumerate()
            .filter_map(|(i, s)| s.points.last().map(|&p| (self.at(p).y, i)))
            .collect();
        wanted.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut free_from = self.plot.y0;
        let mut placed = Vec::new();
        for (y, index) in wanted {
            let y = y.max(free_from);
            free_from = y + NAME_PITCH;
            placed.push((y, index));
        }
        let over = (free_from - NAME_PITCH - self.plot.y1).max(0.0);
        for (y, index) in placed {
            let y = y - over;
            let series = &self.chart.series[index];
            let end = series.points.last().map_or(Point::new(x, y), |&p| self.at(p));
            let ink = self.paint(Role::Ink);
            let leader = Stroke { dash: vec![2.0, 3.0], ..Stroke::solid(self.paint(Role::Muted), 0.75) };
            let from = Point::new(end.x + 7.0, end.y);
            let path = Path::stroked(Contour::line(from, Point::new(x - 4.0, y)), leader);
            self.items.push(Item::Path(path));
            let origin = Point::new(x, y + 4.5);
            self.items.push(Item::Text(Text {
                line: names[index].line.clone(),
                origin,
                paint: ink,
                halo: None,
            }));
        }
    }
}
