//! Answers to a stream of scenes, on one thread or on several, in the order of its lines.
//!
//! A thread reads what has arrived in pieces of some lines, others answer a piece each, and this one writes
//! the answers. A piece goes out when no further line has arrived whole, so that whoever writes a line and
//! waits gets its answer before writing the next; and so few pieces are under way that a stream of any length
//! takes the memory of those. Where nobody reads the answers any more, no more lines are read.

use std::io::{self, Read, Write};
use std::num::NonZeroUsize;
use std::sync::mpsc::{Receiver, Sender, SyncSender, TryRecvError, channel, sync_channel};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use tracefig::scene::{Reply, refuse_jsonl_line, refuse_long_jsonl_line, solve_jsonl_line};

use super::console::Results;
use super::lines::{Line, Lines};
use super::partition::Partition;
use super::tally::Tally;

/// Most lines of a piece: enough that handing it over costs nothing beside its answers.
const LINES: usize = 64;

/// Bytes after which a piece takes no further line.
const BYTES: usize = 1 << 16;

/// A line that is no one else's.
enum Question {
    /// A text that may be a scene.
    Text(String),
    /// Bytes that are no UTF-8.
    NotUtf8,
    /// More bytes than a scene may have, and how many.
    TooLong(usize),
}

/// Lines of a stream with their numbers, from 1.
type Piece = Vec<(usize, Question)>;

/// The answers to a piece, a line each, and what they are.
#[derive(Default)]
struct Answers {
    /// Lines, each with its break.
    text: String,
    /// What became of them.
    tally: Tally,
}

/// A piece and where its answers go.
type Job = (Piece, Sender<Answers>);

/// What the writer waits for next: the answers to a piece, or the end by an error.
type Next = io::Result<Receiver<Answers>>;

/// Why no more of a stream is answered.
pub(crate) enum End {
    /// All was, or nobody reads the answers any more.
    Done,
    /// No more can be read.
    CantRead(io::Error),
    /// An answer was lost, by a bug of ours.
    Lost,
}

/// Answers a stream; what became of its lines, and how it ended.
pub(crate) fn answer_all(
    input: impl Read + Send + 'static,
    part: Partition,
    threads: NonZeroUsize,
    out: &mut Results,
) -> (Tally, End) {
    let reader = Reader { lines: Lines::new(input), part };
    match if threads.get() > 1 { reader.spread(threads) } else { Err(reader) } {
        Ok(order) => write_in_order(&order, out),
        Err(reader) => reader.alone(out),
    }
}

impl Question {
    /// The line, kept.
    fn of(line: &Line<'_>) -> Self {
        match *line {
            Line::Text(text) => Self::Text(text.to_owned()),
            Line::NotUtf8 => Self::NotUtf8,
            Line::TooLong(bytes) => Self::TooLong(bytes),
        }
    }

    /// The reply to it.
    fn reply(&self, number: usize) -> Reply {
        match self {
            Self::Text(text) => solve_jsonl_line(text, number),
            Self::NotUtf8 => refuse_jsonl_line(number),
            Self::TooLong(bytes) => refuse_long_jsonl_line(number, *bytes),
        }
    }
}

impl Answers {
    /// The answers to all lines of a piece.
    fn to(piece: &Piece) -> Self {
        let mut answers = Self::default();
        for (number, question) in piece {
            let reply = question.reply(*number);
            answers.tally.count(&reply);
            answers.text.push_str(&reply.line);
            answers.text.push('\n');
        }
        answers
    }
}

/// Reads a stream piece by piece.
struct Reader<R> {
    /// The lines that were not read yet.
    lines: Lines<R>,
    /// Which of them are wanted.
    part: Partition,
}

impl<R: Read> Reader<R> {
    /// The next lines that are wanted; none at the end of the stream. The second is why no more can be read.
    fn piece(&mut self) -> (Piece, Option<io::Error>) {
        let (mut piece, mut bytes) = (Piece::new(), 0);
        while piece.len() < LINES && bytes < BYTES && (piece.is_empty() || self.lines.has_next()) {
            match self.lines.next() {
                Ok(Some((number, _))) if !self.part.holds(number) => {}
                Ok(Some((number, line))) => {
                    let question = Question::of(&line);
                    if let Question::Text(text) = &question {
                        bytes += text.len();
                    }
                    piece.push((number, question));
                }
                Ok(None) => break,
                Err(error) => return (piece, Some(error)),
            }
        }
        (piece, None)
    }

