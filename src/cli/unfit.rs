//! Theme files that scenes refuse: what is wrong is said once for all scenes that say the same.

use std::fmt::Write as _;

use tracefig::drawing::Drawing;
use tracefig::figure::theme::{remedies, shortcomings};
use tracefig::output::Format;
use tracefig::scene::{SceneFile, visible};

use super::console::Console;
use super::own_themes::NoOwnTheme;
use super::themes::ChosenTheme;

/// How many scenes are named that say the same.
const NAMED: usize = 4;

/// What a scene has against a theme file.
pub(crate) struct Unfit {
    /// The scene.
    scene: String,
    /// The theme.
    theme: String,
    /// What is wrong.
    said: String,
    /// The message where no other scene says it.
    alone: String,
    /// Whether the scene was not drawn because of colours, which an option allows.
    is_refused: bool,
    /// What a message of it begins with.
    severity: &'static str,
}

impl Unfit {
    /// What readers can't tell apart in a drawing with a theme of a user's own; nothing for a fit one. The
    /// dark side counts where one of the `formats` shows it. `allowed` says that these are warnings, without
    /// the colours that would pass.
    pub(crate) fn colors(
        scene: &str,
        (chosen, drawing): (&ChosenTheme, &Drawing),
        mut formats: impl Iterator<Item = &'static Format>,
        allowed: bool,
    ) -> Vec<Self> {
        if chosen.file.is_none() {
            return Vec::new();
        }
        let (scene, theme) = (visible(scene).into_owned(), visible(&chosen.asked).into_owned());
        let severity = if allowed { "warning" } else { "error" };
        let unfit = |short| {
            let mut said = format!("{short}");
            let near = if allowed { Vec::new() } else { remedies(&chosen.theme, drawing, &short) };
            let near: Vec<_> = near.iter().map(|(role, color)| format!("{} {color}", role.name())).collect();
            if !near.is_empty() {
                let _ = write!(said, "; nearest that passes: {}", near.join(", or "));
            }
            let alone = format!("{severity}: {scene}, theme {theme}: {said}\n");
            let (scene, theme) = (scene.clone(), theme.clone());
            Self { scene, theme, said, alone, is_refused: !allowed, severity }
        };
        let is_dark = formats.any(|format| format.in_the_dark);
        let seen = shortcomings(&chosen.theme, drawing).into_iter().filter(|s| is_dark || !s.in_the_dark);
        seen.map(unfit).collect()
    }

    /// The message where no other scene says the same.
    pub(crate) fn message(&self) -> &str {
        &self.alone
    }

    /// A file that a scene names, and that is no theme.
    pub(crate) fn file(file: &SceneFile, none: NoOwnTheme) -> Self {
        let NoOwnTheme { theme, said, message: alone } = none;
        let scene = visible(&file.source.name).into_owned();
        Self { scene, theme, said, alone, is_refused: false, severity: "error" }
    }
}

/// Several scenes that say the same of a theme, or one.
struct Group {
    /// What the first of them says.
    first: Unfit,
    /// Names of the others, as many as are told.
    others: Vec<String>,
    /// How many the others are.
    count: usize,
}

/// What the scenes of a run have against their themes.
#[derive(Default)]
pub(crate) struct Unfits(Vec<Group>);

impl Unfits {
    /// Adds what a scene says.
    pub(crate) fn extend(&mut self, found: Vec<Unfit>) {
        for unfit in found {
            let alike = |group: &&mut Group| {
                let first = &group.first;
                (&first.theme, &first.said, first.severity) == (&unfit.theme, &unfit.said, unfit.severity)
            };
            match self.0.iter_mut().find(alike) {
                // A scene may have several files of a theme.
                Some(group) if group.first.scene == unfit.scene || group.others.contains(&unfit.scene) => {}
                Some(group) => {
                    group.count += 1;
                    if group.others.len() + 1 < NAMED {
                        group.others.push(unfit.scene);
                    }
                }
                None => self.0.push(Group { first: unfit, others: Vec::new(), count: 0 }),
            }
        }
    }

    /// What one scene says.
    pub(crate) fn of(found: Vec<Unfit>) -> Self {
        let mut all = Self::default();
        all.extend(found);
        all
    }

    /// Adds what a scene says that was asked by itself.
    pub(crate) fn join(&mut self, own: Self) {
        self.extend(own.found());
    }

    /// What is said, each thing once.
    pub(crate) fn found(self) -> Vec<Unfit> {
        self.0.into_iter().map(|group| group.first).collect()
    }

    /// The messages, one for each thing that is said; empty where nothing is.
    pub(crate) fn messages(&self) -> String {
        let mut lines = String::new();
        for Group { first, others, count } in &self.0 {
            if *count == 0 {
                lines.push_str(&first.alone);
                continue;
            }
            let Unfit { scene, theme, said, severity, .. } = first;
            let named: Vec<_> = std::iter::once(scene).chain(others).map(String::as_str).collect();
            let more = match count - others.len() {
                0 => String::new(),
                more => format!(" and {more} more"),
            };
            let (count, named) = (count + 1, named.join(", "));
            let _ = writeln!(lines, "{severity}: theme {theme}: {said} ({count} scenes: {named}{more})");
        }
        if self.0.iter().any(|group| group.first.is_refused) {
            lines.push_str("help: `--allow-similar` draws it all the same\n");
        }
        lines
    }

    /// Says them, after what is on standard output.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn tell(&self, console: &mut Console) -> std::io::Result<()> {
        let messages = self.messages();
        if messages.is_empty() {
            return Ok(());
        }
        std::io::Write::flush(&mut console.out)?;
        Console::message(&messages);
        Ok(())
    }
}
