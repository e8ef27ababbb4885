//! "Did you mean": the nearest known word, or all of them.

#[cfg(not(tracefig_page))]
use super::meant::meant;

/// How many letters differ, where at most a third do: a word that differs by more is another word. At two
/// thirds `arc` would be suggested for `ray`; at a sixth a slip in a word of five letters would find nothing.
#[cfg(not(tracefig_page))]
fn is_near(got: &str, known: &str) -> Option<usize> {
    let distance = strsim::damerau_levenshtein(&got.to_lowercase(), &known.to_lowercase());
    (distance * 3 <= got.chars().count().max(known.chars().count())).then_some(distance)
}

/// A page changes numbers, and misspells no word.
#[cfg(tracefig_page)]
fn is_near(_: &str, _: &str) -> Option<usize> {
    None
}

/// A page has no words of other tools.
#[cfg(tracefig_page)]
fn meant<'k>(_: &str, _: &'k [String]) -> Option<&'k String> {
    None
}

/// Whether another tool's word means one of these.
pub(super) fn is_meant(got: &str, known: &[String]) -> bool {
    meant(got, known).is_some()
}

/// The known words that a word begins which lacks its unit, as `angle` begins `angle_deg` and `angle_rad`.
fn with_units(got: &str, known: &[String]) -> Vec<String> {
    let begun = known.iter().filter(|word| word.strip_prefix(got).is_some_and(|rest| rest.starts_with('_')));
    begun.map(|word| format!("`{word}`")).collect()
}

/// The nearest of the known words where one is near, else all of them.
pub(super) fn nearest_or_all(got: &str, known: &[String]) -> Option<String> {
    // A misspelt word is short; a long text is compared with nothing, as that takes quadratic time.
    const LONGEST_WORD: usize = 64;
    let begun = with_units(got, known);
    if !begun.is_empty() {
        return Some(format!("did you mean {}?", begun.join(" or ")));
    }
    let is_short = got.len() <= LONGEST_WORD;
    let near = || {
        let all = known.iter().filter_map(|word| is_near(got, word).map(|d| (d, word)));
        all.min_by_key(|&(d, _)| d).map(|(_, word)| word)
    };
    match is_short.then(|| meant(got, known).or_else(near)).flatten() {
        Some(word) => Some(format!("did you mean `{word}`?")),
        None if known.is_empty() => None,
        None => Some(format!("known are: {}", quoted(known))),
    }
}

/// Words for a message: `` `a`, `b` ``.
pub(super) fn quoted(words: &[String]) -> String {
    words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(list: &[&str]) -> Vec<String> {
        list.iter().map(|&w| w.to_owned()).collect()
    }

    #[test]
    fn the_nearest_word_is_suggested() {
        let known = words(&["radius", "center", "position"]);
        assert_eq!(nearest_or_all("raduis", &known).as_deref(), Some("did you mean `radius`?"));
        assert_eq!(nearest_or_all("centre", &known).as_deref(), Some("did you mean `center`?"));
    }

    #[test]
    fn a_word_of_another_tool_and_one_without_its_unit_are_understood() {
        let known = words(&["overlap", "separation"]);
        assert_eq!(nearest_or_all("distance", &known).as_deref(), Some("did you mean `separation`?"));
        assert_eq!(nearest_or_all("square", &known).as_deref(), Some("known are: `overlap`, `separation`"));
        // What is known is meant before what is spelt alike: an arc is no ray.
        let known = words(&["arc", "clip", "separating-axes"]);
        assert_eq!(nearest_or_all("sat", &known).as_deref(), Some("did you mean `separating-axes`?"));
        let known = words(&["angle_deg", "angle_rad", "angles"]);
        assert_eq!(
            nearest_or_all("angle", &known).as_deref(),
            Some("did you mean `angle_deg` or `angle_rad`?")
        );
    }

    #[test]
    fn a_far_word_lists_what_is_known() {
        let known = words(&["radius", "center"]);
        assert_eq!(nearest_or_all("banana", &known).as_deref(), Some("known are: `radius`, `center`"));
        assert_eq!(nearest_or_all("banana", &[]), None);
    }
}
