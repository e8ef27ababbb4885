//! Where a line of a page stands in its file.
//!
//! A page comes as the preprocessors before ours left it: `{{#include}}` has become what it includes, and
//! lines below it have other numbers than in the file. What is the same at the beginning or at the end of
//! both texts keeps its place; between them a line is known by itself and those that follow it.

/// The number of a page's line in the page's file, both from 1; `None` where the file does not have it, as
/// it was included. `page` and `file` are the texts.
pub(crate) fn line_in_file(page: &str, file: &str, line: usize) -> Option<usize> {
    let (page, file): (Vec<&str>, Vec<&str>) = (page.lines().collect(), file.lines().collect());
    let at = line.checked_sub(1).filter(|&at| at < page.len())?;
    let alike = page.iter().zip(&file).take_while(|(ours, theirs)| ours == theirs).count();
    if at < alike {
        return Some(line);
    }
    let from_end = page.len() - at;
    let ends = page.iter().rev().zip(file.iter().rev());
    if from_end <= ends.take_while(|(ours, theirs)| ours == theirs).count() {
        return Some(file.len() + 1 - from_end);
    }
    let run = |start: usize| page[at..].iter().zip(&file[start..]).take_while(|(a, b)| a == b).count();
    let candidates = (alike..file.len()).filter(|&start| file[start] == page[at]);
    // The first of those that go on alike for longest.
    let best =
        candidates.map(|start| (run(start), start)).max_by_key(|&(run, start)| (run, usize::MAX - start));
    best.map(|(_, start)| start + 1)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_below_an_include_has_its_place_in_the_file() {
        let file = "# One\n\n{{#include two.md}}\n\n```tracefig\nx = 1\n```\nThen\n{{#include two.md}}\n";
        let page = "# One\n\nTwo\nlines\nmore\n\n```tracefig\nx = 1\n```\nThen\nTwo\nlines\nmore\n";
        let at = |line| line_in_file(page, file, line);
        assert_eq!(at(1), Some(1));
        assert_eq!(at(7), Some(5), "the fence");
        assert_eq!(at(8), Some(6));
        assert_eq!(at(4), None, "an included line");
        assert_eq!(at(99), None);
    }

    #[test]
    fn lines_at_the_end_are_counted_from_there() {
        let file = "{{#include two.md}}\n```tracefig\nx = 1\n```";
        let page = "```tracefig\nx = 2\n```\n```tracefig\nx = 1\n```";
        assert_eq!(line_in_file(page, file, 4), Some(2));
        assert_eq!(line_in_file(page, page, 4), Some(4));
    }
}
