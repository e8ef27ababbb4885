//! How far two bodies are apart at moments that curves ask for: each moment once, though a figure is sketched
//! to see what it reaches before it is drawn.

use std::sync::{Mutex, PoisonError};

use crate::collision::{Pair, Separation};
use crate::geometry::Body;

/// The separations of a figure's two bodies with the bits of their moments, in the order of these.
#[derive(Debug, Default)]
pub(crate) struct Distances(Mutex<Vec<(u64, Separation)>>);

impl Distances {
    /// The separation of the figure's bodies at a moment, which are always the same two.
    pub(crate) fn at(&self, a: &Body, b: &Body, time: f64) -> Separation {
        let mut known = self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let bits = time.to_bits();
        match known.binary_search_by(|(other, _)| other.cmp(&bits)) {
            Ok(at) => known[at].1,
            Err(at) => {
                let found = Pair::at(a, b, time).separation();
                known.insert(at, (bits, found));
                found
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::open_text;

    #[test]
    fn what_is_kept_is_what_is_found_afresh() {
        let text = "shapes.A = { kind = 'circle', radius = 1, velocity = [1, 0] }
            shapes.B = { kind = 'circle', radius = 1, position = [5, 0] }
            query = { kind = 'linear-sweep', of = ['A', 'B'] }";
        let scene = open_text("apart", text).unwrap().scene;
        let query = scene.query_of_bodies();
        let distances = Distances::default();
        for (time, apart) in [(0.0, 3.0), (0.5, 2.5), (0.0, 3.0), (1.0, 2.0)] {
            let found = distances.at(query.a, query.b.unwrap(), time).separation;
            assert_eq!(found.to_bits(), f64::to_bits(apart), "at {time}");
        }
    }
}
