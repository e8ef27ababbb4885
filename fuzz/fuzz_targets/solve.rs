//! Any line to `solve --jsonl`: one line of JSON comes back, whose bounds are in order and hold the value.
#![no_main]

use libfuzzer_sys::fuzz_target;

fuzz_target!(|text: &str| {
    let reply = tracefig::solve_jsonl_line(text, 1).line;
    assert!(!reply.trim_end().contains('\n'), "{reply}");
    let Some(after) = reply.split("\"separation_bounds\":").nth(1) else { return };
    let numbers: Vec<f64> = after
        .trim_start_matches([' ', '['])
        .split([',', ']'])
        .take(2)
        .filter_map(|number| number.trim().parse().ok())
        .collect();
    assert!(numbers.len() == 2 && numbers[0] <= numbers[1], "{reply}");
});
