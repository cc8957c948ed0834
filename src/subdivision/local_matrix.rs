//! The square matrix that refines the points around one parameter.

use super::laurent::LaurentPolynomial;
use super::mask::Mask;
use crate::scalar::Scalar;

/// The subdivision matrix A of the points that decide the limit at the parameter 0.
///
/// Let the mask have the indices l, …, h, and let pᵢ belong to the parameter i, after k steps to i/2ᵏ.
/// The limit at 0 depends on the points of the indices 1 − h, …, −l − 1 alone, before and after every step.
/// A refines them: the entry in row i and column j is aᵢ₋₂ⱼ.
///
/// Eigenvectors are found by elimination, where a pivot is whatever is not 0.
/// So take exact numbers.
///
/// # Examples
///
/// ```
/// use cagd::scalar::{BigRational, Scalar};
/// use cagd::subdivision::{LocalMatrix, Mask};
///
/// let ratio = |p, q| <BigRational as Scalar>::from_ratio(p, q);
/// let chaikin = LocalMatrix::of(&Mask::lane_riesenfeld(2));
/// assert_eq!((chaikin.first(), chaikin.size()), (-2, 2));
/// assert_eq!(chaikin.rows()[0], [ratio(3, 4), ratio(1, 4)]);
/// assert_eq!(chaikin.left_eigenvectors(&ratio(1, 1)), [[ratio(1, 1), ratio(1, 1)]]);
/// assert_eq!(chaikin.left_eigenvectors(&ratio(1, 2)), [[ratio(-1, 1), ratio(1, 1)]]);
/// assert_eq!(chaikin.left_eigenvectors(&ratio(1, 3)).len(), 0);
/// ```
///
/// Source: `warren-weimer2001`, §3.
#[derive(Debug, Clone, PartialEq)]
pub struct LocalMatrix<T> {
    first: i64,
    rows: Vec<Vec<T>>,
}

impl<T: Scalar> LocalMatrix<T> {
    /// The matrix of a scheme; it has no row if the mask has fewer than three indices.
    #[must_use]
    pub fn of(mask: &Mask<T>) -> Self {
        let support = mask.support();
        let window = 2 - support.end..-support.start;
        let row = |i: i64| {
            let columns = window.clone();
            columns.map(|j| mask.coefficient(i - 2 * j)).collect()
        };
        Self {
            first: window.start,
            rows: window.clone().map(row).collect(),
        }
    }

    /// The index of the first of the points.
    #[must_use]
    pub fn first(&self) -> i64 {
        self.first
    }

    /// How many points there are.
    #[must_use]
    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// The rows: the rules of the new points.
    #[must_use]
    pub fn rows(&self) -> &[Vec<T>] {
        &self.rows
    }

    /// A basis of the row vectors l with l·A = `eigenvalue`·l; none if that is no eigenvalue.
    #[must_use]
    pub fn left_eigenvectors(&self, eigenvalue: &T) -> Vec<Vec<T>> {
        let shifted = self.shifted(eigenvalue);
        let columns = (0..self.size()).map(|j| shifted.iter().map(|row| row[j].clone()).collect());
        null_space(columns.collect())
    }

    /// A basis of the column vectors r with A·r = `eigenvalue`·r.
    #[must_use]
    pub fn right_eigenvectors(&self, eigenvalue: &T) -> Vec<Vec<T>> {
        null_space(self.shifted(eigenvalue))
    }

    /// The value of the characteristic polynomial det(A − λ·I) at λ = `at`.
    #[must_use]
    pub fn characteristic(&self, at: &T) -> T {
        determinant(self.shifted(at))
    }

    /// A − λ·I.
    fn shifted(&self, eigenvalue: &T) -> Vec<Vec<T>> {
        let mut rows = self.rows.clone();
        for (i, row) in rows.iter_mut().enumerate() {
            row[i] -= eigenvalue.clone();
        }
        rows
    }

