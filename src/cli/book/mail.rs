//! How mdBook and its preprocessors speak: `[context, book]` as JSON in, the book out.
//!
//! Only what is needed is read, wherever a version has it, and all else is handed back as it came: 0.4 calls
//! the list of a book `sections`, 0.5 `items`.

use std::path::{Path, PathBuf};

use serde_json::Value;

/// What mdBook sent.
#[derive(Debug)]
pub(crate) struct Mail {
    /// The folder of the book.
    pub(crate) root: PathBuf,
    /// The folder of its pages, from there.
    pub(crate) src: PathBuf,
    /// The renderer that the pages are for.
    pub(crate) renderer: String,
    /// The theme file that figures of the book have, from its folder.
    pub(crate) theme: Option<String>,
    /// The address of the book's folder where its repository is shown.
    pub(crate) code: Option<String>,
    /// The scripts that the pages load besides those of mdBook, from the book's folder.
    pub(crate) scripts: Vec<PathBuf>,
    /// The book.
    pub(crate) book: Value,
}

/// A page of a book.
#[derive(Debug)]
pub(crate) struct Page<'b> {
    /// Its path from the folder of the pages.
    pub(crate) path: PathBuf,
    /// Its text, to be replaced.
    pub(crate) content: &'b mut String,
}

impl Mail {
    /// Reads what mdBook sent.
    ///
    /// # Errors
    /// In a sentence: it is no JSON, or has no book.
    pub(crate) fn read(bytes: &[u8]) -> Result<Self, String> {
        let sent: Value = serde_json::from_slice(bytes).map_err(|e| format!("no JSON from mdBook: {e}"))?;
        let Value::Array(mut parts) = sent else { return Err(unlike()) };
        let (Some(book), Some(context)) = (parts.pop(), parts.pop()) else { return Err(unlike()) };
        let text = |at: &str| context.pointer(at).and_then(Value::as_str);
        let renderer = text("/renderer").ok_or_else(unlike)?.to_owned();
        let root = PathBuf::from(text("/root").ok_or_else(unlike)?);
        let src = PathBuf::from(text("/config/book/src").unwrap_or("src"));
        let theme = text("/config/preprocessor/tracefig/theme").map(str::to_owned);
        let code = text("/config/preprocessor/tracefig/code").map(str::to_owned);
        let scripts = context.pointer("/config/output/html/additional-js").and_then(Value::as_array);
        let scripts = scripts.into_iter().flatten().filter_map(Value::as_str).map(PathBuf::from).collect();
        if list(&book).is_none() {
            return Err(unlike());
        }
        Ok(Self { root, src, renderer, theme, code, scripts, book })
    }

    /// The pages with a file, in the order of the book.
    pub(crate) fn pages(&mut self) -> Vec<Page<'_>> {
        let mut pages = Vec::new();
        if let Some(name) = list(&self.book) {
            collect(self.book.get_mut(name), &mut pages);
        }
        pages
    }
}

/// What is said where the book is not where it should be.
fn unlike() -> String {
    "expected `[context, book]` from mdBook on standard input".to_owned()
}

/// The key of a book's list.
fn list(book: &Value) -> Option<&'static str> {
    ["items", "sections"].into_iter().find(|name| book.get(name).is_some_and(Value::is_array))
}

/// Adds the pages of a list and of the lists within.
fn collect<'b>(items: Option<&'b mut Value>, pages: &mut Vec<Page<'b>>) {
    for item in items.and_then(Value::as_array_mut).into_iter().flatten() {
        let Some(Value::Object(chapter)) = item.get_mut("Chapter") else { continue };
        // The file is read for the numbers of its lines only; a draft has none.
        let path = ["source_path", "path"].into_iter().find_map(|key| chapter.get(key)?.as_str());
        let path = path.map(|path| Path::new(path).to_owned());
        let (mut content, mut below) = (None, None);
        for (key, value) in chapter.iter_mut() {
            match (key.as_str(), value) {
                ("content", Value::String(text)) => content = Some(text),
                ("sub_items", items) => below = Some(items),
                _ => {}
            }
        }
        pages.extend(path.zip(content).map(|(path, content)| Page { path, content }));
        collect(below, pages);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn book(list: &str) -> String {
        let two = r##"{"Chapter": {"name": "2", "content": "# Two", "sub_items": [], "path": "a/2.md"}}"##;
        let one = format!(
            r##"{{"Chapter": {{"name": "1", "content": "# One", "sub_items": [{two}], "new": [1],
            "path": "index.md", "source_path": "README.md"}}}}"##
        );
        let draft = r#"{"Chapter": {"name": "3", "content": "", "sub_items": [], "path": null}}"#;
        format!(
            r#"[{{"root": "/book", "renderer": "html", "config": {{"book": {{"src": "pages"}}}}}},
            {{"{list}": ["Separator", {{"PartTitle": "I"}}, {one}, {draft}], "other": null}}]"#
        )
    }

    #[test]
    fn both_names_of_the_list_are_read_and_all_else_comes_back() {
        for list in ["sections", "items"] {
            let text = book(list);
            let mut mail = Mail::read(text.as_bytes()).unwrap();
            assert_eq!((mail.renderer.as_str(), mail.src.as_path()), ("html", Path::new("pages")));
            let before = mail.book.to_string();
            let paths: Vec<PathBuf> = mail.pages().into_iter().map(|page| page.path).collect();
            assert_eq!(paths, ["README.md", "a/2.md"].map(PathBuf::from));
            assert_eq!(mail.book.to_string(), before);
            *mail.pages()[1].content = "changed".to_owned();
            assert_eq!(mail.book.to_string(), before.replace("# Two", "changed"));
        }
    }

    #[test]
    fn what_is_no_book_is_refused() {
        for text in ["", "{}", "[]", "[{}, {}]", &book("pages")] {
            let told = Mail::read(text.as_bytes()).unwrap_err();
            assert!(told.contains("from mdBook"), "{told}");
        }
    }
}
