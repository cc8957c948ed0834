//! The eigenvalues of the subdivision matrices and the tests of the characteristic maps, by valence.

use super::{Computed, VALENCES};
use crate::affine::Point;
use crate::subdivision::{
    Butterfly, CatmullClark, CharacteristicMap, DooSabin, FanNet, Kobbelt, Loop, Spectrum,
    SubdivisionMatrix, SubdivisionMatrixError, SurfaceScheme,
};

pub(super) const ALL: &[Computed] = &[
    ("subdominant_eigenvalues", subdominant_eigenvalues),
    ("third_eigenvalues", third_eigenvalues),
    ("characteristic_tests", characteristic_tests),
];

/// Something that is asked of each scheme of the chapter at one valence; its smallest matrix has so many rings.
trait Question {
    fn ask<S>(
        &self,
        scheme: &S,
        net: FanNet,
        valence: usize,
        rings: usize,
    ) -> Result<String, SubdivisionMatrixError>
    where
        S: SurfaceScheme<f64> + SurfaceScheme<Point<f64, 2>>;
}

/// A table with a row for each valence, the five schemes and perhaps the unmodified Butterfly scheme in its columns.
fn table(question: &impl Question, with_eight_points: bool) -> String {
    let mut names = vec!["Loop", "Butterfly", "Catmull–Clark", "Doo–Sabin", "Kobbelt"];
    if with_eight_points {
        names.push("eight points");
    }
    let mut table = format!("| $k$ | {} |\n|--:|", names.join(" | "));
    table += &"--:|".repeat(names.len());
    table += "\n";
    for k in VALENCES {
        let cells = [
            question.ask(&Loop, FanNet::Triangles, k, 1),
            question.ask(&Butterfly::MODIFIED, FanNet::Triangles, k, 2),
            question.ask(&CatmullClark, FanNet::Quadrilaterals, k, 1),
            question.ask(&DooSabin, FanNet::AroundFace, k, 2),
            question.ask(&Kobbelt, FanNet::Quadrilaterals, k, 2),
        ];
        let mut cells = Vec::from(cells);
        if with_eight_points {
            cells.push(question.ask(&Butterfly::UNMODIFIED, FanNet::Triangles, k, 2));
        }
        let cells: Vec<String> = cells
            .into_iter()
            .map(|cell| cell.unwrap_or_else(|_| "none".to_string()))
            .collect();
        table += &format!("| {k} | {} |\n", cells.join(" | "));
    }
    table
}

/// The absolute value of the eigenvalue with this place in the order of size.
struct AbsoluteValue {
    place: usize,
}

impl Question for AbsoluteValue {
    fn ask<S>(
        &self,
        scheme: &S,
        net: FanNet,
        valence: usize,
        rings: usize,
    ) -> Result<String, SubdivisionMatrixError>
    where
        S: SurfaceScheme<f64> + SurfaceScheme<Point<f64, 2>>,
    {
        let spectrum = Spectrum::of(&SubdivisionMatrix::extract(scheme, net, valence, rings)?);
        let value = spectrum.eigenvalues()[self.place].value.norm();
        // Multiple eigenvalues with a Jordan block are found with half of the digits.
        Ok(format!("{value:.3}"))
    }
}

/// λ₁ = λ₂.
fn subdominant_eigenvalues() -> String {
    table(&AbsoluteValue { place: 1 }, false)
}

/// |λ₃|.
fn third_eigenvalues() -> String {
    table(&AbsoluteValue { place: 3 }, false)
}

/// Whether the characteristic map passes its test after one step, and why not.
struct CharacteristicTest;

impl Question for CharacteristicTest {
    fn ask<S>(
        &self,
        scheme: &S,
        net: FanNet,
        valence: usize,
        _rings: usize,
    ) -> Result<String, SubdivisionMatrixError>
    where
        S: SurfaceScheme<f64> + SurfaceScheme<Point<f64, 2>>,
    {
        let test = CharacteristicMap::of(scheme, net, valence)?.test(scheme, 1)?;
        Ok(if test.passed() {
            "passes".to_string()
        } else if !test.subdominant_pair {
            "no pair".to_string()
        } else if test.winding_number != 1 {
            format!("winds {}×", test.winding_number)
        } else {
            "turns over".to_string()
        })
    }
}

fn characteristic_tests() -> String {
    table(&CharacteristicTest, true)
}
