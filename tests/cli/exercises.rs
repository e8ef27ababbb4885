//! `--variant`: questions and keys of exercises, named apart from figures.

use crate::render::{names, set};
use crate::{CIRCLES, folder_with, run, tracefig};

fn exercise() -> String {
    format!("{CIRCLES}[exercise]\nask = \"d\"\nlength_unit = \"m\"\n")
}

#[test]
fn a_question_and_its_key_have_names_of_their_own() {
    let folder = folder_with("s.toml", &exercise());
    let render = |arguments: &[&str]| {
        run(tracefig(folder.path()).args(["render", "s.toml", "--format", "svg"]).args(arguments))
    };
    let ran = render(&["--variant", "question,key,question"]);
    assert_eq!((ran.code, ran.out.as_str()), (Some(0), "s.question.svg\ns.key.svg\n"), "{}", ran.err);
    assert_eq!(
        render(&["--variant", "key", "--theme", "dark,light"]).out,
        "s.key.dark.svg\ns.key.light.svg\n"
    );
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let (question, key) = (read("s.question.svg"), read("s.key.svg"));
    assert!(question.contains("\"variant\":\"question\"}") && !question.contains("\"answer\""));
    assert!(key.contains("\"answer\":{\"kind\":\"separation\"") && key.contains("Answer: "));
    assert!(!question.contains("nswer") && question.contains("Find how far A and B are apart"), "{question}");
    assert!(question.contains("Lengths are in m."), "{question}");
    // Both are up to date, and the one is not the other.
    assert_eq!(render(&["--variant", "question,key", "--skip-unchanged"]).out, "");
    std::fs::copy(folder.path().join("s.key.svg"), folder.path().join("s.question.svg")).unwrap();
    assert_eq!(render(&["--variant", "question,key", "--skip-unchanged"]).out, ran.out);
    let checked =
        run(tracefig(folder.path()).args(["check", "s.toml", "--format", "svg", "--variant", "key"]));
    assert_eq!(checked.code, Some(0), "{}{}", checked.out, checked.err);
    let both = render(&["--variant", "question,key", "-o", "one.svg"]);
    assert!(both.code == Some(2) && both.err.contains("`--variant`"), "{}", both.err);
}

#[test]
fn variants_by_number_are_files_of_their_own_and_the_same_however_many_are_asked_for() {
    let folder = folder_with("s.toml", &exercise());
    let render = |arguments: &[&str]| {
        run(tracefig(folder.path()).args(["render", "s.toml", "--format", "svg"]).args(arguments))
    };
    let ran = render(&["--variant", "question,key", "--seed", "2,1..2"]);
    let all = ["s.01.question.svg", "s.01.key.svg", "s.02.question.svg", "s.02.key.svg"];
    assert_eq!((ran.code, ran.out.lines().collect::<Vec<_>>()), (Some(0), all.to_vec()), "{}", ran.err);
    let read = |name: &str| std::fs::read_to_string(folder.path().join(name)).unwrap();
    let second = read("s.02.key.svg");
    assert!(read("s.01.key.svg") != second);
    assert_eq!(render(&["--variant", "key", "--seed", "2"]).out, "s.02.key.svg\n");
    assert!(read("s.02.key.svg") == second);
    assert_eq!(render(&["--variant", "key", "--seed", "1..2", "--skip-unchanged"]).out, "");
    for wrong in ["0", "3..2", "1001", "x"] {
        assert_eq!(render(&["--seed", wrong]).code, Some(2), "{wrong}");
    }
    let box_of = "kind = \"box\"\nhalf_extents = [1, 0.3]\nangle_deg = 17";
    let turned = exercise().replacen("kind = \"circle\"\nradius = 2", box_of, 1);
    std::fs::write(folder.path().join("s.toml"), turned).unwrap();
    let few = render(&["--seed", "1..1000"]);
    assert!(few.code == Some(1) && few.err.contains(" of 1000 variants have"), "{}", few.err);
}

#[test]
fn what_is_no_exercise_or_has_no_answer_is_refused() {
    let folder = folder_with("plain.toml", CIRCLES);
    std::fs::write(folder.path().join("deep.toml"), exercise().replace("\"d\"", "\"depth\"")).unwrap();
    let render =
        |scene: &str, word: &str| run(tracefig(folder.path()).args(["render", scene, "--variant", word]));
    let plain = render("plain.toml", "key");
    assert!(plain.code == Some(1) && plain.err.contains("plain.toml is no exercise"), "{}", plain.err);
    let deep = render("deep.toml", "question");
    assert!(deep.code == Some(1) && deep.err.contains("the bodies are apart"), "{}", deep.err);
    assert!(deep.err.contains("ask = \"depth\""), "the line is quoted: {}", deep.err);
    assert_eq!(render("deep.toml", "answer").code, Some(2));
    assert_eq!(names(folder.path()), set(&["deep.toml", "plain.toml"]));
}

#[test]
fn the_exercises_of_the_guide_are_drawn_without_a_warning() {
    let out = tempfile::tempdir().unwrap();
    let guide = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("guide/exercises");
    let ran = run(tracefig(out.path())
        .args(["render", "--strict", "--format", "svg", "--variant", "question,key", "-o", "."])
        .arg(guide));
    assert_eq!((ran.code, ran.err.as_str()), (Some(0), ""));
    assert!(ran.out.lines().count() >= 8, "{}", ran.out);
}
