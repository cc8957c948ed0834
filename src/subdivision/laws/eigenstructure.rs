//! Laws of subdivision matrices and of characteristic maps.

use super::catmull_clark::refused;
use crate::affine::Affine;
use crate::law::{Rounding, Sides};
use crate::scalar::Scalar;
use crate::subdivision::{
    CharacteristicMapTest, SubdivisionMatrix, SubdivisionMatrixError, SurfaceScheme,
};

/// `subdivision-matrix`: P' = A·P, and the rows of A sum to 1.
///
/// `scheme` makes the new points of the rings, `product(v)` must be A·v for the matrix of that scheme, `data` are numbers at the vertices.
///
/// # Rounding
///
/// A new point is a sum of at most n terms, n the size of the matrix, whose weights pass at most 60 roundings; their absolute values
/// sum to at most 3.
pub fn matrix<T: Scalar + Affine<Scalar = T>>(
    scheme: &impl SurfaceScheme<T>,
    matrix: &SubdivisionMatrix<T>,
    product: impl Fn(&[T]) -> Vec<T>,
    data: &[T],
) -> Sides<T> {
    let fan = matrix.fan();
    let largest = data.iter().map(Scalar::magnitude).fold(1.0, f64::max);
    let rounding = Rounding::new(2 * matrix.len() + 60, 6.0 * largest);
    let sides = Sides::new(format!("valence {}, data {data:?}", fan.valence()));
    let refined = match fan.refine(scheme, data) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let sector = refined.len() / fan.valence();
    let centre = usize::from(fan.has_centre());
    let new = (0..fan.valence()).flat_map(|s| {
        let start = centre + s * sector;
        start..start + fan.sector_len()
    });
    let new = (0..centre).chain(new).map(|i| refined[i].clone());
    let ones = vec![T::one(); matrix.len()];
    sides
        .equal("A·P = P'", product(data), new.collect::<Vec<_>>(), rounding)
        .equal("A·1 = 1", product(&ones), ones.clone(), rounding)
}

/// `subdivision-characteristic-map`: the scheme passes the test at this valence.
///
/// `implementation(valence)` must be the test of the scheme's characteristic map. The claims: 1 > λ₁ = λ₂ > |λ₃|, no face of the
/// refined ring is turned over, and the ring winds around the centre once.
///
/// # Rounding
///
/// None: the test gives whole numbers.
pub fn characteristic_map(
    implementation: impl Fn(usize) -> Result<CharacteristicMapTest, SubdivisionMatrixError>,
    valence: usize,
) -> Sides<f64> {
    let sides = Sides::new(format!("valence {valence}"));
    match implementation(valence) {
        Err(error) => refused(sides, &error),
        Ok(test) => sides
            .equal(
                "a subdominant pair",
                [f64::from(u8::from(test.subdominant_pair))],
                [1.0],
                Rounding::none(),
            )
            .equal(
                "faces with the wrong orientation",
                [test.not_positive as f64],
                [0.0],
                Rounding::none(),
            )
            .at_most(
                "there are faces",
                [1.0],
                [test.faces as f64],
                Rounding::none(),
            )
            .equal(
                "winding number",
                [test.winding_number as f64],
                [1.0],
                Rounding::none(),
            ),
    }
}
