//! Random masks and data, exact.

use cagd::scalar::{BigRational, Scalar};
use cagd::subdivision::{LaurentPolynomial, Mask};
use proptest::prelude::*;

/// A fraction with a small numerator and denominator, often whole, often 0.
pub fn fraction() -> impl Strategy<Value = BigRational> {
    (-4_i64..=4, prop_oneof![2 => Just(1_i64), 1 => 2_i64..=5])
        .prop_map(|(p, q)| BigRational::from_ratio(p, q))
}

/// Data with finitely many nonzero members: none, one, or some, also at negative indices.
pub fn data() -> impl Strategy<Value = LaurentPolynomial<BigRational>> {
    (-3_i64..=3, prop::collection::vec(fraction(), 0..6))
        .prop_map(|(first, values)| LaurentPolynomial::new(first, values))
}

/// Masks of all kinds, with up to four factors 1 + z.
pub fn mask() -> impl Strategy<Value = Mask<BigRational>> {
    (
        -4_i64..=1,
        prop::collection::vec(fraction(), 1..5),
        0_usize..=4,
    )
        .prop_filter_map(
            "a mask has a coefficient that is not 0",
            |(first, factor, rules)| {
                let factor = LaurentPolynomial::new(first, factor);
                Mask::from_symbol(&factor * &LaurentPolynomial::one_plus_z_to(rules)).ok()
            },
        )
}

/// Masks of schemes for points: a(1) = 2 and a(−1) = 0.
pub fn affine_mask() -> impl Strategy<Value = Mask<BigRational>> {
    mask().prop_filter_map("the coefficients do not sum to 0", |mask| {
        let symbol = mask.symbol() * &LaurentPolynomial::one_plus_z_to(1);
        let sum = symbol.at(BigRational::from_ratio(1, 1))?;
        let zero = BigRational::from_ratio(0, 1);
        let two = BigRational::from_ratio(2, 1);
        (sum != zero).then(|| Mask::from_symbol(symbol.scaled(&(two / sum))).ok())?
    })
}

#[test]
fn every_class_of_mask_occurs() {
    use std::cell::RefCell;
    use std::collections::BTreeMap;

    use cagd::law::{Rounding, Sides};

    let counts = RefCell::new(BTreeMap::new());
    let outcome =
        crate::generators::for_all((mask(), affine_mask(), data()), |(mask, affine, data)| {
            let classes = [
                ("no sum rule".to_string(), mask.sum_rules() == 0),
                ("a sum rule".to_string(), mask.sum_rules() == 1),
                ("four sum rules".to_string(), mask.sum_rules() >= 4),
                (
                    "a single coefficient".to_string(),
                    mask.symbol().coefficients().len() == 1,
                ),
                ("not affine".to_string(), !mask.is_affine()),
                ("affine".to_string(), affine.is_affine()),
                (
                    "not contractive".to_string(),
                    affine.smoothness(2).is_none(),
                ),
                ("continuous".to_string(), affine.smoothness(2).is_some()),
                ("no data".to_string(), data.is_zero()),
                (
                    "data at negative indices".to_string(),
                    data.powers().start < 0,
                ),
            ];
            for (class, occurs) in classes {
                *counts.borrow_mut().entry(class).or_insert(0) += i32::from(occurs);
            }
            Sides::new("statistics").equal("always", [0.0], [0.0], Rounding::none())
        });
    assert_eq!(outcome, Ok(()));
    for (class, count) in counts.into_inner() {
        assert!(count >= 2, "{count} masks of the class «{class}»");
    }
}

/// Indices near the ends of their type are refused or computed with, and never wrap around.
#[test]
fn indices_at_the_ends_of_their_range() {
    use cagd::subdivision::MaskError;

    let refused = |outcome: Result<(), MaskError>| matches!(outcome, Err(MaskError::Index { .. }));
    let chaikin = Mask::<f64>::lane_riesenfeld(2);
    let weights = chaikin.symbol().coefficients().to_vec();
    for first in [
        i64::MIN,
        -(1 << 31) - 1,
        (1 << 31) - 3,
        i64::MAX - 3,
        i64::MAX,
    ] {
        assert!(refused(Mask::new(first, weights.clone()).map(|_| ())));
        let symbol = LaurentPolynomial::new(first, weights.clone());
        assert!(refused(Mask::from_symbol(symbol).map(|_| ())));
    }
    for first in [-(1 << 31), (1 << 31) - 4] {
        let mask = Mask::new(first, weights.clone()).expect("the last indices that are allowed");
        for i in [i64::MIN, i64::MIN + 1, -1, 0, i64::MAX - 1, i64::MAX] {
            let rule = mask.rule(i);
            assert_eq!(rule.len(), 2);
            for (j, weight) in rule {
                let index = i128::from(i) - 2 * i128::from(j);
                let place = usize::try_from(index - i128::from(first)).expect("in the mask");
                assert_eq!(weight, weights[place]);
            }
        }
        let huge = 1 << 61;
        for start in [i64::MIN, -huge - 1, huge - 1, i64::MAX - 1, i64::MAX] {
            assert!(refused(mask.refine_window(start, &[0.0, 4.0]).map(|_| ())));
            assert!(refused(mask.apply_window(start, &[0.0, 4.0]).map(|_| ())));
        }
        for start in [-huge, huge - 2] {
            let (new, points) = mask.refine_window(start, &[0.0, 4.0]).expect("two points");
            assert_eq!(points, [1.0, 3.0]);
            assert_eq!(new, 2 * start + first + 2);
        }
    }
    assert_eq!(
        chaikin.computable(i64::MIN..i64::MAX),
        i64::MIN + 2..i64::MAX
    );
}

#[test]
fn powers_beyond_the_range_count_as_its_ends() {
    for far in [i64::MIN, i64::MAX] {
        let end = far.clamp(-(1 << 60), 1 << 60);
        let p = LaurentPolynomial::new(far, [0.0, 1.0, 2.0]);
        assert_eq!(p.powers().end - p.powers().start, 2);
        assert_eq!(p.powers().start, end);
        assert_eq!(p.coefficient(p.powers().start), 1.0);
        assert_eq!(p.coefficient(far), 0.0);
        assert_eq!(p.coefficient(-end), 0.0);
        assert_eq!((&p * &p).powers().start, end);
        assert_eq!(p.shifted(far).powers().start, end);
        assert_eq!(p.stretched(2).powers().start, end);
    }
}
