//! What a place costs for what lies there.

super::numbers! {
    /// Costs of hiding, touching, crowding and misleading.
    Costs {
        /// Room that labels keep from strokes of other things, page pixels.
        /// Twice: 62 + 223 labels, five faults more; half: 26 + 79 labels, three faults more.
        stroke_room: f64 = 2.0;
        /// Touching an outline, vector or dimension of something else.
        /// Twice: 5 + 30 labels, three faults more; half: 3 + 28 labels, one fault fewer.
        stroke: f64 = 18.0;
        /// Each page pixel of such a stroke inside the label.
        /// Twice: 2 + 27 labels, two faults more; half: 3 + 8 labels.
        stroke_px: f64 = 0.5;
        /// Touching a construction line, a ghost or an axis of something else, or any stroke of the thing
        /// that the label belongs to.
        /// Twice: 2 + 20 labels, two faults fewer; half: 5 + 24 labels.
        light: f64 = 11.0;
        /// Each page pixel of such a stroke inside the label.
        /// Twice: 1 + 12 labels; half: 1 + 12 labels.
        light_px: f64 = 0.3;
        /// A foreign stroke nearer than this crowds a label, page pixels.
        /// Twice: 57 + 335 labels; half: 28 + 223 labels.
        crowd_reach: f64 = 8.0;
        /// A foreign stroke right beside a label, falling to nothing at `crowd_reach`.
        /// Twice: 41 + 127 labels; half: 20 + 122 labels.
        crowd: f64 = 1.2;
        /// A line between a label and the point that it names.
        /// Twice: 5 + 4 labels; half: 1 + 8 labels.
        parted: f64 = 7.0;
        /// Room that labels keep from markers and arrowheads, page pixels.
        /// Twice: 22 + 61 labels, two faults more; half: 24 + 30 labels.
        marker_room: f64 = 1.5;
        /// Touching a marker or an arrowhead.
        /// Twice: 1 + 15 labels, one fault more; half: 5 + 10 labels, one fault more.
        marker: f64 = 30.0;
        /// A foreign marker nearer than this misleads, page pixels.
        /// Twice: 23 + 86 labels, two faults more; half: 14 + 31 labels.
        mislead_reach: f64 = 8.0;
        /// A foreign marker so near that a reader could take the label for its.
        /// Twice: 24 + 42 labels; half: 4 + 27 labels.
        mislead: f64 = 2.5;
        /// The name of an area seems to name a marker nearer than this, page pixels.
        /// Twice: 23 + 110 labels, two faults more; half: 10 + 54 labels.
        naming_reach: f64 = 30.0;
        /// A marker right beside the name of an area, falling to nothing at `naming_reach`.
        /// Twice: 3 + 36 labels, two faults more; half: 6 + 40 labels.
        naming: f64 = 6.0;
        /// How far a label may reach over the edge of its panel, page pixels: a quarter of the gap between
        /// panels.
        /// Twice: 0 + 23 labels, 15 faults more; half: 4 + 24 labels, two faults more. A label that reaches
        /// farther than it does as tuned is a fault, so most of those at twice are of this number's making.
        spill: f64 = 6.0;
        /// A label right at the panel's edge, falling to nothing at `rim_reach` within it: words that press
        /// on a frame look as if they had no room.
        /// Twice: 6 + 37 labels; half: 6 + 28 labels.
        rim: f64 = 3.0;
        /// How far from the panel's edge a label stands well, page pixels.
        /// Twice: 16 + 58 labels; half: 5 + 37 labels.
        rim_reach: f64 = 6.0;
        /// Each page pixel of reaching into that gap, off the ground of its panel.
        /// At 3 labels hang over grounds by some px where a place within is no worse; 1,000 scenes have as
        /// many faults with it, and no label of the figures moves.
        spilled_px: f64 = 8.0;
        /// Reaching farther over the panel's edge than `spill`.
        /// Twice and half: nothing.
        edge: f64 = 60.0;
        /// Each page pixel of reaching farther over the panel's edge than `spill`.
        /// Twice and half: nothing.
        edge_px: f64 = 2.0;
        /// Room that labels keep from each other, page pixels.
        /// Twice: 4 + 5 labels; half: 1 + 6 labels, one fault more.
        label_room: f64 = 3.0;
        /// Two labels that overlap, or come nearer than `label_room`.
        /// Twice: 0 + 3 labels, two faults more; half: nothing.
        overlap: f64 = 70.0;
        /// Two labels at this distance are as good as apart, page pixels.
        /// Twice: 55 + 157 labels; half: 25 + 91 labels.
        label_comfort: f64 = 18.0;
        /// Two labels that nearly touch, falling to nothing at `label_comfort`.
        /// Twice: 10 + 45 labels; half: 13 + 50 labels.
        close: f64 = 4.0;
        /// Two labels so near that a reader takes them for one, falling to nothing at `word`.
        /// Twice and half: not counted.
        as_one: f64 = 8.0;
        /// Two labels at this distance are no more read as one, page pixels.
        /// Twice and half: not counted.
        word: f64 = 9.0;
        /// A stroke under a leader line.
        /// Twice: 2 + 9 labels; half: 2 + 12 labels.
        leader: f64 = 3.0;
        /// A label or another leader line under a leader line.
        /// Twice and half: nothing.
        under: f64 = 40.0;
        /// Standing as near to another thing as to its own, or nearer, without a leader line.
        /// Twice: nothing; half: 2 + 7 labels.
        nearer: f64 = 40.0;
        /// How much nearer to its own thing than to any other a label should stand, page pixels.
        /// Twice: 15 + 49 labels; half: 7 + 22 labels.
        doubt_reach: f64 = 8.0;
        /// Standing just nearer to its own thing than to another one, falling to nothing at `doubt_reach`.
        /// Twice: 2 + 19 labels; half: 2 + 7 labels.
        doubt: f64 = 5.0;
        /// The label of a length standing in a body that the length lies beside; a part of it where a part of
        /// the label does. At half, labels stay in bodies above which there is room with a leader line.
        astray: f64 = 12.0;
        /// Standing elsewhere than the same label of the same thing in an earlier panel.
        /// Twice: 0 + 16 labels; half: 1 + 18 labels, two faults more.
        moved: f64 = 6.0;
        /// Things and labels of two panels are at the same place if they are nearer than this, page pixels.
        /// Twice: nothing; half: 0 + 2 labels.
        same_place: f64 = 1.0;
    }
}
