//! Laws of affine maps.

use super::magnitudes::{largest, row_sum};
use crate::affine::{Affine, AffineBasis, AffineMap, Line, Point, Vector, signed_area};
use crate::law::{Rounding, Sides};
use crate::scalar::{OrderedScalar, Scalar};

/// A bound for the coordinates that a map computes for points whose coordinates are at most `size`: |A|·size + |a|.
fn image_size<T: Scalar, const D: usize, const E: usize>(
    map: &AffineMap<T, D, E>,
    size: f64,
) -> f64 {
    row_sum(map.linear()) * size + largest(map.translation().iter())
}

/// `affine-map`: α(x) = A·x + a, and α(Σ λᵢ·xᵢ) = Σ λᵢ·α(xᵢ) if Σ λᵢ = 1.
///
/// `implementation(α, x)` must give the image of a point. The weights are those of all points but the first one, whose
/// weight brings the sum to 1.
///
/// # Rounding
///
/// A combination of n points passes n + 1 roundings a term, an image D + 1, on both sides. The rounded weights miss the sum 1
/// by n roundings more. With m = |A|·max|x| + |a|, the terms sum to at most m·Σ|λᵢ|.
pub fn map<T: Scalar, const D: usize, const E: usize>(
    implementation: impl Fn(&AffineMap<T, D, E>, &Point<T, D>) -> Point<T, E>,
    map: &AffineMap<T, D, E>,
    points: &[Point<T, D>],
    weights: &[T],
) -> Sides<T> {
    let first = weights.iter().fold(T::one(), |rest, w| rest - w.clone());
    let weights: Vec<T> = std::iter::once(first)
        .chain(weights.iter().cloned())
        .collect();
    let total: f64 = weights.iter().map(Scalar::magnitude).sum();
    let size = largest(points.iter().flat_map(Point::coordinates));
    let bound = image_size(map, size) * total.max(1.0);
    let images: Vec<_> = points.iter().map(|x| implementation(map, x)).collect();
    let by_hand = |x: &Point<T, D>, row: usize| {
        (0..D).fold(map.translation()[row].clone(), |sum, column| {
            sum + map.linear()[(row, column)].clone() * x[column].clone()
        })
    };
    let combination = combined(&weights, points);
    Sides::new(format!("{map:?}, weights {weights:?}, points {points:?}"))
        .equal(
            "the image is the linear part of the point plus the translation",
            images.iter().flat_map(|image| image.coordinates().to_vec()),
            points
                .iter()
                .flat_map(|x| (0..E).map(|row| by_hand(x, row)).collect::<Vec<_>>()),
            Rounding::new(2 * (D + 1), bound),
        )
        .equal(
            "the image of the combination is the combination of the images",
            implementation(map, &combination).coordinates().to_vec(),
            combined(&weights, &images).coordinates().to_vec(),
            Rounding::new(3 * points.len() + 2 * (D + 2), bound),
        )
}

/// Σ wᵢ·xᵢ, coordinate by coordinate.
fn combined<T: Scalar, const D: usize>(weights: &[T], points: &[Point<T, D>]) -> Point<T, D> {
    Point::from_fn(|k| {
        std::iter::zip(weights, points).fold(T::zero(), |sum, (weight, point)| {
            sum + weight.clone() * point[k].clone()
        })
    })
}

/// The constructors of the maps with names, which [`map_examples`] judges.
pub struct MapExamples<T: Scalar> {
    /// Scales the coordinates.
    pub scaling: fn([T; 2]) -> AffineMap<T, 2, 2>,
    /// Scales from a centre.
    pub homothety: fn(&Point<T, 2>, T) -> AffineMap<T, 2, 2>,
    /// Rotates by 2·arctan of a number.
    pub rotation: fn(T) -> AffineMap<T, 2, 2>,
    /// Projects onto a line along a direction that leaves it.
    pub projection: fn(&Line<T>, &Vector<T, 2>) -> AffineMap<T, 2, 2>,
}

