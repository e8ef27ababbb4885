//! What an exercise may ask of a contact: how many points it has, how deep they are, and where.

use crate::collision::QueryKind;

use super::measure::Measure;
use super::quantities::{Askable, proved, row};

/// Whether a question is for a contact.
fn is_for_a_contact(kind: QueryKind) -> bool {
    kind == QueryKind::Contact
}

/// Every value of a contact that can be asked for.
pub(super) static ASKABLE: &[Askable] = &[
    row(
        "contacts",
        "k",
        [
            "how many points the contact of {} has",
            "wie viele Punkte der Kontakt von {} hat",
            "combien de points a le contact de {}",
            "cuántos puntos tiene el contacto de {}",
        ],
        Measure::Pure,
        is_for_a_contact,
    ),
    proved(row(
        "shallow",
        r"d_{\mathrm{min}}",
        [
            "the depth of {} at the point of contact where they overlap less",
            "die Tiefe von {} an dem Kontaktpunkt, an dem sie sich weniger überlappen",
            "la profondeur de {} au point de contact où ils se recouvrent le moins",
            "la profundidad de {} en el punto de contacto donde menos se solapan",
        ],
        Measure::Length,
        is_for_a_contact,
    )),
    row(
        "contact.a.x",
        "p_x",
        [
            "the x of the point of {a} where the contact is deepest",
            "das x des Punktes von {a}, an dem der Kontakt am tiefsten ist",
            "le x du point de {a} où le contact est le plus profond",
            "la x del punto de {a} donde el contacto es más profundo",
        ],
        Measure::Length,
        is_for_a_contact,
    ),
    row(
        "contact.a.y",
        "p_y",
        [
            "the y of the point of {a} where the contact is deepest",
            "das y des Punktes von {a}, an dem der Kontakt am tiefsten ist",
            "le y du point de {a} où le contact est le plus profond",
            "la y del punto de {a} donde el contacto es más profundo",
        ],
        Measure::Length,
        is_for_a_contact,
    ),
    row(
        "contact.b.x",
        "q_x",
        [
            "the x of the point of {b} where the contact is deepest",
            "das x des Punktes von {b}, an dem der Kontakt am tiefsten ist",
            "le x du point de {b} où le contact est le plus profond",
            "la x del punto de {b} donde el contacto es más profundo",
        ],
        Measure::Length,
        is_for_a_contact,
    ),
    row(
        "contact.b.y",
        "q_y",
        [
            "the y of the point of {b} where the contact is deepest",
            "das y des Punktes von {b}, an dem der Kontakt am tiefsten ist",
            "le y du point de {b} où le contact est le plus profond",
            "la y del punto de {b} donde el contacto es más profundo",
        ],
        Measure::Length,
        is_for_a_contact,
    ),
];
