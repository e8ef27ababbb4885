//! How long the search for better places goes on.

super::numbers! {
    /// Limits of the search, and what makes it try harder.
    Search {
        /// Two labels of one key and text name the same thing if what they belong to is nearer than this,
        /// page pixels.
        /// Twice and half: nothing that the survey sees; only at 0 do labels move.
        same_thing: f64 = 12.0;
        /// A label that costs more than this where it stands is offered places about its places.
        /// Twice: 6 + 168 labels, one fault more; half: 11 + 279 labels.
        trouble: f64 = 8.0;
        /// How many of its cheapest places a label tries while it displaces others, and is offered more
        /// places about. Twice: 2 + 94 labels, four faults fewer; half: 1 + 141 labels, eight faults more.
        cheapest: usize = 12;
        /// How far a label in trouble is moved from one of its places at most, page pixels.
        /// Twice: 0 + 106 labels, five faults fewer; half: 0 + 199 labels, twelve faults more.
        nudge: f64 = 24.0;
        /// How far apart the places are that a label in trouble is moved to, page pixels.
        /// Twice: 5 + 212 labels, one fault more; half: 5 + 191 labels.
        nudge_step: f64 = 4.0;
        /// Reluctance for each page pixel that a label in trouble is moved.
        /// Twice: 1 + 187 labels; half: 2 + 118 labels.
        nudged: f64 = 0.16;
        /// A label that costs more than this where it stands may displace others to stand better.
        /// Twice: 2 + 46 labels; half: 0 + 12 labels.
        uneasy: f64 = 3.0;
        /// Labels that still overlap by this many page pixels in both directions: the weaker one is left out.
        /// Twice and half: nothing that the survey sees.
        clash: f64 = 1.0;
    }
}
