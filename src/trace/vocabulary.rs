//! The table of events, made of the one place where they are declared: a name, what it tells, and its fields.

/// A kind of event, as a trace writes it.
#[derive(Clone, Copy, Debug)]
pub struct EventKind {
    /// The name of its variant.
    pub(super) variant: &'static str,
    /// The lines of its doc, one after the other.
    pub(super) doc: &'static str,
    /// Its fields, all of them in every such event.
    pub fields: &'static [EventField],
}

/// A field of an event.
#[derive(Clone, Copy, Debug)]
pub struct EventField {
    /// Its key in a line.
    pub name: &'static str,
    /// The lines of its doc, one after the other.
    pub(super) doc: &'static str,
}

impl EventKind {
    /// The word under `event` in its lines.
    ///
    /// ```
    /// assert_eq!(tracefig::trace::EVENTS[0].name(), "started");
    /// assert!(tracefig::trace::EVENTS.iter().any(|kind| kind.name() == "axis-tested"));
    /// ```
    #[must_use]
    pub fn name(&self) -> String {
        let mut name = String::new();
        for letter in self.variant.chars() {
            if letter.is_ascii_uppercase() && !name.is_empty() {
                name.push('-');
            }
            name.push(letter.to_ascii_lowercase());
        }
        name
    }

    /// What it tells.
    ///
    /// ```
    /// assert!(tracefig::trace::EVENTS[0].about().starts_with("An algorithm began"));
    /// ```
    #[must_use]
    pub fn about(&self) -> String {
        written(self.doc)
    }
}

impl EventField {
    /// What it holds.
    ///
    /// ```
    /// assert_eq!(tracefig::trace::EVENTS[0].fields[1].about(), "The moment it looks at.");
    /// ```
    #[must_use]
    pub fn about(&self) -> String {
        written(self.doc)
    }
}

/// A doc as words of the JSON lines, in which a missing value is null.
fn written(doc: &str) -> String {
    doc.trim().replace("`None`", "null").replace("None", "null")
}

/// Declares the enum of events and, of its variants, fields and their docs, the table of events.
macro_rules! vocabulary {
    ($(#[$of_all:meta])* pub enum $Event:ident { $(
        $(#[doc = $about:literal])+
        $Kind:ident { $($(#[doc = $of_field:literal])+ $field:ident: $Held:ty,)+ },
    )+ }) => {
        $(#[$of_all])*
        pub enum $Event { $(
            $(#[doc = $about])+
            $Kind { $($(#[doc = $of_field])+ $field: $Held,)+ },
        )+ }

        /// Every kind of event with its fields, in the order of their declaration.
        pub static EVENTS: &[EventKind] = &[$(EventKind {
            variant: stringify!($Kind),
            doc: concat!($($about),+),
            fields: &[$(EventField { name: stringify!($field), doc: concat!($($of_field),+) }),+],
        }),+];
    };
}

pub(super) use vocabulary;
