//! Numbers of the command line that are above 0.

/// A number above 0 and up to the most that there may be, as written on the command line.
///
/// # Errors
/// Says what is expected, where it is none.
pub(crate) fn up_to(most: f64, text: &str) -> Result<f64, String> {
    let expected = || format!("expected a number above 0 and up to {most}");
    let number: f64 = text.parse().map_err(|_| expected())?;
    if number > 0.0 && number <= most { Ok(number) } else { Err(expected()) }
}
