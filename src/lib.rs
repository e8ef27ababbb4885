//! Headless renderer of explanatory diagrams for 2D collision detection.
//!
//! A scene file names two shapes, a motion and a question. The algorithm answers it and emits trace events; a
//! renderer turns the events into SVG and PNG figures.
//!
//! World space is [`geometry::DVec2`], y up; page space is [`drawing::Point`], pixels, y down.
//!
//! A pair of bodies to its answer, to what the algorithm did, and to a figure in memory:
//!
//! ```
//! use tracefig::collision::{Answer, QueryKind};
//! use tracefig::figure::{draw, plan};
//! use tracefig::geometry::{Angle, Body, DVec2, Shape};
//! use tracefig::output::{Options, format};
//! use tracefig::{Refused, Scene};
//!
//! let ball = Body::at_rest(Shape::circle(1.0)?, DVec2::ZERO);
//! let plank = Shape::rectangle(DVec2::new(2.0, 0.25))?;
//! let plank = Body { angle: Angle::Degrees(30.0), ..Body::at_rest(plank, DVec2::new(4.0, 0.5)) };
//! let mut scene = Scene::asking(QueryKind::Separation, &[("ball", ball), ("plank", plank)])
//!     .map_err(Refused::from)?;
//! let answered = scene.query().algorithm.answer_traced(&scene.query_of_bodies());
//! let (answer, trace) = answered.ok_or("not taken")?;
//! let Answer::Separation(found) = answer else { unreachable!("as was asked") };
//! assert!(found.bounds.lo <= found.separation && found.separation <= found.bounds.hi);
//! assert!(!trace.events.is_empty());
//!
//! scene.headline = Some("They are {=separation} apart.".to_owned().into());
//! let plan = plan(&scene).map_err(Refused::from)?;
//! let figure = draw(&plan, plan.theme, "pair");
//! let options = Options { scale: 2.0, ..Options::default() };
//! for name in ["svg", "png"] {
//!     let format = format(name).ok_or("no such format")?;
//!     assert!(!format.encode(&figure.drawing, &options)?.is_empty());
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! For distances and times of impact without scene or trace there are [`collision::Pair`] and
//! [`collision::MovingPair`]; for scenes in files [`open`].

pub mod collision;
pub mod drawing;
pub mod drift;
pub mod figure;
pub mod geometry;
pub mod live;
pub mod output;
#[cfg(not(tracefig_page))]
pub mod report;
pub mod scene;
pub mod trace;
pub mod typeset;

pub use scene::{Refused, Scene, SceneFile, open, solve, solve_jsonl_line};

/// The chapters of the guide, whose Rust is run with the examples of the library.
#[cfg(doctest)]
mod guide {
    #![doc = include_str!("../guide/src/introduction.md")]
    #![doc = include_str!("../guide/src/circles.md")]
    #![doc = include_str!("../guide/src/boxes.md")]
    #![doc = include_str!("../guide/src/circle-and-box.md")]
    #![doc = include_str!("../guide/src/oriented-boxes-and-axes.md")]
    #![doc = include_str!("../guide/src/the-minkowski-difference.md")]
    #![doc = include_str!("../guide/src/gjk.md")]
    #![doc = include_str!("../guide/src/epa.md")]
    #![doc = include_str!("../guide/src/contact-points.md")]
    #![doc = include_str!("../guide/src/rotating-calipers.md")]
    #![doc = include_str!("../guide/src/moving.md")]
    #![doc = include_str!("../guide/src/turning.md")]
    #![doc = include_str!("../guide/src/numbers.md")]
}
