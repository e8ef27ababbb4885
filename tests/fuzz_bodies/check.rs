//! What the fuzz target `check` holds of any file in the place of a figure.

use std::sync::OnceLock;

use tracefig::drift::{
    Rendered, Stamp, compare, compare_and_show, metadata, text_chunk, triptych, what_moved,
};
use tracefig::figure::{draw, plan};
use tracefig::output::{FORMATS, Format, Options, Writer};
use tracefig::scene::open_text;

use super::choices::Choices;

/// Pixels for a page pixel, which is all that time depends on.
const SCALE: f64 = 0.25;

/// A small figure with a part of each sort: areas, patterns, lines, dashes, letters with halos.
const SCENE: &str = "title = 'T'\n[shapes.A]\nkind = 'box'\nhalf_extents = [1, 0.6]\n[shapes.B]\nkind = 'circle'\nradius = 1\n\
    position = [3, 1]\n[query]\nkind = 'separation'\nof = ['A', 'B']\n[[panels]]\nlayers = ['shapes', 'separation']\n\
    [canvas]\nwidth = 200\nheight = 160\ntheme = 'print'\n";

/// The figure in each format.
fn figures() -> &'static [(&'static Format, Vec<u8>)] {
    static FIGURES: OnceLock<Vec<(&'static Format, Vec<u8>)>> = OnceLock::new();
    FIGURES.get_or_init(|| {
        let Ok(file) = open_text("s.toml", SCENE) else { return Vec::new() };
        let Ok(plan) = plan(&file.scene) else { return Vec::new() };
        let mut drawing = draw(&plan, plan.theme, "fuzz").drawing;
        drawing.metadata =
            metadata("00", "\"answer\":{\"separation\":1.5},\"trace\":[[\"e\",[\"x\"],[1],[2]]]");
        drawing.hash = text_chunk("00");
        let options = Options { scale: SCALE, ..Options::default() };
        let written = |format: &'static Format| {
            let bytes = match format.write {
                Writer::One(write) => write(&drawing, &options),
                Writer::Sequence(write) => write(&[&drawing], &options),
            };
            (format, bytes.unwrap_or_default())
        };
        FORMATS.iter().map(written).collect()
    })
}

/// Any file in the place of a figure is compared with it, and what is said of it is something.
pub(crate) fn holds(bytes: &[u8]) {
    let mut choices = Choices::new(bytes);
    let Some((format, new)) = figures().get(choices.below(FORMATS.len())) else { return };
    let rest = bytes.get(1..).unwrap_or_default();
    let old = match rest.first() {
        // Checksums and lengths that fit, which no change of a byte would keep.
        Some(b'h') => image(&rest[1..]),
        // The figure with a part replaced.
        Some(b'e') => edited(new, &rest[1..]),
        _ => rest.to_vec(),
    };
    let now = Rendered { format, bytes: new, scale: SCALE };
    let state = compare(Some(&old), now);
    assert_eq!(compare_and_show(Some(&old), now).0, state);
    assert_eq!(old == *new, state.word() == "identical");
    let _ = triptych(format, &old, new, SCALE);
    let _ = Stamp::read(format, &old);
    assert!(what_moved(format, &old, new).iter().all(|line| !line.is_empty()));
}

/// A file with other bytes at some places: each place by two bytes, then how many go and how many come.
fn edited(file: &[u8], changes: &[u8]) -> Vec<u8> {
    let mut file = file.to_vec();
    let mut rest = changes;
    while let [a, b, gone, come, more @ ..] = rest {
        let at = (usize::from(*a) + (usize::from(*b) << 8)) % (file.len() + 1);
        let end = (at + usize::from(*gone % 32)).min(file.len());
        let (piece, after) = more.split_at(usize::from(*come % 32).min(more.len()));
        file.splice(at..end, piece.iter().copied());
        rest = after;
    }
    file
}

/// A PNG: its head by thirteen bytes, its pixels by the rest.
fn image(bytes: &[u8]) -> Vec<u8> {
    let (head, pixels) = bytes.split_at(bytes.len().min(13));
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    for (name, data) in [(b"IHDR", head), (b"IDAT", pixels), (b"IEND", &[])] {
        let checked = [&name[..], data].concat();
        file.extend(u32::try_from(data.len()).unwrap_or(0).to_be_bytes());
        file.extend(&checked);
        file.extend(checksum(&checked).to_be_bytes());
    }
    file
}

/// The checksum of a chunk (*Portable Network Graphics, Third Edition*, annex D).
fn checksum(bytes: &[u8]) -> u32 {
    let step = |crc: u32, _| if crc & 1 == 1 { (crc >> 1) ^ 0xedb8_8320 } else { crc >> 1 };
    !bytes.iter().fold(!0, |crc, &byte| (0..8).fold(crc ^ u32::from(byte), step))
}
