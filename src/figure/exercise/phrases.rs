//! The sentences of an exercise in the languages that the words of labels have.
//!
//! A scene in any other language has them in English, with English numbers.

use crate::figure::describe::body_phrases::AND;
use crate::figure::text::Decimal;
use crate::figure::tongue::tongue;
use crate::geometry::DVec2;
use crate::scene::Scene;
use crate::trace::{Tongue, phrases};

phrases! {
    listed for tests;
    /// The vertices of a polygon, listed.
    WITH_VERTICES: " with the vertices *", " mit den Ecken *", " de sommets *", " con los vértices *";
    /// The points that a polygon is the hull of.
    HULL_OF: ", the convex hull of *",
        ", die konvexe Hülle von *",
        ", enveloppe convexe de *",
        ", la envolvente convexa de *";
    /// The vertices of a polygon, counted.
    OF_VERTICES: " of * vertices", " mit * Ecken", " de * sommets", " de * vértices";
    /// A regular polygon: its edges, its circumradius, and how it stands.
    REGULAR: " with * edges and circumradius *, the lowest edge level,",
        " mit * Kanten und dem Umkreisradius *, die unterste Kante waagrecht,",
        " à * arêtes, de rayon circonscrit *, l’arête la plus basse horizontale,",
        " de * aristas y circunradio *, con la arista más baja horizontal,";
    /// By which angle a body is turned whose cosine and sine are given.
    TURNED_BY_SINE: ", turned by the angle of cosine * and sine *",
        ", um den Winkel mit Kosinus * und Sinus * gedreht",
        ", avec une rotation de l’angle de cosinus * et de sinus *",
        ", con un giro del ángulo de coseno * y seno *";
    /// The gap of two AABBs along an axis: both, the axis.
    GAP_ALONG: "the gap D between * along *, negative where they overlap there",
        "die Lücke D zwischen * entlang *, negativ, wo sie sich dort überlappen",
        "l’écart D entre * selon *, négatif s’ils s’y recouvrent",
        "el hueco D entre * a lo largo de *, negativo si ahí se solapan";
    /// How a body moves: its name, what it does.
    DOES: "* *.", "* *.", "* *.", "* *.";
    /// What a body does that is carried along.
    MOVES: "moves by *", "bewegt sich um *", "se déplace de *", "se desplaza *";
    /// What a body does that turns to the left.
    TURNS_LEFT: "turns by * counter-clockwise about its origin",
        "dreht sich um * gegen den Uhrzeigersinn um den eigenen Ursprung",
        "tourne de * dans le sens antihoraire autour de son origine",
        "gira * en sentido antihorario alrededor de su origen";
    /// What a body does that turns to the right.
    TURNS_RIGHT: "turns by * clockwise about its origin",
        "dreht sich um * im Uhrzeigersinn um den eigenen Ursprung",
        "tourne de * dans le sens horaire autour de son origine",
        "gira * en sentido horario alrededor de su origen";
    /// How a body is turned to the left at the start.
    TURNED_LEFT: ", turned by * counter-clockwise",
        ", um * gegen den Uhrzeigersinn gedreht",
        ", avec une rotation de * dans le sens antihoraire",
        ", con un giro antihorario de *";
    /// How a body is turned to the right at the start.
    TURNED_RIGHT: ", turned by * clockwise",
        ", um * im Uhrzeigersinn gedreht",
        ", avec une rotation de * dans le sens horaire",
        ", con un giro horario de *";
    /// When the motion begins and ends.
    MOTION: "The motion runs from t = 0 to t = 1.",
        "Die Bewegung geht von t = 0 bis t = 1.",
        "Le mouvement va de t = 0 à t = 1.",
        "El movimiento va de t = 0 a t = 1.";
    /// The moment that is asked about.
    MOMENT: "The moment is t = *.",
        "Der Zeitpunkt ist t = *.",
        "L’instant est t = *.",
        "El instante es t = *.";
    /// The unit of lengths.
    LENGTHS_IN: "Lengths are in *.",
        "Längen sind in * angegeben.",
        "Les longueurs sont données en *.",
        "Las longitudes se dan en *.";
    /// The unit of times.
    TIMES_IN: "Times are in *.",
        "Zeiten sind in * angegeben.",
        "Les temps sont donnés en *.",
        "Los tiempos se dan en *.";
    /// What is to be done.
    FIND: "Find *.", "Gesucht: *.", "Trouver *.", "Se pide: *.";
    /// An answer.
    ANSWER: "Answer: *", "Antwort: *", "Réponse : *", "Respuesta: *";
    /// What is behind a question.
    SOLUTION: "Answer", "Lösung", "Réponse", "Solución";
    /// An answer that needs no bounds.
    EXACT: "*, proved to be exact.",
        "*, bewiesen als exakt.",
        "*, valeur exacte prouvée.",
        "*, valor exacto demostrado.";
    /// An answer that is proved but for rounding: how far off it is at most.
    WITHIN: "*, proved to within *.",
        "*, bewiesen bis auf *.",
        "*, prouvé à * près.",
        "*, demostrado con un error de * a lo sumo.";
    /// An answer with its bounds.
    BETWEEN: "*, proved to lie between * and *.",
        "*, bewiesen zwischen * und *.",
        "*, prouvé entre * et *.",
        "*, demostrado entre * y *.";
    /// The unit of lengths where a scene names none.
    UNITS: "units", "Einheiten", "unités", "unidades";
    /// One of [`UNITS`].
    UNIT: "unit", "Einheit", "unité", "unidad";
    /// Which number is to be typed, and what it is.
    ENTER: "Enter * (*)", "Gib * ein (*)", "Saisir * (*)", "Escribe * (*)";
    /// The unit in which a number is to be typed.
    IN_UNIT: " in *", " in *", " en *", " en *";
    /// How many digits a number has that is typed.
    DIGITS: "*, to three digits.",
        "*, auf drei Ziffern.",
        "*, à trois chiffres significatifs.",
        "*, con tres cifras significativas.";
    /// Steps that have no room.
    MORE: "* more steps are in the trace of the scene.",
        "* weitere Schritte stehen im Verlauf der Szene.",
        "* autres étapes sont dans la trace de la scène.",
        "Otros * pasos están en la traza de la escena.";
}

