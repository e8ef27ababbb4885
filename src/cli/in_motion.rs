//! `--motion`: a figure that plays, in one file or in a file a picture.

use clap::Args;
use tracefig::figure::theme::Theme;
use tracefig::figure::{Fault, Figure, Plan, draw, draw_in_motion, draw_in_steps, plan, plan_in};
use tracefig::output::{Format, InMotion};
use tracefig::scene::{Problem, Scene};

use super::in_time::InTime;
use super::positive::up_to;

/// The most pictures of a motion: half a minute of the usual ones.
const MOST_FRAMES: i64 = 600;
/// The most pictures a second: a GIF shows one for two hundredths at least.
const MOST_FPS: f64 = 50.0;

/// Options of a figure that plays.
#[derive(Args)]
pub(crate) struct MotionOptions {
    /// Play the motion of each figure, from its start to the hit, the closest approach or the end, then show
    /// the figure: STEM.motion.EXT, in formats that play, which are the default then; in others a file a
    /// picture, STEM.frame-01.EXT
    #[arg(long, group = InTime::GROUP)]
    motion: bool,
    /// How many pictures the way has, up to 600; default: 40
    #[arg(long, requires = "motion", conflicts_with = "steps", value_name = "N",
        value_parser = clap::value_parser!(u16).range(2..=MOST_FRAMES))]
    frames: Option<u16>,
    /// How many pictures a second shows, up to 50; default: 20
    #[arg(long, requires = "motion", conflicts_with = "steps", value_name = "N", value_parser = fps)]
    fps: Option<f64>,
}

/// Pictures a second, as written on the command line.
fn fps(text: &str) -> Result<f64, String> {
    up_to(MOST_FPS, text)
}

impl MotionOptions {
    /// Whether the command line asks for figures that play.
    pub(crate) fn is_asked(&self) -> bool {
        self.motion
    }

    /// How a motion is written; `hold` is how long its last picture stays, in seconds.
    fn how(&self, hold: Option<f64>) -> InMotion {
        let usual = InMotion::default();
        InMotion {
            frames: self.frames.map_or(usual.frames, usize::from),
            fps: self.fps.unwrap_or(usual.fps),
            hold: hold.unwrap_or(usual.hold),
        }
    }

    /// How a file of a format is written of a figure that plays; none for a file that shows one picture.
    pub(crate) fn in_one(
        &self,
        in_time: Option<InTime>,
        format: &Format,
        hold: Option<f64>,
    ) -> Option<InMotion> {
        let plays = in_time == Some(InTime::Motion) && format.holds_motion();
        plays.then(|| self.how(hold))
    }

    /// Draws a figure with all that its files show.
    ///
    /// # Errors
    /// Where it plays, and all its pictures together draw too much.
    pub(crate) fn drawn(
        &self,
        in_time: Option<InTime>,
        (plan, theme, id): (&Plan<'_>, &Theme, &str),
    ) -> Result<Figure, Vec<Problem<Fault>>> {
        match in_time {
            None => Ok(draw(plan, theme, id)),
            Some(InTime::Steps(_)) => Ok(draw_in_steps(plan, theme, id)),
            Some(InTime::Motion) => draw_in_motion(plan, theme, id, self.how(None).frames),
        }
    }
}

/// The plan of a scene in a theme, or in its own, on a page with room for what its files show.
///
/// # Errors
/// As planning a figure has them.
pub(crate) fn planned<'s>(
    scene: &'s Scene,
    theme: Option<&'s Theme>,
    in_time: Option<InTime>,
) -> Result<Plan<'s>, Vec<Problem<Fault>>> {
    let plan = theme.map_or_else(|| plan(scene), |theme| plan_in(scene, theme))?;
    match in_time {
        None => Ok(plan),
        Some(InTime::Steps(_)) => plan.with_room_for_steps(),
        Some(InTime::Motion) => plan.with_room_to_move(),
    }
}
