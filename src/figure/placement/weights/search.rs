//! How long the search for better places goes on.

super::numbers! {
    /// Limits of the search, and what makes it try harder.
    Search {
        /// Two labels of one key and text name the same thing if what they belong to is nearer than this,
        /// page pixels.
        /// Twice and half: nothing.
        same_thing: f64 = 12.0;
        /// A label that costs more than this where it stands is offered places about its places.
        /// Twice: 19 + 180 labels, two faults more; half: 22 + 75 labels.
        trouble: f64 = 8.0;
        /// How many of its cheapest places a label tries while it displaces others, and is offered more
        /// places about.
        /// Twice: 16 + 78 labels, two faults fewer; half: 19 + 73 labels, two faults more.
        cheapest: usize = 12;
        /// How far a label in trouble is moved from one of its places at most, page pixels.
        /// Twice: 9 + 39 labels, two faults fewer; half: 14 + 71 labels, two faults more.
        nudge: f64 = 24.0;
        /// How far apart the places are that a label in trouble is moved to, page pixels.
        /// Twice: 30 + 212 labels, one fault more; half: 23 + 187 labels, one fault more.
        nudge_step: f64 = 4.0;
        /// Reluctance for each page pixel that a label in trouble is moved.
        /// Twice: 17 + 122 labels; half: 20 + 85 labels.
        nudged: f64 = 0.16;
        /// A further place is not offered that costs this much more than where its label stands.
        /// Twice and half: nothing.
        hopeless: f64 = 10.0;
        /// How far apart the spots of the field are that a label looks at which hides something elsewhere,
        /// page pixels.
        /// Twice: 0 + 9 labels, one fault more; half: 0 + 12 labels, one fault more.
        field_step: f64 = 6.0;
        /// Reluctance to stand in that field.
        /// Twice: 0 + 1 labels; half: 0 + 2 labels.
        in_field: f64 = 6.0;
        /// Reluctance for each page pixel between a label in that field and its thing.
        /// Twice: nothing; half: 0 + 1 labels.
        field_off: f64 = 0.1;
        /// What hiding something costs such a label besides.
        /// Twice: nothing; half: 0 + 1 labels, one fault more.
        hiding: f64 = 30.0;
        /// A label that costs more than this where it stands may displace others to stand better.
        /// Twice: 2 + 4 labels; half: 0 + 7 labels.
        uneasy: f64 = 3.0;
        /// In a figure that moves, a label rests where it costs less than this beside its reluctance: less
        /// than what it costs to touch a line.
        /// Twice and half: nothing.
        comfort: f64 = 9.0;
        /// It rests too where its place costs no more than this more than when it was chosen.
        /// Twice and half: nothing.
        worse: f64 = 4.0;
        /// Two labels that rest may cost each other less than this; else the weaker one seeks another place.
        /// Twice and half: nothing.
        unrest: f64 = 8.0;
        /// How much cheaper its old place is to a label that seeks another one.
        /// Twice and half: nothing.
        inertia: f64 = 12.0;
        /// Labels that still overlap by this many page pixels in both directions: the weaker one is left out.
        /// Twice and half: nothing.
        clash: f64 = 1.0;
    }
}
