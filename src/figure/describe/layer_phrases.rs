//! What layers are called in the long text: in English by the words of a scene, elsewhere in words.

use crate::trace::{Phrase, phrases};

phrases! {
    /// The layer of this name.
    SHAPES: "shapes", "Körper", "corps", "cuerpos";
    /// The layer of this name.
    VERTICES: "vertices", "Ecken", "sommets", "vértices";
    /// The layer of this name.
    FEATURE: "feature", "ein Merkmal", "un élément", "un elemento";
    /// The layer of this name.
    POINT: "point", "ein Punkt", "un point", "un punto";
    /// The layer of this name.
    GHOSTS: "ghosts", "Körper anderswo", "corps ailleurs", "cuerpos en otro lugar";
    /// The layer of this name.
    SEPARATION: "separation", "Abstand", "distance", "separación";
    /// The layer of this name.
    NORMAL: "normal", "Normale", "normale", "normal";
    /// The layer of this name.
    CONTACT: "contact", "Berührpunkt", "point de contact", "punto de contacto";
    /// The layer of this name.
    CLIPPING: "clipping", "Beschneiden", "découpage", "recorte";
    /// The layer of this name.
    APPROACH: "approach", "größte Annäherung", "approche la plus proche", "máxima aproximación";
    /// The layer of this name.
    EXPECTED: "expected", "erwartete Antwort", "réponse attendue", "respuesta esperada";
    /// The layer of this name.
    NAIVE: "naive", "naive Antwort", "réponse naïve", "respuesta ingenua";
    /// The layer of this name.
    BOUNDS: "bounds", "Bounding-Box", "boîte englobante", "caja envolvente";
    /// The layer of this name.
    HALF_EXTENTS: "half-extents", "halbe Ausdehnungen", "demi-étendues", "semiextensiones";
    /// The layer of this name.
    CLAMP: "clamp", "Begrenzen auf das Rechteck", "bornage au rectangle", "limitación al rectángulo";
    /// The layer of this name.
    RADII: "radii", "Radien", "rayons", "radios";
    /// The layer of this name.
    TRANSLATION: "translation", "kürzester Schub", "poussée la plus courte", "empuje más corto";
    /// The layer of this name.
    AXIS_GAPS: "axis-gaps", "Lücken entlang der Achsen", "écarts selon les axes", "huecos según los ejes";
    /// The layer of this name.
    FRAME: "frame", "Bezugssystem eines Körpers", "repère d’un corps", "sistema de un cuerpo";
    /// The layer of this name.
    GRID: "grid", "Gitter", "quadrillage", "cuadrícula";
    /// The layer of this name.
    AXES: "axes", "Achsen", "axes", "ejes";
    /// The layer of this name.
    GROWN: "grown", "vergrößerter Körper", "corps agrandi", "cuerpo agrandado";
    /// The layer of this name.
    DIFFERENCE: "difference", "Minkowski-Differenz", "différence de Minkowski", "diferencia de Minkowski";
    /// The layer of this name.
    ORIGIN: "origin", "Ursprung", "origine", "origen";
    /// The layer of this name.
    CLOSEST: "closest", "nächster Punkt", "point le plus proche", "punto más cercano";
    /// The layer of this name.
    SUPPORT: "support", "Stützecken", "sommets d’appui", "vértices de soporte";
    /// The layer of this name.
    PAIR: "pair", "ein Paar von Ecken", "une paire de sommets", "un par de vértices";
    /// The layer of this name.
    VELOCITY: "velocity", "Geschwindigkeit", "vitesse", "velocidad";
    /// The layer of this name.
    RAY: "ray", "Strahl", "rayon lancé", "rayo";
    /// The layer of this name.
    SWEEP: "sweep", "überstrichenes Band", "bande balayée", "banda barrida";
    /// The layer of this name.
    ADVANCEMENT: "advancement", "ein Schritt der Annäherung", "une étape de l’avance", "un paso del avance";
    /// The layer of this name.
    TRACKS: "tracks",
        "Wege der Berührpunkte",
        "trajets des points de contact",
        "caminos de los puntos de contacto";
    /// The layer of this name.
    SPIN: "spin", "Drehung", "rotation", "giro";
    /// The layer of this name.
    ARC: "arc", "Bogen", "arc", "arco";
    /// The layer of this name.
    PROJECTION: "projection", "Projektion auf eine Achse", "projection sur un axe", "proyección sobre un eje";
    /// The layer of this name.
    SIMPLEX: "simplex", "Simplex", "simplexe", "símplex";
    /// The layer of this name.
    BRACKET: "bracket", "Schranken des Abstands", "bornes de la distance", "cotas de la distancia";
    /// The layer of this name.
    POLYTOPE: "polytope", "Polytop", "polytope", "politopo";
    /// The layer of this name.
    EDGE_NORMALS: "edge-normals", "Kantennormalen", "normales des arêtes", "normales de las aristas";
    /// The layer of this name.
    EDGE_FAN: "edge-fan", "Kanten nach ihrer Richtung", "arêtes par direction", "aristas por dirección";
    /// The layer of this name.
    MERGING: "merging", "Mischen der Kanten", "fusion des arêtes", "fusión de las aristas";
    /// The layer of this name.
    SEPARATING_CONE: "separating-cone",
        "trennende Richtungen",
        "directions séparatrices",
        "direcciones separadoras";
    /// The layer of this name.
    SEPARATING_LINES: "separating-lines", "trennende Geraden", "droites séparatrices", "rectas separadoras";
    /// The layer of this name.
    GRAPH: "graph", "Abstand über der Zeit", "distance en fonction du temps", "separación en el tiempo";
    /// The layer of this name.
    FASTEST_APPROACH: "fastest-approach",
        "schnellste Annäherung",
        "approche la plus rapide",
        "acercamiento más rápido";
    /// The layer of this name.
    ENLARGED: "enlarged", "Rahmen um ein Detail", "cadre d’un détail", "marco de un detalle";
    /// The layer of this name.
    NOTE: "note", "Text", "texte", "texto";
}

/// What a layer is called; `None` where there is none of that name.
pub(super) fn called(name: &str) -> Option<&'static Phrase> {
    ALL.iter().copied().find(|phrase| phrase[0] == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::figure::layer::LAYERS;

    #[test]
    fn every_layer_is_called_in_every_language() {
        let names: Vec<_> = LAYERS.iter().map(|layer| layer.name).collect();
        let called: Vec<_> = ALL.iter().map(|phrase| phrase[0]).collect();
        assert_eq!(called, names, "in their order");
    }
}
