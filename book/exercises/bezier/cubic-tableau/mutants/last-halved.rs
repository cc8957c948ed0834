//! misconception: the last step takes the midpoint, whatever t is

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
(0, 0)
(8, 16)  (6, 12)
(16, 0)  (14, 4)  (12, 6)
(24, 0)  (22, 0)  (20, 1)  (16, 7/2)
";
