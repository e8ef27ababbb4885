//! Writing the files of a scene, and what became of them.

use std::io::{self, Write};
use std::path::Path;

use super::Status;
use super::atomic_file::{Wait, write_whole};
use super::console::Console;
use super::encoded::Encoded;
use super::files::Drawn;
use super::inputs::shown;
use super::jobs::Target;
use super::timings::Timings;
use super::unfit::Unfit;

/// What became of a job.
pub(crate) struct Written {
    /// The one file, where it goes to standard output.
    picture: Vec<u8>,
    /// The names of the files that were written.
    pub(crate) names: Vec<String>,
    /// What is said on standard error.
    pub(crate) messages: String,
    /// What the scene has against its themes, to be said once for all scenes.
    pub(crate) unfit: Vec<Unfit>,
    /// Why a file is not what it should be.
    pub(crate) status: Status,
    /// Where the time went.
    pub(crate) timings: Timings,
}

impl Written {
    /// A job of which nothing was written and nothing is to be said.
    pub(crate) fn nothing() -> Self {
        let (picture, names, messages) = (Vec::new(), Vec::new(), String::new());
        let unfit = Vec::new();
        Self { picture, names, messages, unfit, status: Status::Done, timings: Timings::start() }
    }

    /// A scene that was not drawn, with the reasons.
    pub(crate) fn refused(messages: String) -> Self {
        Self { messages, status: Status::Wrong, ..Self::nothing() }
    }

    /// A scene of this name whose drawing panicked.
    pub(crate) fn bug(name: &str) -> Self {
        let messages = format!("error: {name} was not drawn because of a bug of tracefig\n");
        Self { messages, status: Status::Bug, ..Self::nothing() }
    }

    /// Says what became of it, messages first.
    ///
    /// # Errors
    /// When standard output fails.
    pub(crate) fn tell(&self, console: &mut Console) -> io::Result<()> {
        if !self.messages.is_empty() {
            console.out.flush()?;
            Console::message(&self.messages);
        }
        if !console.is_quiet() {
            self.names.iter().try_for_each(|name| writeln!(console.out, "{name}"))?;
        }
        console.out.write_all(&self.picture)
    }
}

/// Writes the files of a scene.
pub(crate) fn write_files(drawn: Drawn, wait: Wait) -> Written {
    let Drawn { files, messages, unfit, status, timings } = drawn;
    let mut written = Written { messages, unfit, status, timings, ..Written::nothing() };
    for Encoded { bytes, target, .. } in files {
        match &target {
            Target::Stdout => written.picture = bytes,
            Target::File(path) => match write_whole(path, &bytes, wait) {
                Ok(()) => written.names.push(shown(path)),
                Err(error) => {
                    written.messages.push_str(&cant_write(path, &error));
                    written.status = Status::Io;
                }
            },
        }
    }
    written.timings.lap("write");
    written
}

/// Makes the folders that files go to; whether all are there.
pub(crate) fn makes_folders<'f>(folders: impl IntoIterator<Item = &'f Path>, console: &Console) -> bool {
    let mut made = true;
    for folder in folders.into_iter().filter(|folder| !folder.as_os_str().is_empty()) {
        if let Err(error) = std::fs::create_dir_all(folder) {
            console.error(&format!("can't make the folder {}: {error}", shown(folder)));
            made = false;
        }
    }
    made
}

/// The message of a file that can't be written.
pub(crate) fn cant_write(path: &Path, error: &io::Error) -> String {
    format!("error: can't write {}: {error}\n", shown(path))
}
