//! Laws of Loop's scheme.

use std::collections::BTreeMap;

use super::catmull_clark::{Refined, flat, largest, refused, shown};
use crate::affine::{Affine, Point, Vector};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};
use crate::subdivision::{
    CosineError, CosineOfTurn, LatticeMask, Mesh, SchemeError, SubdivisionMatrix, VertexId,
};

/// The third vertex of the face to the left of every directed edge, from the lists of faces alone.
pub(super) struct Opposite(BTreeMap<(u32, u32), u32>);

impl Opposite {
    pub(super) fn of<P: Affine>(mesh: &Mesh<P>) -> Self {
        let lists = mesh.connectivity().face_lists();
        let sides = lists.iter().flat_map(|face| {
            let corner = |i: usize| face[i % face.len()];
            (0..face.len()).map(move |i| ((corner(i), corner(i + 1)), corner(i + 2)))
        });
        Self(sides.collect())
    }

    /// The vertex opposite to the edge from a to b, on its left.
    pub(super) fn left_of(&self, a: u32, b: u32) -> Option<u32> {
        self.0.get(&(a, b)).copied()
    }

    /// Of every vertex on the boundary the one before and the one after it, the boundary running with its faces to the right.
    pub(super) fn boundary(&self) -> BTreeMap<u32, (u32, u32)> {
        let mut along: BTreeMap<u32, (u32, u32)> = BTreeMap::new();
        for &(b, a) in self
            .0
            .keys()
            .filter(|&&(b, a)| !self.0.contains_key(&(a, b)))
        {
            along.entry(a).or_insert((a, a)).1 = b;
            along.entry(b).or_insert((b, b)).0 = a;
        }
        along
    }

    /// The vertices that are joined to v.
    pub(super) fn neighbours(&self, v: u32) -> std::collections::BTreeSet<u32> {
        let sides = self.0.keys();
        let ends = sides.flat_map(|&(a, b)| [(a, b), (b, a)]);
        ends.filter(|&(a, _)| a == v).map(|(_, b)| b).collect()
    }
}

/// Σ weight · point, by coordinates.
pub(super) fn weighted_sum<T: Scalar, const D: usize>(
    mesh: &Mesh<Point<T, D>>,
    terms: &[(T, u32)],
) -> Vec<T> {
    (0..D)
        .map(|k| {
            terms.iter().fold(T::zero(), |sum, (weight, v)| {
                sum + weight.clone() * mesh.point(VertexId(*v))[k].clone()
            })
        })
        .collect()
}

/// `subdivision-loop`: every new point satisfies its rule.
///
/// `implementation(mesh)` must give the refined mesh, the old vertices first, then one vertex an edge in the order of the edges.
/// The rules are taken from the lists of faces, without half-edges: 8e' = 3(a + b) + c + d, on the boundary 2e' = a + b;
/// k·v' = k(1 − w)v + w·Σ neighbours with w = 5/8 − (3/8 + cos(2π/k)/4)², on the boundary 8v' = a + 6v + b.
///
/// # Rounding
///
/// With valences up to k at most 2k + 30 roundings a term, the cosine's twelve among them; the terms of 8e' and of k·v' sum to at most
/// (8 + 2k) times the largest coordinate on both sides.
pub fn loop_rules<T: CosineOfTurn>(
    implementation: impl Fn(&Mesh<Point<T, 3>>) -> Refined<Point<T, 3>>,
    mesh: &Mesh<Point<T, 3>>,
) -> Sides<T> {
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let refined = match implementation(mesh) {
        Ok(refined) => refined,
        Err(error) => return refused(sides, &error),
    };
    let whole = |n: usize| T::from_integer(n as i64);
    let count = old.vertex_count() + old.edge_count();
    let sides = sides.equal(
        "one point for each vertex and edge",
        [whole(refined.points().len())],
        [whole(count)],
        Rounding::none(),
    );
    if refined.points().len() != count {
        return sides;
    }
    let opposite = Opposite::of(mesh);
    let is_rim =
        |a: u32, b: u32| opposite.left_of(a, b).is_none() || opposite.left_of(b, a).is_none();
    let widest = old.vertices().map(|v| old.valence(v)).max().unwrap_or(3);
    let rounding = Rounding::new(
        2 * widest + 30,
        (8 + 2 * widest) as f64 * largest(mesh.points()),
    );
    let times = |factor: T, point: &Point<T, 3>| -> Vec<T> {
        let coordinates = point.coordinates().iter();
        coordinates.map(|x| factor.clone() * x.clone()).collect()
    };
    let (mut found, mut expected) = (vec![], vec![]);
    for e in old.edges() {
        let [a, b] = old.edge_vertices(e).map(|v| v.0);
        let point = &refined.points()[old.vertex_count() + e.index()];
        let one = T::one();
        let (factor, terms) = match (opposite.left_of(a, b), opposite.left_of(b, a)) {
            (Some(c), Some(d)) => (
                8,
                vec![(whole(3), a), (whole(3), b), (one.clone(), c), (one, d)],
            ),
            _ => (2, vec![(one.clone(), a), (one, b)]),
        };
        found.extend(times(whole(factor), point));
        expected.extend(weighted_sum(mesh, &terms));
    }
    let sides = sides.equal("edge points", found, expected, rounding);
    let (mut found, mut expected) = (vec![], vec![]);
    for v in 0..old.vertex_count() as u32 {
        let point = &refined.points()[v as usize];
        let neighbours = opposite.neighbours(v);
        let rim: Vec<u32> = neighbours
            .iter()
            .copied()
            .filter(|&n| is_rim(v, n))
            .collect();
        let (factor, terms) = if rim.is_empty() {
            let k = neighbours.len();
            let cosine = match T::cosine_of_turn(1, k) {
                Ok(cosine) => cosine,
                Err(error) => return refused(sides, &error),
            };
            let lambda = T::from_ratio(3, 8) + cosine * T::from_ratio(1, 4);
            let w = T::from_ratio(5, 8) - lambda.clone() * lambda;
            let own = (whole(k) * (T::one() - w.clone()), v);
            let others = neighbours.iter().map(|&n| (w.clone(), n));
            (k, std::iter::once(own).chain(others).collect::<Vec<_>>())
        } else {
            let own = (whole(6), v);
            let others = rim.iter().map(|&n| (T::one(), n));
            (8, std::iter::once(own).chain(others).collect())
        };
        found.extend(times(whole(factor), point));
        expected.extend(weighted_sum(mesh, &terms));
    }
    sides
        .equal("vertex points", found, expected, rounding)
        .and(split_in_four(mesh, &refined))
}

