//! To compute: the value p(2/3, 1/4, -2) of the blossom with p(0,0,0), p(0,0,1), p(0,1,1), p(1,1,1) in the first column.

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
//@ solution
6
12  10
15  14  11
24  21  63/4  3/2
//@ starter
//| 6
//| 12  ?
//| 15  ?  ?
//| 24  ?  ?  ?
//@ end
";
