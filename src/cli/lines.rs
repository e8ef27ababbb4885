//! Lines of a stream of scenes, one after the other, none longer than a scene may be.

use std::io::{self, BufRead, BufReader, Read};

use tracefig::scene::limits::MAX_FILE_BYTES;

/// Bytes that are asked for at once.
const BUFFER: usize = 1 << 16;

/// What some editors and systems write before the first line of a text in UTF-8.
const BYTE_ORDER_MARK: &[u8] = b"\xef\xbb\xbf";

/// A line without its end.
#[derive(Debug, PartialEq, Eq)]
pub(crate) enum Line<'l> {
    /// A text that may be a scene.
    Text(&'l str),
    /// Bytes that are no UTF-8.
    NotUtf8,
    /// More bytes than a scene may have, which were not kept; how many they are.
    TooLong(usize),
}

/// Reads a stream line by line.
pub(crate) struct Lines<R> {
    /// What is read.
    input: BufReader<R>,
    /// The last line.
    bytes: Vec<u8>,
    /// Number of the last line, from 1.
    number: usize,
}

impl<R: Read> Lines<R> {
    /// The lines of a stream of which nothing was read yet.
    pub(crate) fn new(input: R) -> Self {
        Self { input: BufReader::with_capacity(BUFFER, input), bytes: Vec::new(), number: 0 }
    }

    /// The next line and its number, from 1; `None` at the end of the stream.
    pub(crate) fn next(&mut self) -> io::Result<Option<(usize, Line<'_>)>> {
        self.bytes.clear();
        // One more than the longest line with its end, so that a longer one is known to be one.
        let most = MAX_FILE_BYTES as u64 + 3;
        if (&mut self.input).take(most).read_until(b'\n', &mut self.bytes)? == 0 {
            return Ok(None);
        }
        self.number += 1;
        let mut line = self.bytes.as_slice();
        let is_whole = line.ends_with(b"\n") || (line.len() as u64) < most;
        line = line.strip_suffix(b"\n").unwrap_or(line);
        line = line.strip_suffix(b"\r").filter(|_| is_whole).unwrap_or(line);
        if self.number == 1 {
            line = line.strip_prefix(BYTE_ORDER_MARK).unwrap_or(line);
        }
        let mut length = line.len();
        if !is_whole {
            length += skip_line(&mut self.input)?;
        }
        let line = match std::str::from_utf8(line) {
            _ if length > MAX_FILE_BYTES => Line::TooLong(length),
            Ok(text) => Line::Text(text),
            Err(_) => Line::NotUtf8,
        };
        Ok(Some((self.number, line)))
    }

    /// Whether the next line has arrived whole, so that nobody waits for the reply to the last one before
    /// writing it.
    pub(crate) fn has_next(&self) -> bool {
        self.input.buffer().contains(&b'\n')
    }
}

/// Reads on to the end of the line; how many bytes were before it.
fn skip_line(input: &mut impl BufRead) -> io::Result<usize> {
    let mut skipped = 0;
    loop {
        let buffer = match input.fill_buf() {
            Err(error) if error.kind() == io::ErrorKind::Interrupted => continue,
            other => other?,
        };
        let (length, end) = (buffer.len(), buffer.iter().position(|&byte| byte == b'\n'));
        input.consume(end.map_or(length, |end| end + 1));
        skipped += end.unwrap_or(length);
        if end.is_some() || length == 0 {
            return Ok(skipped);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(bytes: &[u8]) -> Vec<String> {
        let mut lines = Lines::new(bytes);
        let mut all = Vec::new();
        while let Some((number, line)) = lines.next().unwrap() {
            all.push(match line {
                Line::Text(text) if text.len() > 20 => format!("{number}: {} bytes", text.len()),
                other => format!("{number}: {other:?}"),
            });
        }
        all
    }

    #[test]
    fn a_line_has_no_end_and_the_first_no_byte_order_mark() {
        let want = ["1: Text(\"a\")", "2: Text(\"\")", "3: Text(\"b\\rc\")", "4: Text(\"\\u{feff}d\")"];
        assert_eq!(read("\u{feff}a\r\n\nb\rc\n\u{feff}d".as_bytes()), want);
        assert_eq!(read(b""), Vec::<String>::new());
        assert_eq!(read(b"\xff\xfe\nx"), ["1: NotUtf8", "2: Text(\"x\")"]);
    }

    #[test]
    fn a_line_is_as_long_as_a_scene_may_be_and_a_longer_one_is_counted() {
        for end in ["\n", "\r\n", ""] {
            let long = |count: usize| format!("{}{end}", "é".repeat(count)).into_bytes();
            assert_eq!(read(&long(MAX_FILE_BYTES / 2)), [format!("1: {MAX_FILE_BYTES} bytes")]);
            for more in [2, 4, 200_000] {
                let got = read(&long(MAX_FILE_BYTES / 2 + more / 2))[0].clone();
                // Of a line that was cut, a carriage return at the far end counts.
                let lengths = [0, usize::from(end == "\r\n")].map(|r| MAX_FILE_BYTES + more + r);
                assert!(lengths.iter().any(|l| got == format!("1: TooLong({l})")), "{more}: {got}");
            }
        }
        let after = [&vec![b'x'; MAX_FILE_BYTES + 100][..], b"\nnext"].concat();
        assert_eq!(read(&after)[1], "2: Text(\"next\")");
    }

    #[test]
    fn a_piece_of_a_line_is_no_next_line() {
        let mut lines = Lines::new(&b"a\nb\nc"[..]);
        let mut waiting = Vec::new();
        while lines.next().unwrap().is_some() {
            waiting.push(lines.has_next());
        }
        assert_eq!(waiting, [true, false, false]);
    }
}
