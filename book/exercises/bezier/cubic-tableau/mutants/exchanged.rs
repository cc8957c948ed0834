//! misconception: t is the weight of the first of two neighbours, so the new point is close to it when t is close to 1

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
(0, 0)
(8, 16)  (2, 4)
(16, 0)  (10, 12)  (4, 6)
(24, 0)  (18, 0)   (12, 9)  (6, 27/4)
";
