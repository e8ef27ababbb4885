//! Links that lead out of the book, as to the code that a page speaks of.
//!
//! In the repository they are paths from the page to a file. A published book has no such file: there they
//! lead to the same place below `code`, the address of the book's folder where the repository is shown.

use std::path::{Component, Path};

/// The address of what a link leads to, where that is a file outside the pages: `code` is that of the book's
/// folder, and from there lie the folder `src` of the pages and the page. `None` for all other links.
///
/// # Errors
/// In a sentence: the way to the file leads above where the address begins.
pub(super) fn address(code: &str, src: &Path, page: &Path, link: &str) -> Result<Option<String>, String> {
    let (path, behind) = link.split_at(link.find(['#', '?']).unwrap_or(link.len()));
    let has_scheme = path.split('/').next().is_some_and(|first| first.contains(':'));
    if path.is_empty() || path.starts_with('/') || has_scheme {
        return Ok(None);
    }
    let way = page.parent().unwrap_or(Path::new("")).join(path);
    let (mut above, mut parts) = (0, Vec::new());
    for part in way.components() {
        match part {
            Component::Normal(part) => parts.push(part.to_string_lossy()),
            Component::ParentDir if parts.pop().is_none() => above += 1,
            _ => {}
        }
    }
    let in_src = src.components().zip(&parts).all(|(a, b)| a.as_os_str() == b.as_ref());
    if above == 0 && in_src && parts.len() > src.components().count() {
        return Ok(None);
    }
    let mut base = code.trim_end_matches('/');
    let host = base.find("://").map_or(0, |at| at + "://".len());
    for _ in 0..above {
        let too_far = || format!("`{link}` leads above `code`, {code}");
        base = &base[..host + base[host..].rfind('/').ok_or_else(too_far)?];
    }
    Ok(Some(format!("{base}/{}{behind}", parts.join("/"))))
}

#[cfg(test)]
mod tests {
    use super::*;

    const CODE: &str = "https://example.org/us/it/blob/main/guide/";

    fn led(link: &str) -> Option<String> {
        address(CODE, Path::new("src"), Path::new("src/more/page.md"), link).unwrap()
    }

    #[test]
    fn files_outside_the_pages_have_an_address() {
        let at = |path: &str| Some(format!("https://example.org/us/it/blob/main/{path}"));
        assert_eq!(led("../../../src/gjk.rs#L3"), at("src/gjk.rs#L3"));
        assert_eq!(led("../../book.toml"), at("guide/book.toml"));
        assert_eq!(led("../../src-of-more/a.rs"), at("guide/src-of-more/a.rs"));
    }

    #[test]
    fn links_within_the_book_and_to_elsewhere_stay() {
        for link in ["two.md", "../one.md#three", "#here", "/top", "https://x.org/../a", "mailto:a@b.c"] {
            assert_eq!(led(link), None, "{link}");
        }
        let (src, page) = (Path::new(""), Path::new("page.md"));
        assert_eq!(address(CODE, src, page, "code.rs"), Ok(None), "the book's folder has the pages");
    }

    #[test]
    fn a_way_above_the_address_is_told() {
        let page = Path::new("src/page.md");
        let told = address("https://example.org/it", Path::new("src"), page, "../../../a.rs").unwrap_err();
        assert!(told.contains("leads above `code`"), "{told}");
    }
}
