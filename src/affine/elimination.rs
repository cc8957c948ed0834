//! Small linear systems over any field.
//!
//! nalgebra solves them over real and complex floating-point numbers only; here are the rationals too.

use crate::scalar::Scalar;

/// Solves A·X = B by elimination with the pivot of largest magnitude; rows are given.
///
/// `None` if A is singular, that is, if no pivot but 0 is left.
pub(crate) fn solve<T: Scalar>(
    mut matrix: Vec<Vec<T>>,
    mut right: Vec<Vec<T>>,
) -> Option<Vec<Vec<T>>> {
    let size = matrix.len();
    for column in 0..size {
        let pivot = (column..size)
            .filter(|&row| !matrix[row][column].is_zero())
            .max_by(|&a, &b| {
                let magnitude = |row: usize| matrix[row][column].magnitude();
                magnitude(a).total_cmp(&magnitude(b))
            })?;
        matrix.swap(column, pivot);
        right.swap(column, pivot);
        let (pivot_row, pivot_right) = (matrix[column].clone(), right[column].clone());
        for row in (0..size).filter(|&row| row != column) {
            let factor = matrix[row][column].clone() / pivot_row[column].clone();
            if factor.is_zero() {
                continue;
            }
            subtract(&mut matrix[row], &pivot_row, &factor);
            subtract(&mut right[row], &pivot_right, &factor);
        }
    }
    for (row, right) in right.iter_mut().enumerate() {
        for entry in right {
            *entry /= matrix[row][row].clone();
        }
    }
    Some(right)
}

/// `row − factor·other`, in place.
fn subtract<T: Scalar>(row: &mut [T], other: &[T], factor: &T) {
    for (entry, other) in row.iter_mut().zip(other) {
        *entry -= factor.clone() * other.clone();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::BigRational;

    fn integers(rows: &[&[i64]]) -> Vec<Vec<BigRational>> {
        let row = |row: &&[i64]| row.iter().map(|&n| Scalar::from_integer(n)).collect();
        rows.iter().map(row).collect()
    }

    #[test]
    fn a_system_that_needs_a_pivot() {
        let matrix = integers(&[&[0, 1, 2], &[1, 0, 3], &[2, 1, 0]]);
        let solution = integers(&[&[1, 0], &[-2, 5], &[3, 7]]);
        let product = |row: &Vec<BigRational>| {
            (0..2)
                .map(|k| row.iter().zip(&solution).map(|(a, x)| a * &x[k]).sum())
                .collect()
        };
        let right = matrix.iter().map(product).collect();
        assert_eq!(solve(matrix, right), Some(solution));
    }

    #[test]
    fn a_singular_matrix() {
        let matrix = integers(&[&[1, 2], &[2, 4]]);
        assert_eq!(solve(matrix, integers(&[&[1], &[1]])), None);
    }
}
