//! `report`: what is finished is kept when it is stopped.

use crate::{TRACEFIG, run, tracefig};

#[test]
fn a_filter_that_matches_nothing_is_told() {
    let folder = tempfile::tempdir().unwrap();
    let ran = run(tracefig(folder.path()).args(["report", "--filter", "no such workload"]));
    assert_eq!((ran.code, ran.out.as_str()), (Some(1), ""));
    assert_eq!(ran.err, "error: no workload's name contains `no such workload`\n");
}

#[cfg(unix)]
#[test]
fn ctrl_c_leaves_what_is_finished() {
    use std::process::{Command, Stdio};
    let folder = tempfile::tempdir().unwrap();
    // On a busy machine the signal may come before anyone listens: then once more, later.
    let ended = (1..6)
        .map(|seconds| {
            let child = Command::new(TRACEFIG)
                .args(["report", "--quick", "-o", "out"])
                .current_dir(folder.path())
                .stdout(Stdio::null())
                .stderr(Stdio::piped())
                .spawn()
                .unwrap();
            std::thread::sleep(std::time::Duration::from_secs(seconds));
            let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap();
            assert!(killed.success());
            child.wait_with_output().unwrap()
        })
        .find(|ended| ended.status.code().is_some())
        .unwrap();
    let err = String::from_utf8_lossy(&ended.stderr);
    assert_eq!(ended.status.code(), Some(1), "{err}");
    assert_eq!(err, "error: stopped: the report holds what was finished\n");
    let json = std::fs::read_to_string(folder.path().join("out/report.json")).unwrap();
    let report: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert!(report.is_object(), "{json}");
    assert!(folder.path().join("out/report.md").exists());
}
