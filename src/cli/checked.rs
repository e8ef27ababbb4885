//! What `check` says of a scene, and of what lies beside scenes.

use tracefig::drift::report::Finding;

use super::Status;
use super::handout::Told;
use super::unfit::{Unfit, Unfits};

/// The state of a file that can't be drawn, read or written.
pub(crate) const ERROR: &str = "error";

/// The state of a figure that no scene gives.
pub(crate) const ORPHAN: &str = "orphan";

/// What `check` says of a scene.
pub(crate) struct Checked {
    /// A finding for each file, in the order of the job.
    pub(crate) findings: Vec<Finding>,
    /// What is said on standard error.
    pub(crate) messages: String,
    /// What the scene has against its themes, to be said once for all scenes.
    pub(crate) unfit: Vec<Unfit>,
    /// Why something could not be checked, the worst of it.
    pub(crate) status: Status,
    /// How many files were written that differed.
    pub(crate) accepted: usize,
    /// Whether a scene, or a folder of scenes, can't be read.
    pub(crate) is_unread: bool,
    /// What was said of each scene when it was drawn.
    pub(crate) told: Told,
}

impl Checked {
    /// Nothing is said yet.
    pub(crate) fn new() -> Self {
        let (findings, messages, unfit) = (Vec::new(), String::new(), Vec::new());
        Self {
            findings,
            messages,
            unfit,
            status: Status::Done,
            accepted: 0,
            is_unread: false,
            told: Told::new(),
        }
    }

    /// Remembers what is said of a scene, so that a document that holds it need not say it again.
    pub(crate) fn keep_told(&mut self, scene: String) {
        let own = Unfits::of(std::mem::take(&mut self.unfit));
        self.told.insert(scene, self.messages.clone() + &own.messages());
        self.unfit = own.found();
    }

    /// A scene that was not compared because of a bug, by its name and as people are shown it.
    pub(crate) fn bug((name, shown): (&str, &str)) -> Self {
        let mut bug = Self::new();
        let message = format!("error: {shown} was not drawn because of a bug of tracefig\n");
        bug.fail(name, Status::Bug, &message);
        bug
    }

    /// Adds what was found of other files.
    pub(crate) fn add(&mut self, other: Self) {
        self.findings.extend(other.findings);
        self.messages.push_str(&other.messages);
        self.unfit.extend(other.unfit);
        self.status = self.status.max(other.status);
        self.accepted += other.accepted;
        self.is_unread |= other.is_unread;
        self.told.extend(other.told);
    }

    /// Says something on standard error.
    pub(crate) fn say(&mut self, message: &str) {
        self.messages.push_str(message);
    }

    /// Adds a file that could not be checked, and why, which is said.
    pub(crate) fn fail(&mut self, file: &str, status: Status, message: &str) {
        self.say(message);
        self.miss(file, status, message);
    }

    /// Says what could not be written of a file that was checked, whose finding says it too.
    pub(crate) fn cant(&mut self, finding: &mut Finding, message: &str) {
        self.say(message);
        self.status = self.status.max(Status::Io);
        finding.details.extend(message.lines().map(str::to_owned));
    }

    /// Adds a file that could not be checked, why, and the place of that.
    pub(crate) fn miss(&mut self, file: &str, status: Status, message: &str) {
        let mut lines = message.lines();
        let why = lines.next();
        let place = lines.next().map(str::trim_start).filter(|line| line.starts_with("--> "));
        self.miss_by(file, status, why.into_iter().chain(place).map(str::to_owned).collect());
    }

    /// Adds a file that could not be checked, and the lines that say why.
    pub(crate) fn miss_by(&mut self, file: &str, status: Status, details: Vec<String>) {
        self.status = self.status.max(status);
        self.findings.push(Finding { details, ..Finding::new(file, ERROR) });
    }
}
