//! Figures of the section on eigenvalues and characteristic maps.

use crate::affine::{Affine, Point};
use crate::figure::{Axes, BoxError, Canvas, Figure, PointStyle, Style, Surface, View};
use crate::scalar::Scalar;
use crate::subdivision::{
    Butterfly, CatmullClark, CharacteristicMap, CosineOfTurn, DooSabin, FanNet, Kobbelt, Loop,
    Mesh, SchemeError, Spectrum, SubdivisionMatrix, SubdivisionMatrixError, SurfaceScheme, laws,
};

pub(super) fn all() -> Vec<Figure> {
    vec![matrix(), characteristic_map()]
}

/// A scheme that is chosen when a figure or a table is made, so that the code around it is there once and not for each of them.
#[derive(Debug, Clone, Copy)]
pub(in crate::subdivision) enum Chosen {
    Loop,
    Butterfly(Butterfly),
    CatmullClark,
    DooSabin,
    Kobbelt,
}

impl<P> SurfaceScheme<P> for Chosen
where
    P: Affine,
    P::Scalar: CosineOfTurn,
{
    fn name(&self) -> &'static str {
        match self {
            Self::Loop => SurfaceScheme::<P>::name(&Loop),
            Self::Butterfly(scheme) => SurfaceScheme::<P>::name(scheme),
            Self::CatmullClark => SurfaceScheme::<P>::name(&CatmullClark),
            Self::DooSabin => SurfaceScheme::<P>::name(&DooSabin),
            Self::Kobbelt => SurfaceScheme::<P>::name(&Kobbelt),
        }
    }

    fn refine(&self, mesh: &Mesh<P>) -> Result<Mesh<P>, SchemeError> {
        match self {
            Self::Loop => Loop.refine(mesh),
            Self::Butterfly(scheme) => scheme.refine(mesh),
            Self::CatmullClark => CatmullClark.refine(mesh),
            Self::DooSabin => DooSabin.refine(mesh),
            Self::Kobbelt => Kobbelt.refine(mesh),
        }
    }
}

/// The schemes of the chapter, the unmodified Butterfly scheme last.
///
/// Each has its net around an extraordinary point, and the number of rings of its smallest matrix.
pub(in crate::subdivision) const SCHEMES: [(Chosen, FanNet, usize); 6] = [
    (Chosen::Loop, FanNet::Triangles, 1),
    (Chosen::Butterfly(Butterfly::MODIFIED), FanNet::Triangles, 2),
    (Chosen::CatmullClark, FanNet::Quadrilaterals, 1),
    (Chosen::DooSabin, FanNet::AroundFace, 2),
    (Chosen::Kobbelt, FanNet::Quadrilaterals, 2),
    (
        Chosen::Butterfly(Butterfly::UNMODIFIED),
        FanNet::Triangles,
        2,
    ),
];

/// The names of the schemes in a legend.
const NAMES: [&str; 6] = [
    "Loop",
    "modified Butterfly",
    "Catmull–Clark",
    "Doo–Sabin",
    "Kobbelt",
    "unmodified Butterfly",
];

/// λ and |λ₃| of a scheme at one valence.
fn pair(
    scheme: Chosen,
    net: FanNet,
    valence: usize,
    rings: usize,
) -> Result<[f64; 2], SubdivisionMatrixError> {
    let spectrum = Spectrum::of(&SubdivisionMatrix::extract(&scheme, net, valence, rings)?);
    let third = spectrum.eigenvalues()[3].value.magnitude();
    Ok([spectrum.subdominant().value.magnitude(), third])
}

