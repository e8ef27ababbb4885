//! Words, packed in both weights, with their kerning.

use std::collections::BTreeSet;

use super::super::face::Loaded;
use super::super::line::Face;
use super::super::words::units;
use super::glyphs::{glyphs_of, width};
use super::numbers::Numbers;
use super::outline::Outline;

/// A piece of the face of words, in both weights: some glyphs for a face that has others already.
pub(in crate::typeset) fn words(known: &BTreeSet<u16>, glyphs: &BTreeSet<u16>) -> Vec<u8> {
    let ids: Vec<u16> = glyphs.difference(known).copied().collect();
    let [Some(regular), Some(semibold)] = [Face::Regular, Face::Semibold].map(Loaded::of) else {
        return Vec::new();
    };
    let mut out = Numbers(vec![0]);
    let outlines = ids.iter().filter_map(|&id| {
        let mut weights = Outline::of_all(&[regular, semibold], id).into_iter();
        weights.next().zip(weights.next())
    });
    let (own, bold): (Vec<_>, Vec<_>) = outlines.unzip();
    glyphs_of(&mut out, regular, &ids, &own);
    out.all_signed(ids.iter().map(|&id| i32::from(width(semibold, id)) - i32::from(width(regular, id))));
    for axis in 0..2 {
        let all = |outlines: &[Outline]| -> Vec<i32> {
            outlines.iter().flat_map(|outline| outline.ways[axis].clone()).collect()
        };
        out.all_signed(all(&own).into_iter().zip(all(&bold)).map(|(own, bold)| bold - own));
    }
    let faces = [regular, semibold];
    if known.is_empty() {
        kerning(&mut out, faces, &ids);
    } else {
        more_kerning(&mut out, faces, known, &ids);
    }
    out.0
}

/// The kerning of a pair in both weights.
fn pair(faces: [&Loaded; 2], left: u16, right: u16) -> [i32; 2] {
    faces.map(|face| i32::from(units(face, left, right)))
}

/// The kerning of all pairs of glyphs of words.
fn kerning(out: &mut Numbers, faces: [&Loaded; 2], order: &[u16]) {
    let pair = |left, right| pair(faces, left, right);
    let rows: Vec<Vec<_>> = order.iter().map(|&l| order.iter().map(|&r| pair(l, r)).collect()).collect();
    let columns: Vec<Vec<_>> = (0..order.len()).map(|k| rows.iter().map(|row| row[k]).collect()).collect();
    let ((lefts, of_left), (rights, of_right)) = (kinds(&rows), kinds(&columns));
    out.count(lefts.len());
    out.count(rights.len());
    for &kind in of_left.iter().chain(&of_right) {
        out.count(kind);
    }
    let pairs = || lefts.iter().flat_map(|&left| rights.iter().map(move |&right| (left, right)));
    let kernings: Vec<_> = pairs().map(|(left, right)| rows[left][right]).collect();
    both_weights(out, &kernings);
}

/// The kerning of pairs with a new glyph, one by one: they are few.
fn more_kerning(out: &mut Numbers, faces: [&Loaded; 2], known: &BTreeSet<u16>, ids: &[u16]) {
    let order: Vec<u16> = known.iter().chain(ids).copied().collect();
    let places = (0..order.len()).flat_map(|left| (0..order.len()).map(move |right| (left, right)));
    let is_new = |&(left, right): &(usize, usize)| left.max(right) >= known.len();
    let all =
        places.filter(is_new).map(|(left, right)| (left, right, pair(faces, order[left], order[right])));
    let pairs: Vec<_> = all.filter(|(.., kerning)| *kerning != [0; 2]).collect();
    out.count(pairs.len());
    let mut before = 0;
    for (left, ..) in &pairs {
        out.count(left - before);
        before = *left;
    }
    for (_, right, _) in &pairs {
        out.count(*right);
    }
    both_weights(out, &pairs.iter().map(|(.., kerning)| *kerning).collect::<Vec<_>>());
}

/// Numbers of the regular weight, and by how much more those of the semibold one are.
fn both_weights(out: &mut Numbers, numbers: &[[i32; 2]]) {
    out.all_signed(numbers.iter().map(|[regular, _]| *regular));
    out.all_signed(numbers.iter().map(|[regular, semibold]| semibold - regular));
}

/// The kinds of rows: where each has its first one, and the kind of every row, 0 for one of zeros alone.
fn kinds(rows: &[Vec<[i32; 2]>]) -> (Vec<usize>, Vec<usize>) {
    let mut firsts: Vec<usize> = Vec::new();
    let of = rows.iter().enumerate().map(|(at, row)| {
        if row.iter().all(|pair| *pair == [0; 2]) {
            return 0;
        }
        let known = firsts.iter().position(|&first| rows[first] == *row).unwrap_or(firsts.len());
        if known == firsts.len() {
            firsts.push(at);
        }
        known + 1
    });
    let of = of.collect();
    (firsts, of)
}
