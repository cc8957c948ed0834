//! misconception: the blossom is symmetric, so the given values may stand in any order

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
24
15  18
12  13  67/4
6   8   47/4  107/4
";
