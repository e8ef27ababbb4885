//! The theme that a scene asks for by name.

use crate::scene::{self, Scene};

use super::fault::{Fault, Problem};
use super::theme::{self, THEMES, Theme};

/// The theme that the scene asks for; the default where it does not say, or names one that there is not.
pub(super) fn theme_of(scene: &Scene, problems: &mut Vec<Problem>) -> &'static Theme {
    let Some(asked) = &scene.canvas.theme else { return &THEMES[0] };
    if theme::is_file(&asked.value) {
        let reason = "it is a file, which this command does not read".to_owned();
        let fault = Fault::BadTheme { name: asked.value.clone(), reason };
        problems.push(Problem::new(fault, asked.span.clone()));
        return &THEMES[0];
    }
    theme::find(&asked.value).unwrap_or_else(|| {
        let known = THEMES.iter().map(|t| t.name.to_owned()).collect();
        let fault = scene::Fault::UnknownWord { what: "theme", got: asked.value.clone(), known };
        problems.push(Problem::new(fault.into(), asked.span.clone()));
        &THEMES[0]
    })
}
