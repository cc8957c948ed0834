//! misconception: every step begins again at the control points

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
(0, 0)
(8, 16)  (6, 12)
(16, 0)  (14, 4)  (14, 4)
(24, 0)  (22, 0)  (22, 0)  (22, 0)
";
