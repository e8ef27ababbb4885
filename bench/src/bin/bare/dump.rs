//! Display lists as JSON, so that plotters in other languages can draw them.
//!
//! `[{"name", "width", "height", "background", "items": [ITEM…]}…]`; an ITEM is a group `{"clip", "opacity",
//! "items"}` or a path `{"path": [PIECE…], "fill": COLOR, "stroke": {"color", "width", "dash", "round"}}`; a
//! PIECE is `["M", x, y]`, `["L", x, y]`, `["C", x1, y1, x2, y2, x, y]` or `["Z"]` in page pixels, a COLOR
//! `[red, green, blue, opacity]` from 0 to 1. Text is the outlines of its glyphs, an arc is cubics, a pattern
//! is lines in a group that its area clips.

use std::fmt::Write;

use tracefig::drawing::{Cap, Contour, Drawing, Item, Paint, Path, Point, Rect, Segment, Stroke, Text};
use tracefig::typeset::{OutlineSegment, UNITS_PER_EM};

/// All drawings, each with its name.
pub(super) fn json(drawings: &[(String, Drawing)]) -> String {
    let one = |(name, d): &(String, Drawing)| {
        format!(
            r#"{{"name": "{name}", "width": {}, "height": {}, "background": {}, "items": [{}]}}"#,
            d.width,
            d.height,
            color(&d.background),
            items(&d.items)
        )
    };
    format!("[{}]", list(drawings.iter().map(one)))
}

fn list(all: impl Iterator<Item = String>) -> String {
    all.collect::<Vec<_>>().join(",")
}

