//! misconception: the blossom is the polynomial at the mean of the arguments

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
6
12  23/6
15  131/12  551/432
24  47/4    2293/216  -10873/5184
";
