//! Properties of subdivision matrices and characteristic maps.

use cagd::affine::Point;
use cagd::subdivision::{
    Butterfly, CatmullClark, CharacteristicMap, CharacteristicMapTest, DooSabin, FanNet, Kobbelt,
    Loop, Spectrum, SubdivisionMatrix, SubdivisionMatrixError, SurfaceScheme, laws,
};
use proptest::prelude::*;

use crate::generators::for_all_of;
use crate::support::mutants::subdivision::eigenstructure as mutants;
use crate::support::{Outcome, holds, rejects};

type Product = fn(&SubdivisionMatrix<f64>, &[f64]) -> Vec<f64>;

#[test]
fn matrix() {
    /// The law of the matrix for one scheme, with random data around a point of valence 3 to 12.
    fn law(
        scheme: impl SurfaceScheme<f64>,
        net: FanNet,
        rings: usize,
        product: Product,
    ) -> Outcome {
        let inputs = (3..=12usize).prop_flat_map(move |valence| {
            let count = 1 + valence * 12;
            (Just(valence), prop::collection::vec(-8.0..8.0, count))
        });
        for_all_of(24, inputs, |(valence, data)| {
            let matrix =
                SubdivisionMatrix::extract(&scheme, net, *valence, rings).expect("enough rings");
            let data = &data[..matrix.len()];
            laws::matrix(&scheme, &matrix, |v| product(&matrix, v), data)
        })
    }

    let apply: Product = |matrix, v| matrix.apply(v);
    holds(law(Loop, FanNet::Triangles, 1, apply));
    holds(law(Butterfly::MODIFIED, FanNet::Triangles, 2, apply));
    holds(law(CatmullClark, FanNet::Quadrilaterals, 1, apply));
    holds(law(DooSabin, FanNet::AroundFace, 2, apply));
    holds(law(Kobbelt, FanNet::Quadrilaterals, 2, apply));
    rejects(
        "transposed",
        law(Loop, FanNet::Triangles, 1, mutants::transposed),
    );
    rejects(
        "sectors reversed",
        law(Loop, FanNet::Triangles, 1, mutants::sectors_reversed),
    );
}

/// The test of one scheme at one valence, after two further steps.
fn test_of(
    scheme: &(impl SurfaceScheme<f64> + SurfaceScheme<Point<f64, 2>>),
    net: FanNet,
    valence: usize,
) -> Result<CharacteristicMapTest, SubdivisionMatrixError> {
    Ok(CharacteristicMap::of(scheme, net, valence)?.test(scheme, 2)?)
}

#[test]
fn characteristic_map() {
    type Test = fn(usize) -> Result<CharacteristicMapTest, SubdivisionMatrixError>;
    let law = |implementation: Test| -> Outcome {
        for valence in 3..=12 {
            let sides = laws::characteristic_map(implementation, valence);
            sides.judge().map_err(|violation| violation.to_string())?;
        }
        Ok(())
    };
    holds(law(|valence| test_of(&Loop, FanNet::Triangles, valence)));
    holds(law(|valence| {
        test_of(&Butterfly::MODIFIED, FanNet::Triangles, valence)
    }));
    holds(law(|valence| {
        test_of(&CatmullClark, FanNet::Quadrilaterals, valence)
    }));
    holds(law(|valence| {
        test_of(&DooSabin, FanNet::AroundFace, valence)
    }));
    holds(law(|valence| {
        test_of(&Kobbelt, FanNet::Quadrilaterals, valence)
    }));
    rejects("eight points", law(mutants::unmodified_butterfly));
}

/// At valence 9 the eight points alone give a subdominant pair of frequency 2, and the ring winds twice.
#[test]
fn the_unmodified_butterfly_winds_twice() {
    let map = CharacteristicMap::of(&Butterfly::UNMODIFIED, FanNet::Triangles, 9).expect("4 rings");
    assert_eq!(map.eigenvalue().frequency, 2);
    let test = map.test(&Butterfly::UNMODIFIED, 2).expect("a refined net");
    assert_eq!(test.winding_number, 2);
}

/// Known eigenvalues of the five schemes at valence 5.
#[test]
fn subdominant_eigenvalues() {
    fn lambda(scheme: impl SurfaceScheme<f64>, net: FanNet, rings: usize) -> f64 {
        let matrix = SubdivisionMatrix::extract(&scheme, net, 5, rings).expect("enough rings");
        Spectrum::of(&matrix).subdominant().value.re
    }
    let c = (std::f64::consts::TAU / 5.0).cos();
    let half = (std::f64::consts::PI / 5.0).cos();
    let catmull_clark = (5.0 + c + half * (18.0 + 2.0 * c).sqrt()) / 16.0;
    let found = [
        lambda(Loop, FanNet::Triangles, 1),
        lambda(Butterfly::MODIFIED, FanNet::Triangles, 2),
        lambda(CatmullClark, FanNet::Quadrilaterals, 1),
        lambda(DooSabin, FanNet::AroundFace, 1),
        lambda(Kobbelt, FanNet::Quadrilaterals, 2),
    ];
    let expected = [0.375 + c / 4.0, 0.5, catmull_clark, 0.5, 0.5379];
    for (found, expected) in found.into_iter().zip(expected) {
        // The last is known to four digits only.
        let bound = if expected == 0.5379 { 5e-5 } else { 1e-12 };
        assert!(
            (found - expected).abs() < bound,
            "{found}, expected {expected}"
        );
    }
}
