//! Affine maps over rationals.
//!
//! Where both sides are linear in the map, the six maps of the plane with a single entry 1 prove the identity for all maps;
//! where they are affine in a point, the origin and the unit points do.

use cagd::affine::{AffineBasis, AffineMap, Point, laws};
use cagd::scalar::BigRational;

use crate::inputs::{at, for_each, integer, ratio};
use crate::support::mutants::affine::maps as mutants;
use crate::support::{holds, rejects};

type Exact = BigRational;
type Place = Point<Exact, 2>;
type Map = AffineMap<Exact, 2, 2>;

fn plane_map(entries: [i64; 6]) -> Map {
    let [a, b, c, d, x, y] = entries.map(integer);
    AffineMap::new([[a, b], [c, d]], [x, y])
}

/// The six maps with a single entry 1, and some that turn, shear and flatten.
fn maps() -> impl Iterator<Item = Map> + Clone {
    let units = (0..6).map(|one| std::array::from_fn(|k| i64::from(k == one)));
    let others = [
        [1, 2, 0, 3, -1, 5],
        [0, -1, 1, 0, 2, 0],
        [1, 1, 1, 1, 0, 0],
        [2, -3, 5, 7, -4, 1],
    ];
    units.chain(others).map(plane_map)
}

/// The origin and the unit points, and one more.
fn unit_points<const D: usize>() -> impl Iterator<Item = Point<Exact, D>> + Clone {
    let unit = |one: usize| -> Vec<i64> { (0..D).map(|k| i64::from(k == one)).collect() };
    (0..=D).map(move |one| at(&unit(one)))
}

/// All triples of the origin and the unit points of the plane.
fn unit_triples() -> impl Iterator<Item = [Place; 3]> + Clone {
    unit_points::<2>().flat_map(|p| {
        unit_points::<2>().flat_map(move |q| {
            let p = p.clone();
            unit_points::<2>().map(move |r| [p.clone(), q.clone(), r])
        })
    })
}

/// Proved for all maps of the plane and all weights of four points; checked for the points named.
#[test]
fn map() {
    let points: Vec<Place> = [[0, 0], [3, 1], [-2, 5], [4, -7]].map(|p| at(&p)).into();
    let weights = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, -3, 5]].map(|w| w.map(integer));
    let law = |implementation: fn(&Map, &Place) -> Place| {
        let inputs = maps().flat_map(|map| weights.iter().map(move |w| (map.clone(), w)));
        for_each(inputs, |(map, weights)| {
            laws::map(implementation, map, &points, *weights)
        })
    };
    holds(law(AffineMap::point));
    rejects(
        "the translation is forgotten",
        law(mutants::translation_forgotten),
    );
    rejects("the matrix is transposed", law(mutants::transposed));
    rejects("a term of second order", law(mutants::bent));
    rejects("nothing to the left of zero", law(mutants::cut_off));
}

/// Checked for the triples of a few points.
#[test]
fn map_examples() {
    let places: Vec<Place> = [[0, 0], [3, 1], [-2, 5], [4, -7], [1, 1]]
        .map(|p| at(&p))
        .into();
    let law = |implementation: laws::MapExamples<Exact>| {
        let triples = places.iter().flat_map(|x| {
            let pairs = places
                .iter()
                .flat_map(|p| places.iter().map(move |q| (p, q)));
            pairs.map(move |(p, q)| [x, p, q])
        });
        for_each(triples, |[x, p, q]| {
            laws::map_examples(&implementation, x, p, q)
        })
    };
    let library = mutants::library;
    holds(law(library()));
    rejects(
        "one factor for both coordinates",
        law(laws::MapExamples {
            scaling: mutants::scaling_by_the_first_factor,
            ..library()
        }),
    );
    rejects(
        "always from the origin",
        law(laws::MapExamples {
            homothety: mutants::homothety_from_the_origin,
            ..library()
        }),
    );
    rejects(
        "a reflection",
        law(laws::MapExamples {
            rotation: mutants::reflection,
            ..library()
        }),
    );
    rejects(
        "a projection onto the parallel",
        law(laws::MapExamples {
            projection: mutants::offset_forgotten,
            ..library()
        }),
    );
}