/// `affine-map-examples`: what makes scalings, homotheties, rotations and parallel projections what they are.
///
/// A scaling multiplies the coordinates, a homothety multiplies vectors by k and fixes its centre.
/// A rotation keeps lengths and the signed area. A projection leads into the line, along its direction, and moves no
/// point of the line. Each is tried on the point x, with p and q as parameters: p is the centre and the pair of factors,
/// its first coordinate gives factor and angle, the line goes through p and q. If p = q there is no line.
///
/// # Rounding
///
/// With s the largest coordinate, 1 included. Images pass at most 8 roundings of terms of size s² (homothety) or
/// of size s (rotation, whose matrix is rounded 4 times); squares of lengths add 3. The projection along the normal vector m
/// divides by |m|², so each of its entries is at most 2 and passes 8 roundings; heights are products with m, of size |m|·s.
pub fn map_examples<T: OrderedScalar>(
    implementation: &MapExamples<T>,
    x: &Point<T, 2>,
    p: &Point<T, 2>,
    q: &Point<T, 2>,
) -> Sides<T> {
    let size = largest([x, p, q].into_iter().flat_map(Point::coordinates)).max(1.0);
    let factor = p[0].clone();
    let list = |point: Point<T, 2>| point.coordinates().to_vec();
    let scaled = (implementation.scaling)([p[0].clone(), p[1].clone()]).point(x);
    let homothety = (implementation.homothety)(q, factor.clone());
    let rotation = (implementation.rotation)(factor.clone());
    let square = |point: &Point<T, 2>| {
        point[0].clone() * point[0].clone() + point[1].clone() * point[1].clone()
    };
    let origin = Point::origin();
    let [turned, turned_p] = [x, p].map(|point| rotation.point(point));
    let rounded = |roundings: usize, power: i32| Rounding::new(roundings, 8.0 * size.powi(power));
    let mut sides = Sides::new(format!("x = {x}, p = {p}, q = {q}"))
        .equal(
            "a scaling multiplies the coordinates",
            list(scaled),
            (0..2).map(|k| x[k].clone() * p[k].clone()),
            rounded(4, 2),
        )
        .equal(
            "a homothety multiplies vectors by its factor",
            homothety
                .vector(&x.difference(q))
                .iter()
                .cloned()
                .collect::<Vec<_>>(),
            x.difference(q)
                .iter()
                .map(|v| v.clone() * factor.clone())
                .collect::<Vec<_>>(),
            rounded(6, 2),
        )
        .equal(
            "a homothety fixes its centre",
            list(homothety.point(q)),
            list(q.clone()),
            rounded(8, 2),
        )
        .equal(
            "a rotation keeps the distance from the origin",
            [square(&turned)],
            [square(x)],
            rounded(18, 2),
        )
        .equal(
            "a rotation keeps the signed area",
            [signed_area(&origin, &turned, &turned_p)],
            [signed_area(&origin, x, p)],
            rounded(18, 2),
        )
        .equal(
            "a rotation by 2 arctan q turns (1, −q) to (1, q)",
            list(rotation.point(&Point::new([T::one(), -factor.clone()]))),
            [T::one(), factor.clone()],
            rounded(12, 1),
        );
    if let Ok(line) = Line::through(p, q) {
        let normal = line.normal().clone();
        let projection = (implementation.projection)(&line, &normal);
        let image = projection.point(x);
        let way = image.difference(x);
        let slope = largest(normal.iter());
        sides = sides
            .equal(
                "the image lies on the line",
                [line.value(&image)],
                [T::zero()],
                Rounding::new(24, 8.0 * slope * size),
            )
            .equal(
                "the way to it goes along the direction",
                [way[0].clone() * normal[1].clone()],
                [way[1].clone() * normal[0].clone()],
                Rounding::new(24, 8.0 * slope * size),
            )
            .equal(
                "points of the line stay",
                list(projection.point(p)),
                list(p.clone()),
                rounded(24, 1),
            );
    }
    sides
}

