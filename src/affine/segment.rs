//! Whether points lie on segments, and segments meet, decided without rounding.

use super::Point;
use super::orientation::{Orient, Turn};

/// Whether `point` lies on the segment from `start` to `end`; both ends belong to it.
pub(crate) fn lies_on<T: Orient>(
    point: &Point<T, 2>,
    start: &Point<T, 2>,
    end: &Point<T, 2>,
) -> bool {
    let between = |k: usize| {
        (start[k] <= point[k] && point[k] <= end[k]) || (end[k] <= point[k] && point[k] <= start[k])
    };
    between(0) && between(1) && T::turn(start, end, point) == Turn::Straight
}

/// Whether two segments have a point in common.
///
/// Either the ends of each lie on different sides of the line through the other, or all four lie on one line and
/// an end of one lies on the other.
pub(crate) fn meet<T: Orient>(first: [&Point<T, 2>; 2], second: [&Point<T, 2>; 2]) -> bool {
    let ([a, b], [c, d]) = (first, second);
    let split = |[start, end]: [&Point<T, 2>; 2], [p, q]: [&Point<T, 2>; 2]| {
        T::turn(start, end, p) != T::turn(start, end, q)
    };
    split(first, second) && split(second, first)
        || lies_on(a, c, d)
        || lies_on(b, c, d)
        || lies_on(c, a, b)
        || lies_on(d, a, b)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn segments_that_touch_cross_or_miss_each_other() {
        let cases = [
            ([[0, 0], [2, 2]], [[0, 2], [2, 0]], true, "cross"),
            ([[0, 0], [2, 2]], [[1, 1], [2, 0]], true, "touch inside"),
            (
                [[0, 0], [2, 2]],
                [[2, 2], [3, 0]],
                true,
                "touch at the ends",
            ),
            ([[0, 0], [2, 2]], [[1, 1], [3, 3]], true, "overlap"),
            (
                [[0, 0], [3, 3]],
                [[1, 1], [2, 2]],
                true,
                "one inside the other",
            ),
            (
                [[0, 0], [1, 1]],
                [[2, 2], [3, 3]],
                false,
                "apart on one line",
            ),
            (
                [[0, 0], [2, 2]],
                [[3, 3], [4, 0]],
                false,
                "on the line of the first",
            ),
            ([[0, 0], [2, 0]], [[0, 1], [2, 1]], false, "parallel"),
            ([[0, 0], [2, 0]], [[3, -1], [3, 1]], false, "beyond the end"),
        ];
        let point = |p: [i32; 2]| Point::new(p.map(f64::from));
        for (first, second, expected, name) in cases {
            let (first, second) = (first.map(point), second.map(point));
            for (p, q) in [(&first, &second), (&second, &first)] {
                let found = meet(p.each_ref(), q.each_ref());
                assert_eq!(found, expected, "{name}");
                assert_eq!(
                    meet([&p[1], &p[0]], q.each_ref()),
                    expected,
                    "{name}, reversed"
                );
            }
        }
    }
}