/// The eigenvalues λ and |λ₃| of all five schemes against the valence.
#[must_use]
pub fn matrix() -> Figure {
    const PANELS: [&str; 2] = ["lambda", "third"];
    // The unmodified Butterfly scheme has no double subdominant eigenvalue to show.
    const SHOWN: usize = 5;
    Figure::new(
        "subdivision-matrix",
        "Eigenvalues of the subdivision matrices against the valence",
        "Two diagrams with the valence from 3 to 12 on the horizontal axis and five broken lines, one for each scheme. \
         The upper diagram shows the double subdominant eigenvalue: it is one half for the modified Butterfly scheme and that of Doo and Sabin, \
         and grows with the valence for the other three. The lower diagram shows the absolute value of the next eigenvalue, which is smaller everywhere.",
    )
    .rows(&[&PANELS[..1], &PANELS[1..]])
    .draw(|_, canvas| {
        let mut lines = vec![[vec![], vec![]]; SHOWN];
        for (lines, (scheme, net, rings)) in lines.iter_mut().zip(SCHEMES) {
            for k in 3..=12 {
                for (line, value) in lines.iter_mut().zip(pair(scheme, net, k, rings)?) {
                    line.push([k as f64, value]);
                }
            }
        }
        for (i, panel) in PANELS.into_iter().enumerate() {
            canvas.panel(panel);
            canvas.axes(Axes::new("k", ["\\lambda", "|\\lambda_3|"][i]));
            canvas.window([2.5, 0.0], [12.5, 0.8]);
            for (s, (line, name)) in lines.iter().zip(NAMES).enumerate() {
                canvas.polyline(name, line[i].iter().copied(), Style::Series(s));
                canvas.legend(name, Style::Series(s));
            }
        }
        Ok(())
    })
}

/// The ring of a characteristic map with what the test says of it.
fn ring(
    canvas: &mut Canvas,
    name: &str,
    scheme: Chosen,
    net: FanNet,
    valence: usize,
    steps: usize,
) -> Result<(), BoxError> {
    let map = CharacteristicMap::of(&scheme, net, valence)?;
    let ring = map.ring(&scheme, steps)?;
    let test = map.test(&scheme, steps)?;
    let mut faces = vec![];
    let mut points = vec![];
    for face in &ring.faces {
        let first = points.len() as u32;
        faces.push((first..first + face.len() as u32).collect());
        points.extend(face.iter().map(|p| Point::new([p[0], p[1], 0.0])));
    }
    canvas.caption(&format!(
        "{name}, $k = {valence}$: {} of {} faces turned over, winding number {}",
        test.not_positive, test.faces, test.winding_number
    ));
    canvas.surface("ring", &View::from_above(), &Surface::new(points, faces));
    let border = ring.inner_border.iter();
    canvas.polyline(
        "inner border",
        border.chain(ring.inner_border.first()),
        Style::Tangent,
    );
    canvas.point("centre", [0.0, 0.0], PointStyle::Guide);
    if test.passed() {
        canvas.law(
            "subdivision-characteristic-map",
            &laws::characteristic_map(|_| Ok(test), valence),
        );
    } else {
        canvas.remark(&format!(
            "The test fails: {} Nothing is proved then, and the surface need not be smooth at such a vertex.",
            match test.subdominant_pair {
                false => "the eigenvalues after 1 are no pair that is larger than all others.",
                true => "the ring covers itself, or some of its faces are turned over.",
            }
        ));
    }
    Ok(())
}

/// The characteristic net of a scheme, refined, with orientation and winding number.
#[must_use]
pub fn characteristic_map() -> Figure {
    Figure::new(
        "subdivision-characteristic-map",
        "The ring of a characteristic map, which must run around once without a fold",
        "A ring of small faces in the plane with k-fold symmetry around its centre, and its inner border as a line. \
         The text above names the scheme and the valence and says how many faces are turned over, and how often the ring runs around the centre. \
         The schemes are, in this order: Loop, modified Butterfly, Catmull–Clark, Doo–Sabin, Kobbelt, and the unmodified Butterfly scheme.",
    )
    .choice("scheme", &NAMES, 0)
    .stepper("k", 3..=12, 5)
    .stepper("steps", 0..=2, 1)
    .draw(|values, canvas| {
        let (k, steps) = (values.count("k")?, values.count("steps")?);
        let chosen = values.count("scheme")?;
        let (scheme, net, _) = SCHEMES[chosen];
        ring(canvas, NAMES[chosen], scheme, net, k, steps)
    })
}