/// Every triangle became four, and the new points are where the scheme says: the lists of faces.
pub(super) fn split_in_four<P: Affine>(mesh: &Mesh<P>, refined: &Mesh<P>) -> Sides<P::Scalar> {
    let old = mesh.connectivity();
    let middles: BTreeMap<[u32; 2], u32> = old
        .edges()
        .flat_map(|e| {
            let [a, b] = old.edge_vertices(e).map(|v| v.0);
            let middle = (old.vertex_count() + e.index()) as u32;
            [([a, b], middle), ([b, a], middle)]
        })
        .collect();
    let sorted = |lists: Vec<Vec<u32>>| -> Vec<P::Scalar> {
        let mut lists: Vec<Vec<u32>> = lists.into_iter().map(turned).collect();
        lists.sort();
        let numbers = lists.into_iter().flatten();
        numbers
            .map(|v| P::Scalar::from_integer(i64::from(v)))
            .collect()
    };
    let expected = old.face_lists().into_iter().flat_map(|face| {
        let m = |i: usize| middles[&[face[i % 3], face[(i + 1) % 3]]];
        [
            vec![face[0], m(0), m(2)],
            vec![face[1], m(1), m(0)],
            vec![face[2], m(2), m(1)],
            vec![m(0), m(1), m(2)],
        ]
    });
    Sides::new(shown(mesh)).equal(
        "every triangle becomes four",
        sorted(refined.connectivity().face_lists()),
        sorted(expected.collect()),
        Rounding::none(),
    )
}

/// The same cycle with the smallest number first.
fn turned(mut face: Vec<u32>) -> Vec<u32> {
    let smallest = face.iter().enumerate().min_by_key(|(_, v)| **v);
    let start = smallest.map_or(0, |(i, _)| i);
    face.rotate_left(start);
    face
}

/// `subdivision-loop-properties`: the eigenvalues around a vertex of valence k, each with an eigenvector.
///
/// `matrix` must be that of one ring. The claims: A·1 = 1, A·w = λ²w for w = (kβ; −3/8, …), and A·v = (3/8 + cos(2πj/k)/4)·v
/// for v = (0; cos(2πj(i − t)/k)), j = 1, …, k − 1 and all t.
/// These vectors span the space, so there are no other eigenvalues.
///
/// # Rounding
///
/// A row has 7 weights at the most besides that of the centre, whose k + 1 weights sum to 1; all numbers are at most 1, so that
/// 2k + 60 roundings, the cosines' among them, of terms with the sum 4 are enough.
pub fn loop_properties<T: CosineOfTurn>(matrix: &SubdivisionMatrix<T>) -> Sides<T> {
    let k = matrix.fan().valence();
    let sides = Sides::new(format!("valence {k}"));
    match eigenvectors::<T>(k) {
        Err(error) => refused(sides, &error),
        Ok(pairs) => pairs.into_iter().fold(sides, |sides, (value, vector)| {
            let expected: Vec<T> = vector.iter().map(|x| value.clone() * x.clone()).collect();
            sides.equal(
                format!("A·v = {value}·v"),
                matrix.apply(&vector),
                expected,
                Rounding::new(2 * k + 60, 4.0),
            )
        }),
    }
}

