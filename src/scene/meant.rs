//! Words of other tools and of lectures, and what they are called here.

/// What is called so here, and what others call it: engines (of games and of robots), lectures, drawing
/// tools. Letters alone count: `timeOfImpact` and `time_of_impact` are one word. A word may stand in several
/// rows: the first that the place knows is meant.
const MEANT: &[(&str, &str)] = &[
    // Questions.
    ("separation", "distance closest closestpoints nearest proximity signeddistance sdf shapedistance gap"),
    ("separation", "penetration depth penetrationdepth mtv mtd minimumtranslation epa d"),
    (
        "overlap",
        "collision collide collides intersection intersect intersects overlaps overlapping test hittest",
    ),
    ("overlap", "testoverlap sat gjk"),
    (
        "linear-sweep",
        "raycast shapecast circlecast boxcast cast linearcast sweep swept sweeptest sweepandprune",
    ),
    ("linear-sweep", "ray translation moving bullet hit firstcontact"),
    (
        "time-of-impact",
        "toi ccd tunneling tunnelling continuous continuouscollision angularsweep rotationalsweep",
    ),
    ("time-of-impact", "impact timeofcollision conservativeadvancement"),
    ("motion-bound", "motion bound arclength reach maxdistance"),
    ("contact", "manifold contacts contactpoints contactmanifold collide clip clipping"),
    ("bounds", "aabb boundingbox bbox extent extents minmax box"),
    // Algorithms.
    ("separating-axes", "sat separatingaxis separatingaxistest separatingaxistheorem axes"),
    ("gjk", "epa simplex expandingpolytope gilbertjohnsonkeerthi mpr xenocollide shapedistance"),
    ("conservative-advancement", "ca mirtich advancement bisection rootfinding toi timeofimpact"),
    ("minkowski", "minkowskidifference minkowskisum cso configurationspaceobstacle"),
    ("merge", "mergesort rotatingcalipers sweepmerge"),
    ("ray-cast", "raycast slab slabs slabtest raytest linearsweep"),
    ("ray-clipping", "gjkraycast gjkray rayclip shapecast vandenbergen"),
    ("clip", "sutherlandhodgman clipping manifold clippolygon"),
    ("clamp", "clampedpoint circlebox closestpoint voronoi"),
    ("extents", "aabbaabb interval intervals boxbox"),
    ("circles", "circlecircle radii spheresphere"),
    ("swept-axis", "sweptaxes sat ccd"),
    ("closest-features", "closest features linkcanny vclip exact bruteforce"),
    // Kinds of shape.
    ("circle", "ball disc disk sphere point dot"),
    ("box", "obb rect rectangle square cuboid quad orientedbox rotatedbox orientedboundingbox"),
    ("aabb", "boundingbox bbox axisalignedbox axisalignedboundingbox"),
    ("capsule", "line segment edge pill stadium roundedsegment linesegment stick"),
    ("polygon", "triangle convex convexpolygon convexhull hull poly pointcloud trapezoid"),
    ("regular-polygon", "ngon hexagon pentagon octagon regular polygonregular"),
    ("outline", "concave concavepolygon simplepolygon mesh chain polyline path contour"),
    // Keys of shapes.
    ("kind", "type shape"),
    ("position", "pos translation location offset origin xy"),
    ("center", "centre middle"),
    ("position", "center centre middle"),
    ("angle_deg", "rot orientation theta heading yaw"),
    ("velocity", "vel speed linearvelocity v linvel"),
    ("angular_velocity_deg", "omega spin angvel w angularspeed rotationspeed"),
    ("half_extents", "size extents halfsize halfwidth halfheight hx hy width height dimensions"),
    ("vertices", "verts points corners coordinates"),
    ("points", "vertices ends endpoints from to start end p0 p1 p2 p3 a b v1 v2 center1 center2"),
    ("edges", "sides n count vertices"),
    ("circumradius", "radius size"),
    ("radius", "r rad rounding skin margin polygonradius skinradius borderradius"),
    ("hull", "convexhull convex"),
    // Keys of the question, the top, panels and the page.
    ("of", "shapes bodies between pair objects colliders a b"),
    ("algorithm", "method algo solver by using"),
    ("tolerance", "tol eps epsilon slop linearslop target"),
    ("max_iterations", "iterations maxiter maxiters maxsteps steps"),
    ("time", "t when moment at"),
    ("expected", "expect reference result answer"),
    ("shapes", "bodies objects colliders body shape"),
    ("query", "question ask test"),
    ("panels", "panel subplots plots figure views view axes"),
    ("canvas", "page size width height figsize theme background text columns"),
    ("caption", "description subtitle text footer"),
    ("headline", "heading claim header"),
    ("title", "name"),
    ("lang", "language locale"),
    ("labels", "annotations texts label"),
    ("layers", "draw show content elements marks"),
    ("view", "bounds viewbox window limits xlim ylim camera viewport"),
    ("inset", "zoom magnify detail magnifier"),
    ("background", "bg backgroundcolor fill color"),
    ("text", "fontsize font textsize size label"),
    ("columns", "cols ncols"),
    ("margin", "padding border"),
    ("at", "place pos position anchor time when"),
    ("hide", "hidden visible show"),
    ("ask", "question what asks"),
    // Spaces, places and layers.
    ("configuration", "minkowski cspace cso config difference configurationspace minkowskispace"),
    ("body", "local object frame"),
    ("difference", "minkowski minkowskidifference cso"),
    ("tracks", "path paths trajectory trajectories trace"),
    ("velocity", "velocities arrows"),
    ("projection", "intervals shadows projections sat axis"),
    ("clipping", "manifold contacts contactpoints"),
    ("normal", "normals n"),
    ("polytope", "epa"),
    ("simplex", "gjk"),
    ("ghosts", "ghost previous trail end"),
    ("bounds", "min max"),
    ("vertices", "numbers indices"),
    ("axes", "ticks coordinates coordinatesystem"),
    ("grid", "gridlines background"),
    ("note", "text annotation legend"),
    ("feature", "edge vertex highlight"),
    ("spin", "rotation angularvelocity omega"),
    ("shapes", "outlines polygons"),
    ("enlarged", "inset zoom"),
    ("print", "paper grayscale greyscale bw"),
    ("dark", "night black"),
    ("light", "default white day"),
];