    /// The row vector `weights`·A.
    #[must_use]
    pub fn times_left(&self, weights: &[T]) -> Vec<T> {
        let entry = |j: usize| {
            let terms = weights.iter().zip(&self.rows);
            terms.fold(T::zero(), |sum, (w, row)| sum + w.clone() * row[j].clone())
        };
        (0..self.size()).map(entry).collect()
    }

    /// Row weights as a sequence with the indices of the points.
    #[must_use]
    pub fn indexed(&self, weights: Vec<T>) -> LaurentPolynomial<T> {
        LaurentPolynomial::new(self.first, weights)
    }
}

/// A basis of the vectors x with `matrix`·x = 0, by elimination; each basis vector has a 1 of its own.
fn null_space<T: Scalar>(mut matrix: Vec<Vec<T>>) -> Vec<Vec<T>> {
    let size = matrix.first().map_or(0, Vec::len);
    let mut pivots = Vec::new();
    for column in 0..size {
        let rank = pivots.len();
        let Some(row) = (rank..matrix.len()).find(|&row| !matrix[row][column].is_zero()) else {
            continue;
        };
        matrix.swap(rank, row);
        let pivot = matrix[rank][column].clone();
        for entry in &mut matrix[rank] {
            *entry /= pivot.clone();
        }
        let pivot_row = matrix[rank].clone();
        for (other, row) in matrix.iter_mut().enumerate() {
            if other != rank {
                eliminate(row, &pivot_row, column);
            }
        }
        pivots.push(column);
    }
    let free = (0..size).filter(|column| !pivots.contains(column));
    let vector = |free: usize| {
        let mut vector = vec![T::zero(); size];
        vector[free] = T::one();
        for (row, &column) in pivots.iter().enumerate() {
            vector[column] = -matrix[row][free].clone();
        }
        vector
    };
    free.map(vector).collect()
}

/// The determinant, by elimination; 1 if there is no row.
pub(super) fn determinant<T: Scalar>(mut matrix: Vec<Vec<T>>) -> T {
    let mut product = T::one();
    for column in 0..matrix.len() {
        let Some(row) = (column..matrix.len()).find(|&row| !matrix[row][column].is_zero()) else {
            return T::zero();
        };
        if row != column {
            matrix.swap(row, column);
            product = -product;
        }
        let pivot = matrix[column][column].clone();
        product *= pivot.clone();
        let mut pivot_row = matrix[column].clone();
        for entry in &mut pivot_row {
            *entry /= pivot.clone();
        }
        for row in &mut matrix[column + 1..] {
            eliminate(row, &pivot_row, column);
        }
    }
    product
}

/// Subtracts the multiple of a row with 1 in this column that makes the entry there 0.
fn eliminate<T: Scalar>(row: &mut [T], pivot_row: &[T], column: usize) {
    let factor = row[column].clone();
    if !factor.is_zero() {
        for (entry, pivot) in row.iter_mut().zip(pivot_row) {
            *entry -= factor.clone() * pivot.clone();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::BigRational;

    fn whole(rows: &[&[i64]]) -> Vec<Vec<BigRational>> {
        let row = |row: &&[i64]| row.iter().map(|&n| Scalar::from_integer(n)).collect();
        rows.iter().map(row).collect()
    }

    #[test]
    fn determinants_with_and_without_exchange() {
        let value = |rows: &[&[i64]]| determinant(whole(rows));
        let number = <BigRational as Scalar>::from_integer;
        assert_eq!(value(&[&[0, 2], &[3, 5]]), number(-6));
        assert_eq!(value(&[&[2, 1, 0], &[1, 2, 1], &[0, 1, 2]]), number(4));
        assert_eq!(value(&[&[1, 2], &[2, 4]]), number(0));
    }

    #[test]
    fn null_spaces_of_all_dimensions() {
        assert_eq!(null_space(whole(&[&[0, 1], &[1, 0]])).len(), 0);
        assert_eq!(null_space(whole(&[&[1, 2], &[2, 4]])), whole(&[&[-2, 1]]));
        assert_eq!(
            null_space(whole(&[&[0, 0], &[0, 0]])),
            whole(&[&[1, 0], &[0, 1]])
        );
    }
}