fn eigenvectors<T: CosineOfTurn>(k: usize) -> Result<Vec<(T, Vec<T>)>, CosineError> {
    let lambda = |j: i64| -> Result<T, CosineError> {
        Ok(T::from_ratio(3, 8) + T::cosine_of_turn(j, k)? * T::from_ratio(1, 4))
    };
    let square = lambda(1)? * lambda(1)?;
    let mut second = vec![T::from_ratio(-3, 8); k + 1];
    second[0] = T::from_ratio(5, 8) - square.clone();
    let mut pairs = vec![(T::one(), vec![T::one(); k + 1]), (square, second)];
    for j in 1..k as i64 {
        for t in 0..k as i64 {
            let ring = (0..k as i64).map(|i| T::cosine_of_turn(j * (i - t), k));
            let vector: Result<Vec<T>, _> = std::iter::once(Ok(T::zero())).chain(ring).collect();
            pairs.push((lambda(j)?, vector?));
        }
    }
    Ok(pairs)
}

/// The limit position of a vertex.
type Limit<T> = Result<Point<T, 3>, SchemeError>;

/// Two tangents at a vertex.
type Tangents<T> = Result<[Vector<T, 3>; 2], SchemeError>;

/// `subdivision-loop-limit`: limit positions stay when the mesh is refined, tangents shrink by their eigenvalues.
///
/// `refine`, `limit` and `tangents` must be Loop's scheme, its limit position and its two tangents at a vertex.
/// The claims, for every vertex of the mesh: limit after a step = limit before; tangents after a step = λ·tangents, with
/// λ = 3/8 + cos(2π/k)/4 inside, 1/2 along the boundary and 3/8 + cos(π/(n − 1))/4 across it (1/4 for n = 2 neighbours);
/// of a mesh with all points in one place the limit is that place.
/// Weights with these properties are left eigenvectors of simple eigenvalues, so the claims leave no choice but a factor of the tangents.
///
/// # Rounding
///
/// With n neighbours at most 4n + 60 roundings. The weights across the boundary have the denominator 1 − c ≥ 2/n², and are up to n²
/// themselves, so that an error of c counts n⁴ times; 8n⁴ bounds all other sums, too.
pub fn loop_limit<T: CosineOfTurn>(
    refine: impl Fn(&Mesh<Point<T, 3>>) -> Refined<Point<T, 3>>,
    limit: impl Fn(&Mesh<Point<T, 3>>, VertexId) -> Limit<T>,
    tangents: impl Fn(&Mesh<Point<T, 3>>, VertexId) -> Tangents<T>,
    mesh: &Mesh<Point<T, 3>>,
) -> Sides<T> {
    let old = mesh.connectivity();
    let sides = Sides::new(shown(mesh));
    let collapsed = mesh.map(|_| mesh.points()[0].clone());
    let both = refine(mesh).and_then(|refined| Ok((refined, collapsed?)));
    let (refined, collapsed) = match both {
        Ok(both) => both,
        Err(error) => return refused(sides, &error),
    };
    let mut all = sides;
    for v in old.vertices() {
        let n = old.valence(v);
        let rounding = Rounding::new(
            4 * n + 60,
            8.0 * (n as f64).powi(4) * largest(mesh.points()),
        );
        let points = [&refined, mesh, &collapsed].map(|mesh| limit(mesh, v));
        let vectors = [&refined, mesh].map(|mesh| tangents(mesh, v));
        let ([Ok(after), Ok(before), Ok(one)], [Ok(small), Ok(large)]) = (points, vectors) else {
            return all.equal(
                "limits exist here",
                [T::one()],
                [T::zero()],
                Rounding::none(),
            );
        };
        let eighths = T::from_ratio(3, 8);
        let quarter = T::from_ratio(1, 4);
        let factors = match (old.is_boundary(v), n) {
            (true, 2) => Ok([T::from_ratio(1, 2), quarter]),
            (true, _) => T::cosine_of_turn(1, 2 * (n - 1))
                .map(|c| [T::from_ratio(1, 2), eighths + c * quarter]),
            (false, _) => T::cosine_of_turn(1, n).map(|c| {
                let lambda = eighths + c * quarter;
                [lambda.clone(), lambda]
            }),
        };
        let factors = match factors {
            Ok(factors) => factors,
            Err(error) => return refused(all, &error),
        };
        all = all
            .equal(
                format!("the limit of {v}"),
                flat([&after]),
                flat([&before]),
                rounding,
            )
            .equal(
                format!("the limit of {v} with all points in one place"),
                flat([&one]),
                flat([&mesh.points()[0]]),
                rounding,
            );
        for ((small, large), factor) in small.iter().zip(&large).zip(factors) {
            let scaled = large.iter().map(|x| factor.clone() * x.clone());
            all = all.equal(
                format!("a tangent at {v}"),
                small.iter().cloned(),
                scaled.collect::<Vec<_>>(),
                rounding,
            );
        }
    }
    all
}

