//! Points of contact where an edge is cut near its end.

use tracefig_reference::json::Json;

/// A corner of a large box inside of a small body, which has the reference edge: of the box's edge a part of 1e-17
/// is over it.
#[test]
fn the_edge_of_a_large_body_is_cut_near_its_end_by_that_of_a_small_one() {
    for (edge, at, angle) in [
        (1e9, [3_121_777_801.756_107_3, -999_852_355.790_739_7], -15.742_066_774_032_821),
        (1e6, [2_054.887_826_983_267, 3_059.645_029_593_476_5], 31.0),
        (1e3, [1.0e3 / 3.0, -7.0e3 / 11.0], 133.7),
    ] {
        let small = edge * 1e-16;
        let a = format!(
            r#"{{"kind": "aabb", "half_extents": [{edge}, {edge}], "position": [{}, {}]}}"#,
            at[0] - edge,
            at[1] + edge
        );
        let b = format!(
            r#"{{"kind": "box", "half_extents": [{small}, {small}], "position": [{}, {}], "angle_deg": {angle}}}"#,
            at[0], at[1]
        );
        for of in [["A", "B"], ["B", "A"]] {
            let line = format!(
                r#"{{"shapes": {{"A": {a}, "B": {b}}},
                "query": {{"kind": "contact", "of": ["{}", "{}"]}}}}"#,
                of[0], of[1]
            );
            let line = line.replace('\n', " ");
            let found = Json::parse(&tracefig::solve_jsonl_line(&line, 1).line).expect("valid");
            let found = found.get("result").expect("a result");
            let contacts = found.get("contacts").map(|list| list.list().to_vec()).unwrap_or_default();
            for contact in &contacts {
                let [lo, hi] = contact.pair_at("separation_bounds").expect("bounds");
                assert!(hi - lo < 1e-6 * edge, "{edge}, {of:?}: {found}");
            }
        }
    }
}