/// `affine-map-determined-by-basis`: f(Aᵢ) = A′ᵢ, and f(Σ αᵢ·Aᵢ) = Σ αᵢ·A′ᵢ.
///
/// `implementation(basis, images)` must give the map. The coordinates are α₁ … α_D; α₀ brings their sum to 1.
///
/// # Rounding
///
/// Elimination with pivoting solves a system whose matrix M of edges is off by γ₃D·2ᴰ⁻¹ (`higham2002`, §9.3); so each entry of
/// the map is off by κ times that, κ = |M|·|M⁻¹|. With q the largest coordinate of an image and p of a basis point, an
/// entry of the map is at most 2·D·q·|M⁻¹|, which a point multiplies by at most p·Σ|αᵢ|.
pub fn map_determined_by_basis<T: Scalar, const D: usize, const E: usize>(
    implementation: impl Fn(&AffineBasis<T, D>, &[Point<T, E>]) -> AffineMap<T, D, E>,
    basis: &AffineBasis<T, D>,
    images: &[Point<T, E>],
    coordinates: &[T],
) -> Sides<T> {
    let map = implementation(basis, images);
    let first = coordinates
        .iter()
        .fold(T::one(), |rest, c| rest - c.clone());
    let weights: Vec<T> = std::iter::once(first)
        .chain(coordinates.iter().cloned())
        .collect();
    let total: f64 = weights.iter().map(Scalar::magnitude).sum();
    let rounding = if T::EXACT {
        Rounding::none()
    } else {
        let spread = spread(basis);
        let q = largest(images.iter().flat_map(Point::coordinates));
        let condition = (2.0 * D as f64 * spread).max(1.0).ceil() as usize;
        let solving = 3 * D * D * (1 << (D - 1)) * condition;
        let bound = (2.0 * D as f64 * q * spread + q) * total;
        Rounding::new(solving + 8 * (D + 2), bound)
    };
    let found = basis
        .points()
        .iter()
        .flat_map(|p| map.point(p).coordinates().to_vec());
    Sides::new(format!(
        "{basis:?}, images {images:?}, coordinates {weights:?}"
    ))
    .equal(
        "the points of the basis go to their images",
        found,
        images.iter().flat_map(|image| image.coordinates().to_vec()),
        rounding,
    )
    .equal(
        "a point goes to the point with the same coordinates",
        map.point(&combined(&weights, basis.points()))
            .coordinates()
            .to_vec(),
        combined(&weights, images).coordinates().to_vec(),
        rounding,
    )
}

/// |M⁻¹|·p: the largest sum of a row of M⁻¹, where the columns of M are the edges from the first point of the basis, times the
/// largest coordinate p of a point.
fn spread<T: Scalar, const D: usize>(basis: &AffineBasis<T, D>) -> f64 {
    let coordinates = basis.points().iter().flat_map(Point::coordinates);
    let size = coordinates
        .max_by(|x, y| x.magnitude().total_cmp(&y.magnitude()))
        .cloned()
        .unwrap_or_else(T::one);
    let columns: Vec<Vec<T>> = (0..D)
        .map(|k| {
            let along = |row| if row == k { size.clone() } else { T::zero() };
            let step = Vector::from_fn(|row, _| along(row));
            basis.coordinates(&basis.points()[0].translated(&step))
        })
        .collect();
    let row = |i: usize| {
        columns
            .iter()
            .map(|column| column[i].magnitude())
            .sum::<f64>()
    };
    (1..=D).map(row).fold(0.0, f64::max)
}

/// `affine-map-properties`: ratios and parallels are kept,
///
/// ```text
/// Φ((1 − λ)·P + λ·Q) − Φ(P) = λ·(Φ(Q) − Φ(P)),   Φ(R + (Q − P)) − Φ(R) = Φ(Q) − Φ(P).
/// ```
///
/// `implementation(Φ, x)` must give the image of a point.
///
/// # Rounding
///
/// Between points and images lie at most 3 roundings before and D + 3 after the map, on both sides; the terms are at most
/// the images of points of three times the size, times 1 + 2|λ|.
pub fn map_properties<T: Scalar, const D: usize, const E: usize>(
    implementation: impl Fn(&AffineMap<T, D, E>, &Point<T, D>) -> Point<T, E>,
    map: &AffineMap<T, D, E>,
    [p, q, r]: [&Point<T, D>; 3],
    lambda: T,
) -> Sides<T> {
    let size = largest([p, q, r].into_iter().flat_map(Point::coordinates));
    let bound = 4.0 * image_size(map, 3.0 * size) * (1.0 + 2.0 * lambda.magnitude());
    let rounding = Rounding::new(2 * (D + 8), bound);
    let image = |point: &Point<T, D>| implementation(map, point);
    let along = image(q).difference(&image(p));
    let list = |vector: Vector<T, E>| vector.iter().cloned().collect::<Vec<_>>();
    let part = image(&p.lerp(q, lambda.clone())).difference(&image(p));
    let moved = image(&r.translated(&q.difference(p))).difference(&image(r));
    Sides::new(format!("{map:?}, P = {p}, Q = {q}, R = {r}, λ = {lambda}"))
        .equal(
            "the image of the segment is divided in the same ratio",
            list(part),
            along
                .iter()
                .map(|x| x.clone() * lambda.clone())
                .collect::<Vec<_>>(),
            rounding,
        )
        .equal(
            "parallel segments have parallel images",
            list(moved),
            list(along),
            rounding,
        )
}

