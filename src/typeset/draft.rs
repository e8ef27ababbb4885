//! A line, or a part of one, while it is set.

use super::line::{Line, PlacedGlyph, Rule, Run, Tint};

/// Height of the letter x in the word face, in ems; a line's ascent is never less.
const X_HEIGHT: f64 = 0.486;

/// A line, or a part of one, while it is set.
#[derive(Default)]
pub(super) struct Draft {
    /// The glyphs so far, from the draft's start.
    pub(super) glyphs: Vec<PlacedGlyph>,
    /// The rules so far, from the draft's start.
    pub(super) rules: Vec<Rule>,
    /// The stretches so far that wear a role.
    pub(super) tints: Vec<Tint>,
    /// The words and formulas so far.
    pub(super) runs: Vec<Run>,
    /// The advance width so far, in page pixels.
    pub(super) width: f64,
}

impl Draft {
    /// Whether nothing of it is seen.
    pub(super) fn is_empty(&self) -> bool {
        self.glyphs.is_empty() && self.rules.is_empty()
    }

    /// Adds what is set next on the line, behind a space of some page pixels.
    pub(super) fn append(&mut self, other: &Self, space: f64) {
        if !self.is_empty() {
            self.width += space;
            self.runs.iter_mut().last().into_iter().for_each(|run| run.text.push(' '));
        }
        self.join(other);
    }

    /// Adds what is set right behind it.
    pub(super) fn join(&mut self, other: &Self) {
        let x = self.width;
        let (glyphs, rules) = (self.glyphs.len(), self.rules.len());
        for Tint { role, glyphs: g, rules: r, x: [from, to] } in &other.tints {
            let (g, r) = (glyphs + g.start..glyphs + g.end, rules + r.start..rules + r.end);
            match self.tints.last_mut() {
                // Nothing that is seen lies between the words of one stretch.
                Some(last)
                    if last.role == *role && last.glyphs.end == g.start && last.rules.end == r.start =>
                {
                    (last.glyphs.end, last.rules.end, last.x[1]) = (g.end, r.end, x + to);
                }
                _ => self.tints.push(Tint { role: role.clone(), glyphs: g, rules: r, x: [x + from, x + to] }),
            }
        }
        self.runs.extend(other.runs.iter().map(|run| Run { x: run.x.map(|from| x + from), ..run.clone() }));
        self.glyphs.extend(other.glyphs.iter().map(|g| PlacedGlyph { x: x + g.x, ..*g }));
        self.rules.extend(other.rules.iter().map(|r| Rule { x: x + r.x, ..*r }));
        self.width += other.width;
    }

    /// The line, of words of so many page pixels an em.
    pub(super) fn into_line(self, markup: &str, size: f64) -> Line {
        let (mut ascent, mut descent) = (X_HEIGHT * size, 0.0_f64);
        for g in &self.glyphs {
            let [_, top, _, bottom] = g.glyph.outline().bounds;
            let em = g.size / super::face::UNITS_PER_EM;
            ascent = ascent.max(-(g.y + f64::from(top) * em));
            descent = descent.max(g.y + f64::from(bottom) * em);
        }
        for r in &self.rules {
            ascent = ascent.max(-r.y);
            descent = descent.max(r.y + r.height);
        }
        let Self { glyphs, rules, tints, runs, width } = self;
        Line { markup: markup.to_owned(), glyphs, rules, tints, runs, width, ascent, descent }
    }
}
