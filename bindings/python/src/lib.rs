//! What `tracefig` for Python takes from the library: texts in, texts and bytes out.
//!
//! The functions here know no Python but strings, bytes and one exception; that a scene may be a dict or a
//! path, and what an answer looks like, is said in `python/tracefig/__init__.py`.

use std::num::NonZeroUsize;
use std::panic::resume_unwind;
use std::path::Path;
use std::thread;

use pyo3::create_exception;
use pyo3::exceptions::{PyOSError, PyValueError};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use tracefig::drawing::Drawing;
use tracefig::figure::theme::{self, Theme};
use tracefig::figure::{draw, plan, plan_in};
use tracefig::output::{Options, Writer, format};
use tracefig::scene::{Explain, Ink, Refused, SceneFile, Severity, Solution, message};
use tracefig::trace::{Trace, Tracer, json_lines, story};

create_exception!(_tracefig, SceneError, PyValueError, "A scene that can't be answered or drawn.");

/// The exception for a scene: its message quotes the lines at fault, its arguments are the message and one
/// tuple `(code, line, column, what)` a fault, lines and columns from 1.
fn refused<F: Explain>(refused: &Refused<F>) -> PyErr {
    let faults: Vec<(String, usize, usize, String)> = refused
        .problems
        .iter()
        .map(|problem| {
            let place = refused.source.place(problem.span.start);
            (problem.fault.code().to_owned(), place.line, place.column, problem.fault.to_string())
        })
        .collect();
    SceneError::new_err((refused.render(Ink::Plain).trim_end().to_owned(), faults))
}

/// A scene from a text, or from a file where there is none.
fn opened(name: &str, text: Option<&str>) -> PyResult<SceneFile> {
    match text {
        Some(text) => tracefig::scene::open_text(name, text),
        None => tracefig::open(Path::new(name)),
    }
    .map_err(|problems| refused(&problems))
}

/// A theme of the house by its word, or from a file.
fn theme_of(name: &str, folder: &Path) -> PyResult<Theme> {
    if let Some(known) = theme::find(name) {
        return Ok(known.clone());
    }
    if !theme::is_file(name) {
        let names: Vec<&str> = theme::THEMES.iter().map(|theme| theme.name).collect();
        return Err(PyValueError::new_err(format!(
            "unknown theme {name:?}: expected one of {}, or a file ending in .toml",
            names.join(", ")
        )));
    }
    let dark_side = theme::dark_side_of(name);
    let path = folder.join(dark_side.unwrap_or(name));
    let text = std::fs::read_to_string(&path)
        .map_err(|error| PyOSError::new_err(format!("{}: {error}", path.display())))?;
    let whole =
        theme::parse(&text).map_err(|error| PyValueError::new_err(format!("{}: {error}", path.display())))?;
    match dark_side {
        None => Ok(whole),
        Some(file) => {
            whole.in_the_dark().ok_or_else(|| PyValueError::new_err(format!("{file} has no table `[dark]`")))
        }
    }
}

/// A figure, drawn; it writes itself in every format.
#[pyclass(frozen, module = "tracefig._tracefig", name = "Drawn")]
struct Drawn {
    drawing: Drawing,
    warnings: Vec<String>,
}

#[pymethods]
impl Drawn {
    /// Width and height, page pixels.
    #[getter]
    fn size(&self) -> (f64, f64) {
        (self.drawing.width, self.drawing.height)
    }

    /// The alternative text, short and long.
    #[getter]
    fn alt(&self) -> (&str, &str) {
        (&self.drawing.title, &self.drawing.desc)
    }

    /// What should be better, each quoted.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.warnings.clone()
    }

    /// The bytes in a format; `scale` is pixels of an image per page pixel.
    fn write<'py>(&self, py: Python<'py>, name: &str, scale: f64) -> PyResult<Bound<'py, PyBytes>> {
        let Some(Writer::One(write)) = format(name).map(|format| format.write) else {
            return Err(PyValueError::new_err(format!("unknown format {name:?} of one figure")));
        };
        let options = Options { scale, ..Options::default() };
        let bytes = py.detach(|| write(&self.drawing, &options).map_err(|error| error.to_string()));
        Ok(PyBytes::new(py, &bytes.map_err(PyValueError::new_err)?))
    }
}

