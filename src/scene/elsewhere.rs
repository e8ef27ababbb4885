//! Where a key belongs that stands in another table, and what stands for one that means something else here.
//!
//! In TOML a key belongs to the table above it, so that one of the scene itself, written at the end of a
//! file, is taken for one of the last table: the commonest slip.

#[cfg(not(tracefig_page))]
use super::fields::{CANVAS, QUERY, ROOT, TableRows};

/// Where a key belongs that this table, which has the `known` ones, lacks; `None` where nobody has it.
#[cfg(not(tracefig_page))]
pub(super) fn elsewhere(key: &str, known: &[String]) -> Option<String> {
    if key == "depth" && known.iter().any(|word| word == "separation") {
        return Some("`separation` is minus the depth, where bodies overlap".to_owned());
    }
    let is_of = |rows: &&&TableRows| rows.fields.iter().any(|row| row.name == key);
    // What stands in a body or a layer is misspelt rather than out of place.
    let tables = [&ROOT, &CANVAS, &QUERY];
    let table = tables.iter().find(is_of)?;
    Some(match table.header {
        header if header != ROOT.header => format!("it is a key of `{header}`"),
        _ => "it is a key of the scene itself, which stands above the first `[table]`".to_owned(),
    })
}

/// A page changes numbers, and puts no key anywhere.
#[cfg(tracefig_page)]
pub(super) fn elsewhere(_: &str, _: &[String]) -> Option<String> {
    None
}

#[cfg(test)]
mod tests {
    use crate::scene::open_text;

    /// The help of the one thing that is wrong with a scene.
    fn help(text: &str) -> String {
        let bodies = "[shapes.A]\nkind = 'circle'\nradius = 1\n[shapes.B]\nkind = 'circle'\nradius = 1\n";
        let refused = open_text("s.toml", &format!("{bodies}{text}")).unwrap_err();
        assert_eq!(refused.problems.len(), 1, "{:?}", refused.problems);
        refused.problems[0].fault.help().unwrap_or_default()
    }

    #[test]
    fn a_key_of_another_table_is_sent_there() {
        let query = "[query]\nkind = 'separation'\nof = ['A', 'B']\n";
        let above = "it is a key of the scene itself, which stands above the first `[table]`";
        assert_eq!(help(&format!("caption = 'x'\n{query}")), above);
        assert_eq!(help(&format!("{query}lang = 'de'")), above);
        assert_eq!(help(&format!("{query}theme = 'dark'")), "it is a key of `[canvas]`");
        assert_eq!(help(&format!("tolerance = 1e-9\n{query}")), "it is a key of `[query]`");
        let said = "`separation` is minus the depth, where bodies overlap";
        assert_eq!(help(&format!("{query}[query.expected]\ndepth = 0.2")), said);
        assert!(help(&format!("raduis = 2\n{query}")).starts_with("did you mean"));
    }
}
