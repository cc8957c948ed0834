//! misconception: the upper one of the two entries stands right above, in the same column

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
(0, 0)
(8, 16)  (6, 12)
(16, 0)  (27/2, 3)     (93/8, 21/4)
(24, 0)  (171/8, 3/4)  (303/16, 15/8)  (1095/64, 87/32)
";
