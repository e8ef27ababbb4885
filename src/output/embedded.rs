//! A figure inside another file: a picture that says nothing of itself, as the file does.

use super::{IMAGE, Options, OutputError, Writer};
use crate::drawing::Drawing;

/// A figure without what it says of itself: no hash, no answer, no numbers of a trace.
pub(super) fn mute(figure: &Drawing) -> Drawing {
    Drawing { hash: String::new(), metadata: String::new(), ..figure.clone() }
}

/// A figure as an image that says nothing of itself: a student reads all of it.
pub(super) fn image(figure: &Drawing, options: &Options) -> Result<Vec<u8>, OutputError> {
    let mute = mute(figure);
    match IMAGE.write {
        Writer::One(write) => write(&mute, options),
        Writer::Sequence(write) => write(&[&mute], options),
    }
}
