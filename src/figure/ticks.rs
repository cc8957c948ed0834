//! Round numbers for axes.

use super::decimal;

/// A tick: its position in units of the axis, and its label.
pub(super) type Tick = (f64, String);

/// At most `most` round numbers between `low` and `high`, both included.
///
/// Steps are 1, 2 or 5 times a power of ten; only products and quotients of small integers occur, so the
/// numbers are the same on every platform.
pub(super) fn linear(low: f64, high: f64, most: usize, whole: bool) -> Vec<Tick> {
    let span = high - low;
    if span.is_nan() || span <= 0.0 || !span.is_finite() {
        return vec![];
    }
    // A step is numerator · power or numerator / power.
    let (mut power, mut exponent) = (1.0, 0_i32);
    while span > 10.0 * power && exponent < 300 {
        power *= 10.0;
        exponent += 1;
    }
    let mut inverse = 1.0;
    while !whole && span * inverse < 1.0 && exponent > -300 {
        inverse *= 10.0;
        exponent -= 1;
    }
    if !whole {
        // One decade finer, so that the finest step tried is fine enough.
        if exponent > 0 {
            power /= 10.0
        } else {
            inverse *= 10.0
        }
        exponent -= 1;
    }
    for numerator in [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0] {
        let unit = |k: f64| {
            if exponent < 0 {
                k * numerator / inverse
            } else {
                k * numerator * power
            }
        };
        let (first, last) = (
            (low / unit(1.0) - 1e-9).ceil(),
            (high / unit(1.0) + 1e-9).floor(),
        );
        if last - first < most as f64 {
            let digits = usize::try_from(-exponent).unwrap_or(0);
            let count = (last - first) as i64;
            return (0..=count)
                .map(|i| unit(first + i as f64))
                .map(|value| (value, decimal(value, digits)))
                .collect();
        }
    }
    vec![]
}

/// Powers of ten between two logarithms.
pub(super) fn logarithmic(low: f64, high: f64, most: usize) -> Vec<Tick> {
    linear(low, high, most, true)
        .into_iter()
        .map(|(k, label)| (k, format!("10^{{{label}}}")))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn labels(ticks: Vec<Tick>) -> Vec<String> {
        ticks.into_iter().map(|(_, label)| label).collect()
    }

    #[test]
    fn ticks_are_round_and_few() {
        assert_eq!(
            labels(linear(0.0, 1.0, 6, false)),
            ["0", "0.2", "0.4", "0.6", "0.8", "1"]
        );
        assert_eq!(
            labels(linear(-1.0, 1.0, 5, false)),
            ["-1", "-0.5", "0", "0.5", "1"]
        );
        assert_eq!(labels(linear(0.0, 37.0, 5, false)), ["0", "10", "20", "30"]);
        assert_eq!(
            labels(linear(0.0, 0.003, 5, false)),
            ["0", "0.001", "0.002", "0.003"]
        );
        assert_eq!(
            labels(linear(0.0, 5.0, 9, true)),
            ["0", "1", "2", "3", "4", "5"]
        );
        assert_eq!(
            labels(linear(0.0, 12000.0, 5, false)),
            ["0", "5000", "10000"]
        );
        assert!(linear(1.0, 1.0, 5, false).is_empty());
    }

    #[test]
    fn logarithms_are_labelled_by_powers() {
        assert_eq!(
            labels(logarithmic(-3.4, 0.0, 6)),
            ["10^{-3}", "10^{-2}", "10^{-1}", "10^{0}"]
        );
    }
}
