//! Small linear systems over any field.
//!
//! nalgebra solves them over real and complex floating-point numbers only; here are the rationals too.

use crate::law::gamma;
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

/// Whether a matrix of differences has an inverse, as far as rounding can tell.
///
/// Elimination with the pivots of [`solve`], and with the magnitude of what every entry was subtracted from beside it.
/// A pivot that is not larger than its rounding error is taken for 0.
/// The entries of the first column are differences with a single rounding, so they are 0 only if they are exactly.
/// A step multiplies and divides three entries and subtracts: 3 roundings of the entries, 3 of the operations.
/// For two columns this bounds the error, so that a singular matrix is always found; for more it is an estimate,
/// because the error of a pivot goes into later ones.
pub(crate) fn is_regular<T: Scalar>(mut matrix: Vec<Vec<T>>) -> bool {
    let size = matrix.len();
    let mut magnitudes: Vec<Vec<f64>> = matrix
        .iter()
        .map(|row| row.iter().map(Scalar::magnitude).collect())
        .collect();
    for column in 0..size {
        let magnitude = |row: usize| matrix[row][column].magnitude();
        let pivot = (column..size)
            .filter(|&row| !matrix[row][column].is_zero())
            .max_by(|&a, &b| magnitude(a).total_cmp(&magnitude(b)));
        let Some(pivot) = pivot else { return false };
        let error = gamma(6 * column) * magnitudes[pivot][column];
        if !T::EXACT && magnitude(pivot) <= error {
            return false;
        }
        matrix.swap(column, pivot);
        magnitudes.swap(column, pivot);
        let (pivot_row, pivot_magnitudes) = (matrix[column].clone(), magnitudes[column].clone());
        for row in column + 1..size {
            let factor = matrix[row][column].clone() / pivot_row[column].clone();
            subtract(&mut matrix[row], &pivot_row, &factor);
            for (magnitude, other) in magnitudes[row].iter_mut().zip(&pivot_magnitudes) {
                *magnitude += factor.magnitude() * other;
            }
        }
    }
    true
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
    fn rounding_does_not_make_a_singular_matrix_regular() {
        for (p, q) in (1..40).flat_map(|p| (1..40).map(move |q| (f64::from(p), f64::from(q)))) {
            assert!(
                !is_regular(vec![vec![p, q * p], vec![3.0, q * 3.0]]),
                "{p}, {q}"
            );
            assert!(
                is_regular(vec![vec![p, q * p], vec![3.0, q * 3.0 + 1.0]]),
                "{p}, {q}"
            );
        }
        assert!(is_regular(integers(&[&[0, 1, 2], &[1, 0, 3], &[2, 1, 0]])));
        assert!(!is_regular(integers(&[&[0, 1, 2], &[1, 0, 3], &[1, 1, 5]])));
    }

    #[test]
    fn a_singular_matrix() {
        let matrix = integers(&[&[1, 2], &[2, 4]]);
        assert_eq!(solve(matrix, integers(&[&[1], &[1]])), None);
    }
}
