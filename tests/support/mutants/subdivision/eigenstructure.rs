//! Wrong matrices and tests of characteristic maps.

use cagd::subdivision::{
    Butterfly, CharacteristicMap, CharacteristicMapTest, FanNet, SubdivisionMatrix,
    SubdivisionMatrixError,
};

/// Multiplies from the wrong side.
pub fn transposed(matrix: &SubdivisionMatrix<f64>, data: &[f64]) -> Vec<f64> {
    matrix.apply_left(data)
}

/// Numbers the sectors the other way round.
pub fn sectors_reversed(matrix: &SubdivisionMatrix<f64>, data: &[f64]) -> Vec<f64> {
    let mut product = matrix.apply(data);
    let centre = usize::from(matrix.fan().has_centre());
    product[centre..].reverse();
    product
}

/// Takes the eight-point stencil at every valence.
pub fn unmodified_butterfly(
    valence: usize,
) -> Result<CharacteristicMapTest, SubdivisionMatrixError> {
    let map = CharacteristicMap::of(&Butterfly::UNMODIFIED, FanNet::Triangles, valence)?;
    Ok(map.test(&Butterfly::UNMODIFIED, 1)?)
}
