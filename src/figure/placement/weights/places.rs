//! Where a label may stand about what it belongs to, and how little it likes to.

super::numbers! {
    /// Places, and the reluctance to take them.
    Places {
        /// Room between a label and what it belongs to, page pixels: the first ring of places.
        /// Twice: 291 + 479 labels; half: 281 + 479 labels, three faults more.
        gap: f64 = 6.0;
        /// Room on the second ring of places, page pixels.
        /// Twice: 70 + 231 labels, one fault more; half: 49 + 194 labels.
        second_gap: f64 = 11.0;
        /// Room on the third ring, page pixels.
        /// Twice: 6 + 41 labels, two faults more; half: 3 + 17 labels.
        third_gap: f64 = 16.0;
        /// Room on the fourth ring, whose places have a leader line, page pixels.
        /// Twice: 17 + 69 labels, one fault fewer; half: 27 + 59 labels, one fault fewer.
        far_gap: f64 = 27.0;
        /// Room on the last ring about a point, as far as a leader line goes, page pixels.
        /// Twice: 6 + 27 labels; half: 6 + 11 labels.
        last_gap: f64 = 38.0;
        /// Reluctance to stand on the second ring.
        /// Twice: 14 + 57 labels; half: 31 + 60 labels.
        second_ring: f64 = 3.0;
        /// Reluctance to stand on the third ring.
        /// Twice: 2 + 6 labels; half: 17 + 51 labels.
        third_ring: f64 = 7.0;
        /// Reluctance to stand on the fourth ring.
        /// Twice: 6 + 25 labels; half: 3 + 26 labels.
        far_ring: f64 = 16.0;
        /// Reluctance to stand on the last ring.
        /// Twice: 2 + 8 labels; half: 3 + 31 labels.
        last_ring: f64 = 19.0;
        /// A label farther from its point than this share of `far_gap` gets a leader line.
        /// Twice: 15 + 59 labels, one fault more; half: 24 + 41 labels, one fault more.
        led: f64 = 0.7;
        /// Room between either end of a leader line and what it joins, page pixels.
        /// Twice: 2 + 36 labels, one fault fewer; half: 1 + 8 labels, one fault more.
        leader_room: f64 = 2.0;
        /// Reluctance for each page pixel that a place over the panel's edge is moved to lie within: at none,
        /// a name leaves the middle under its marker.
        /// Twice: 9 + 14 labels; half: 0 + 18 labels.
        kept_in: f64 = 0.2;
        /// How far within the panel's edge such a place is moved, page pixels.
        from_edge: f64 = 3.0;
        /// Reluctance of a name to be broken into lines, for each line.
        /// Twice: 2 + 23 labels; half: 3 + 28 labels.
        folded: f64 = 1.0;
        /// Reluctance of a name to be broken in its words.
        /// Twice: 0 + 13 labels; half: 0 + 21 labels.
        broken: f64 = 7.0;
        /// Reluctance of a sum to have its result on a line of its own: it is read in one go. At none, a gap
        /// of `separating-axes` has it below, where a line suffices.
        /// Twice and half: nothing.
        result_below: f64 = 12.0;
        /// Reluctance of a formula to name its bodies by a few of their letters: more than to stand anywhere
        /// whole, less than what it costs to hide something.
        /// Twice and half: nothing.
        brief: f64 = 20.0;
        /// Reluctance to have a leader line where a label stands near its thing, but as near to another one;
        /// and to have none where it stands off an end of a line.
        /// Twice: 1 + 4 labels; half: 0 + 2 labels.
        lead: f64 = 5.0;
        /// How far a leader line reaches into an area, page pixels.
        /// Twice: 0 + 9 labels; half: 1 + 14 labels.
        leader_depth: f64 = 6.0;
        /// Reluctance to stand in each of the eight directions about a point, from the east
        /// counter-clockwise. Mapmakers put names right above their place if they can.
        /// Twice: 5 + 21 labels; half: 9 + 22 labels.
        around: [f64; 8] = [0.6, 0.0, 1.2, 1.4, 1.8, 2.4, 2.0, 1.6];
        /// Reluctance to stand square to the side that a layer asked for; opposite to it, twice as much.
        /// Twice: 7 + 40 labels; half: 17 + 47 labels.
        astray: f64 = 3.0;
        /// Reluctance of the number at a tick of an axis, as `astray` of others: aside it seems to be of
        /// another value.
        /// Twice and half: not counted.
        off_tick: f64 = 12.0;
        /// How much of `around` counts where a layer asked for a side: enough to choose between two as near
        /// to it.
        /// Twice: 0 + 4 labels; half: 0 + 2 labels.
        around_asked: f64 = 0.05;
        /// Reluctance to stand at the second and third of a line's places instead of the first.
        /// Twice: 13 + 12 labels; half: 13 + 9 labels.
        off_best: f64 = 1.0;
        /// Reluctance to stand at the fourth or fifth of a line's places.
        /// Twice: 9 + 9 labels; half: 5 + 19 labels.
        off_end: f64 = 2.2;
        /// Reluctance to stand on the worse side of a line, vector or arc: below it, or inside the arc.
        /// Twice: 13 + 3 labels; half: 2 + 5 labels.
        other_side: f64 = 0.6;
        /// Reluctance to stand beside a vector's tip instead of beyond it.
        /// Twice: 4 + 2 labels; half: 0 + 1 labels.
        beside_tip: f64 = 0.5;
        /// How far before a vector's tip the first place beside it is, page pixels.
        /// Twice: 17 + 18 labels; half: 14 + 15 labels.
        before_tip: f64 = 6.0;
        /// Reluctance to stand between a dimension line and what it measures.
        /// Twice: 2 + 8 labels; half: 2 + 0 labels.
        inner_side: f64 = 2.0;
        /// Reluctance to stand beyond an end of a line instead of beside it.
        /// Twice: 3 + 14 labels; half: 6 + 10 labels.
        beyond_end: f64 = 3.0;
        /// Reluctance to stand around a line that is shorter than its label, instead of beside it.
        /// Twice: 0 + 4 labels; half: 3 + 8 labels.
        about_short: f64 = 8.0;
        /// Room beyond an end of a line, in gaps.
        /// Twice: 13 + 36 labels; half: 10 + 36 labels.
        beyond_gaps: f64 = 2.0;
        /// Room between a note and the panel's edges, page pixels.
        /// Twice: 6 + 0 labels; half: 6 + 0 labels.
        inset: f64 = 8.0;
        /// How far a note is moved along its edge of the panel, or away from it, at each try, page pixels.
        /// Twice and half: nothing.
        note_step: f64 = 32.0;
        /// Reluctance for each page pixel that a note is moved from its corner.
        /// Twice and half: nothing.
        note_moved: f64 = 0.03;
        /// A name's places inside an area are looked for on a grid of this many points along the longer side.
        /// Twice: 43 + 200 labels; half: 40 + 188 labels.
        grid: usize = 22;
        /// How many places inside its area a name is offered.
        /// Twice: 1 + 15 labels; half: 4 + 34 labels.
        inside: usize = 20;
        /// How many of the grid's best points are refined.
        /// Twice: 7 + 29 labels; half: 10 + 18 labels.
        refined: usize = 4;
        /// Reluctance to stand on the area's boundary instead of at its pole, the remotest point from it.
        /// Twice: 13 + 63 labels; half: 9 + 30 labels.
        off_pole: f64 = 5.0;
        /// Reluctance to stand as far from the area's middle as its line is: among places as remote, the
        /// middle one.
        /// Twice: 9 + 11 labels; half: 3 + 26 labels.
        off_middle: f64 = 0.8;
        /// Places inside an area are at least this share of the name's width from each other.
        /// Twice: 3 + 58 labels; half: 2 + 52 labels.
        spread: f64 = 0.25;
        /// Places inside an area are at least this far from each other, page pixels.
        /// Twice: 12 + 67 labels; half: 9 + 46 labels.
        least_spread: f64 = 10.0;
        /// Room between a name and its area's line, page pixels.
        /// Twice: 27 + 294 labels, four faults more; half: 26 + 235 labels, three faults more.
        area_room: f64 = 6.0;
        /// A name nearer than this to another area, page pixels, touches it.
        /// Twice: 6 + 7 labels; half: 1 + 1 labels.
        shared_room: f64 = 2.0;
        /// Reluctance of a name to stand in a part of its area that another area covers.
        /// Twice: 0 + 2 labels; half: nothing.
        shared: f64 = 9.0;
        /// Reluctance of a name to stand outside its area.
        /// Twice: 0 + 43 labels; half: 4 + 129 labels.
        outside: f64 = 7.0;
        /// Reluctance to take each next of the eight directions about an area, from the upper right.
        /// Twice: 6 + 50 labels, two faults more; half: 1 + 45 labels.
        outside_next: f64 = 0.3;
        /// Room between an area and a name that stands off it, with a leader line, page pixels.
        /// Twice: 3 + 28 labels; half: 6 + 27 labels, two faults more.
        area_rings: [f64; 2] = [19.5, 31.0];
        /// Reluctance to stand on the first of these rings; on the second, twice as much.
        /// Twice: 0 + 21 labels; half: 4 + 40 labels, two faults more.
        area_ring: f64 = 4.0;
        /// How many points along its area's line a name may stand beside, besides the eight directions.
        /// Twice: 6 + 50 labels, one fault more; half: 4 + 44 labels, two faults more.
        beside_area: usize = 12;
        /// Reluctance to stand beside one of those points, in steps of `outside_next`.
        /// Twice: 4 + 37 labels, two faults more; half: 1 + 53 labels.
        off_eight: f64 = 9.0;
    }
}

impl Places {
    /// The places beside what reaches so far, page pixels.
    pub(in crate::figure::placement) fn beside(&self, reach: f64) -> Self {
        Self { gap: self.gap + reach, second_gap: self.second_gap + reach, ..self.clone() }
    }
}
