//! Runs that are killed, that race or whose disk is full: every file is whole, and what a dead run left is
//! cleared.

use std::collections::BTreeMap;
use std::path::Path;
use std::process::{Child, Command, Output, Stdio};
use std::thread;
use std::time::Duration;

use tracefig_reference::random::Random;

use crate::render::{drawn, names, set};
use crate::{TRACEFIG, folder_with, run, tracefig};

/// Runs that are killed, over all threads.
const KILLS: u32 = 200;
/// Runs at once.
const THREADS: u32 = 4;
/// Scenes of a run; each becomes two files.
const SCENES: u32 = 3;

/// A small page, so that a run is short.
fn small() -> String {
    format!("{}[canvas]\nwidth = 200\nheight = 150\n", drawn())
}

fn start(folder: &Path, arguments: &[&str]) -> Child {
    Command::new(TRACEFIG)
        .arg("render")
        .args(arguments)
        .current_dir(folder)
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

/// Every file with its bytes.
fn contents(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    names(folder).into_iter().map(|name| (name.clone(), std::fs::read(folder.join(name)).unwrap())).collect()
}

fn is_part(name: &str) -> bool {
    name.starts_with(".tracefig-")
}

/// What one kill found.
enum Found {
    /// The run had ended by itself.
    Late,
    /// Nothing was written yet.
    Early,
    /// Some files were there and some were not.
    Between,
}

/// Kills a run after a while. Afterwards every visible file is as it should be; they are then removed, parts
/// are not.
fn kill(folder: &Path, after: Duration, whole: &BTreeMap<String, Vec<u8>>) -> Found {
    let mut child = start(folder, &[".", "--scale", "1", "-o", "out"]);
    thread::sleep(after);
    child.kill().unwrap();
    let ended = child.wait().unwrap();
    let out = folder.join("out");
    if !out.exists() {
        return Found::Early;
    }
    let mut files = contents(&out);
    files.retain(|name, _| !is_part(name));
    for (name, bytes) in &files {
        assert!(whole.get(name) == Some(bytes), "{name} is not whole after {after:?}");
        std::fs::remove_file(out.join(name)).unwrap();
    }
    match files.len() {
        _ if ended.success() => Found::Late,
        0 => Found::Early,
        _ => Found::Between,
    }
}

/// Kills runs in a folder at random points of a span that follows how long runs take; returns how many were
/// killed between their first and their last file.
fn kill_many(folder: &Path, seed: u64, whole: &BTreeMap<String, Vec<u8>>) -> u32 {
    let (mut random, mut span, mut between) = (Random::new(seed), Duration::from_millis(200), 0);
    for _ in 0..KILLS / THREADS {
        match kill(folder, span.mul_f64(random.unit()), whole) {
            Found::Late => span = span * 9 / 10,
            Found::Early => span = span * 11 / 10,
            Found::Between => between += 1,
        }
    }
    between
}

#[test]
fn runs_killed_at_200_random_points_leave_whole_files_and_the_next_run_clears_up() {
    let folders: Vec<_> = (0..THREADS)
        .map(|_| {
            let folder = folder_with("s0.toml", &small());
            for i in 1..SCENES {
                std::fs::write(folder.path().join(format!("s{i}.toml")), small()).unwrap();
            }
            folder
        })
        .collect();
    let whole = run(tracefig(folders[0].path()).args(["render", ".", "--scale", "1", "-o", "whole"]));
    assert_eq!(whole.code, Some(0), "{}", whole.err);
    let whole = contents(&folders[0].path().join("whole"));
    let between: u32 = thread::scope(|scope| {
        let (folders, whole) = (&folders, &whole);
        let threads: Vec<_> = (0..THREADS)
            .zip(folders)
            .map(|(i, folder)| scope.spawn(move || kill_many(folder.path(), i.into(), whole)))
            .collect();
        threads.into_iter().map(|thread| thread.join().unwrap()).sum()
    });
    // Otherwise the points were not where it matters.
    assert!(between >= KILLS / 20, "{between} of {KILLS} runs were killed while writing");
    for folder in &folders {
        let last = run(tracefig(folder.path()).args(["render", ".", "--scale", "1", "-o", "out"]));
        assert_eq!(last.code, Some(0), "{}", last.err);
        assert!(contents(&folder.path().join("out")) == whole, "{:?}", names(&folder.path().join("out")));
    }
}

#[test]
fn the_part_of_a_dead_run_is_cleared_wherever_a_run_writes() {
    let folder = folder_with("s.toml", &small());
    let part = folder.path().join(".tracefig-Ab3xYz.part");
    for arguments in [&["render", "s.toml"][..], &["check", "s.toml", "--accept"]] {
        std::fs::write(&part, "half a pict").unwrap();
        assert_eq!(run(tracefig(folder.path()).args(arguments)).code, Some(0));
        assert!(!part.exists(), "{arguments:?}");
    }
    std::fs::write(&part, "half a pict").unwrap();
    assert_eq!(run(tracefig(folder.path()).args(["check", "s.toml"])).code, Some(0));
    assert!(part.exists(), "a check alone writes nothing, and removes nothing");
}

#[test]
fn runs_that_race_leave_whole_files() {
    let folder = folder_with("s.toml", &small());
    for round in 0..10 {
        std::fs::write(folder.path().join(".tracefig-left.part"), "half a pict").unwrap();
        let children: Vec<_> = (0..4).map(|_| start(folder.path(), &["s.toml", "--format", "svg"])).collect();
        for child in children {
            let ended = child.wait_with_output().unwrap();
            assert!(ended.status.success(), "round {round}: {}", String::from_utf8_lossy(&ended.stderr));
        }
        assert_eq!(names(folder.path()), set(&["s.svg", "s.toml"]));
    }
    assert_eq!(run(tracefig(folder.path()).args(["check", "s.toml", "--format", "svg"])).code, Some(0));
}

/// Runs a shell script in a folder; `$0` is the built binary.
fn script(folder: &Path, shell: &[&str], script: &str) -> Output {
    Command::new(shell[0])
        .args(&shell[1..])
        .args(["-c", script])
        .arg(TRACEFIG)
        .current_dir(folder)
        .output()
        .unwrap()
}

#[cfg(target_os = "linux")]
#[test]
fn a_file_that_finds_no_room_leaves_the_old_one() {
    let folder = folder_with("s.toml", &small());
    assert_eq!(run(tracefig(folder.path()).args(["render", "s.toml"])).code, Some(0));
    let before = contents(folder.path());
    std::fs::write(folder.path().join("s.toml"), small().replace("radius = 1", "radius = 1.5")).unwrap();
    // A write past the limit fails, as on a full disk, once the signal is ignored.
    let ran = script(folder.path(), &["sh"], "trap '' XFSZ; ulimit -f 1; exec \"$0\" render s.toml");
    assert_eq!(ran.status.code(), Some(74), "{ran:?}");
    let err = String::from_utf8_lossy(&ran.stderr);
    assert!(err.contains("error: can't write s.svg: File too large"), "{err}");
    assert!(err.contains("error: can't write s.png: File too large"), "{err}");
    let mut after = contents(folder.path());
    after.insert("s.toml".to_owned(), before["s.toml"].clone());
    assert!(after == before, "{:?}", names(folder.path()));
}

/// Needs a file system of its own; where none may be mounted, the limit above has to do.
#[cfg(target_os = "linux")]
#[test]
fn on_a_full_disk_what_fits_is_whole_and_the_rest_is_told() {
    let folder = tempfile::tempdir().unwrap();
    for name in ["disk", "saved", "scenes"] {
        std::fs::create_dir(folder.path().join(name)).unwrap();
    }
    for i in 0..12 {
        std::fs::write(folder.path().join(format!("scenes/s{i:02}.toml")), small()).unwrap();
    }
    assert_eq!(run(tracefig(folder.path()).args(["render", "scenes", "-o", "whole"])).code, Some(0));
    let mount = "mount -t tmpfs -o size=64k none disk";
    let own = ["unshare", "-rm", "sh"];
    let mounts = Command::new(own[0]).args(&own[1..]).args(["-c", mount]).current_dir(folder.path()).output();
    if !mounts.is_ok_and(|output| output.status.success()) {
        println!("skipped: no file system may be mounted here");
        return;
    }
    let render = "\"$0\" render scenes -o disk; status=$?; cp -a disk/. saved; exit $status";
    let ran = script(folder.path(), &own, &format!("{mount} && {render}"));
    let err = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.code() == Some(74) && err.contains("No space left on device"), "{ran:?}");
    let (saved, whole) = (contents(&folder.path().join("saved")), contents(&folder.path().join("whole")));
    assert!(!saved.is_empty() && saved.len() < whole.len(), "{:?}", saved.keys());
    assert!(saved.iter().all(|(name, bytes)| whole.get(name) == Some(bytes)), "{:?}", saved.keys());
}
