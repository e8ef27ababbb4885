//! What glyphs are called, where a test tells of them.

use super::super::face::Loaded;
use super::super::line::Face;
use super::formulas::script_forms;
use super::glyphs::characters;

/// A glyph by its character, if it is of one, and its number.
pub(in crate::typeset) fn named(face: Face, id: u16) -> String {
    let face = Loaded::of(face).unwrap().face();
    let own = characters(face).into_iter().find(|(_, glyph)| *glyph == id);
    let form = || {
        let of = |&(_, glyph): &(i32, u16)| script_forms(face, glyph).contains(&id);
        characters(face).into_iter().find(of)
    };
    let name = |(code, _): (i32, u16)| char::from_u32(code.cast_unsigned()).unwrap();
    match own {
        Some(own) => format!("{} {id}", name(own)),
        None => format!("a form of {} {id}", form().map_or('?', name)),
    }
}
