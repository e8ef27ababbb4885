//! How the cost of a figure grows with its trace: time and memory for 10, 100, 1,000 and 10,000 shapes' worth
//! of events.
//!
//! ```text
//! cargo bench --bench growth
//! ```
//!
//! A shape's worth are the events that one shape of Figure 4 leaves, four edges of a difference. Events come
//! from many vertices (up to the limit of a shape) or from many iterations. Each figure is read, answered
//! with its trace, drawn, and written as SVG and PNG; of a few rounds the one with the least processor time
//! counts. Memory is the most that was allocated at one time. What it has more than that of the smallest
//! figure is told as a multiple of what the output (SVG, PNG and the trace as JSON lines) has more. The bench
//! fails where events cost more than [`MOST_TIME`] times the time that fewer did, each, or where memory grows
//! by more than [`MOST_MEMORY`] times the output.

#![expect(clippy::print_stdout, reason = "a table for whoever runs it")]

use std::error::Error;
use std::hint::black_box;
use std::time::{Duration, Instant};

use tracefig::drawing::Drawing;
use tracefig::figure::{draw, plan};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Source, read};
use tracefig::trace::{Trace, json_lines};

/// Events that a shape of Figure 4 leaves.
const A_SHAPE: usize = 4;

/// What an event of a longer trace may cost, as a multiple of one of a shorter: 1, and room for an unquiet
/// machine.
const MOST_TIME: f64 = 1.5;

/// Bytes at one time for each byte of output. The display list keeps a path of some 400 bytes for an edge
/// that an SVG says in 120: the aim of 2 is not reached.
const MOST_MEMORY: f64 = 8.0;

/// Rounds; the fastest counts.
const ROUNDS: usize = 3;

/// Figures whose traces grow in one way.
struct Family {
    name: &'static str,
    scene: fn(usize) -> String,
    sizes: [usize; 4],
}

const FAMILIES: [Family; 2] = [
    Family { name: "many vertices", scene: vertices, sizes: [10, 100, 1_000, 4_096] },
    Family { name: "many iterations", scene: iterations, sizes: [2, 23, 230, 2_300] },
];

/// What one figure costs.
struct Cost {
    events: usize,
    /// Reading and answering, drawing, SVG, PNG.
    times: [Duration; 4],
    memory: u64,
    output: usize,
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut slow = Vec::new();
    for Family { name, scene, sizes } in FAMILIES {
        println!("\n{name}\n");
        println!(
            "| events | shapes' worth | trace, ms | draw, ms | SVG, ms | PNG, ms | µs an event | memory, MB | output, MB | more memory / more output |"
        );
        println!("|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|");
        let mut costs: Vec<Cost> = Vec::new();
        for size in sizes {
            let cost = cost(&scene(size))?;
            tell(&cost, costs.first());
            costs.push(cost);
        }
        slow.extend(costs.windows(2).filter_map(|pair| too_slow(name, &pair[0], &pair[1])));
        slow.extend(costs.last().and_then(|last| too_large(name, &costs[0], last)));
    }
    if slow.is_empty() { Ok(()) } else { Err(slow.join("; ").into()) }
}

/// Vertices of a regular polygon about the origin.
#[expect(clippy::cast_precision_loss, reason = "some thousand vertices")]
fn polygon(count: usize, phase: f64) -> String {
    let vertex = |i: usize| {
        let angle = std::f64::consts::TAU * (i as f64 + phase) / count as f64;
        format!("[{}, {}]", libm::cos(angle), libm::sin(angle))
    };
    (0..count).map(vertex).collect::<Vec<_>>().join(", ")
}

/// Two regular polygons of so many vertices, and their difference.
fn vertices(count: usize) -> String {
    format!(
        r#"{{"title": "Growth", "shapes": {{
            "A": {{"kind": "polygon", "vertices": [{}]}},
            "B": {{"kind": "polygon", "vertices": [{}], "position": [2.6, 0.8]}}}},
        "query": {{"kind": "separation", "of": ["A", "B"], "algorithm": "merge"}},
        "panels": [
            {{"space": "world", "layers": ["shapes", "separation", "normal"]}},
            {{"space": "configuration", "layers": ["axes", "difference", "origin", "closest"]}}]}}"#,
        polygon(count, 0.0),
        polygon(count, 0.3)
    )
}

