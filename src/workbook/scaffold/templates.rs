//! What the files of a new exercise hold, kind by kind.

use crate::book::exercise::ExerciseKind;

/// The sources of an exercise.
pub(super) struct Template {
    pub(super) answer: &'static str,
    pub(super) tests: &'static str,
    /// Name and source of each wrong answer.
    pub(super) mutants: [(&'static str, &'static str); 3],
}

/// The sources for a kind; an explanation has none.
pub(super) fn template(kind: ExerciseKind) -> Option<Template> {
    match kind {
        ExerciseKind::Implement | ExerciseKind::Repair => Some(FUNCTION),
        ExerciseKind::Counterexample => Some(COUNTEREXAMPLE),
        ExerciseKind::Prove => Some(LAW),
        ExerciseKind::Compute => Some(TABLEAU),
        ExerciseKind::Explain => None,
    }
}

/// The file `exercise.md`.
pub(super) fn task(kind: ExerciseKind, statement: &str, order: u32) -> String {
    let tableau = if kind == ExerciseKind::Compute {
        "tableau = \"cubic\"\n"
    } else {
        ""
    };
    let parts = if kind.is_tested() {
        ""
    } else {
        "\n## Model answer\n\nTODO: write the answer that you would like to hear.\n\n## Checklist\n\n- [ ] TODO: list what a good answer says, a line each.\n"
    };
    format!(
        r"+++
title = 'TODO: say in a few words what it is about'
kind = '{kind}'
statements = ['{statement}']
difficulty = 1
minutes = 10
order = {order}
{tableau}+++

TODO: say what to do, with all conventions, and correct statements, difficulty and minutes above.

## Hint

TODO: give a nudge in the right direction.

## Hint

TODO: tell the idea.

## Hint

TODO: give the formula, such as $2n$, so that only writing is left.
{parts}"
    )
}

const FUNCTION: Template = Template {
    answer: "\
//! TODO: say what the answer computes.

/// The double of n. TODO: write the function, and the starter behind `//|`.
pub fn double(n: i64) -> i64 {
    //@ solution
    2 * n
    //@ starter
    //| // What is missing?
    //| n
    //@ end
}
",
    tests: r#"use cagd::check::claim;
use proptest::prelude::*;

// TODO: choose inputs on which the solution and any two mutants differ.
fn probes() -> Vec<String> {
    cagd::probes![answer::double(2), answer::double(3), answer::double(-3)]
}

/// Why: small enough to follow by hand. TODO: say for each test what only it rejects, or why it is there.
#[test]
fn by_hand() {
    claim("the double of 2").input("n = 2").equal(answer::double(2), 4);
}

proptest! {
    #[test]
    fn everywhere(n in -100..100_i64) {
        claim("the double of n").equal(answer::double(n), n + n);
    }
}
"#,
    mutants: [
        (
            "square",
            "//! misconception: TODO: the double is the square\n\n/// The double of n.\npub fn double(n: i64) -> i64 {\n    n * n\n}\n",
        ),
        (
            "plus-two",
            "//! misconception: TODO: to double is to add two\n\n/// The double of n.\npub fn double(n: i64) -> i64 {\n    n + 2\n}\n",
        ),
        (
            "unsigned",
            "//! misconception: TODO: the double of a number is positive\n\n/// The double of n.\npub fn double(n: i64) -> i64 {\n    2 * n.abs()\n}\n",
        ),
    ],
};

const COUNTEREXAMPLE: Template = Template {
    answer: "\
//! TODO: say what the answer refutes.

/// An even number whose half is odd. TODO: let the function return what refutes the claim.
pub fn number() -> i64 {
    //@ solution
    6
    //@ starter
    //| // The half of 4 is even.
    //| 4
    //@ end
}
",
    tests: r#"use cagd::check::claim;

fn probes() -> Vec<String> {
    cagd::probes![answer::number()]
}

// TODO: write a test for each hypothesis of the claim.
#[test]
fn the_hypothesis_holds() {
    let n = answer::number();
    claim("the number").holds(n % 2 == 0, "an even number", n);
}

// TODO: write the test that the claim fails.
#[test]
fn the_claim_fails() {
    let n = answer::number();
    claim("its half").holds((n / 2) % 2 != 0, "an odd number", n / 2);
}
"#,
    mutants: [
        (
            "odd",
            "//! misconception: TODO: the number may be odd\n\n/// The number.\npub fn number() -> i64 {\n    3\n}\n",
        ),
        (
            "power-of-two",
            "//! misconception: TODO: every even number will do\n\n/// The number.\npub fn number() -> i64 {\n    8\n}\n",
        ),
        (
            "zero",
            "//! misconception: TODO: zero is always a counterexample\n\n/// The number.\npub fn number() -> i64 {\n    0\n}\n",
        ),
    ],
};

