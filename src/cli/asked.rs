//! Which scenes the command line asks for, and as what: options of each command that draws.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::Args;
use clap::builder::PossibleValuesParser;
use tracefig::output::FORMATS;
use tracefig::scene::Variant;
use tracefig::scene::limits::MAX_SCALE;

use super::in_time::InTime;
use super::positive::up_to;
use super::project::{OpenProject, nearest};
use super::settings::{Flags, usual_formats};
use super::themes::AskedTheme;
use super::unplanned::Unplanned;
use super::variants::{Seeds, variant};

/// The help of `--format`.
fn format_help() -> String {
    let usual: Vec<&str> = usual_formats().iter().map(|format| format.name).collect();
    format!("Formats, separated by commas; default: those of the project file, else {}", usual.join(","))
}

/// Which scenes, and as what.
#[derive(Args)]
pub(crate) struct Asked {
    /// Scene files, or folders, which are searched in depth; `-` is standard input, of `render`; none: the
    /// scenes of the project file `tracefig.toml`, else all of figures/
    #[arg(value_name = "SCENE")]
    pub(crate) scenes: Vec<PathBuf>,
    /// Formats, separated by commas; the help says which are usual, from the table.
    #[arg(long, value_delimiter = ',', value_name = "FORMAT", help = format_help(),
        value_parser = PossibleValuesParser::new(FORMATS.iter().map(|f| f.name)))]
    pub(crate) format: Vec<String>,
    /// Themes, separated by commas: light, dark, print, auto, or a theme file FILE.toml, or its dark side
    /// FILE.toml#dark; with several, files are named STEM.THEME.EXT; default: those of the project file, else
    /// each scene's own
    #[arg(long, value_delimiter = ',', value_name = "THEME", value_parser = AskedTheme::read)]
    theme: Vec<AskedTheme>,
    /// Dots of an image for each page pixel; default: what the project file says, else 2
    #[arg(long, value_parser = scale)]
    scale: Option<f64>,
    /// `question` of an exercise, without any trace of the answer, `key` with the answer and the way to it,
    /// or both as `question,key`: STEM.question.EXT and STEM.key.EXT; default: the figure
    #[arg(long, value_delimiter = ',', value_name = "VARIANT", value_parser = variant)]
    variant: Vec<Variant>,
    /// Variants of an exercise by number, as 7 or 1..30: other bodies near the scene's own, whose answer has
    /// three digits at most, as STEM.07.EXT
    #[arg(long, value_delimiter = ',', value_name = "N|FROM..TO")]
    seed: Vec<Seeds>,
    /// Project file of all these scenes and lines; default: the nearest tracefig.toml upward from each scene,
    /// for lines from the working directory
    #[arg(long, value_name = "FILE")]
    project: Option<PathBuf>,
}

/// A scale as written on the command line.
fn scale(text: &str) -> Result<f64, String> {
    up_to(MAX_SCALE, text)
}

impl Asked {
    /// What the command line says of all scenes; `in_time` is how it wants figures to be shown in time.
    ///
    /// # Errors
    /// When the text of a theme file is wrong.
    pub(crate) fn flags<'c>(
        &'c self,
        output: Option<&'c Path>,
        in_time: Option<InTime>,
    ) -> Result<Flags<'c>, Unplanned> {
        let themes = self.theme.iter().map(|asked| asked.theme.clone());
        Ok(Flags {
            output,
            formats: &self.format,
            themes: themes.collect::<Result<_, _>>().map_err(Unplanned::Refused)?,
            scale: self.scale,
            variants: &self.variant,
            seeds: &self.seed,
            in_time,
            is_still: false,
            project: self.project.as_deref(),
        })
    }

    /// The project file of what has no folder of its own: the one that is named, else the nearest.
    ///
    /// # Errors
    /// When it can't be read, or is none.
    pub(crate) fn project(&self) -> Result<Option<OpenProject>, Unplanned> {
        match &self.project {
            Some(file) => OpenProject::read(file.clone()).map(Some),
            None => nearest(Path::new("")),
        }
    }

    /// Whether it asks for no other files than a project does.
    pub(crate) fn is_nothing(&self) -> bool {
        self.scenes.is_empty()
            && self.format.is_empty()
            && self.theme.is_empty()
            && self.variant.is_empty()
            && self.seed.is_empty()
    }

    /// Reads the theme files anew.
    ///
    /// # Errors
    /// Where one was a theme and is none any more; the themes are then as they were.
    pub(crate) fn read_themes_again(&mut self) -> Result<(), String> {
        self.theme = self.theme.iter().map(AskedTheme::again).collect::<Result<_, _>>()?;
        Ok(())
    }

    /// Whether a scene is to come from standard input.
    pub(crate) fn read_stdin(&self) -> bool {
        self.scenes.iter().any(|scene| scene.as_os_str() == "-")
    }

    /// The folders that the arguments name, and those of the files that they name, where they are there.
    pub(crate) fn named_folders(&self) -> BTreeSet<PathBuf> {
        let here = [PathBuf::new()];
        let named = if self.scenes.is_empty() { &here[..] } else { &self.scenes };
        let folder = |path: &PathBuf| {
            if path.is_dir() { Some(path.clone()) } else { path.parent().map(Path::to_owned) }
        };
        let themes = self.theme.iter().filter_map(|theme| theme.file()?.parent().map(Path::to_owned));
        let folders = named.iter().map(|path| folder(path).unwrap_or_default()).chain(themes);
        folders.filter(|folder| folder.as_os_str().is_empty() || folder.is_dir()).collect()
    }
}