/// Draws a scene; `id` is the prefix of every id in its SVG.
#[pyfunction]
fn render(py: Python<'_>, name: &str, text: Option<&str>, theme: Option<&str>, id: &str) -> PyResult<Drawn> {
    let file = opened(name, text)?;
    let folder = match text {
        None => Path::new(name).parent().unwrap_or(Path::new("")),
        Some(_) => Path::new(""),
    };
    let asked = file.scene.canvas.theme.as_ref().map(|theme| theme.value.as_str());
    let own = match (theme, asked) {
        (Some(theme), _) => Some(theme_of(theme, Path::new(""))?),
        (None, Some(asked)) if theme::is_file(asked) => Some(theme_of(asked, folder)?),
        (None, _) => None,
    };
    py.detach(|| {
        let plan = own.as_ref().map_or_else(|| plan(&file.scene), |own| plan_in(&file.scene, own));
        let plan = plan.map_err(|problems| refused(&Refused { source: file.source.clone(), problems }))?;
        let figure = draw(&plan, plan.theme, id);
        let told = |problem| message(&file.source, problem, Severity::Warning, Ink::Plain);
        Ok(Drawn { warnings: figure.warnings.iter().map(told).collect(), drawing: figure.drawing })
    })
}

/// The answer as a JSON object.
#[pyfunction]
fn solve(py: Python<'_>, name: &str, text: Option<&str>) -> PyResult<String> {
    let file = opened(name, text)?;
    Ok(py.detach(|| Solution::of(&file.scene).json().to_string()))
}

/// A JSON line for each line, in their order, as `tracefig solve --jsonl` writes it, on so many threads.
#[pyfunction]
fn solve_many(py: Python<'_>, lines: Vec<String>, threads: Option<NonZeroUsize>) -> Vec<String> {
    let cores = threads.or_else(|| thread::available_parallelism().ok()).map_or(1, NonZeroUsize::get);
    let share = lines.len().div_ceil(cores).max(1);
    py.detach(|| {
        thread::scope(|scope| {
            let shares = lines.chunks(share).enumerate().map(|(k, share_lines)| {
                let first = k * share + 1;
                scope.spawn(move || {
                    let numbered = share_lines.iter().zip(first..);
                    numbered
                        .map(|(line, number)| tracefig::solve_jsonl_line(line, number).line)
                        .collect::<Vec<_>>()
                })
            });
            let running: Vec<_> = shares.collect();
            // A line's bug is its own reply; whatever else ends a thread is raised.
            running
                .into_iter()
                .flat_map(|share| share.join().unwrap_or_else(|ended| resume_unwind(ended)))
                .collect()
        })
    })
}

/// Every event as JSON lines after a header, and the story of them in words.
#[pyfunction]
fn trace(py: Python<'_>, name: &str, text: Option<&str>) -> PyResult<(String, String)> {
    let file = opened(name, text)?;
    py.detach(|| {
        let mut events = Trace::default();
        (file.scene.query().algorithm.traced)(&file.scene.query_of_bodies(), &mut events);
        if let Some(off) = Solution::of(&file.scene).off {
            events.record(|| off.event());
        }
        let lines = json_lines(&events).map_err(|error| PyValueError::new_err(error.to_string()))?;
        Ok((lines, story(&events, &file.scene.names())))
    })
}

/// The library, without Python's manners.
#[pymodule]
fn _tracefig(module: &Bound<'_, PyModule>) -> PyResult<()> {
    module.add("SceneError", module.py().get_type::<SceneError>())?;
    module.add_class::<Drawn>()?;
    module.add_function(wrap_pyfunction!(render, module)?)?;
    module.add_function(wrap_pyfunction!(solve, module)?)?;
    module.add_function(wrap_pyfunction!(solve_many, module)?)?;
    module.add_function(wrap_pyfunction!(trace, module)?)
}
