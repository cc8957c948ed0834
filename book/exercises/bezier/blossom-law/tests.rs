use cagd::bezier::{BezierCurve, elementary_symmetric};
use cagd::check::claim;
use cagd::law::Violation;
use cagd::scalar::{BigRational, Scalar};

type Number = BigRational;
type Function<'a> = &'a dyn Fn(&[Number]) -> Number;
type Polynomial<'a> = &'a dyn Fn(&Number) -> Number;

fn number(n: i64) -> Number {
    <Number as Scalar>::from_integer(n)
}

/// All lists of `count` numbers out of 0, 1 and 3.
fn lists(count: usize) -> Vec<Vec<Number>> {
    let mut lists = vec![Vec::new()];
    for _ in 0..count {
        lists = lists
            .into_iter()
            .flat_map(|list: Vec<Number>| {
                [0, 1, 3].map(|n| list.iter().cloned().chain([number(n)]).collect())
            })
            .collect();
    }
    lists
}

/// What the law says of a function of `count` numbers: the first violation, or none.
fn judge(count: usize, function: Function, polynomial: Polynomial) -> Result<(), Violation> {
    for x in lists(count) {
        for (v, lambda) in [(2, 2), (-1, 3)] {
            answer::law(function, polynomial, &x, &number(v), &number(lambda)).judge()?;
        }
    }
    Ok(())
}

#[track_caller]
fn holds(what: &str, count: usize, function: Function, polynomial: Polynomial) {
    let verdict = judge(count, function, polynomial);
    let found = verdict
        .as_ref()
        .err()
        .map(ToString::to_string)
        .unwrap_or_default();
    claim("the law on a blossom")
        .input(what)
        .holds(verdict.is_ok(), "the law holds", found);
}

#[track_caller]
fn fails(what: &str, count: usize, function: Function, polynomial: Polynomial) {
    claim("the law on a function that is no blossom")
        .input(what)
        .holds(
            judge(count, function, polynomial).is_err(),
            "the law is violated for some input",
            "it holds for every input",
        );
}

/// t to the power k.
fn power(t: &Number, k: usize) -> Number {
    (0..k).fold(number(1), |product, _| product * t.clone())
}

/// Which of some functions, all but the first no blossom of t², the law accepts.
fn probes() -> Vec<String> {
    let square: Polynomial = &|t| power(t, 2);
    let cube: Polynomial = &|t| power(t, 3);
    let fourth: Polynomial = &|t| power(t, 4);
    let accepts =
        |count, function: Function, polynomial| judge(count, function, polynomial).is_ok();
    cagd::probes![
        accepts(2, &product, square),
        accepts(2, &skewed, square),
        accepts(3, &skewed_in_the_last, cube),
        accepts(3, &skewed_in_the_middle, cube),
        accepts(4, &skewed_around, fourth),
        accepts(4, &skewed_in_pairs, fourth),
        accepts(2, &square_of_the_mean, square),
        accepts(2, &sum, square),
        accepts(1, &|x| x[0].clone() + number(1), &|t| t.clone() + number(1)),
    ]
}

fn product(x: &[Number]) -> Number {
    x.iter().cloned().fold(number(1), |product, x| product * x)
}

fn sum(x: &[Number]) -> Number {
    x.iter().cloned().fold(number(0), |sum, x| sum + x)
}

/// x₁·x₂ + x₁ − x₂
fn skewed(x: &[Number]) -> Number {
    product(x) + x[0].clone() - x[1].clone()
}

/// x₁·x₂·x₃ + x₁ + x₂ − 2x₃, symmetric in the first two arguments
fn skewed_in_the_last(x: &[Number]) -> Number {
    product(x) + sum(x) - number(3) * x[2].clone()
}

/// x₁·x₂·x₃ + x₁ − 2x₂ + x₃, the same from both ends
fn skewed_in_the_middle(x: &[Number]) -> Number {
    product(x) + sum(x) - number(3) * x[1].clone()
}

/// x₁x₂x₃x₄ + (x₁x₂ + x₂x₃ + x₃x₄ + x₄x₁) − 2(x₁x₃ + x₂x₄), the same if the list is turned round, and from both ends
fn skewed_around(x: &[Number]) -> Number {
    let [odd, even] = [0, 1].map(|k| x[k].clone() + x[k + 2].clone());
    let across = x[0].clone() * x[2].clone() + x[1].clone() * x[3].clone();
    product(x) + odd * even - number(2) * across
}

