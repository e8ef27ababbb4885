//! Packed faces as they are read: numbers of seven bits a byte, all of a kind after each other.

use crate::GlyphId;
use crate::math::GlyphPart;

/// How many points each piece of an outline takes, by its number; see [`crate::outline`].
const POINTS: [usize; 10] = [0, 1, 1, 0, 2, 1, 1, 3, 2, 0];

/// A glyph.
#[derive(Clone, Copy, Default)]
pub(crate) struct Glyph {
    pub(crate) id: u16,
    pub(crate) advance: u16,
    /// Where the pieces of its outline begin, and where their points do.
    pub(crate) pieces: usize,
    pub(crate) points: usize,
    /// How far it leans over its width.
    pub(crate) italic: i16,
    /// Where an accent stands over it.
    pub(crate) accent: Option<i16>,
    /// Its forms in scripts and in scripts of scripts, and how many of them it has.
    pub(crate) scripts: [GlyphId; 2],
    pub(crate) forms: usize,
}

/// What a glyph grows to.
pub(crate) struct Growth {
    pub(crate) id: u16,
    /// Higher forms and wider ones.
    pub(crate) variants: [Vec<crate::math::GlyphVariant>; 2],
    /// The parts that a form of any width is made of.
    pub(crate) parts: Vec<GlyphPart>,
}

/// The places of two glyphs that stand side by side, and their kerning.
struct Pair {
    left: usize,
    right: usize,
    kerning: i16,
}

/// A face, unpacked but for its outlines.
#[derive(Default)]
pub(crate) struct Packed {
    pub(crate) ascender: i16,
    pub(crate) descender: i16,
    pub(crate) x_height: Option<i16>,
    /// For each number of a glyph one more than its place, 0 where there is none.
    places: Vec<usize>,
    glyphs: Vec<Glyph>,
    /// Characters in order with their glyphs.
    characters: Vec<(char, u16)>,
    /// The pieces of all outlines, and the way to each point from the one before.
    pub(crate) pieces: Vec<u8>,
    pub(crate) ways: [Vec<i16>; 2],
    /// The kinds of the first glyphs as the left and as the right one of a pair, by place; 0 has no kerning.
    kinds: [Vec<usize>; 2],
    /// How many kinds there are to the right, and the kerning of each kind to the left with them.
    rights: usize,
    kernings: Vec<i16>,
    /// The kerning of pairs of which one came later.
    pairs: Vec<Pair>,
    /// The measures of formulas.
    pub(crate) constants: Vec<i16>,
    pub(crate) growths: Vec<Growth>,
}

/// What is left to read.
struct Bytes<'a>(&'a [u8]);

impl Bytes<'_> {
    fn byte(&mut self) -> Option<u8> {
        let (&first, rest) = self.0.split_first()?;
        self.0 = rest;
        Some(first)
    }

    /// A number from 0.
    fn number(&mut self) -> Option<u32> {
        let (mut number, mut shift) = (0, 0);
        loop {
            let byte = self.byte()?;
            number |= u32::from(byte & 127).checked_shl(shift)?;
            shift += 7;
            if byte < 128 {
                return Some(number);
            }
        }
    }

    fn count(&mut self) -> Option<usize> {
        usize::try_from(self.number()?).ok()
    }

    /// A number of either sign: 0, −1, 1, −2, 2, …
    fn signed(&mut self) -> Option<i16> {
        unfolded(self.number()?)
    }

    /// A number from another one.
    fn from(&mut self, other: u16) -> Option<u16> {
        other.checked_add_signed(self.signed()?)
    }

    /// The numbers of glyphs, each from the one before.
    fn ids(&mut self, mut before: u16) -> Option<Vec<u16>> {
        let count = self.count()?;
        let mut ids = Vec::new();
        for _ in 0..count {
            before = self.from(before)?;
            ids.push(before);
        }
        Some(ids)
    }
}

/// The number of either sign that a number from 0 stands for.
fn unfolded(number: u32) -> Option<i16> {
    let half = i16::try_from(number >> 1).ok()?;
    Some(if number & 1 == 0 { half } else { -1 - half })
}