/// A word by its letters and digits alone, in lower case.
fn letters(word: &str) -> String {
    word.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_lowercase).collect()
}

/// Which of the known words another tool's word means; `None` where it is nobody's.
pub(super) fn meant<'k>(got: &str, known: &'k [String]) -> Option<&'k String> {
    let got = letters(got);
    let same = known.iter().find(|word| letters(word) == got);
    let theirs = |row: &&(&str, &str)| row.1.split(' ').any(|word| word == got);
    same.or_else(|| MEANT.iter().filter(theirs).find_map(|(ours, _)| known.iter().find(|word| word == ours)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::collision::{ALGORITHMS, QUERIES};
    use crate::geometry::shape::KINDS;

    fn words<'w>(all: impl Iterator<Item = &'w str>) -> Vec<String> {
        all.map(str::to_owned).collect()
    }

    #[test]
    fn each_word_is_written_as_it_is_compared_and_once_for_what_it_means() {
        for (i, (ours, theirs)) in MEANT.iter().enumerate() {
            for word in theirs.split(' ') {
                assert_eq!(letters(word), word, "{ours}");
                let again = |row: &&(&str, &str)| row.0 == *ours && row.1.split(' ').any(|w| w == word);
                assert_eq!(MEANT[i..].iter().filter(again).count(), 1, "{word} for {ours}");
            }
        }
    }

    #[test]
    fn what_a_programmer_of_physics_types_is_understood() {
        let queries = words(QUERIES.iter().map(|q| q.word));
        let algorithms = words(ALGORITHMS.iter().map(|a| a.name));
        let kinds = words(KINDS.iter().map(|k| k.name));
        let all = [
            (&queries, "toi", "time-of-impact"),
            (&queries, "time_of_impact", "time-of-impact"),
            (&queries, "ccd", "time-of-impact"),
            (&queries, "ShapeCast", "linear-sweep"),
            (&queries, "epa", "separation"),
            (&queries, "mtv", "separation"),
            (&queries, "b2Manifold", ""),
            (&queries, "manifold", "contact"),
            (&queries, "aabb", "bounds"),
            (&algorithms, "sat", "separating-axes"),
            (&algorithms, "epa", "gjk"),
            (&algorithms, "ca", "conservative-advancement"),
            (&algorithms, "minkowski-difference", "minkowski"),
            (&algorithms, "Sutherland-Hodgman", "clip"),
            (&kinds, "obb", "box"),
            (&kinds, "sphere", "circle"),
            (&kinds, "segment", "capsule"),
            (&kinds, "convex hull", "polygon"),
            (&kinds, "banana", ""),
        ];
        for (known, got, ours) in all {
            assert_eq!(meant(got, known).map_or("", String::as_str), ours, "{got}");
        }
    }
}
