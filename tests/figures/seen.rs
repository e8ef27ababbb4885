//! Looks into a [`Drawing`] for things at places, after the panel's own world → page transform.
//!
//! The transform here is the storyboard's, written down a second time: one scale for both axes, as large as the
//! panel's place on the page allows, the view in the middle.

use tracefig::drawing::{Contour, Drawing, Item, Path, Point, Rect, Role, Segment};

/// How far a thing may be from its place, in page pixels. Coordinates are exact to some 1e-13 px before they
/// are written, so that a quarter of a pixel, which no eye sees, finds every thing that is out of place.
pub(crate) const NEAR: f64 = 0.25;

/// What a figure shows, flattened.
pub(crate) struct Figure {
    pub(crate) paths: Vec<Path>,
    pub(crate) texts: Vec<(String, Point)>,
    pub(crate) panels: Vec<Rect>,
}

impl Figure {
    pub(crate) fn of(drawing: &Drawing) -> Self {
        let mut figure = Self { paths: Vec::new(), texts: Vec::new(), panels: Vec::new() };
        figure.walk(&drawing.items);
        figure
    }

    fn walk(&mut self, items: &[Item]) {
        for item in items {
            match item {
                Item::Group(group) => self.walk(&group.items),
                Item::Path(path) => self.paths.push(path.clone()),
                Item::Text(text) => {
                    let middle = text.origin.x + 0.5 * text.line.width;
                    let y = text.origin.y + 0.5 * (text.line.descent - text.line.ascent);
                    self.texts.push((text.line.markup.clone(), Point::new(middle, y)));
                }
            }
        }
    }

    /// Whether a text with exactly this markup stands somewhere.
    pub(crate) fn says(&self, markup: &str) -> bool {
        self.texts.iter().any(|(text, _)| text == markup)
    }
}

/// A panel: where a point of its space lies on the page.
#[derive(Clone, Copy)]
pub(crate) struct Panel {
    pub(crate) scale: f64,
    middle: Point,
    center: (f64, f64),
}

impl Panel {
    /// A panel with this place on the page, that shows `view`.
    pub(crate) fn new(place: Rect, view: [f64; 4]) -> Self {
        let [x0, y0, x1, y1] = view;
        Self {
            scale: (place.width() / (x1 - x0)).min(place.height() / (y1 - y0)),
            middle: place.center(),
            center: (0.5 * (x0 + x1), 0.5 * (y0 + y1)),
        }
    }

    pub(crate) fn page(&self, (x, y): (f64, f64)) -> Point {
        Point::new(
            self.middle.x + self.scale * (x - self.center.0),
            self.middle.y - self.scale * (y - self.center.1),
        )
    }
}

pub(crate) fn near(p: Point, q: Point) -> bool {
    (p.x - q.x).abs() <= NEAR && (p.y - q.y).abs() <= NEAR
}

fn stroke_role(path: &Path) -> Option<Role> {
    path.stroke.as_ref().and_then(|s| s.paint.role)
}

fn fill_role(path: &Path) -> Option<Role> {
    path.fill.and_then(|f| f.role)
}

/// The vertices of a contour, in order; arcs by their ends.
pub(crate) fn vertices(path: &Path) -> Vec<Point> {
    let Contour::Segments(segments) = &path.contour else { return Vec::new() };
    let mut points = Vec::new();
    for segment in segments {
        match *segment {
            Segment::Move(p) | Segment::Line(p) | Segment::Quad(_, p) | Segment::Cubic(_, _, p) => {
                points.push(p);
            }
            Segment::Arc { center, radius, start, sweep } => {
                for a in [start, start + sweep] {
                    points
                        .push(Point::new(center.x + radius * libm::cos(a), center.y + radius * libm::sin(a)));
                }
            }
            Segment::Close => {}
        }
    }
    points
}

fn closed(path: &Path) -> bool {
    matches!(&path.contour, Contour::Segments(s) if s.last() == Some(&Segment::Close))
}

/// Straight pieces of a path, the closing one too.
pub(crate) fn edges(path: &Path) -> Vec<(Point, Point)> {
    let points = vertices(path);
    let mut edges: Vec<_> = points.windows(2).map(|w| (w[0], w[1])).collect();
    if closed(path) && points.len() > 2 {
        edges.push((points[points.len() - 1], points[0]));
    }
    edges
}

