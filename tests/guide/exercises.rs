//! Exercises at the end of chapters: each on one page, its key folded away and with the numbers of the tool.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use tracefig::figure::exercise::{answer_in_words, asked};
use tracefig::figure::plan;
use tracefig::scene::open;

use crate::pages::{all, built};
use crate::src;

/// What stands before the path of an exercise on a page, and behind it.
const ORDER: [&str; 2] = ["{{#tracefig ../exercises/", " exercise}}"];

/// The files of exercises that a page asks for.
fn orders(text: &str) -> Vec<&str> {
    text.split(ORDER[0]).skip(1).filter_map(|rest| rest.split_once(ORDER[1]).map(|(file, _)| file)).collect()
}

/// Pages that end with exercises, with the files of those.
fn chapters() -> Vec<((PathBuf, String), Vec<String>)> {
    let with = |page: (PathBuf, String)| {
        let files = orders(&page.1).into_iter().map(str::to_owned).collect::<Vec<_>>();
        (page, files)
    };
    all().into_iter().map(with).filter(|(_, files)| !files.is_empty()).collect()
}

#[test]
fn every_chapter_of_ideas_ends_with_two_and_every_exercise_stands_once() {
    let chapters = chapters();
    assert!(chapters.len() >= 11, "{} chapters", chapters.len());
    let mut counts: BTreeMap<String, usize> = BTreeMap::new();
    for ((path, _), files) in &chapters {
        assert!(files.len() >= 2, "{}", path.display());
        for file in files {
            *counts.entry(file.clone()).or_default() += 1;
        }
    }
    let folder = src().with_file_name("exercises");
    let there = folder.read_dir().unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let there: BTreeMap<String, usize> = there.map(|name| (name, 1)).collect();
    assert_eq!(counts, there);
}

/// What a key says of each number of an exercise.
fn answers(path: &Path) -> Vec<String> {
    let file = open(path).unwrap();
    let plan = plan(&file.scene).unwrap();
    asked(&plan).iter().map(|number| answer_in_words(&plan, number)).collect()
}

#[test]
fn a_key_is_folded_away_with_the_numbers_of_the_tool_and_the_question_lacks_them() {
    let chapters = chapters();
    let pages: Vec<_> = chapters.iter().map(|(page, _)| page.clone()).collect();
    for (text, ((path, _), files)) in built(&pages, ("", "")).iter().zip(&chapters) {
        let (_, exercises) = text.rsplit_once("## Exercises").unwrap();
        let mut parts = exercises.split("<details><summary>Answer</summary>");
        let mut question = parts.next().unwrap();
        for (file, part) in files.iter().zip(parts) {
            let (key, next) = part.split_once("</details>").unwrap();
            for answer in answers(&src().with_file_name("exercises").join(file)) {
                let what = answer.split(", proved").next().unwrap();
                assert!(key.contains(what), "{}: {file} lacks {what}", path.display());
                assert!(!question.contains(what), "{}: {file} gives {what} away", path.display());
            }
            question = next;
        }
        assert_eq!(exercises.matches("<details>").count(), files.len());
    }
}