/// A wheel that turns by tenths of a degree close above a box: conservative advancement steps by the gap over
/// the speed of its rim.
#[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
fn iterations(count: usize) -> String {
    let degrees = count as f64 / 10.0;
    format!(
        r#"{{"title": "Growth", "shapes": {{
            "A": {{"kind": "box", "half_extents": [1, 0.5]}},
            "B": {{"kind": "polygon", "vertices": [{}], "position": [0, 1.51], "angular_velocity_deg": {degrees}}}}},
        "query": {{"kind": "time-of-impact", "of": ["A", "B"], "algorithm": "conservative-advancement"}},
        "panels": [
            {{"space": "world", "layers": ["shapes"]}},
            {{"space": "configuration", "time": 0, "layers": ["axes", {{"layer": "difference", "at": "steps"}}, "origin"]}}]}}"#,
        polygon(32, 0.0)
    )
}

/// Makes a figure of a scene, a few times.
fn cost(text: &str) -> Result<Cost, Box<dyn Error>> {
    let mut best: Option<Cost> = None;
    for _ in 0..ROUNDS {
        let mut made = None;
        let used = allocation_counter::measure(|| made = Some(figure(text)));
        let (events, times, output) = made.ok_or("nothing was measured")??;
        let earlier = best.map_or([Duration::MAX; 4], |b: Cost| b.times);
        let times = std::array::from_fn(|i| times[i].min(earlier[i]));
        best = Some(Cost { events, times, memory: used.bytes_max, output });
    }
    best.ok_or_else(|| "no rounds".into())
}

/// Count of events, times, and bytes of output of one figure.
fn figure(text: &str) -> Result<(usize, [Duration; 4], usize), String> {
    let start = Instant::now();
    let now = || processor_time().unwrap_or_else(|| start.elapsed());
    let mut clock = now();
    let mut lap = || {
        let before = std::mem::replace(&mut clock, now());
        clock.saturating_sub(before)
    };
    let scene = read(&Source::new("growth.json", text)).map_err(|p| format!("{p:?}"))?;
    let mut trace = Trace::default();
    black_box((scene.query().algorithm.traced)(&scene.query_of_bodies(), &mut trace));
    let story = json_lines(&trace).map_err(|error| error.to_string())?.len();
    let events = trace.events.len();
    drop(trace);
    let tracing = lap();
    let plan = plan(&scene).map_err(|p| format!("{p:?}"))?;
    let drawing = draw(&plan, plan.theme, "growth").drawing;
    let drawn = lap();
    let svg = written(&drawing, "svg")?;
    let svg_time = lap();
    let png = written(&drawing, "png")?;
    let png_time = lap();
    Ok((events, [tracing, drawn, svg_time, png_time], svg.len() + png.len() + story))
}

/// What this thread has used of a processor so far, where the system tells (Linux does, in nanoseconds).
fn processor_time() -> Option<Duration> {
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok()?;
    told.split(' ').next()?.parse().ok().map(Duration::from_nanos)
}

fn written(drawing: &Drawing, name: &str) -> Result<Vec<u8>, String> {
    match format(name).map(|f| f.write) {
        Some(Writer::One(write)) => write(drawing, &Options::default()).map_err(|error| error.to_string()),
        _ => Err(format!("no format {name}")),
    }
}

#[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
fn tell(cost: &Cost, first: Option<&Cost>) {
    let ms = |i: usize| cost.times[i].as_secs_f64() * 1e3;
    let all: f64 = (0..4).map(ms).sum();
    let ratio = first.map_or("–".to_owned(), |first| format!("{:.2}", memory_ratio(first, cost)));
    println!(
        "| {} | {} | {:.2} | {:.2} | {:.2} | {:.2} | {:.1} | {:.2} | {:.2} | {ratio} |",
        cost.events,
        cost.events / A_SHAPE,
        ms(0),
        ms(1),
        ms(2),
        ms(3),
        all * 1e3 / cost.events as f64,
        cost.memory as f64 / 1e6,
        cost.output as f64 / 1e6,
    );
}

#[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
fn memory_ratio(first: &Cost, cost: &Cost) -> f64 {
    cost.memory.saturating_sub(first.memory) as f64 / (cost.output.saturating_sub(first.output)).max(1) as f64
}

#[expect(clippy::cast_precision_loss, reason = "far below 2^53")]
fn too_slow(name: &str, small: &Cost, large: &Cost) -> Option<String> {
    let total = |cost: &Cost| cost.times.iter().sum::<Duration>().as_secs_f64();
    let (time, events) = (total(large) / total(small), large.events as f64 / small.events as f64);
    (time > (events * MOST_TIME).max(1.0))
        .then(|| format!("{name}: {events:.1} times the events took {time:.1} times as long"))
}

fn too_large(name: &str, first: &Cost, last: &Cost) -> Option<String> {
    let ratio = memory_ratio(first, last);
    (ratio > MOST_MEMORY).then(|| format!("{name}: memory grows {ratio:.2} times as fast as the output"))
}