/// A figure through one of its panels.
pub(crate) struct Look<'f> {
    pub(crate) figure: &'f Figure,
    pub(crate) panel: Panel,
}

type P = (f64, f64);

impl Look<'_> {
    fn paths(&self) -> impl Iterator<Item = &Path> {
        self.figure.paths.iter()
    }

    /// A line of the role between exactly these ends, in either direction.
    pub(crate) fn line(&self, role: Role, p: P, q: P) -> Option<&Path> {
        let (p, q) = (self.panel.page(p), self.panel.page(q));
        self.paths().find(|path| {
            stroke_role(path) == Some(role)
                && edges(path).iter().any(|&(a, b)| (near(a, p) && near(b, q)) || (near(a, q) && near(b, p)))
        })
    }

    /// An unbroken line of the role from p to q, thicker than an outline.
    pub(crate) fn emphasised(&self, role: Role, p: P, q: P) -> bool {
        let (p, q) = (self.panel.page(p), self.panel.page(q));
        self.paths().any(|path| {
            let thick = path.stroke.as_ref().is_some_and(|s| s.width >= 2.75 && s.dash.is_empty());
            let joins = |(a, b)| (near(a, p) && near(b, q)) || (near(a, q) && near(b, p));
            thick && stroke_role(path) == Some(role) && edges(path).into_iter().any(joins)
        })
    }

    /// An arrow of the role: a shaft that starts at `from` and points at `tip`, where a filled head has a
    /// vertex.
    pub(crate) fn arrow(&self, role: Role, from: P, tip: P) -> bool {
        self.shaft(role, from, tip) && self.head(role, tip)
    }

    /// An arrow of the role that starts at `from` and ends up to 14 px short of `tip`: at the rim of a marker,
    /// or behind a head that ends there.
    pub(crate) fn arrow_toward(&self, role: Role, from: P, tip: P) -> bool {
        let end = self.panel.page(tip);
        let heads = |reach: f64| {
            self.paths().any(|path| {
                let c = vertices(path);
                let filled = fill_role(path) == Some(role) && c.len() == 3;
                filled && on_segment(c[0], self.panel.page(from), end) && distance(c[0], end) <= reach
            })
        };
        self.carried(role, from, tip) && heads(14.0)
    }

    /// An edge of a difference from p to q: a plain line of A's, a cased one of B's: two rails as far from it on
    /// either side, joined at its ends, with a pale core.
    pub(crate) fn edge(&self, role: Role, p: P, q: P) -> Option<&Path> {
        if role != Role::B {
            return self.line(role, p, q);
        }
        let ends = [self.panel.page(p), self.panel.page(q)];
        let middle = |a: Point, b: Point| Point::new(0.5 * (a.x + b.x), 0.5 * (a.y + b.y));
        self.paths().find(|path| {
            let c = vertices(path);
            if stroke_role(path) != Some(role) || fill_role(path) != Some(role) || c.len() != 4 {
                return false;
            }
            let [from, to] = [middle(c[0], c[3]), middle(c[1], c[2])];
            let narrow = (1.0..4.0).contains(&distance(c[0], c[3]));
            let joins = |[a, b]: [Point; 2]| near(from, a) && near(to, b);
            narrow && (joins(ends) || joins([ends[1], ends[0]]))
        })
    }

    /// A filled arrow head of the role with its tip there.
    pub(crate) fn head(&self, role: Role, tip: P) -> bool {
        let tip = self.panel.page(tip);
        self.paths().any(|path| {
            let c = vertices(path);
            let small = path.contour.bounds().is_some_and(|b| b.width() < 16.0 && b.height() < 16.0);
            fill_role(path) == Some(role)
                && small
                && (3..=5).contains(&c.len())
                && c.iter().any(|&p| near(p, tip))
        })
    }

    fn shaft(&self, role: Role, from: P, tip: P) -> bool {
        let (from, tip) = (self.panel.page(from), self.panel.page(tip));
        self.paths().any(|path| {
            stroke_role(path) == Some(role)
                && edges(path).iter().any(|&(a, b)| {
                    (near(a, from) && on_segment(b, from, tip) && distance(b, tip) < 12.0)
                        || (near(b, from) && on_segment(a, from, tip) && distance(a, tip) < 12.0)
                })
        })
    }

    /// A line of the role that lies on the segment p – q and covers it up to arrow heads.
    fn carried(&self, role: Role, p: P, q: P) -> bool {
        let (p, q) = (self.panel.page(p), self.panel.page(q));
        self.paths().any(|path| {
            stroke_role(path) == Some(role)
                && edges(path).iter().any(|&(a, b)| {
                    on_segment(a, p, q) && on_segment(b, p, q) && distance(a, b) > distance(p, q) - 24.0
                })
        })
    }

    /// A closed polygon with these vertices, from any of them, in either direction, stroked in the role.
    pub(crate) fn polygon(&self, role: Role, points: &[P]) -> Option<&Path> {
        let points: Vec<_> = points.iter().map(|&p| self.panel.page(p)).collect();
        self.paths().find(|path| {
            let c = vertices(path);
            let n = points.len();
            stroke_role(path) == Some(role)
                && c.len() == n
                && closed(path)
                && (0..n).any(|shift| {
                    (0..n).all(|i| near(c[i], points[(i + shift) % n]))
                        || (0..n).all(|i| near(c[n - 1 - i], points[(i + shift) % n]))
                })
        })
    }

    /// A whole circle, stroked in the role; `radius` in units of the space.
    pub(crate) fn circle(&self, role: Role, center: P, radius: f64) -> Option<&Path> {
        let (center, radius) = (self.panel.page(center), radius * self.panel.scale);
        self.paths().find(|path| {
            stroke_role(path) == Some(role)
                && matches!(path.contour, Contour::Circle { center: c, radius: r }
                    if near(c, center) && (r - radius).abs() <= NEAR)
        })
    }

    /// An arc of the role about `center` from `p` to `q`, in either direction.
    pub(crate) fn arc(&self, role: Role, center: P, p: P, q: P) -> bool {
        let (center, p, q) = (self.panel.page(center), self.panel.page(p), self.panel.page(q));
        self.paths().any(|path| {
            let Contour::Segments(segments) = &path.contour else { return false };
            stroke_role(path) == Some(role)
                && segments.iter().any(|s| {
                    let Segment::Arc { center: c, radius, start, sweep } = *s else { return false };
                    let at = |a: f64| Point::new(c.x + radius * libm::cos(a), c.y + radius * libm::sin(a));
                    // A marker and an arrow head take the place of the arc's last pixels.
                    let ends = [(at(start), at(start + sweep)), (at(start + sweep), at(start))];
                    near(c, center) && ends.iter().any(|&(a, b)| near(a, p) && distance(b, q) < 14.0)
                })
        })
    }

    /// A closed area of the role without an outline, p and q among its vertices.
    pub(crate) fn strip(&self, role: Role, p: P, q: P) -> bool {
        let ends = [self.panel.page(p), self.panel.page(q)];
        self.paths().any(|path| {
            let c = vertices(path);
            let lit = fill_role(path) == Some(role) && path.stroke.is_none();
            lit && ends.iter().all(|&end| c.iter().any(|&v| near(v, end)))
        })
    }

    /// A marker: something small of the role whose middle is there.
    pub(crate) fn marker(&self, role: Role, p: P) -> bool {
        let p = self.panel.page(p);
        self.paths().any(|path| {
            let Some(bounds) = path.contour.bounds() else { return false };
            let colour = fill_role(path) == Some(role) || stroke_role(path) == Some(role);
            colour && near(bounds.center(), p) && bounds.width() < 24.0 && bounds.height() < 24.0
        })
    }

    /// The text nearest to a place is the wanted one, or it is within `reach` pixels of it.
    pub(crate) fn text_near(&self, markup: &str, p: P, reach: f64) -> bool {
        let p = self.panel.page(p);
        self.figure.texts.iter().any(|(text, at)| text == markup && distance(*at, p) <= reach)
    }
}

