//! How a file that `check` looks at differs from what is drawn now: in numbers, and in lines.

use tracefig::drawing::Rect;
use tracefig::drift::report::Finding;
use tracefig::drift::{Change, Measured, PixelDrift, elements_in, what_moved};
use tracefig::output::Format;

use super::encoded::Encoded;

/// How a file differs, in numbers.
pub(crate) fn measured(change: &Change, old: &[u8], encoded: &Encoded) -> Measured {
    let pixels = change.pixels().cloned();
    let elements = pixels.as_ref().and_then(|drift| drift.area).map_or_else(Vec::new, |area| {
        let [x0, y0, x1, y1] = area.map(|dots| f64::from(dots) / encoded.options.scale);
        elements_in(&encoded.drawing, Rect { x0, y0, x1, y1 })
    });
    Measured { bytes: [old.len(), encoded.bytes.len()], pixels, elements }
}

/// How a file differs, in lines.
pub(crate) fn details(
    change: &Change,
    (old, format): (&[u8], &Format),
    encoded: &Encoded,
    measured: &Measured,
) -> Vec<String> {
    let mut lines = what_moved(format, old, &encoded.bytes);
    lines.push(change.to_string());
    lines.extend(measured.pixels.as_ref().map(PixelDrift::under_tolerances));
    let names: Vec<&str> = measured.elements.iter().map(|element| element.name.as_str()).collect();
    if !names.is_empty() {
        lines.push(format!("in the changed area: {}", names.join(", ")));
    }
    lines
}

/// Fewer lines that are alike are told again: it takes a line to say where they were told.
const ALIKE: usize = 2;

/// How many lines of a finding another one of the same scene began with before, and which that is: a body
/// that moved has moved in every theme. 0 where there is nothing to refer to.
pub(crate) fn told_before<'f>(finding: &Finding, before: &[&'f Finding]) -> (usize, Option<&'f Finding>) {
    let alike = |other: &Finding| {
        let pairs = finding.details.iter().zip(&other.details);
        pairs.take_while(|(one, two)| one == two).count()
    };
    let all = before.iter().map(|other| (alike(other), *other));
    // The first of those that are as long told them all.
    let most = all.rev().max_by_key(|(count, _)| *count).filter(|(count, _)| *count >= ALIKE);
    most.map_or((0, None), |(count, other)| (count, Some(other)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_moved_in_one_theme_is_not_told_again_of_another() {
        let finding = |file: &str, details: &[&str]| Finding {
            details: details.iter().map(|&line| line.to_owned()).collect(),
            ..Finding::new(file, "changed")
        };
        let light = finding("s.svg", &["A moved", "d: 1 → 2", "5 pixels differ"]);
        let (dark, other) =
            (finding("s.dark.svg", &["A moved", "d: 1 → 2", "6 pixels"]), finding("o", &["x"]));
        let (alike, of) = told_before(&dark, &[&light, &other]);
        assert_eq!((alike, of.map(|of| of.file.as_str())), (2, Some("s.svg")));
        assert_eq!(told_before(&other, &[&light, &dark]).0, 0);
    }
}