/// `affine-map-properties`, its last part: a map of dimension D multiplies volumes by its determinant,
///
/// ```text
/// det(Φ(Pᵢ) − Φ(P₀))ᵢ = det(A)·det(Pᵢ − P₀)ᵢ.
/// ```
///
/// `implementation(Φ)` must give det(A). There must be D + 1 corners.
///
/// # Rounding
///
/// A difference of images passes D + 3 roundings, a product of D of them D·(D + 3) + D, and D! such products are added.
/// The terms of the left side are at most D!·(2m)ᴰ, m the largest coordinate of an image; those of the right side are at most
/// D!·|A|ᴰ·D!·(2s)ᴰ, with s the largest coordinate of a corner.
pub fn volume_factor<T: Scalar, const D: usize>(
    implementation: impl Fn(&AffineMap<T, D, D>) -> T,
    map: &AffineMap<T, D, D>,
    corners: &[Point<T, D>],
) -> Sides<T> {
    let volume = |corners: &[Point<T, D>]| {
        let edges: Vec<_> = corners[1..]
            .iter()
            .map(|p| p.difference(&corners[0]))
            .collect();
        leibniz(&edges)
    };
    let images: Vec<_> = corners.iter().map(|corner| map.point(corner)).collect();
    let factorial: usize = (1..=D).product();
    let size = largest(corners.iter().flat_map(Point::coordinates));
    let power = |x: f64| x.powi(D as i32);
    let left = power(2.0 * image_size(map, size));
    let right = factorial as f64 * power(2.0 * row_sum(map.linear()) * size);
    Sides::new(format!("{map:?}, corners {corners:?}")).equal(
        "the volume is multiplied by the determinant",
        [volume(&images)],
        [implementation(map) * volume(corners)],
        Rounding::new(
            2 * (D * (D + 4) + factorial),
            factorial as f64 * (left + right),
        ),
    )
}

/// The determinant as the sum over all permutations, each built by exchanges: another way than the library's.
fn leibniz<T: Scalar, const D: usize>(rows: &[Vector<T, D>]) -> T {
    fn sum<T: Scalar, const D: usize>(
        rows: &[Vector<T, D>],
        order: &mut [usize],
        from: usize,
    ) -> T {
        if from == D {
            return (0..D).fold(T::one(), |product, k| product * rows[k][order[k]].clone());
        }
        let mut total = T::zero();
        for other in from..D {
            order.swap(from, other);
            let part = sum(rows, order, from + 1);
            order.swap(from, other);
            if other == from {
                total += part;
            } else {
                total -= part;
            }
        }
        total
    }
    let mut order: Vec<usize> = (0..D).collect();
    sum(rows, &mut order, 0)
}

/// `affine-linear-interpolation-invariant`: Φ((1 − λ)·P + λ·Q) = (1 − λ)·Φ(P) + λ·Φ(Q), and so every algorithm of such steps
/// commutes with Φ.
///
/// `implementation(P, Q, λ)` must interpolate. The algorithm tried here replaces neighbours by their interpolation, level by
/// level, each level with a λ of its own, until one point is left; there must be one λ a level.
///
/// # Rounding
///
/// A step passes 3 roundings and its terms grow by |λ| + |1 − λ|; the map passes D + 1.
pub fn linear_interpolation_invariant<T: Scalar, const D: usize, const E: usize>(
    implementation: impl Fn(&[T], &[T], T) -> Vec<T>,
    map: &AffineMap<T, D, E>,
    points: &[Point<T, D>],
    lambdas: &[T],
) -> Sides<T> {
    let run = |points: Vec<Vec<T>>| {
        lambdas.iter().fold(points, |level, lambda| {
            let pairs = level.windows(2);
            pairs
                .map(|pair| implementation(&pair[0], &pair[1], lambda.clone()))
                .collect()
        })
    };
    let lists = |points: &[Point<T, E>]| -> Vec<Vec<T>> {
        points.iter().map(|p| p.coordinates().to_vec()).collect()
    };
    let images: Vec<_> = points.iter().map(|point| map.point(point)).collect();
    let first: Vec<Vec<T>> = points.iter().map(|p| p.coordinates().to_vec()).collect();
    let image_of_result: Vec<T> = run(first.clone())
        .into_iter()
        .flat_map(|result| {
            map.point(&Point::from_fn(|k| result[k].clone()))
                .coordinates()
                .to_vec()
        })
        .collect();
    let growth: f64 = lambdas
        .iter()
        .map(|lambda| lambda.magnitude() + (T::one() - lambda.clone()).magnitude())
        .product();
    let size = largest(points.iter().flat_map(Point::coordinates));
    let bound = image_size(map, size) * growth;
    let ends = |lambda: T| {
        let pairs = first.windows(2);
        pairs
            .flat_map(|pair| implementation(&pair[0], &pair[1], lambda.clone()))
            .collect::<Vec<_>>()
    };
    Sides::new(format!("{map:?}, λ = {lambdas:?}, points {points:?}"))
        .equal(
            "the image of the result is the result of the images",
            image_of_result,
            run(lists(&images)).into_iter().flatten(),
            Rounding::new(6 * lambdas.len() + 2 * (D + 1), bound),
        )
        .equal(
            "λ = 0 gives the first point",
            ends(T::zero()),
            first[..first.len() - 1].iter().flatten().cloned(),
            Rounding::none(),
        )
        .equal(
            "λ = 1 gives the second point",
            ends(T::one()),
            first[1..].iter().flatten().cloned(),
            Rounding::none(),
        )
}