/// Proved for all images and all coordinates, for the bases named, in the dimensions 1, 2 and 3: both sides are linear in
/// the images, so one image coordinate 1 and the others 0 are enough, and affine in the coordinates of the point.
#[test]
fn map_determined_by_basis() {
    fn determined_in_dimension<const D: usize>(
        bases: &[&[[i64; D]]],
        implementation: fn(&AffineBasis<Exact, D>, &[Point<Exact, 1>]) -> AffineMap<Exact, D, 1>,
    ) -> Result<(), String> {
        let inputs = bases.iter().flat_map(|points| {
            let basis = AffineBasis::new(points.iter().map(|p| at(p))).expect("a basis");
            (0..=D).flat_map(move |one| {
                let images: Vec<Point<Exact, 1>> =
                    (0..=D).map(|i| at(&[i64::from(i == one)])).collect();
                let basis = basis.clone();
                unit_points::<D>().map(move |weights| (basis.clone(), images.clone(), weights))
            })
        });
        for_each(inputs, |(basis, images, weights)| {
            laws::map_determined_by_basis(implementation, basis, images, weights.coordinates())
        })
    }

    let library = |basis: &AffineBasis<Exact, 2>, images: &[Point<Exact, 1>]| {
        AffineMap::from_images(basis, images).expect("one image a point")
    };
    let plane: &[&[[i64; 2]]] = &[
        &[[0, 0], [1, 0], [0, 1]],
        &[[3, 1], [-2, 5], [4, -7]],
        &[[1, 1], [2, 1], [1, 3]],
    ];
    holds(determined_in_dimension(plane, library));
    holds(determined_in_dimension::<1>(
        &[&[[0], [1]], &[[5], [-2]]],
        |basis, images| AffineMap::from_images(basis, images).expect("one image a point"),
    ));
    holds(determined_in_dimension::<3>(
        &[&[[1, 0, 2], [0, 3, 1], [-1, 1, 1], [2, 2, -5]]],
        |basis, images| AffineMap::from_images(basis, images).expect("one image a point"),
    ));
    rejects(
        "the images in another order",
        determined_in_dimension(plane, mutants::images_shifted),
    );
    rejects(
        "the standard basis",
        determined_in_dimension(plane, mutants::basis_ignored),
    );
}

/// Proved in the plane: both sides are linear in the map, affine in each point, and of degree 1 in λ.
#[test]
fn map_properties() {
    let law = |implementation: fn(&Map, &Place) -> Place| {
        let inputs = maps().flat_map(|map| {
            unit_triples().flat_map(move |triple| {
                let map = map.clone();
                [ratio(-1, 2), integer(3)].map(|lambda| (map.clone(), triple.clone(), lambda))
            })
        });
        for_each(inputs, |(map, triple, lambda)| {
            laws::map_properties(implementation, map, triple.each_ref(), lambda.clone())
        })
    };
    holds(law(AffineMap::point));
    rejects("a term of second order", law(mutants::bent));
    rejects("nothing to the left of zero", law(mutants::cut_off));
}

/// A map with the given rows, each a unit vector, and corners that are unit points: all of them, D²ᴰ in number.
fn unit_volumes<const D: usize>()
-> impl Iterator<Item = (AffineMap<Exact, D, D>, Vec<Point<Exact, D>>)> {
    let choices = D.pow(D as u32);
    let chosen = |choice: usize, k: usize| choice / D.pow(k as u32) % D;
    let unit = |one: usize| -> [Exact; D] { std::array::from_fn(|k| integer(i64::from(k == one))) };
    (0..choices).flat_map(move |rows| {
        (0..choices).map(move |corners| {
            let map = AffineMap::new(
                std::array::from_fn(|k| unit(chosen(rows, k))),
                std::array::from_fn(|k| integer(2 - k as i64)),
            );
            let corners = (0..D).map(|k| Point::new(unit(chosen(corners, k))));
            let corners = std::iter::once(Point::origin()).chain(corners).collect();
            (map, corners)
        })
    })
}

