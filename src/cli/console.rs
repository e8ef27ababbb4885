//! Standard output and standard error: results on one, messages on the other, colour only on a terminal.

use std::io::{self, BufWriter, IsTerminal, Stdout, Write};

use annotate_snippets::{Level, Renderer};
use clap::{Args, ColorChoice};
use tracefig::scene::{Explain, Ink, Refused};

use super::Status;

/// Where a command writes.
pub(crate) struct Console {
    /// Standard output, for results.
    pub(crate) out: Results,
    /// Whether messages are coloured.
    ink: Ink,
    /// Whether standard error is a terminal.
    on_terminal: bool,
    /// Whether only what went wrong is said.
    is_quiet: bool,
}

/// What a user wants to be told, and how.
#[derive(Args, Clone, Copy, Debug, Default)]
pub(crate) struct Manner {
    /// Say nothing but what is wrong
    #[arg(short, long, global = true)]
    quiet: bool,
    /// Whether messages are coloured; default: on a terminal, unless `NO_COLOR` is set
    #[arg(long, global = true, value_name = "WHEN", value_enum)]
    color: Option<ColorChoice>,
}

impl Console {
    /// The console of this process.
    pub(crate) fn new(manner: Manner) -> Self {
        let on_terminal = io::stderr().is_terminal();
        // https://no-color.org: present and not empty, whatever its value.
        let no_color = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
        let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
        let coloured = match manner.color {
            Some(ColorChoice::Always) => true,
            Some(ColorChoice::Never) => false,
            Some(ColorChoice::Auto) | None => on_terminal && !no_color && !dumb,
        };
        let ink = if coloured { Ink::Coloured } else { Ink::Plain };
        let out = Results { out: BufWriter::new(io::stdout()), failed: None };
        Self { out, ink, on_terminal, is_quiet: manner.quiet }
    }

    /// Whether only what went wrong is said.
    pub(crate) fn is_quiet(&self) -> bool {
        self.is_quiet
    }

    /// Writes a message about what is not wrong.
    pub(crate) fn note(&self, text: &str) {
        if !self.is_quiet {
            Self::message(text);
        }
    }

    /// How messages are written.
    pub(crate) fn ink(&self) -> Ink {
        self.ink
    }

    /// Whether someone watches standard error, so that a progress bar makes sense.
    pub(crate) fn is_watched(&self) -> bool {
        self.on_terminal && !self.is_quiet
    }

    /// Writes a message as it is. What standard error can't take is lost: there is nowhere left to say so.
    pub(crate) fn message(text: &str) {
        let _ = io::stderr().lock().write_all(text.as_bytes());
    }

    /// Writes all that is wrong with a scene, after the results so far where both go to one place.
    pub(crate) fn refuse<F: Explain>(&mut self, refused: &Refused<F>) -> io::Result<Status> {
        self.out.flush()?;
        Self::message(&refused.render(self.ink));
        Ok(Status::of(refused))
    }

    /// Writes `error: …`.
    pub(crate) fn error(&self, text: &str) {
        let report = [annotate_snippets::Group::with_title(Level::ERROR.primary_title(text))];
        let renderer = match self.ink {
            Ink::Plain => Renderer::plain(),
            Ink::Coloured => Renderer::styled(),
        };
        Self::message(&format!("{}\n", renderer.render(&report)));
    }

    /// Writes what is still buffered.
    ///
    /// # Errors
    /// When not all results could be written, though somebody was there to read them.
    pub(crate) fn finish(&mut self) -> io::Result<()> {
        self.out.flush()?;
        match self.out.failed.take() {
            // Whoever read has seen enough.
            Some(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(error),
            _ => Ok(()),
        }
    }
}

/// Standard output. From its first failure on, what is written is dropped: files and reports are still to be
/// written, and the exit status is to tell of all the work. [`Console::finish`] tells of the failure.
pub(crate) struct Results {
    /// Where results go.
    out: BufWriter<Stdout>,
    /// Why nothing more goes there.
    failed: Option<io::Error>,
}

impl Results {
    /// Whether what is written is dropped.
    pub(crate) fn is_closed(&self) -> bool {
        self.failed.is_some()
    }

    /// Hands on what is buffered; a failure is kept for [`Console::finish`].
    pub(crate) fn flush_now(&mut self) {
        self.attempt(Write::flush);
    }

    /// Writes or flushes, unless an earlier time failed.
    fn attempt(&mut self, write: impl FnOnce(&mut BufWriter<Stdout>) -> io::Result<()>) {
        if self.failed.is_none() {
            self.failed = write(&mut self.out).err();
        }
    }
}

impl Write for Results {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.attempt(|out| out.write_all(bytes));
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.attempt(Write::flush);
        Ok(())
    }
}
