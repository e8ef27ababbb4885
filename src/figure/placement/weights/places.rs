//! Where a label may stand about what it belongs to, and how little it likes to.

super::numbers! {
    /// Places, and the reluctance to take them.
    Places {
        /// Room between a label and what it belongs to, page pixels: the first ring of places.
        gap: f64 = 5.0;
        /// Room on the second ring of places, page pixels.
        second_gap: f64 = 10.0;
        /// Room on the third ring, page pixels.
        third_gap: f64 = 16.0;
        /// Room on the last ring, whose places have a leader line, page pixels.
        far_gap: f64 = 27.0;
        /// Reluctance to stand on the second ring.
        second_ring: f64 = 3.0;
        /// Reluctance to stand on the third ring.
        third_ring: f64 = 7.0;
        /// Reluctance to stand on the last ring.
        far_ring: f64 = 16.0;
        /// A label farther from its point than this share of `far_gap` gets a leader line.
        led: f64 = 0.7;
        /// Room between either end of a leader line and what it joins, page pixels.
        leader_room: f64 = 2.0;
        /// Reluctance to stand in each of the eight directions about a point, from the east
        /// counter-clockwise. Mapmakers put names right above their place if they can.
        around: [f64; 8] = [0.6, 0.0, 1.2, 1.4, 1.8, 2.4, 2.0, 1.6];
        /// Reluctance to stand square to the side that a layer asked for; opposite to it, twice as much.
        astray: f64 = 3.0;
        /// How much of `around` counts where a layer asked for a side: enough to choose between two as near
        /// to it.
        around_asked: f64 = 0.05;
        /// Reluctance to stand at the second and third of a line's places instead of the first.
        off_best: f64 = 1.0;
        /// Reluctance to stand at the fourth or fifth of a line's places.
        off_end: f64 = 2.2;
        /// Reluctance to stand on the worse side of a line, vector or arc: below it, or inside the arc.
        other_side: f64 = 0.6;
        /// Reluctance to stand beside a vector's tip instead of beyond it.
        beside_tip: f64 = 0.5;
        /// How far before a vector's tip the first place beside it is, page pixels.
        before_tip: f64 = 6.0;
        /// Reluctance to stand between a dimension line and what it measures.
        inner_side: f64 = 2.0;
        /// Reluctance to stand beyond an end of a line instead of beside it.
        beyond_end: f64 = 3.0;
        /// Room beyond an end of a line, in gaps.
        beyond_gaps: f64 = 2.0;
        /// Room between a note and the panel's edges, page pixels.
        inset: f64 = 8.0;
        /// How far a note is moved along its edge of the panel, or away from it, at each try, page pixels.
        note_step: f64 = 32.0;
        /// Reluctance for each page pixel that a note is moved from its corner.
        note_moved: f64 = 0.03;
        /// A name's places inside an area are looked for on a grid of this many points along the longer side.
        grid: usize = 22;
        /// How many places inside its area a name is offered.
        inside: usize = 20;
        /// How many of the grid's best points are refined.
        refined: usize = 4;
        /// Reluctance to stand on the area's boundary instead of at its pole, the remotest point from it.
        off_pole: f64 = 5.0;
        /// Reluctance to stand as far from the area's middle as its line is: among places as remote, the
        /// middle one.
        off_middle: f64 = 0.8;
        /// Places inside an area are at least this share of the name's width from each other.
        spread: f64 = 0.25;
        /// Places inside an area are at least this far from each other, page pixels.
        least_spread: f64 = 10.0;
        /// Room between a name and its area's line, page pixels.
        area_room: f64 = 5.0;
        /// A name nearer than this to another area, page pixels, touches it.
        shared_room: f64 = 2.0;
        /// Reluctance of a name to stand in a part of its area that another area covers.
        shared: f64 = 9.0;
        /// Reluctance of a name to stand outside its area.
        outside: f64 = 7.0;
        /// Reluctance to take each next of the eight directions about an area, from the upper right.
        outside_next: f64 = 0.3;
    }
}