/// The words of an exercise in the language of its scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Words {
    /// The language of the sentences.
    pub(super) tongue: Tongue,
    /// The sign in numbers.
    decimal: Decimal,
}

impl Words {
    /// English, whatever a scene says.
    pub(super) const ENGLISH: Self = Self { tongue: Tongue::ENGLISH, decimal: Decimal::Point };

    /// The words of a scene.
    pub(super) fn of(scene: &Scene) -> Self {
        let tongue = tongue(scene);
        if tongue == Tongue::ENGLISH { Self::ENGLISH } else { Self { tongue, decimal: Decimal::of(scene) } }
    }

    /// A phrase without a star.
    pub(super) fn word(self, phrase: &[&'static str]) -> &'static str {
        self.tongue.word(phrase)
    }

    /// A phrase with what stands for its stars.
    pub(super) fn say(self, phrase: &[&'static str], parts: &[&str]) -> String {
        self.tongue.say(phrase, parts)
    }

    /// Two things and more, of which the last two are named together.
    pub(super) fn listed(self, all: &[String]) -> String {
        match all {
            [before @ .., last] if !before.is_empty() => {
                // An aside is closed by the comma that it was opened by.
                let closed = if before.last().is_some_and(|one| one.contains(", ")) { "," } else { "" };
                self.say(&AND, &[&(before.join(", ") + closed), last])
            }
            _ => all.concat(),
        }
    }

    /// A number with all its digits and a real minus sign.
    pub(super) fn number(self, x: f64) -> String {
        self.decimal.in_number(format!("{}", x + 0.0).replace('-', "−"))
    }

    /// A number within a formula.
    pub(super) fn in_latex(self, number: String) -> String {
        self.decimal.in_latex(number)
    }

    /// A point as `(x, y)`; where numbers have commas, something else parts them.
    pub(super) fn point(self, p: DVec2) -> String {
        format!("({}{}{})", self.number(p.x), self.tongue.between(), self.number(p.y))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_phrase_has_its_stars_in_every_language() {
        for phrase in ALL {
            let stars = phrase.map(|said| said.matches('*').count());
            assert_eq!(stars, [stars[0]; 4], "{phrase:?}");
        }
        let german = Words { tongue: Tongue::new(1, true), decimal: Decimal::Comma };
        assert_eq!(german.say(&AND, &["A*", "B"]), "A* und B");
        assert_eq!(german.point(DVec2::new(1.5, -2.0)), "(1,5; −2)");
        assert_eq!(german.listed(&["a", "b", "c"].map(str::to_owned)), "a, b und c");
    }
}