/// x₁x₂x₃x₄ + 2(x₁x₂ + x₃x₄) − (x₁ + x₂)(x₃ + x₄), the same after a swap of the first two, and from both ends
fn skewed_in_pairs(x: &[Number]) -> Number {
    let [first, last] = [0, 2].map(|k| x[k].clone() + x[k + 1].clone());
    let within = x[0].clone() * x[1].clone() + x[2].clone() * x[3].clone();
    product(x) + number(2) * within - first * last
}

fn square_of_the_mean(x: &[Number]) -> Number {
    let mean = sum(x) / number(x.len() as i64);
    mean.clone() * mean
}

/// Why: products of all arguments are the simplest blossoms.
#[test]
fn it_holds_for_the_products() {
    for n in 1..=4 {
        holds(
            &format!("x₁ ⋯ xₙ and tⁿ, n = {n}"),
            n,
            &product,
            &|t| power(t, n),
        );
    }
}

/// Why: the blossoms of all powers in degree 3, and with control points, in the words of the library.
#[test]
fn it_holds_for_the_library() {
    for k in 0..=3 {
        let binomial = number([1, 3, 3, 1][k]);
        let blossom = |x: &[Number]| elementary_symmetric(x)[k].clone() / binomial.clone();
        holds(&format!("the blossom of X^{k}, n = 3"), 3, &blossom, &|t| {
            power(t, k)
        });
    }
    let curve = BezierCurve::new([5, -2, 7, 1].map(number)).expect("four control values");
    let blossom = curve.blossom();
    let value = |x: &[Number]| blossom.at(x).expect("three arguments");
    let on_the_diagonal = |t: &Number| curve.at(t.clone());
    holds("the blossom of a cubic", 3, &value, &on_the_diagonal);
}

/// Why: two and three arguments, where one exchange is missed at a time.
#[test]
fn it_rejects_what_is_not_symmetric() {
    let square: Polynomial = &|t| power(t, 2);
    let cube: Polynomial = &|t| power(t, 3);
    fails("x₁x₂ + x₁ − x₂ and t²", 2, &skewed, square);
    fails(
        "x₁x₂x₃ + x₁ + x₂ − 2x₃ and t³",
        3,
        &skewed_in_the_last,
        cube,
    );
    fails(
        "x₁x₂x₃ + x₁ − 2x₂ + x₃ and t³",
        3,
        &skewed_in_the_middle,
        cube,
    );
}

/// Why: with four arguments even two kinds of exchange may miss that the order matters.
#[test]
fn it_rejects_what_is_nearly_symmetric() {
    let fourth: Polynomial = &|t| power(t, 4);
    fails(
        "x₁x₂x₃x₄ + (x₁ + x₃)(x₂ + x₄) − 2(x₁x₃ + x₂x₄) and t⁴",
        4,
        &skewed_around,
        fourth,
    );
    fails(
        "x₁x₂x₃x₄ + 2(x₁x₂ + x₃x₄) − (x₁ + x₂)(x₃ + x₄) and t⁴",
        4,
        &skewed_in_pairs,
        fourth,
    );
}

#[test]
fn it_rejects_what_is_not_affine() {
    fails(
        "((x₁ + x₂)/2)² and t²",
        2,
        &square_of_the_mean,
        &|t| power(t, 2),
    );
    fails("x₁² and t²", 1, &|x| power(&x[0], 2), &|t| power(t, 2));
    let mean_of_squares = |x: &[Number]| sum(&[0, 1, 2].map(|i| power(&x[i], 2))) / number(3);
    fails(
        "(x₁² + x₂² + x₃²)/3 and t²",
        3,
        &mean_of_squares,
        &|t| power(t, 2),
    );
}

#[test]
fn it_rejects_the_blossom_of_another_polynomial() {
    fails("x₁ + x₂ and t²", 2, &sum, &|t| power(t, 2));
    fails("x₁x₂ and t² + 1", 2, &product, &|t| {
        power(t, 2) + number(1)
    });
    fails("x₁ and 2t", 1, &product, &|t| number(2) * t.clone());
}
