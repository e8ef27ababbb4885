//! The words that labels and default pictures have of themselves, in the language of the scene.
//!
//! A scene without `lang` is taken for English. In a language that no column of the table is of there are no
//! words of ours at all: what has a formula keeps that, and what is a word alone is left out.

use crate::scene::Scene;
use crate::trace::{Tongue, text};

/// The languages of the columns after the second one, by their ISO 639 code.
const LANGUAGES: [&str; 3] = ["de", "fr", "es"];

/// The language in which the words are written in the layers.
const OWN: &str = "en";

/// The column for languages that no other column is of.
const WORDLESS: usize = 1;

/// What stands in our words for a name or for the rest of a formula.
const STAR: char = '*';

/// Rows that are said of a body at another place: alone in labels that have a name too, which may be any
/// word.
const OF_GHOSTS: usize = 15;

/// Labels that are a name and nothing else.
const NAMES: [&str; 4] = ["A", "B", "a", "context"];
/// Labels that have a name, beside words of ours.
const NAMES_OF_GHOSTS: [&str; 3] = ["A'", "B'", "b"];

/// Words of ours: in English, without words, and in each of [`LANGUAGES`].
#[cfg(not(tracefig_page))]
pub(crate) type Row = [&'static str; 5];

/// Words of ours in English and without words: a page has the others, where it is in one of them ([`text`]).
#[cfg(tracefig_page)]
pub(crate) type Row = [&'static str; 2];

/// What this program has of words.
pub(crate) const fn rows<const N: usize>(all: [[&'static str; 5]; N]) -> [Row; N] {
    #[cfg(tracefig_page)]
    let all = {
        let mut own = [["", ""]; N];
        let mut k = 0;
        while k < N {
            own[k] = [all[k][0], all[k][1]];
            k += 1;
        }
        own
    };
    all
}

/// Our words for labels and titles.
pub(crate) static WORDS: &[Row] = &rows([
    [
        "expected $* (not to scale)",
        "$*",
        "erwartetes $* (nicht maßstäblich)",
        "valeur attendue $* (hors échelle)",
        "valor esperado $* (no a escala)",
    ],
    [
        "$*$, as expected (not to scale)",
        "$*$",
        "$*$, wie erwartet (nicht maßstäblich)",
        "$*$, comme attendu (hors échelle)",
        "$*$, como se esperaba (no a escala)",
    ],
    ["expected at $t*", "$t*", "erwartet bei $t*", "pose attendue à $t*", "pose esperada en $t*"],
    [
        "* expected at $t*",
        "*: $t*",
        "* erwartet bei $t*",
        "pose attendue de * à $t*",
        "pose esperada de * en $t*",
    ],
    ["$*$, as expected", "$*$", "$*$, wie erwartet", "$*$, comme attendu", "$*$, como se esperaba"],
    ["expected $*", "$*", "erwartetes $*", "valeur attendue $*", "valor esperado $*"],
    ["at $t*", "$t*", "bei $t*", "à $t*", "en $t*"],
    ["* at $t*", "*: $t*", "* bei $t*", "* à $t*", "* en $t*"],
    ["origin of *", "*", "Ursprung von *", "origine de *", "origen de *"],
    ["or * pushed out", "*", "oder * hinausgeschoben", "ou * après la poussée", "o * tras el empuje"],
    ["or * pushed farther", "*", "oder * weiter geschoben", "ou * plus loin", "o * más lejos"],
    ["* pushed out", "*", "* hinausgeschoben", "* après la poussée", "* tras el empuje"],
    ["* pushed farther", "*", "* weiter geschoben", "* plus loin", "* más lejos"],
    ["looks the same", "", "sieht gleich aus", "paraît inchangé", "se ve igual"],
    ["turned $*$", "$*$", "um $*$ gedreht", "rotation de $*$", "giro de $*$"],
    ["expected: hit", "", "erwartet: Treffer", "attendu : impact", "esperado: contacto"],
    ["expected: miss", "", "erwartet: kein Treffer", "attendu : pas de contact", "esperado: sin contacto"],
    [
        "expected: overlapping",
        "",
        "erwartet: Überlappung",
        "attendu : recouvrement",
        "esperado: solapamiento",
    ],
    ["expected: apart", "", "erwartet: getrennt", "attendu : séparés", "esperado: separados"],
    ["depth $d*", "$d*", "Tiefe $d*", "profondeur $d*", "profundidad $d*"],
    ["depth $=*", "$*", "Tiefe $=*", "profondeur $=*", "profundidad $=*"],
    ["distance $*", "$d *", "Abstand $*", "distance $*", "distancia $*"],
    ["gap $=*", "$*", "Lücke $=*", "écart $=*", "hueco $=*"],
    ["gap $\\approx 0$", "$\\approx 0$", "Lücke $\\approx 0$", "écart $\\approx 0$", "hueco $\\approx 0$"],
    ["overlap $=*", "$*", "Überlappung $=*", "recouvrement $=*", "solapamiento $=*"],
    ["at least $*", "$\\ge *", "mindestens $*", "au moins $*", "al menos $*"],
    ["centres $*$ apart", "$*$", "Mittenabstand $*$", "centres distants de $*$", "los centros distan $*$"],
    ["$*$, longer", "$*$", "$*$, länger", "$*$, plus long", "$*$, más largo"],
    ["their points $*$ apart", "$*$", "Abstand ihrer Punkte $*$", "leurs points à $*$", "sus puntos a $*$"],
    ["any direction", "", "jede Richtung", "toute direction", "cualquier dirección"],
    ["one of several", "", "eine von mehreren", "une parmi plusieurs", "una de varias"],
    [
        "$*$, clamped to $*$",
        r"$\mathrm{clamp}(*) = *$",
        "$*$, begrenzt auf $*$",
        "$*$, borné à $*$",
        "$*$, limitado a $*$",
    ],
    ["clamped $*$", r"$\mathrm{clamp}(*)$", "$*$ begrenzt", "$*$ borné", "$*$ limitado"],
    ["largest gap:", "", "größte Lücke:", "plus grand écart :", "hueco mayor:"],
    ["centres:", "", "Mittelpunkte:", "centres :", "centros:"],
    ["two frames:", "", "zwei Bilder:", "deux images :", "dos fotogramas:"],
    ["forgotten spin:", "", "vergessene Drehung:", "rotation oubliée :", "giro olvidado:"],
    ["fixed tolerance:", "", "feste Toleranz:", "tolérance fixe :", "tolerancia fija:"],
    ["clamped centre:", "", "begrenzte Mitte:", "centre borné :", "centro limitado:"],
    ["first support:", "", "erste Stützecke:", "premier support :", "primer soporte:"],
    ["single precision:", "", "einfache Genauigkeit:", "simple précision :", "precisión simple:"],
    ["first vertex:", "", "erste Ecke:", "premier sommet :", "primer vértice:"],
    ["squared gap:", "", "Lücke aus Quadraten:", "écart des carrés :", "hueco de cuadrados:"],
    ["slop:", "", "Toleranz:", "marge :", "holgura:"],
    ["deepest vertex:", "", "tiefste Ecke:", "sommet le plus profond :", "vértice más hondo:"],
    ["centre ray:", "", "Strahl der Mitte:", "rayon du centre :", "rayo del centro:"],
    ["one point", "", "ein Punkt", "un seul point", "un solo punto"],
    ["its line: $*$", "$*$", "Gerade der Kante: $*$", "droite de l’arête : $*$", "recta de la arista: $*$"],
    ["no hit", "", "kein Treffer", "pas de contact", "sin contacto"],
    ["division by 0", "", "Division durch 0", "division par 0", "división por 0"],
    [
        "(the edge faces away)",
        "",
        "(die Kante ist abgewandt)",
        "(l’arête est à l’opposé)",
        "(la arista mira atrás)",
    ],
    ["(from vertex to vertex)", "", "(von Ecke zu Ecke)", "(de sommet à sommet)", "(de vértice a vértice)"],
    [
        "(less than the distance)",
        "",
        "(weniger als der Abstand)",
        "(moins que la distance)",
        "(menos que la distancia)",
    ],
    ["($*$ turns)", "($*$)", "($*$ Umdrehungen)", "($*$ tours)", "($*$ vueltas)"],
    ["$*$ of *", "$*$", "$*$ von *", "$*$ de *", "$*$ de *"],
    ["*, drawn at *", "*, *", "*, im Maßstab *", "*, à l’échelle *", "*, a escala *"],
    ["edge of *, $*", "*, $*", "Kante von *, $*", "arête de *, $*", "arista de *, $*"],
    [
        "* more steps, to $*",
        "+ *, $*",
        "* weitere Schritte, bis $*",
        "* étapes de plus, jusqu’à $*",
        "* pasos más, hasta $*",
    ],
    [
        "$*$ in a unit of time",
        "",
        "$*$ in einer Zeiteinheit",
        "$*$ par unité de temps",
        "$*$ por unidad de tiempo",
    ],
    ["one more step, $*", "+ 1, $*", "noch ein Schritt, $*", "une étape de plus, $*", "un paso más, $*"],
    ["touch", "", "Berührung", "ils se touchent", "se tocan"],
    [
        "tolerance $*$, too small to be seen",
        "$*$",
        "Toleranz $*$, zu klein für das Bild",
        "tolérance $*$, trop petite pour être vue",
        "tolerancia $*$, demasiado pequeña para verse",
    ],
    ["tolerance $*$", "$*$", "Toleranz $*$", "tolérance $*$", "tolerancia $*$"],
    [
        "(too small to be seen)",
        "",
        "(zu klein für das Bild)",
        "(trop petite pour être vue)",
        "(demasiado pequeña para verse)",
    ],
    ["distance of the cores", "", "Abstand der Kerne", "distance des noyaux", "distancia de los núcleos"],
    [
        "distance closed by time $t$",
        "",
        "Annäherung bis zur Zeit $t$",
        "rapprochement jusqu’à l’instant $t$",
        "acercamiento hasta el instante $t$",
    ],
    ["here another vertex", "", "hier wird eine andere", "ici un autre sommet", "aquí otro vértice"],
    ["becomes the nearest", "", "Ecke zur nächsten", "devient le plus proche", "pasa a ser el más cercano"],
    [
        "at each dot another",
        "",
        "an jedem Punkt wird eine",
        "à chaque point un autre",
        "en cada punto otro vértice",
    ],
    [
        "vertex becomes the nearest",
        "",
        "andere Ecke zur nächsten",
        "sommet devient le plus proche",
        "pasa a ser el más cercano",
    ],
    [
        "slope $*: every arc ends here",
        "",
        "Steigung $*: hier endet jeder Bogen",
        "pente $* : chaque arc finit ici",
        "pendiente $*: cada arco acaba aquí",
    ],
    ["along $*", "$*", "entlang $*", "le long de $*", "a lo largo de $*"],
    ["as far as $*$", "", "so weit wie $*$", "aussi loin que $*$", "tan lejos como $*$"],
    ["* (not to scale)", "*", "* (nicht maßstäblich)", "* (hors échelle)", "* (no a escala)"],
    [
        "* turned about its origin",
        "",
        "* um den eigenen Ursprung gedreht",
        "* après rotation autour de son origine",
        "* tras girar alrededor de su origen",
    ],
    ["* turned about *", "", "* um * gedreht", "* après rotation autour de *", "* tras girar alrededor de *"],
    ["* moved to *", "", "* auf * geschoben", "* après déplacement en *", "* tras moverse a *"],
    ["* moved around *", "", "* um * geschoben", "* glissant autour de *", "* moviéndose alrededor de *"],
    ["from *", "*", "von *", "de *", "de *"],
    ["vertex * of *", "*, *", "Ecke * von *", "sommet * de *", "vértice * de *"],
    ["vertex *", "*", "Ecke *", "sommet *", "vértice *"],
    ["edge of *, reversed", "*", "Kante von *, umgekehrt", "arête de *, inversée", "arista de *, invertida"],
    ["edge of *", "*", "Kante von *", "arête de *", "arista de *"],
    ["$*$ left", "$*$", "noch $*$", "reste $*$", "quedan $*$"],
    ["inside", "", "innen", "à l’intérieur", "dentro"],
    ["cut off", "", "abgeschnitten", "coupé", "cortado"],
    ["$*$ long", "$*$", "$*$ lang", "longueur $*$", "longitud $*$"],
    ["edge * of *", "*, *", "Kante * von *", "arête * de *", "arista * de *"],
    ["edge *", "*", "Kante *", "arête *", "arista *"],
    ["reference", "", "Referenz", "référence", "referencia"],
    ["incident, of the core", "", "auftreffend, vom Kern", "incidente, du noyau", "incidente, del núcleo"],
    ["incident", "", "auftreffend", "incidente", "incidente"],
    ["distance", "", "Abstand", "distance", "distancia"],
    ["at most", "", "höchstens", "au plus", "a lo sumo"],
    ["in fact", "", "wirklich", "en fait", "en realidad"],
    ["hit at $t*", "$t*", "Treffer bei $t*", "contact à $t*", "contacto en $t*"],
    ["at most $*", "$\\le *", "höchstens $*", "au plus $*", "a lo sumo $*"],
    ["contact *", "*", "Kontakt *", "contact *", "contacto *"],
    ["no contact", "", "kein Kontakt", "pas de contact", "sin contacto"],
    ["dropped", "", "verworfen", "écarté", "descartado"],
    ["* dropped", "*", "* verworfen", "* écarté", "* descartado"],
    ["right here", "", "hier richtig", "ici juste", "aquí correcto"],
    ["half a turn", "", "halbe Drehung", "demi-tour", "media vuelta"],
    ["its normal", "", "ihre Normale", "sa normale", "su normal"],
    ["light", "", "Licht", "lumière", "luz"],
    ["no vertex beyond", "", "keine Ecke dahinter", "aucun sommet au-delà", "ningún vértice más allá"],
    [
        "no vertex of the cores beyond",
        "",
        "keine Ecke der Kerne dahinter",
        "aucun sommet des noyaux au-delà",
        "ningún vértice de los núcleos más allá",
    ],
    ["nothing beyond", "", "nichts dahinter", "rien au-delà", "nada más allá"],
    ["without radii", "", "ohne Radien", "sans rayons", "sin radios"],
    ["new estimate", "", "neue Schätzung", "nouvelle estimation", "nueva estimación"],
    ["estimate", "", "Schätzung", "estimation", "estimación"],
    ["closest point", "", "nächster Punkt", "point le plus proche", "punto más cercano"],
    ["tangent", "", "Tangente", "tangente", "tangente"],
    ["start", "", "Anfang", "début", "inicio"],
    ["order", "", "Reihenfolge", "ordre", "orden"],
    ["* turned", "*", "* gedreht", "* après rotation", "* tras el giro"],
    ["pushed to *", "", "nach * geschoben", "poussée jusqu’à *", "llevada a *"],
    ["shared", "", "gemeinsam", "commun", "compartido"],
    ["depth", "", "Tiefe", "profondeur", "profundidad"],
    ["square to *", "", "senkrecht zu *", "perpendiculaire à *", "perpendicular a *"],
    ["$*$, less", "$*$", "$*$, kleiner", "$*$, plus petit", "$*$, menor"],
    ["turns less", "", "dreht weniger", "tourne moins", "gira menos"],
    ["fastest approach", "", "schnellste Annäherung", "approche la plus rapide", "acercamiento más rápido"],
    ["World", "", "Welt", "Monde", "Mundo"],
    ["Relative velocity", "", "Relativgeschwindigkeit", "Vitesse relative", "Velocidad relativa"],
    [
        "Configuration space",
        "",
        "Konfigurationsraum",
        "Espace des configurations",
        "Espacio de configuración",
    ],
    [
        "Separation over time",
        "",
        "Abstand über der Zeit",
        "Séparation au cours du temps",
        "Separación a lo largo del tiempo",
    ],
    ["Step *", "*", "Schritt *", "Étape *", "Paso *"],
    ["From the start to the end", "", "Vom Anfang zum Ende", "Du début à la fin", "Del principio al fin"],
    [
        "The arc of the farthest point",
        "",
        "Der Bogen des fernsten Punkts",
        "L’arc du point le plus éloigné",
        "El arco del punto más lejano",
    ],
    [
        "Between the reference edge's ends",
        "",
        "Zwischen den Enden der Referenzkante",
        "Entre les bouts de l’arête de référence",
        "Entre los extremos de la arista de referencia",
    ],
    ["Points of contact", "", "Kontaktpunkte", "Points de contact", "Puntos de contacto"],
    ["min $=*", "$\\min =*", "min $=*", "min $=*", "mín $=*"],
    ["max $=*", "$\\max =*", "max $=*", "max $=*", "máx $=*"],
]);

/// The language of the words of ours in a figure.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Language {
    /// The column of [`WORDS`].
    column: usize,
}

impl Language {
    /// The language of a scene; English where it does not say.
    pub(crate) fn of(scene: &Scene) -> Self {
        scene.lang.as_ref().map_or(Self { column: 0 }, |lang| Self::of_tag(&lang.value))
    }

    /// The language of a tag, as `de` or `pt-BR`.
    fn of_tag(tag: &str) -> Self {
        let language = tag.split('-').next().unwrap_or("").to_ascii_lowercase();
        let known = LANGUAGES.iter().position(|known| *known == language);
        let column = if language == OWN { 0 } else { known.map_or(WORDLESS, |i| WORDLESS + 1 + i) };
        Self { column }
    }

    /// Whether it is the one in which whole sentences of ours are written.
    pub(crate) fn is_own(self) -> bool {
        self.column == 0
    }

    /// Whether whole sentences of ours are in it.
    pub(crate) fn has_sentences(self) -> bool {
        self.column != WORDLESS
    }

    /// Which of the languages of whole sentences of ours in exercises it is: English, which stands for those
    /// without words too, then each of [`LANGUAGES`].
    pub(crate) fn of_sentences(self) -> usize {
        self.column.saturating_sub(WORDLESS)
    }

    /// The lines of a label of ours, as markup; none where it has words alone, which the language has not.
    pub(crate) fn lines(self, key: &str, lines: &[String]) -> Vec<String> {
        if self.is_own() || NAMES.contains(&key) {
            return lines.to_vec();
        }
        let rows = if NAMES_OF_GHOSTS.contains(&key) { &WORDS[..OF_GHOSTS] } else { WORDS };
        lines.iter().map(|line| self.said(rows, line)).filter(|line| !line.is_empty()).collect()
    }

    /// Words of ours that are no label's, as the title of a panel; empty where the language has none.
    pub(crate) fn words(self, english: &str) -> String {
        self.said(WORDS, english)
    }

    /// What another table has for words of ours that must be said: in English where the language has none.
    pub(crate) fn of_rows(self, rows: &[Row], english: &str) -> String {
        if self.column == WORDLESS { english.to_owned() } else { self.said(rows, english) }
    }

    /// What is written in English, as a row has it; as it is where no row is of it.
    fn said(self, rows: &[Row], english: &str) -> String {
        let found = rows.iter().find_map(|row| Some((row, taken(row[0], english)?)));
        let Some((row, parts)) = found else { return english.to_owned() };
        Tongue::new(self.of_sentences(), false).filled(text(row, self.column), &parts)
    }
}

/// What stands in a text for the stars of a pattern, at most two; `None` where it does not follow the
/// pattern.
fn taken<'t>(pattern: &str, text: &'t str) -> Option<Vec<&'t str>> {
    let Some((before, after)) = pattern.split_once(STAR) else {
        return (text == pattern).then(Vec::new);
    };
    let rest = text.strip_prefix(before)?;
    let Some((between, end)) = after.split_once(STAR) else {
        return Some(vec![rest.strip_suffix(after)?]);
    };
    let (first, second) = rest.strip_suffix(end)?.rsplit_once(between)?;
    Some(vec![first, second])
}

#[cfg(test)]
mod tests;
