//! Where the time goes: stages of the work and how long each took.

use std::fmt;
use std::time::{Duration, Instant};

/// How long each stage of the work took, in the order in which the stages first ended.
#[derive(Clone, Debug)]
pub(crate) struct Timings {
    /// When the last stage ended.
    last: Instant,
    /// How long each stage took in all.
    stages: Vec<(&'static str, Duration)>,
}

impl Timings {
    /// A clock that starts now, with no stage yet.
    pub(crate) fn start() -> Self {
        Self { last: Instant::now(), stages: Vec::new() }
    }

    /// A stage ends; the time since the last one is its.
    pub(crate) fn lap(&mut self, stage: &'static str) {
        let now = Instant::now();
        self.put(stage, now - self.last);
        self.last = now;
    }

    /// Adds the stages of another clock.
    pub(crate) fn add(&mut self, other: &Self) {
        for &(stage, time) in &other.stages {
            self.put(stage, time);
        }
    }

    fn put(&mut self, stage: &'static str, time: Duration) {
        match self.stages.iter_mut().find(|(name, _)| *name == stage) {
            Some((_, total)) => *total += time,
            None => self.stages.push((stage, time)),
        }
    }
}

impl fmt::Display for Timings {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all: Duration = self.stages.iter().map(|(_, time)| *time).sum();
        for (stage, time) in self.stages.iter().copied().chain([("all", all)]) {
            writeln!(f, "{stage:<6} {:>9.2} ms", time.as_secs_f64() * 1e3)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stages_add_up() {
        let (mut a, mut b) = (Timings::start(), Timings::start());
        a.put("read", Duration::from_millis(2));
        b.put("read", Duration::from_millis(3));
        b.put("draw", Duration::from_millis(1));
        a.add(&b);
        let text = "read        5.00 ms\ndraw        1.00 ms\nall         6.00 ms\n";
        assert_eq!(a.to_string(), text);
    }
}
