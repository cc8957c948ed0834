//! misconception: for the argument −2 the weight 1 − t is 1 − 2 = −1

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
6
12  10
15  14  11
24  21  63/4  -85/2
";
