//! Control values for which inserting knots in the domain is not Chaikin's algorithm.

/// The control values of the quadratic spline.
pub fn counterexample() -> Vec<i64> {
    //@ solution
    vec![0, 4, 8, 8]
    //@ starter
    //| // Here both polygons are the same.
    //| vec![1, 1, 1]
    //@ end
}