/// `subdivision-loop-box-spline`: on regular meshes Loop's scheme has the symbol of the box spline M₂₂₂, and that is its limit.
///
/// `mask` must be the scheme on the lattice, `spline(x)` the value M₂₂₂(x) with the centre at the origin.
/// The claims: the symbol is 4((1 + x)/2)²((1 + y)/2)²((1 + xy)/2)²/(x²y²), its four classes sum to 1,
/// M(x) = Σ a_j M(2x − j), Σ M(x − j) = 1 and M ≥ 0, and the values at lattice points are 1/2, 1/12 and 0.
///
/// # Rounding
///
/// A value of M is a sum of 27 products of at most 9 operations whose absolute values sum to at most 2300;
/// with the 19 coefficients of the mask, which sum to 4, or over the at most 25 places where M(x − j) is not 0.
pub fn loop_box_spline<T: OrderedScalar + CosineOfTurn>(
    mask: &LatticeMask<T>,
    spline: impl Fn(&[T; 2]) -> T,
    x: &[T; 2],
) -> Sides<T> {
    const VALUE: f64 = 2300.0;
    let symbol = LatticeMask::three_direction([2, 2, 2]).shifted([-2, -2]);
    let square = || (-2..=2_i64).flat_map(|i| (-2..=2_i64).map(move |j| [i, j]));
    let numbers = |mask: &LatticeMask<T>| -> Vec<T> {
        let wide = (-3..=3).flat_map(|i| (-3..=3).map(move |j| [i, j]));
        wide.map(|index| mask.coefficient(index)).collect()
    };
    let at = |scale: i64, minus: [i64; 2]| {
        let coordinate =
            |k: usize| T::from_integer(scale) * x[k].clone() - T::from_integer(minus[k]);
        spline(&[coordinate(0), coordinate(1)])
    };
    let sum = |terms: &mut dyn Iterator<Item = T>| terms.fold(T::zero(), |sum, term| sum + term);
    let refined = sum(&mut mask.terms().map(|(j, a)| a.clone() * at(2, j)));
    // M(x − j) is not 0 only where j is less than 2 away from x.
    let near = |k: usize| x[k].to_f64().floor() as i64;
    let partition = sum(&mut (-2..=3).flat_map(|i| {
        let at = &at;
        (-2..=3).map(move |j| at(1, [near(0) + i, near(1) + j]))
    }));
    let at_lattice = square().map(|index| spline(&index.map(T::from_integer)));
    let values = square().map(|index| match index {
        [0, 0] => T::from_ratio(1, 2),
        [1, 0] | [0, 1] | [1, 1] | [-1, 0] | [0, -1] | [-1, -1] => T::from_ratio(1, 12),
        _ => T::zero(),
    });
    Sides::new(format!("x = ({}, {})", x[0], x[1]))
        .equal(
            "the coefficients are those of the symbol",
            numbers(mask),
            numbers(&symbol),
            Rounding::new(8, 4.0),
        )
        .equal(
            "the coefficients of each class sum to 1",
            mask.coset_sums(),
            [T::one(), T::one(), T::one(), T::one()],
            Rounding::new(12, 1.0),
        )
        .equal(
            "M(x) = Σ a_j M(2x − j)",
            [at(1, [0, 0])],
            [refined],
            Rounding::new(60, 5.0 * VALUE),
        )
        .equal(
            "Σ M(x − j) = 1",
            [partition],
            [T::one()],
            Rounding::new(72, 25.0 * VALUE),
        )
        .at_most(
            "M(x) ≥ 0",
            [T::zero()],
            [at(1, [0, 0])],
            Rounding::new(36, VALUE),
        )
        .equal(
            "the values at lattice points are 1/2, 1/12 and 0",
            at_lattice,
            values,
            Rounding::new(36, VALUE),
        )
}