pub(crate) fn distance(p: Point, q: Point) -> f64 {
    libm::hypot(p.x - q.x, p.y - q.y)
}

fn on_segment(x: Point, p: Point, q: Point) -> bool {
    let length = distance(p, q).max(f64::MIN_POSITIVE);
    let (ux, uy) = ((q.x - p.x) / length, (q.y - p.y) / length);
    let along = (x.x - p.x) * ux + (x.y - p.y) * uy;
    let across = (x.x - p.x) * uy - (x.y - p.y) * ux;
    across.abs() <= NEAR && (-NEAR..=length + NEAR).contains(&along)
}

impl Look<'_> {
    /// A line between these ends in any role.
    pub(crate) fn any_line(&self, p: P, q: P) -> bool {
        Role::ALL.into_iter().any(|role| self.line(role, p, q).is_some())
    }

    /// A line of the role that covers p – q up to arrow heads.
    pub(crate) fn along(&self, role: Role, p: P, q: P) -> bool {
        self.carried(role, p, q)
    }

    /// A horizontal line of the role from x = `x0` to `x1`, at any height: a length on a track.
    pub(crate) fn horizontal(&self, role: Role, x0: f64, x1: f64) -> bool {
        let (p, q) = (self.panel.page((x0, 0.0)), self.panel.page((x1, 0.0)));
        self.bar(role, |a, b| {
            (a.y - b.y).abs() < 1e-6
                && (a.x.min(b.x) - p.x).abs() <= NEAR
                && (a.x.max(b.x) - q.x).abs() <= NEAR
        })
    }

    /// A vertical line of the role from y = `y0` to `y1`, anywhere: a length on a track.
    pub(crate) fn vertical(&self, role: Role, y0: f64, y1: f64) -> bool {
        let (p, q) = (self.panel.page((0.0, y1)), self.panel.page((0.0, y0)));
        self.bar(role, |a, b| {
            (a.x - b.x).abs() < 1e-6
                && (a.y.min(b.y) - p.y).abs() <= NEAR
                && (a.y.max(b.y) - q.y).abs() <= NEAR
        })
    }

    fn bar(&self, role: Role, fits: impl Fn(Point, Point) -> bool) -> bool {
        self.paths()
            .any(|path| stroke_role(path) == Some(role) && edges(path).iter().any(|&(a, b)| fits(a, b)))
    }

    /// A straight dashed line whose carrier passes through both points.
    pub(crate) fn through(&self, p: P, q: P) -> bool {
        let (p, q) = (self.panel.page(p), self.panel.page(q));
        self.paths().any(|path| {
            let dashed = path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty());
            dashed && edges(path).iter().any(|&(a, b)| on_segment(p, a, b) && on_segment(q, a, b))
        })
    }

    /// An arc about the centre with this radius, in any role.
    pub(crate) fn round(&self, center: P, radius: f64) -> bool {
        let (center, radius) = (self.panel.page(center), radius * self.panel.scale);
        self.paths().any(|path| {
            let Contour::Segments(segments) = &path.contour else { return false };
            segments.iter().any(|s| {
                matches!(*s, Segment::Arc { center: c, radius: r, .. } if near(c, center) && (r - radius).abs() <= NEAR)
            })
        })
    }
}

impl Look<'_> {
    /// Lengths on the page of the role's straight lines along a direction, given by two page points.
    pub(crate) fn lengths(&self, role: Role, (p, q): (Point, Point)) -> Vec<f64> {
        let (ux, uy) = ((p.x - q.x) / distance(p, q), (p.y - q.y) / distance(p, q));
        let own = self.paths().filter(|path| stroke_role(path) == Some(role));
        own.flat_map(edges)
            .filter(|&(a, b)| ((b.x - a.x) * uy - (b.y - a.y) * ux).abs() < NEAR)
            .map(|(a, b)| distance(a, b))
            .collect()
    }
}

/// The most that a dotted outline is filled: less than two thirds of a body in the theme that fills least.
const GHOST: f64 = 0.065;

/// Whether a line is dotted or dashed, and what it is around is not filled as a body that is there.
pub(crate) fn dotted(path: &Path) -> bool {
    let is_faint = path.fill.as_ref().is_none_or(|fill| fill.opacity < GHOST);
    path.stroke.as_ref().is_some_and(|s| !s.dash.is_empty()) && is_faint && path.pattern.is_none()
}
