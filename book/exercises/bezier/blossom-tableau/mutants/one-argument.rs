//! misconception: a tableau has one parameter, so every column takes the first argument

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
6
12  10
15  14  38/3
24  21  56/3  50/3
";