impl Packed {
    /// Reads pieces of a face, the first of which is whole.
    pub(crate) fn read(bytes: &[u8], weight: u32) -> Option<Self> {
        let mut bytes = Bytes(bytes);
        let mut face = Self::default();
        while !bytes.0.is_empty() {
            let is_of_words = bytes.byte()? == 0;
            face.ascender = bytes.signed()?;
            face.descender = bytes.signed()?;
            face.x_height = bytes.number()?.checked_sub(1).and_then(|height| height.try_into().ok());
            let first = face.glyphs.len();
            face.read_characters(&mut bytes)?;
            let first_way = face.ways[0].len();
            face.read_outlines(&mut bytes, first)?;
            if is_of_words {
                face.read_semibold(&mut bytes, first, first_way, weight)?;
                if first == 0 {
                    face.read_kerning(&mut bytes, weight)?;
                } else {
                    face.read_more_kerning(&mut bytes, weight)?;
                }
            } else {
                face.read_measures(&mut bytes, first)?;
            }
        }
        Some(face)
    }

    /// The numbers of glyphs, and the characters that each stands for.
    fn read_characters(&mut self, bytes: &mut Bytes) -> Option<()> {
        let first = self.glyphs.len();
        for id in bytes.ids(0)? {
            if self.places.len() <= usize::from(id) {
                self.places.resize(usize::from(id) + 1, 0);
            }
            self.glyphs.push(Glyph { id, ..Glyph::default() });
            self.places[usize::from(id)] = self.glyphs.len();
        }
        let mut code = 0_u32;
        for place in first..self.glyphs.len() {
            for _ in 0..bytes.number()? {
                let step = bytes.number()?;
                let half = step >> 1;
                code = if step & 1 == 0 { code.wrapping_add(half) } else { code.wrapping_sub(half + 1) };
                let character = char::from_u32(code)?;
                let at = self.characters.partition_point(|&(known, _)| known < character);
                self.characters.insert(at, (character, self.glyphs[place].id));
            }
        }
        Some(())
    }

    /// Widths, pieces of outlines, and the ways between their points.
    fn read_outlines(&mut self, bytes: &mut Bytes, first: usize) -> Option<()> {
        for glyph in &mut self.glyphs[first..] {
            glyph.advance = bytes.number()?.try_into().ok()?;
        }
        let mut points = self.ways[0].len();
        for glyph in &mut self.glyphs[first..] {
            (glyph.pieces, glyph.points) = (self.pieces.len(), points);
            loop {
                let piece = bytes.byte()?;
                self.pieces.push(piece);
                points += POINTS.get(usize::from(piece))?;
                if piece == 0 {
                    break;
                }
            }
        }
        for ways in &mut self.ways {
            while ways.len() < points {
                ways.push(bytes.signed()?);
            }
        }
        Some(())
    }

    /// What the semibold weight has otherwise.
    fn read_semibold(&mut self, bytes: &mut Bytes, first: usize, way: usize, weight: u32) -> Option<()> {
        for glyph in &mut self.glyphs[first..] {
            let more = bytes.signed()?;
            if weight > 0 {
                glyph.advance = glyph.advance.checked_add_signed(more)?;
            }
        }
        for ways in &mut self.ways {
            for way in &mut ways[way..] {
                let more = bytes.signed()?;
                if weight > 0 {
                    *way = way.checked_add(more)?;
                }
            }
        }
        Some(())
    }

    /// The kinds of all glyphs, and the kerning of pairs of kinds.
    fn read_kerning(&mut self, bytes: &mut Bytes, weight: u32) -> Option<()> {
        let (lefts, rights) = (bytes.count()?, bytes.count()?);
        for kinds in &mut self.kinds {
            for _ in 0..self.glyphs.len() {
                kinds.push(bytes.count()?);
            }
        }
        self.rights = rights;
        for _ in 0..lefts * rights {
            self.kernings.push(bytes.signed()?);
        }
        for kerning in &mut self.kernings {
            let more = bytes.signed()?;
            if weight > 0 {
                *kerning = kerning.checked_add(more)?;
            }
        }
        Some(())
    }