fn items(all: &[Item]) -> String {
    list(all.iter().flat_map(|item| match item {
        Item::Group(group) => {
            let clip = group.clip.map_or("null".into(), |clip| format!("[{}]", rectangle(clip.rect)));
            let inner = items(&group.items);
            vec![format!(r#"{{"clip": {clip}, "opacity": {}, "items": [{inner}]}}"#, group.opacity)]
        }
        Item::Path(path) => painted(path),
        Item::Text(text) => lettering(text),
    }))
}

fn painted(path: &Path) -> Vec<String> {
    let pieces = contour(&path.contour);
    let mut all = Vec::new();
    if let Some(fill) = &path.fill {
        all.push(entry(&pieces, Some(fill), None));
    }
    if let Some((pattern, bounds)) = path.pattern.zip(path.contour.bounds()) {
        let (lines, stroke) = pattern.marks(bounds);
        let mut marks = Vec::new();
        for (from, to) in lines {
            marks.extend([piece("M", &[from]), piece("L", &[to])]);
        }
        let marks = entry(&marks.join(","), None, Some(&stroke));
        all.push(format!(r#"{{"clip": [{pieces}], "opacity": 1, "items": [{marks}]}}"#));
    }
    if let Some(stroke) = &path.stroke {
        all.push(entry(&pieces, None, Some(stroke)));
    }
    all
}

fn lettering(text: &Text) -> Vec<String> {
    let mut pieces = Vec::new();
    for placed in &text.line.glyphs {
        let em = placed.size / UNITS_PER_EM;
        let at = |p: [f32; 2]| {
            Point::new(
                text.origin.x + placed.x + f64::from(p[0]) * em,
                text.origin.y + placed.y + f64::from(p[1]) * em,
            )
        };
        let mut from = Point::default();
        for segment in &placed.glyph.outline().segments {
            let (next, said) = match *segment {
                OutlineSegment::Move(p) => (at(p), piece("M", &[at(p)])),
                OutlineSegment::Line(p) => (at(p), piece("L", &[at(p)])),
                OutlineSegment::Quad(c, p) => (at(p), quad(from, at(c), at(p))),
                OutlineSegment::Cubic(c, d, p) => (at(p), piece("C", &[at(c), at(d), at(p)])),
                OutlineSegment::Close => (from, piece("Z", &[])),
            };
            from = next;
            pieces.push(said);
        }
    }
    for rule in &text.line.rules {
        let (x0, y0) = (text.origin.x + rule.x, text.origin.y + rule.y);
        pieces.push(rectangle(Rect { x0, y0, x1: x0 + rule.width, y1: y0 + rule.height }));
    }
    let pieces = pieces.join(",");
    let halo = text.halo.as_ref().map(|halo| entry(&pieces, None, Some(&Stroke::solid(halo.paint, 2.0 * halo.width))));
    halo.into_iter().chain([entry(&pieces, Some(&text.paint), None)]).collect()
}

fn entry(pieces: &str, fill: Option<&Paint>, stroke: Option<&Stroke>) -> String {
    let fill = fill.map_or("null".into(), color);
    let stroke = stroke.map_or("null".into(), |s| {
        let dash = list(s.dash.iter().map(f64::to_string));
        let round = s.cap == Cap::Round;
        format!(
            r#"{{"color": {}, "width": {}, "dash": [{dash}], "round": {round}}}"#,
            color(&s.paint),
            s.width
        )
    });
    format!(r#"{{"path": [{pieces}], "fill": {fill}, "stroke": {stroke}}}"#)
}

fn color(paint: &Paint) -> String {
    let channel = |c: u8| f64::from(c) / 255.0;
    let tracefig::drawing::Color { r, g, b } = paint.color;
    format!("[{:.4}, {:.4}, {:.4}, {}]", channel(r), channel(g), channel(b), paint.opacity)
}

fn rectangle(r: Rect) -> String {
    let corners = [(r.x0, r.y0), (r.x1, r.y0), (r.x1, r.y1), (r.x0, r.y1)].map(|(x, y)| Point::new(x, y));
    contour(&Contour::polygon(&corners))
}

fn contour(contour: &Contour) -> String {
    let segments = match contour {
        Contour::Circle { center, radius } => {
            let (center, radius) = (*center, *radius);
            vec![Segment::Arc { center, radius, start: 0.0, sweep: std::f64::consts::TAU }, Segment::Close]
        }
        Contour::Segments(segments) => segments.clone(),
    };
    let mut pieces = Vec::new();
    let mut from = Point::default();
    for segment in segments {
        match segment {
            Segment::Move(p) => pieces.push(piece("M", &[p])),
            Segment::Line(p) => pieces.push(piece("L", &[p])),
            Segment::Quad(c, p) => pieces.push(quad(from, c, p)),
            Segment::Cubic(c, d, p) => pieces.push(piece("C", &[c, d, p])),
            Segment::Close => pieces.push(piece("Z", &[])),
            Segment::Arc { center, radius, start, sweep } => arc(center, radius, (start, sweep), &mut pieces),
        }
        from = match segment {
            Segment::Move(p) | Segment::Line(p) | Segment::Quad(_, p) | Segment::Cubic(_, _, p) => p,
            _ => from,
        };
    }
    pieces.join(",")
}

fn quad(from: Point, c: Point, to: Point) -> String {
    let third = |p: Point| Point::new(p.x + 2.0 / 3.0 * (c.x - p.x), p.y + 2.0 / 3.0 * (c.y - p.y));
    piece("C", &[third(from), third(to), to])
}

/// Cubics of at most 45° with control points (4/3) tan(θ/4) r along the tangents.
fn arc(center: Point, radius: f64, (start, sweep): (f64, f64), pieces: &mut Vec<String>) {
    let count = (sweep.abs() / std::f64::consts::FRAC_PI_4).ceil().max(1.0);
    let step = sweep / count;
    let reach = 4.0 / 3.0 * (step / 4.0).tan() * radius;
    let at = |angle: f64, along: f64| {
        let (sin, cos) = angle.sin_cos();
        Point::new(center.x + radius * cos - along * sin, center.y + radius * sin + along * cos)
    };
    pieces.push(piece(if pieces.is_empty() { "M" } else { "L" }, &[at(start, 0.0)]));
    let mut angle = start;
    while (start + sweep - angle).abs() > step.abs() / 2.0 {
        pieces.push(piece("C", &[at(angle, reach), at(angle + step, -reach), at(angle + step, 0.0)]));
        angle += step;
    }
}

fn piece(name: &str, points: &[Point]) -> String {
    let mut text = format!(r#"["{name}""#);
    for p in points {
        let _ = write!(text, ", {:.3}, {:.3}", p.x, p.y);
    }
    text + "]"
}
