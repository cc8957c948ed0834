//! misconception: the order of the control points does not matter

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
(24, 0)
(16, 0)  (18, 0)
(8, 16)  (10, 12)  (12, 9)
(0, 0)   (2, 4)    (4, 6)   (6, 27/4)
";
