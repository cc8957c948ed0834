//! Properties of affine maps.

use cagd::affine::{AffineBasis, AffineMap, Point, laws};
use proptest::prelude::*;

use crate::generators::{for_all, point, polygon};
use crate::support::mutants::affine::maps as mutants;
use crate::support::{holds, rejects};

type Place = Point<f64, 2>;
type Map = AffineMap<f64, 2, 2>;

/// A number of moderate size, often a small whole one.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![(-3i32..=3).prop_map(f64::from), -3.0..3.0]
}

/// Maps of the plane, often with whole entries, so that flat ones occur.
fn maps() -> impl Strategy<Value = Map> {
    [number(), number(), number(), number(), number(), number()]
        .prop_map(|[a, b, c, d, x, y]| AffineMap::new([[a, b], [c, d]], [x, y]))
}

/// Three points of a control polygon: repeated, collinear, huge and tiny ones are among them.
fn triples() -> impl Strategy<Value = [Place; 3]> {
    polygon().prop_map(|points| {
        let last = points.len() - 1;
        [points[0], points[last / 2], points[last]]
    })
}

#[test]
fn map() {
    let inputs = (
        maps(),
        polygon(),
        prop::collection::vec(number(), crate::generators::MAX_DEGREE),
    );
    let law = |implementation: fn(&Map, &Place) -> Place| {
        for_all(&inputs, |(map, points, weights)| {
            laws::map(implementation, map, points, &weights[..points.len() - 1])
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

#[test]
fn map_examples() {
    let law = |implementation: laws::MapExamples<f64>| {
        for_all(triples(), |[x, p, q]| {
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
    for (name, homothety) in [
        (
            "always from the origin",
            mutants::homothety_from_the_origin as fn(&Place, f64) -> Map,
        ),
        (
            "the centre reflected",
            mutants::homothety_with_the_centre_reflected,
        ),
    ] {
        let wrong = laws::MapExamples {
            homothety,
            ..library()
        };
        rejects(name, law(wrong));
    }
    for (name, rotation) in [
        ("clockwise", mutants::clockwise as fn(f64) -> Map),
        ("a reflection", mutants::reflection),
        ("not divided by 1 + q²", mutants::not_normalised),
    ] {
        let wrong = laws::MapExamples {
            rotation,
            ..library()
        };
        rejects(name, law(wrong));
    }
    rejects(
        "a projection onto the parallel",
        law(laws::MapExamples {
            projection: mutants::offset_forgotten,
            ..library()
        }),
    );
    rejects(
        "a reflection for a projection",
        law(laws::MapExamples {
            projection: mutants::reflected,
            ..library()
        }),
    );
}

/// Bases whose points have whole coordinates, times a power of two, so that none is flat but for rounding.
fn bases() -> impl Strategy<Value = AffineBasis<f64, 2>> {
    let whole = || [-8i32..=8, -8i32..=8];
    let scale =
        prop_oneof![4 => Just(1.0), 1 => Just(2.0_f64.powi(330)), 1 => Just(2.0_f64.powi(-330))];
    ([whole(), whole(), whole()], scale).prop_filter_map("a basis", |(points, scale)| {
        let points = points.map(|p| Point::new(p.map(|x| f64::from(x) * scale)));
        AffineBasis::new(points).ok()
    })
}

#[test]
fn map_determined_by_basis() {
    type Build = fn(&AffineBasis<f64, 2>, &[Place]) -> Map;
    let inputs = (
        bases(),
        [point(1.0), point(1.0), point(1.0)],
        [number(), number()],
    );
    let law = |implementation: Build| {
        for_all(&inputs, |(basis, images, coordinates)| {
            laws::map_determined_by_basis(implementation, basis, images, coordinates)
        })
    };
    holds(law(|basis, images| {
        AffineMap::from_images(basis, images).expect("one image a point")
    }));
    rejects("the images in another order", law(mutants::images_shifted));
    rejects("the standard basis", law(mutants::basis_ignored));
}

#[test]
fn map_properties() {
    let inputs = (maps(), triples(), number());
    let law = |implementation: fn(&Map, &Place) -> Place| {
        for_all(&inputs, |(map, triple, lambda)| {
            laws::map_properties(implementation, map, triple.each_ref(), *lambda)
        })
    };
    holds(law(AffineMap::point));
    rejects("a term of second order", law(mutants::bent));
    rejects("nothing to the left of zero", law(mutants::cut_off));
}

#[test]
fn volume_factor() {
    let inputs = (maps(), triples());
    let law = |implementation: fn(&Map) -> f64| {
        for_all(&inputs, |(map, corners)| {
            laws::volume_factor(implementation, map, corners)
        })
    };
    holds(law(AffineMap::determinant));
    rejects("the product of the diagonal", law(mutants::diagonal));
    rejects("the trace", law(mutants::trace));
    rejects("without its sign", law(mutants::absolute));
}

#[test]
fn linear_interpolation_invariant() {
    type Interpolate = fn(&[f64], &[f64], f64) -> Vec<f64>;
    let inputs = (
        maps(),
        polygon().prop_filter("two points", |points| points.len() > 1),
        prop::collection::vec(prop_oneof![0.0..=1.0, -1.0..=2.0], 9),
    );
    let law = |implementation: Interpolate| {
        for_all(&inputs, |(map, points, lambdas)| {
            let lambdas = &lambdas[..points.len() - 1];
            laws::linear_interpolation_invariant(implementation, map, points, lambdas)
        })
    };
    holds(law(mutants::interpolation));
    rejects("the weights swapped", law(mutants::weights_swapped));
    rejects("P + λQ", law(mutants::sum_of_points));
    rejects(
        "eased in one coordinate",
        law(mutants::eased_in_one_coordinate),
    );
}

#[test]
fn shear() {
    let inputs = (number(), triples());
    let law = |implementation: fn(f64) -> Map| {
        for_all(&inputs, |(a, corners)| {
            laws::shear(implementation, *a, corners)
        })
    };
    holds(law(AffineMap::shear));
    rejects("along the other axis", law(mutants::upwards));
    rejects("stretched as well", law(mutants::stretched));
    rejects("turned as well", law(mutants::turned));
}

#[test]
fn shear_in_space() {
    let corner = || [number(), number(), number()].prop_map(Point::new);
    let inputs = (
        [number(), number(), number()],
        [corner(), corner(), corner(), corner()],
    );
    let law = |implementation: fn(f64, f64, f64) -> AffineMap<f64, 3, 3>| {
        for_all(&inputs, |(entries, corners)| {
            laws::shear_in_space(implementation, *entries, corners)
        })
    };
    holds(law(AffineMap::spatial_shear));
    rejects("b and c exchanged", law(mutants::entries_exchanged));
    rejects(
        "one coordinate after the other",
        law(mutants::one_after_the_other),
    );
}
