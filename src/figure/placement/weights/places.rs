//! Where a label may stand about what it belongs to, and how little it likes to.

super::numbers! {
    /// Places, and the reluctance to take them.
    Places {
        /// Room between a label and what it belongs to, page pixels: the first ring of places.
        /// Twice: 111 + 1737 labels, one fault more; half: 108 + 1709 labels, two faults more.
        gap: f64 = 5.0;
        /// Room on the second ring of places, page pixels.
        /// Twice: 22 + 947 labels, two faults fewer; half: 20 + 826 labels, one fault fewer.
        second_gap: f64 = 10.0;
        /// Room on the third ring, page pixels.
        /// Twice: 1 + 38 labels, one fault more; half: 0 + 27 labels.
        third_gap: f64 = 16.0;
        /// Room on the fourth ring, whose places have a leader line, page pixels.
        /// Twice: 0 + 8 labels; half: 1 + 20 labels.
        far_gap: f64 = 27.0;
        /// Room on the last ring about a point, as far as a leader line goes, page pixels.
        last_gap: f64 = 38.0;
        /// Reluctance to stand on the second ring.
        /// Twice: 6 + 116 labels; half: 9 + 168 labels.
        second_ring: f64 = 3.0;
        /// Reluctance to stand on the third ring.
        /// Twice: 0 + 15 labels; half: 8 + 80 labels.
        third_ring: f64 = 7.0;
        /// Reluctance to stand on the fourth ring.
        /// Twice: 0 + 7 labels; half: 0 + 19 labels.
        far_ring: f64 = 16.0;
        /// Reluctance to stand on the last ring.
        last_ring: f64 = 19.0;
        /// A label farther from its point than this share of `far_gap` gets a leader line.
        /// Twice: 0 + 9 labels; half: 0 + 10 labels.
        led: f64 = 0.7;
        /// Room between either end of a leader line and what it joins, page pixels.
        /// Twice and half: nothing that the survey sees, which looks at labels and not at leader lines.
        leader_room: f64 = 2.0;
        /// Reluctance of a name to be broken into lines, for each line.
        folded: f64 = 1.0;
        /// Reluctance of a name to be broken in its words.
        broken: f64 = 7.0;
        /// Reluctance to have a leader line where a label stands near its thing, but as near to another one.
        lead: f64 = 5.0;
        /// How far a leader line reaches into an area, page pixels.
        leader_depth: f64 = 6.0;
        /// Reluctance to stand in each of the eight directions about a point, from the east
        /// counter-clockwise. Mapmakers put names right above their place if they can.
        /// Twice: 1 + 67 labels; half: 2 + 77 labels.
        around: [f64; 8] = [0.6, 0.0, 1.2, 1.4, 1.8, 2.4, 2.0, 1.6];
        /// Reluctance to stand square to the side that a layer asked for; opposite to it, twice as much.
        /// Twice: 4 + 66 labels; half: 6 + 55 labels.
        astray: f64 = 3.0;
        /// How much of `around` counts where a layer asked for a side: enough to choose between two as near
        /// to it.
        /// Twice: 0 + 6 labels; half: 0 + 5 labels.
        around_asked: f64 = 0.05;
        /// Reluctance to stand at the second and third of a line's places instead of the first.
        /// Twice: 8 + 60 labels; half: 3 + 64 labels.
        off_best: f64 = 1.0;
        /// Reluctance to stand at the fourth or fifth of a line's places.
        /// Twice: 1 + 33 labels; half: 6 + 54 labels.
        off_end: f64 = 2.2;
        /// Reluctance to stand on the worse side of a line, vector or arc: below it, or inside the arc.
        /// Twice: 6 + 49 labels; half: 0 + 28 labels.
        other_side: f64 = 0.6;
        /// Reluctance to stand beside a vector's tip instead of beyond it.
        /// Twice: 0 + 5 labels; half: 0 + 4 labels.
        beside_tip: f64 = 0.5;
        /// How far before a vector's tip the first place beside it is, page pixels.
        /// Twice: 3 + 63 labels; half: 2 + 30 labels.
        before_tip: f64 = 6.0;
        /// Reluctance to stand between a dimension line and what it measures.
        /// Twice: 1 + 8 labels; half: 0 + 4 labels.
        inner_side: f64 = 2.0;
        /// Reluctance to stand beyond an end of a line instead of beside it.
        /// Twice: 0 + 84 labels; half: 3 + 41 labels.
        beyond_end: f64 = 3.0;
        /// Reluctance to stand around a line that is shorter than its label, instead of beside it.
        about_short: f64 = 8.0;
        /// Room beyond an end of a line, in gaps.
        /// Twice: 3 + 321 labels, two faults fewer; half: 2 + 282 labels, three faults more.
        beyond_gaps: f64 = 2.0;
        /// Room between a note and the panel's edges, page pixels.
        /// Twice: 5 + 0 labels; half: 5 + 0 labels.
        inset: f64 = 8.0;
        /// How far a note is moved along its edge of the panel, or away from it, at each try, page pixels.
        /// Twice and half: nothing that the survey sees; notes stand at their corner in all figures, and
        /// random scenes have none.
        note_step: f64 = 32.0;
        /// Reluctance for each page pixel that a note is moved from its corner.
        /// Twice and half: nothing that the survey sees, as for `note_step`.
        note_moved: f64 = 0.03;
        /// A name's places inside an area are looked for on a grid of this many points along the longer side.
        /// Twice: 28 + 1055 labels; half: 27 + 982 labels.
        grid: usize = 22;
        /// How many places inside its area a name is offered.
        /// Twice: 3 + 66 labels; half: 4 + 164 labels.
        inside: usize = 20;
        /// How many of the grid's best points are refined.
        /// Twice: 6 + 151 labels; half: 12 + 139 labels.
        refined: usize = 4;
        /// Reluctance to stand on the area's boundary instead of at its pole, the remotest point from it.
        /// Twice: 7 + 238 labels; half: 10 + 179 labels.
        off_pole: f64 = 5.0;
        /// Reluctance to stand as far from the area's middle as its line is: among places as remote, the
        /// middle one.
        /// Twice: 6 + 90 labels; half: 4 + 53 labels.
        off_middle: f64 = 0.8;
        /// Places inside an area are at least this share of the name's width from each other.
        /// Twice: 1 + 111 labels; half: 0 + 29 labels.
        spread: f64 = 0.25;
        /// Places inside an area are at least this far from each other, page pixels.
        /// Twice: 12 + 663 labels; half: 11 + 419 labels.
        least_spread: f64 = 10.0;
        /// Room between a name and its area's line, page pixels.
        /// Twice: 5 + 503 labels; half: 3 + 228 labels.
        area_room: f64 = 5.0;
        /// A name nearer than this to another area, page pixels, touches it.
        /// Twice: 0 + 11 labels; half: 0 + 1 labels.
        shared_room: f64 = 2.0;
        /// Reluctance of a name to stand in a part of its area that another area covers.
        /// Twice: 1 + 0 labels; half: nothing.
        shared: f64 = 9.0;
        /// Reluctance of a name to stand outside its area.
        /// Twice: 1 + 91 labels; half: 4 + 163 labels.
        outside: f64 = 7.0;
        /// Reluctance to take each next of the eight directions about an area, from the upper right.
        /// Twice: 0 + 40 labels; half: 0 + 28 labels.
        outside_next: f64 = 0.3;
        /// Room between an area and a name that stands off it, with a leader line, page pixels.
        area_rings: [f64; 2] = [19.5, 31.0];
        /// Reluctance to stand on the first of these rings; on the second, twice as much.
        area_ring: f64 = 4.0;
        /// How many points along its area's line a name may stand beside, besides the eight directions.
        beside_area: usize = 12;
        /// Reluctance to stand beside one of those points, in steps of `outside_next`.
        off_eight: f64 = 9.0;
    }
}