/// `affine-shear`: (x, y) ↦ (x + a·y, y) has determinant 1, keeps each horizontal line and all areas.
///
/// `implementation(a)` must give the map.
///
/// # Rounding
///
/// A first coordinate passes 2 roundings. The areas pass 4 on each side and 3 more in the images; their terms are at most 4·m²,
/// with m = s·(1 + |a|), s the largest coordinate.
pub fn shear<T: Scalar>(
    implementation: impl Fn(T) -> AffineMap<T, 2, 2>,
    a: T,
    corners: &[Point<T, 2>; 3],
) -> Sides<T> {
    let map = implementation(a.clone());
    let images = corners.each_ref().map(|corner| map.point(corner));
    let size = largest(corners.iter().flat_map(Point::coordinates)) * (1.0 + a.magnitude());
    let area = |[p, q, r]: &[Point<T, 2>; 3]| signed_area(p, q, r);
    Sides::new(format!("a = {a}, corners {corners:?}"))
        .equal(
            "the determinant is 1",
            [map.determinant()],
            [T::one()],
            Rounding::none(),
        )
        .equal(
            "heights stay",
            images.iter().map(|image| image[1].clone()),
            corners.iter().map(|corner| corner[1].clone()),
            Rounding::none(),
        )
        .equal(
            "a point moves by a times its height",
            std::iter::zip(&images, corners).map(|(q, p)| q[0].clone() - p[0].clone()),
            corners.iter().map(|p| a.clone() * p[1].clone()),
            Rounding::new(4, 2.0 * size),
        )
        .equal(
            "areas stay",
            [area(&images)],
            [area(corners)],
            Rounding::new(16, 8.0 * size * size),
        )
}

/// `affine-shear`, in space: the matrix with the rows (1, a, b), (0, 1, c), (0, 0, 1) has determinant 1 and keeps volumes.
///
/// `implementation(a, b, c)` must give the map.
///
/// # Rounding
///
/// The image of a point passes 4 roundings. For the volume see [`volume_factor`].
pub fn shear_in_space<T: Scalar>(
    implementation: impl Fn(T, T, T) -> AffineMap<T, 3, 3>,
    [a, b, c]: [T; 3],
    corners: &[Point<T, 3>; 4],
) -> Sides<T> {
    let map = implementation(a.clone(), b.clone(), c.clone());
    let expected = |p: &Point<T, 3>| {
        let (x, y, z) = (p[0].clone(), p[1].clone(), p[2].clone());
        [
            x + a.clone() * y.clone() + b.clone() * z.clone(),
            y + c.clone() * z.clone(),
            z,
        ]
    };
    let size = largest(corners.iter().flat_map(Point::coordinates));
    let bound = 2.0 * image_size(&map, size);
    Sides::new(format!("a = {a}, b = {b}, c = {c}, corners {corners:?}"))
        .equal(
            "each coordinate moves by multiples of the later ones",
            corners
                .iter()
                .flat_map(|p| map.point(p).coordinates().to_vec()),
            corners.iter().flat_map(expected),
            Rounding::new(8, bound),
        )
        .and(volume_factor(|_| T::one(), &map, corners))
}
