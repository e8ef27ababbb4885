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

/// The double nearest to 10 to a whole power.
///
/// `libm::exp10` brings a table for other powers, which nobody asks for: 4 kB of the module of live pages.
pub(crate) fn power_of_ten(power: f64) -> f64 {
    read(&format!("1e{power:.0}")).unwrap_or(f64::INFINITY)
}

#[cfg(test)]
mod tests {
    use super::{power_of_ten, read};

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

    #[test]
    fn whole_powers_of_ten_are_the_nearest_doubles() {
        assert_eq!([-400.0, -7.0, 0.0, 22.0, 400.0].map(power_of_ten), [0.0, 1e-7, 1.0, 1e22, f64::INFINITY]);
        for power in -15..=15 {
            let power = f64::from(power);
            assert_eq!(power_of_ten(power), libm::exp10(power));
        }
    }
}
