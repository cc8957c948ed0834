//! To compute: the point at t = 3/4 of the cubic with the control points in the first column.

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
//@ solution
(0, 0)
(8, 16)  (6, 12)
(16, 0)  (14, 4)  (12, 6)
(24, 0)  (22, 0)  (20, 1)  (18, 9/4)
//@ starter
//| (0, 0)
//| (8, 16)  ?
//| (16, 0)  ?  ?
//| (24, 0)  ?  ?  ?
//@ end
";
