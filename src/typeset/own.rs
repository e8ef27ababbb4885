//! The glyphs that the module of live pages has of itself: what our words and layers say in English.

use std::sync::OnceLock;

use super::needed::Glyphs;

/// Characters that our words and numbers have, and what marks bodies in legends.
const WORDS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789 .,:;’'“”-()=+−·×°–…/%?_\
                     ′≤≥≈∞●■◆\u{202f}\u{a0}";

/// Formulas that have between them what our layers write: numbers and signs, the letters of quantities, what
/// stands below them, and words.
///
/// What stands below them is also what most scenes put there, as `d_{t = 0.5}` and `E_h`. All small letters,
/// and all of them in scripts, would be 4.3 kB of the face where these are 1.9, and most pages need none.
const FORMULAS: [&str; 7] = [
    r"0123456789 = < > + - ( ) [ ] | , {,} ; . : / ' ° \| \cdot \times \approx \le \ge \ominus \ldots",
    r"a b c d e h i m n o p q r s t u v w x y A B D E I L N O P R V \theta \omega",
    r"t_{0123456789 -,aceinqxy} A_{A''}'' B_{B''} a_{a''} b_{b''}",
    r"x_{dhmpt E = . ( )}",
    r"x_{\min} x_{\max}",
    r"\mathrm{clamp}",
    r"\text{a} \text{a} \text{a} \text{a}",
];

/// The glyphs of all these.
pub(super) fn own() -> &'static Glyphs {
    static OWN: OnceLock<Glyphs> = OnceLock::new();
    OWN.get_or_init(|| {
        let mut own = Glyphs::default();
        WORDS.chars().for_each(|character| own.take_character(character));
        for formula in FORMULAS {
            own.take(&format!("${formula}$"));
        }
        own.grow();
        own
    })
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;
    use std::fs;
    use std::path::Path;

    use super::super::{brought, packed};
    use super::own;

    /// With `TRACEFIG_WRITE` the files are written anew.
    #[test]
    fn the_packed_faces_of_live_pages_are_these_glyphs() {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src/typeset/fonts");
        let (none, own) = (BTreeSet::new(), own());
        let wanted = [packed::words(&none, &own.words), packed::formulas(&none, &own.formulas)];
        for ((wanted, file), name) in wanted.into_iter().zip(brought::FILES).zip(brought::NAMES) {
            if std::env::var_os("TRACEFIG_WRITE").is_some() {
                fs::write(folder.join(format!("live-{name}.face")), wanted).unwrap();
            } else {
                assert!(
                    wanted == file,
                    "`TRACEFIG_WRITE=1 cargo test --lib typeset::own` writes live-{name}.face"
                );
            }
        }
    }
}
