//! How an answer turned out, in a clause: what a note gives as its reason.

use crate::collision::{Answer, Contact, Outcome};

/// How an answer turned out, as "the answer is a miss".
pub(crate) fn standing(answer: &Answer) -> &'static str {
    match answer {
        Answer::Impact(impact) => match impact.outcome {
            Outcome::Hit { .. } => "the answer is a hit",
            Outcome::Miss => "the answer is a miss",
            Outcome::Overlapping { .. } => "the bodies overlap from the start",
            Outcome::Unresolved { .. } => "the answer is unresolved",
        },
        Answer::Separation(separation) | Answer::Contact(Contact { separation, .. }) => {
            match separation.bounds {
                bounds if bounds.lo > 0.0 => "the bodies are apart",
                bounds if bounds.hi < 0.0 => "the bodies overlap",
                _ => "the bodies touch",
            }
        }
        Answer::Overlap(found) => match found.overlap {
            Some(true) => "the bodies overlap",
            Some(false) => "the bodies do not overlap",
            None => "rounding forbids to say whether the bodies overlap",
        },
        Answer::Bounds(_) => "the answer is a box",
        Answer::MotionBound(_) => "the answer is a length",
    }
}

/// Why an answer lacks a value that others of its kind have, in a clause.
pub(crate) fn lacking(answer: &Answer) -> &'static str {
    let points = if let Answer::Contact(contact) = answer { Some(contact.found().count()) } else { None };
    match points {
        Some(0) => "there is no point of contact",
        Some(1) => "there is one point of contact",
        _ => standing(answer),
    }
}
