//! Numbers that are texts, read to the nearest double.

/// The double nearest to a decimal number; `None` where the text is none, or a page's where it is too large.
///
/// The module of live pages reads its scenes as JSON, and numbers with what reads those: the tables of
/// another reader would be 10 kB.
pub(crate) fn read(text: &str) -> Option<f64> {
    #[cfg(not(tracefig_page))]
    return text.parse().ok();
    #[cfg(tracefig_page)]
    return serde_json::from_str(text).ok();
}

#[cfg(test)]
mod tests {
    use super::read;

    #[test]
    fn numbers_as_we_write_them_are_read_alike_here_and_on_a_page() {
        let page = |text: &str| serde_json::from_str::<f64>(text).ok();
        let mut random = oorandom::Rand64::new(7);
        for _ in 0..20_000 {
            let value = f64::from_bits(random.rand_u64());
            let value = if value.is_finite() { value } else { 0.0 };
            for text in
                [format!("{value}"), format!("{value:e}"), format!("{value:.5e}"), format!("{value:.3}")]
            {
                assert_eq!(read(&text).map(f64::to_bits), page(&text).map(f64::to_bits), "{text}");
            }
        }
        for text in ["", "-", "1…2", "–", "a"] {
            assert_eq!((read(text), page(text)), (None, None), "{text}");
        }
    }
}