    /// Answers here, one piece after the other.
    fn alone(mut self, out: &mut Results) -> (Tally, End) {
        let mut tally = Tally::default();
        while !out.is_closed() {
            let (piece, error) = self.piece();
            let answers = Answers::to(&piece);
            write(answers, out, &mut tally);
            if let Some(error) = error {
                return (tally, End::CantRead(error));
            }
            if piece.is_empty() {
                break;
            }
            if !self.lines.has_next() {
                out.flush_now();
            }
        }
        (tally, End::Done)
    }
}

impl<R: Read + Send + 'static> Reader<R> {
    /// Reads on a thread of its own and answers on others; what comes of it, in order. Without threads to be
    /// had the reader comes back.
    fn spread(self, threads: NonZeroUsize) -> Result<Receiver<Next>, Self> {
        let (jobs, waiting) = sync_channel(threads.get());
        let waiting = Arc::new(Mutex::new(waiting));
        let worker = || {
            let waiting = Arc::clone(&waiting);
            thread::Builder::new().spawn(move || work(&waiting)).is_ok()
        };
        // Fewer than asked for are still some.
        if !worker() {
            return Err(self);
        }
        let _ = (1..threads.get()).all(|_| worker());
        let (order, wanted) = sync_channel(threads.get());
        let (hand_over, taken) = channel();
        // Where nobody wants the answers, the reader may wait for a line that never comes. Nobody waits for
        // it.
        match thread::Builder::new()
            .spawn(move || taken.recv().map(|reader: Self| reader.read(&jobs, &order)))
        {
            Ok(_) => hand_over.send(self).map_or_else(|back| Err(back.0), |()| Ok(wanted)),
            Err(_) => Err(self),
        }
    }

    /// Hands out pieces until the stream ends, or nobody wants more.
    fn read(mut self, jobs: &SyncSender<Job>, order: &SyncSender<Next>) {
        loop {
            let (piece, error) = self.piece();
            if !piece.is_empty() {
                let (answers, answered) = channel();
                if order.send(Ok(answered)).is_err() || jobs.send((piece, answers)).is_err() {
                    return;
                }
            } else if error.is_none() {
                return;
            }
            if let Some(error) = error {
                let _ = order.send(Err(error));
                return;
            }
        }
    }
}

/// Answers pieces until there are no more.
fn work(waiting: &Mutex<Receiver<Job>>) {
    loop {
        let job = waiting.lock().unwrap_or_else(PoisonError::into_inner).recv();
        let Ok((piece, answers)) = job else { return };
        // Nobody may want them any more.
        let _ = answers.send(Answers::to(&piece));
    }
}

/// Writes answers as they are due; flushes whenever it would wait.
fn write_in_order(order: &Receiver<Next>, out: &mut Results) -> (Tally, End) {
    let mut tally = Tally::default();
    while let Some(next) = soon(order, out) {
        match next.map(|answered| soon(&answered, out)) {
            Ok(Some(answers)) => write(answers, out, &mut tally),
            Ok(None) => return (tally, End::Lost),
            Err(error) => return (tally, End::CantRead(error)),
        }
        if out.is_closed() {
            break;
        }
    }
    (tally, End::Done)
}

/// What comes next; what was written goes out first where that takes a while. `None` at the end.
fn soon<T>(from: &Receiver<T>, out: &mut Results) -> Option<T> {
    match from.try_recv() {
        Ok(next) => Some(next),
        Err(TryRecvError::Disconnected) => None,
        Err(TryRecvError::Empty) => {
            out.flush_now();
            from.recv().ok()
        }
    }
}

/// Writes answers and counts them.
fn write(answers: Answers, out: &mut Results, tally: &mut Tally) {
    // `Results` keeps its failure, and tells of it at the end.
    let _ = out.write_all(answers.text.as_bytes());
    tally.add(answers.tally);
}