/// Proved in the dimensions 1, 2 and 3 for corners of which the first is the origin: a determinant is linear in each row, so
/// both sides are linear in each row of the map and in each of the other corners.
#[test]
fn volume_factor() {
    fn law<const D: usize>(
        implementation: fn(&AffineMap<Exact, D, D>) -> Exact,
    ) -> Result<(), String> {
        for_each(unit_volumes::<D>(), |(map, corners)| {
            laws::volume_factor(implementation, map, corners)
        })
    }
    holds(law::<1>(AffineMap::determinant));
    holds(law::<2>(AffineMap::determinant));
    holds(law::<3>(AffineMap::determinant));
    rejects("the product of the diagonal", law::<2>(mutants::diagonal));
    rejects("the trace", law::<2>(mutants::trace));
    rejects("without its sign", law::<2>(mutants::absolute));
    rejects("without its sign, in space", law::<3>(mutants::absolute));
}

type Interpolate = fn(&[Exact], &[Exact], Exact) -> Vec<Exact>;

/// Proved on the line for up to six points: both sides are linear in the map and in the points, and of degree 1 in each λ,
/// so two values of each λ are enough. In the plane the coordinates of an image are sums of such images.
#[test]
fn linear_interpolation_invariant() {
    let law = |implementation: Interpolate| {
        let maps = [[1, 0], [0, 1]].map(|[a, b]| AffineMap::new([[integer(a)]], [integer(b)]));
        let inputs = maps.into_iter().flat_map(|map| {
            (2..=6).flat_map(move |count: usize| {
                let map = map.clone();
                (0..=count).flat_map(move |one| {
                    let points: Vec<Point<Exact, 1>> =
                        (0..count).map(|i| at(&[i64::from(i == one)])).collect();
                    let map = map.clone();
                    (0..1_usize << (count - 1)).map(move |choice| {
                        let lambda = |level: usize| integer(2 + (choice >> level & 1) as i64);
                        let lambdas: Vec<Exact> = (0..count - 1).map(lambda).collect();
                        (map.clone(), points.clone(), lambdas)
                    })
                })
            })
        });
        for_each(inputs, |(map, points, lambdas)| {
            laws::linear_interpolation_invariant(implementation, map, points, lambdas)
        })
    };
    holds(law(mutants::interpolation));
    rejects("the weights swapped", law(mutants::weights_swapped));
    rejects("P + λQ", law(mutants::sum_of_points));
}

/// Proved: the areas are affine in each corner and of degree at most 2 in a.
#[test]
fn shear() {
    let law = |implementation: fn(Exact) -> Map| {
        let inputs =
            unit_triples().flat_map(|corners| [-1, 0, 2].map(|a| (integer(a), corners.clone())));
        for_each(inputs, |(a, corners)| {
            laws::shear(implementation, a.clone(), corners)
        })
    };
    holds(law(AffineMap::shear));
    rejects("along the other axis", law(mutants::upwards));
    rejects("stretched as well", law(mutants::stretched));
    rejects("turned as well", law(mutants::turned));
}

/// Proved for corners of which the first is the origin: the volumes are linear in each other corner and of degree at
/// most 3 in each of a, b and c.
#[test]
fn shear_in_space() {
    let law = |implementation: fn(Exact, Exact, Exact) -> AffineMap<Exact, 3, 3>| {
        let units: Vec<Point<Exact, 3>> = unit_points::<3>().skip(1).collect();
        let values = [-1, 0, 2, 3].map(integer);
        let inputs = (0..27).flat_map(|choice| {
            let corner = |k: u32| units[choice / 3_usize.pow(k) % 3].clone();
            let corners = [Point::origin(), corner(0), corner(1), corner(2)];
            let values = &values;
            (0..64).map(move |choice| {
                let entry = |k: u32| values[choice / 4_usize.pow(k) % 4].clone();
                ([entry(0), entry(1), entry(2)], corners.clone())
            })
        });
        for_each(inputs, |(entries, corners)| {
            laws::shear_in_space(implementation, entries.clone(), corners)
        })
    };
    holds(law(AffineMap::spatial_shear));
    rejects("b and c exchanged", law(mutants::entries_exchanged));
    rejects(
        "one coordinate after the other",
        law(mutants::one_after_the_other),
    );
}
