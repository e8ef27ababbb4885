//! A drawing as files: one for each format that is asked for, or one for each picture of a figure in time.

use std::sync::Arc;

use tracefig::drawing::Drawing;
use tracefig::drift::{hash_of_part, metadata, text_chunk};
use tracefig::output::{Format, Options, OutputError};

use super::apart::apart;
use super::in_time::InTime;
use super::jobs::{Planned, Target};
use super::timings::Timings;

/// One file, ready to be written.
pub(crate) struct Encoded {
    /// The file, byte for byte.
    pub(crate) bytes: Vec<u8>,
    /// What it shows; shared by the formats of a theme.
    pub(crate) drawing: Arc<Drawing>,
    /// What was asked of the format.
    pub(crate) options: Options,
    /// What it is written as.
    pub(crate) format: &'static Format,
    /// Where it goes.
    pub(crate) target: Target,
}

/// A drawing that says what it is of.
fn stamped(drawing: Drawing, hash: &str, facts: &str) -> Drawing {
    Drawing { hash: text_chunk(hash), metadata: metadata(hash, facts), ..drawing }
}

/// The files of a drawing in one theme, in the order of the plan; or why one of them can't be made. `asked`
/// says of each what is asked of its format, and its hash; `encode` makes a file of the whole.
pub(crate) fn encode_all<'p>(
    mut drawing: Drawing,
    (planned, in_time): (&'p [Planned], Option<InTime>),
    facts: &str,
    (asked, encode): (
        impl Fn(&Planned) -> (Options, String),
        impl Fn(&Drawing, &Planned, &Options) -> Result<Vec<u8>, OutputError>,
    ),
    timings: &mut Timings,
) -> Result<Vec<Encoded>, (&'p Planned, OutputError)> {
    let mut made: Vec<(Option<Arc<Drawing>>, Encoding)> = Vec::new();
    for planned in planned {
        let format = planned.format;
        let (options, hash) = asked(planned);
        let refused = |error| (planned, error);
        if let Some(pictures) = apart(&drawing, planned, in_time) {
            for one in pictures {
                let drawing = stamped(one.drawing, &hash_of_part(&hash, &one.key), facts);
                let bytes = format.encode(&drawing, &options).map_err(refused)?;
                made.push((Some(Arc::new(drawing)), (bytes, options, format, one.target)));
            }
        } else {
            drawing = stamped(drawing, &hash, facts);
            let bytes = encode(&drawing, planned, &options).map_err(refused)?;
            made.push((None, (bytes, options, format, planned.target.clone())));
        }
        timings.lap(format.name);
    }
    let whole = Arc::new(drawing);
    let file = |(own, (bytes, options, format, target)): (Option<Arc<Drawing>>, Encoding)| Encoded {
        bytes,
        drawing: own.unwrap_or_else(|| Arc::clone(&whole)),
        options,
        format,
        target,
    };
    Ok(made.into_iter().map(file).collect())
}

/// A file's bytes, with what was asked of its format, and where it goes.
type Encoding = (Vec<u8>, Options, &'static Format, Target);
