//! How large a scene may be.
//!
//! Each limit is far above what a figure can show and low enough that no scene within them takes seconds or
//! gigabytes: a hostile file gets an error and not the machine.

/// Bytes of a scene file, 4 MiB. Vertices in full precision take some 40 bytes, so all of `MAX_VERTICES`
/// twice fit.
pub const MAX_FILE_BYTES: usize = 4 << 20;
/// Levels of tables and lists in one another; a scene needs 5 (panels, panel, layers, layer, list of an
/// option).
pub(crate) const MAX_NESTING: usize = 16;
/// Shapes of a scene: one or two are asked about, the others are drawn beside them and named.
pub(crate) const MAX_SHAPES: usize = 64;
/// Vertices of one shape. The article's difference visits pairs of edges one by one, here 1.7 × 10⁷ of them.
pub(crate) const MAX_VERTICES: usize = 4_096;
/// Characters of a title, caption, label or word: more than a page has room for.
pub(crate) const MAX_TEXT: usize = 4_000;
/// Panels of a figure; they stand side by side, so that many are unreadable long before.
pub(crate) const MAX_PANELS: usize = 32;
/// Layers of a panel; seven times as many as there are kinds of layer.
pub(crate) const MAX_LAYERS: usize = 200;
/// Layers of all panels together, as each costs time and memory.
pub(crate) const MAX_ALL_LAYERS: usize = 400;
/// Entries of `[labels]`; far more than a page has room for.
pub(crate) const MAX_LABELS: usize = 1_000;
/// Entries of `[[steps]]`: more than a lecture shows of one figure.
pub(crate) const MAX_STEPS: usize = 1_000;
/// Values that an exercise asks for; more are several exercises.
pub(crate) const MAX_ASKED: usize = 8;
/// Values in a list of an option, as times of ghosts.
pub(crate) const MAX_OPTION_VALUES: usize = 1_000;
/// Page pixels of a side of the canvas; at `--scale 2` 8192 dots.
pub(crate) const MAX_CANVAS: f64 = 4096.0;
/// Most figures on a sheet of a handout: at 36 on A4 the letters have 1.5 points.
pub const MAX_A_SHEET: usize = 36;
/// Largest scale: a page of the usual size then has 2²⁵ dots, half of what an image may have.
pub const MAX_SCALE: f64 = 8.0;
/// Smallest side of the canvas that can hold a panel with its margins.
pub(crate) const MIN_CANVAS: f64 = 100.0;
/// Largest margin, page pixels: a slide's edge; a page too small for it takes less.
pub(crate) const MAX_MARGIN: f64 = 200.0;
/// Smallest size of running text, page pixels an em; no letter is set under 11.
pub(crate) const MIN_TYPE: f64 = 8.0;
/// Largest size of running text, page pixels an em: twice that of a slide for a hall.
pub(crate) const MAX_TYPE: f64 = 48.0;
/// Steps of an iterative algorithm; each leaves a few events of some 200 bytes in a trace.
pub(crate) const MAX_ITERATIONS: usize = 100_000;
/// Step cap where the scene gives none. A graze with a gap of 1e-6 takes conservative advancement 12,405
/// steps.
pub(crate) const DEFAULT_ITERATIONS: usize = 20_000;
/// Steps times vertices of both shapes: with many vertices the step cap is lower, as a step of the article's
/// advancement looks at each, for some 20 ns.
pub(crate) const MAX_STEPS_OF_VERTICES: usize = 50_000_000;
/// How close counts as contact where the scene gives no `tolerance`, in world units: some thousand roundings
/// of coordinates of size 1.
pub(crate) const DEFAULT_TOLERANCE: f64 = 1e-12;
/// Largest magnitude of a number; sums and products with a velocity would overflow soon above it.
pub(crate) const MAX_NUMBER: f64 = 1e300;