const LAW: Template = Template {
    answer: "\
//! TODO: say which law is written.

/// Whether `double` doubles n. TODO: write the law, which judges the implementation that it is given.
pub fn holds(double: fn(i64) -> i64, n: i64) -> bool {
    //@ solution
    double(n) == n + n
    //@ starter
    //| // This holds for every function.
    //| double(n) == double(n)
    //@ end
}
",
    tests: r#"use cagd::check::claim;

// TODO: choose implementations on which the solution and any two mutants differ.
fn probes() -> Vec<String> {
    cagd::probes![
        answer::holds(|n| 2 * n, 3),
        answer::holds(|n| n * n, 2),
        answer::holds(|n| n * n, 3),
        answer::holds(|n| n + 1, 3),
        answer::holds(|n| 2 * n.abs(), -3),
    ]
}

/// Why: a right implementation may not be rejected.
#[test]
fn a_right_implementation() {
    claim("the law for 2n").equal((-3..=3).all(|n| answer::holds(|n| 2 * n, n)), true);
}

/// Why: a law that rejects nothing fails here. TODO: write a test for each kind of wrong implementation.
#[test]
fn a_wrong_implementation() {
    claim("the law for n²").equal(answer::holds(|n| n * n, 3), false);
}

#[test]
fn an_implementation_that_forgets_the_sign() {
    claim("the law for 2|n|").equal(answer::holds(|n| 2 * n.abs(), -3), false);
}
"#,
    mutants: [
        (
            "no-sign",
            "//! misconception: TODO: the sign does not matter\n\n/// Whether `double` doubles n.\npub fn holds(double: fn(i64) -> i64, n: i64) -> bool {\n    double(n).abs() == 2 * n.abs()\n}\n",
        ),
        (
            "even",
            "//! misconception: TODO: what is even is a double\n\n/// Whether `double` doubles n.\npub fn holds(double: fn(i64) -> i64, n: i64) -> bool {\n    double(n) % 2 == 0\n}\n",
        ),
        (
            "nothing-holds",
            "//! misconception: TODO: a law rejects\n\n/// Whether `double` doubles n.\npub fn holds(double: fn(i64) -> i64, n: i64) -> bool {\n    double(n) == n + n && n < 0\n}\n",
        ),
    ],
};

/// Its `answer.rs` is what the tableau `cubic` deals; the schema refuses anything else.
const TABLEAU: Template = Template {
    answer: r#"//! To compute: the point at t = 3/4 of the cubic with the control points in the first column.

/// The round that dealt the numbers; leave it as it is.
pub const ROUND: u64 = 0;

/// Write a fraction such as 3/4, or a point such as (3/4, 2), for each question mark.
pub const TABLEAU: &str = "
//@ solution
(0, 0)
(8, 16)  (6, 12)
(16, 0)  (14, 4)  (12, 6)
(24, 0)  (22, 0)  (20, 1)  (18, 9/4)
//@ starter
//| (0, 0)
//| (8, 16)  ?
//| (16, 0)  ?  ?
//| (24, 0)  ?  ?  ?
//@ end
";
"#,
    tests: r#"use cagd::bezier::tableaux;
use cagd::check::tableau::Tableau;

fn tableau() -> Tableau {
    tableaux::cubic(answer::ROUND).tableau
}

fn probes() -> Vec<String> {
    tableau().trace(answer::TABLEAU)
}

// TODO: name your tableau above and in `exercise.md`; `verify` prints the `answer.rs` that belongs to it.
#[test]
fn first_step() {
    tableau().judge_column(answer::TABLEAU, 1);
}

#[test]
fn second_step() {
    tableau().judge_column(answer::TABLEAU, 2);
}

#[test]
fn last_step() {
    tableau().judge_column(answer::TABLEAU, 3);
}
"#,
    mutants: [
        (
            "first-slip",
            "//! misconception: TODO: a slip in the first step\n\n/// The round.\npub const ROUND: u64 = 0;\n\n/// The tableau.\npub const TABLEAU: &str = \"\n(0, 0)\n(8, 16)  (6, 10)\n(16, 0)  (14, 4)  (12, 11/2)\n(24, 0)  (22, 0)  (20, 1)  (18, 17/8)\n\";\n",
        ),
        (
            "second-slip",
            "//! misconception: TODO: a slip in the second step\n\n/// The round.\npub const ROUND: u64 = 0;\n\n/// The tableau.\npub const TABLEAU: &str = \"\n(0, 0)\n(8, 16)  (6, 12)\n(16, 0)  (14, 4)  (12, 5)\n(24, 0)  (22, 0)  (20, 1)  (18, 2)\n\";\n",
        ),
        (
            "last-slip",
            "//! misconception: TODO: a slip in the last step\n\n/// The round.\npub const ROUND: u64 = 0;\n\n/// The tableau.\npub const TABLEAU: &str = \"\n(0, 0)\n(8, 16)  (6, 12)\n(16, 0)  (14, 4)  (12, 6)\n(24, 0)  (22, 0)  (20, 1)  (18, 2)\n\";\n",
        ),
    ],
};