    /// The kerning of pairs, by the places of their glyphs.
    fn read_more_kerning(&mut self, bytes: &mut Bytes, weight: u32) -> Option<()> {
        let (first, mut left) = (self.pairs.len(), 0);
        for _ in 0..bytes.number()? {
            left += bytes.count()?;
            self.pairs.push(Pair { left, right: 0, kerning: 0 });
        }
        for pair in &mut self.pairs[first..] {
            pair.right = bytes.count()?;
        }
        for pair in &mut self.pairs[first..] {
            pair.kerning = bytes.signed()?;
        }
        for pair in &mut self.pairs[first..] {
            let more = bytes.signed()?;
            if weight > 0 {
                pair.kerning = pair.kerning.checked_add(more)?;
            }
        }
        Some(())
    }

    /// What formulas ask of their glyphs.
    fn read_measures(&mut self, bytes: &mut Bytes, first: usize) -> Option<()> {
        for _ in 0..bytes.number()? {
            let constant = bytes.signed()?;
            self.constants.push(constant);
        }
        for glyph in &mut self.glyphs[first..] {
            glyph.italic = bytes.signed()?;
        }
        for glyph in &mut self.glyphs[first..] {
            let accent = bytes.number()?;
            glyph.accent = accent.checked_sub(1).and_then(unfolded);
        }
        for script in 0..2 {
            for glyph in &mut self.glyphs[first..] {
                let form = bytes.from(glyph.id)?;
                glyph.scripts[script] = GlyphId(form);
                glyph.forms += usize::from(form != glyph.id);
            }
        }
        for _ in 0..bytes.number()? {
            let id = bytes.number()?.try_into().ok()?;
            let mut variants = || {
                let ids = bytes.ids(id)?.into_iter();
                Some(ids.map(|id| crate::math::GlyphVariant { variant_glyph: GlyphId(id) }).collect())
            };
            let variants = [variants()?, variants()?];
            let mut parts = Vec::new();
            for id in bytes.ids(id)? {
                parts.push(GlyphPart::new(
                    id,
                    [bytes.number()?, bytes.number()?, bytes.number()?, bytes.number()?],
                )?);
            }
            self.growths.push(Growth { id, variants, parts });
        }
        Some(())
    }

    /// One more than the greatest number of a glyph.
    pub(crate) fn count(&self) -> u16 {
        u16::try_from(self.places.len()).unwrap_or(u16::MAX)
    }

    fn place(&self, glyph: GlyphId) -> Option<usize> {
        self.places.get(usize::from(glyph.0))?.checked_sub(1)
    }

    /// A glyph of this face.
    pub(crate) fn glyph(&self, glyph: GlyphId) -> Option<&Glyph> {
        self.glyphs.get(self.place(glyph)?)
    }

    /// The glyph of a character.
    pub(crate) fn of_character(&self, character: char) -> Option<u16> {
        let at = self.characters.partition_point(|&(known, _)| known < character);
        self.characters.get(at).filter(|&&(known, _)| known == character).map(|&(_, glyph)| glyph)
    }

    /// The kerning of a pair; none where it has none.
    pub(crate) fn kerning(&self, left: GlyphId, right: GlyphId) -> Option<i16> {
        let (left, right) = (self.place(left)?, self.place(right)?);
        match (self.kinds[0].get(left), self.kinds[1].get(right)) {
            (Some(left), Some(right)) => {
                let (left, right) = (left.checked_sub(1)?, right.checked_sub(1)?);
                self.kernings.get(left * self.rights + right).copied()
            }
            _ => {
                let mut pairs = self.pairs.iter();
                pairs.find(|pair| (pair.left, pair.right) == (left, right)).map(|pair| pair.kerning)
            }
        }
    }

    /// What a glyph grows to.
    pub(crate) fn growth(&self, glyph: GlyphId) -> Option<&Growth> {
        self.growths.iter().find(|growth| growth.id == glyph.0)
    }
}
