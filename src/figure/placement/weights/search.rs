//! How long the search for better places goes on.

super::numbers! {
    /// Limits of the search, and what makes it try harder.
    Search {
        /// Two labels of one key and text name the same thing if what they belong to is nearer than this,
        /// page pixels.
        same_thing: f64 = 12.0;
        /// A label that costs more than this where it stands is offered places about its places.
        trouble: f64 = 8.0;
        /// How many of its cheapest places a label tries while it displaces others, and is offered more
        /// places about.
        cheapest: usize = 12;
        /// How far a label in trouble is moved from one of its places at most, page pixels.
        nudge: f64 = 24.0;
        /// By how many page pixels at a time.
        nudge_step: f64 = 4.0;
        /// Reluctance for each page pixel of that.
        nudged: f64 = 0.16;
        /// A label that costs more than this where it stands may displace others to stand better.
        uneasy: f64 = 3.0;
        /// Labels that still overlap by this many page pixels in both directions: the weaker one is left out.
        clash: f64 = 1.0;
    }
}
