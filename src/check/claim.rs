//! One thing that an answer must do, and what to tell when it does not.

use std::cell::RefCell;
use std::fmt;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::picture::Picture;
use super::report::Finding;
use super::show::{Distance, Show};
use crate::law::Sides;
use crate::scalar::Scalar;

thread_local! {
    /// What the last claim that failed on this thread found.
    ///
    /// A property test shrinks its input by running again and again; the last failure is the smallest.
    static LAST: RefCell<Option<Finding>> = const { RefCell::new(None) };
}

/// Takes what the last failed claim on this thread found; the harness asks, which needs Unix, and so do the tests.
#[cfg(any(unix, test))]
pub(super) fn take_last_finding() -> Option<Finding> {
    LAST.with_borrow_mut(Option::take)
}

/// Begins a claim; `what` completes “tested was …”.
///
/// # Examples
///
/// ```
/// cagd::check::claim("2 + 2").equal(2 + 2, 4);
/// ```
///
/// ```should_panic
/// // Panics: the claim does not hold.
/// cagd::check::claim("2 + 2").equal(2 + 2, 5);
/// ```
#[must_use = "a claim that is not finished claims nothing; end it with `equal`, `close`, `law` or `holds`"]
pub fn claim<'a>(what: impl fmt::Display) -> Claim<'a> {
    Claim {
        what: what.to_string(),
        input: String::new(),
        picture: None,
    }
}

/// A claim about an answer that has not been judged yet.
///
/// It ends with [`equal`](Self::equal), [`close`](Self::close), [`law`](Self::law) or [`holds`](Self::holds).
/// Each of them panics if the claim is wrong, so that the test fails.
#[must_use = "a claim that is not finished claims nothing; end it with `equal`, `close`, `law` or `holds`"]
pub struct Claim<'a> {
    what: String,
    input: String,
    picture: Option<Box<dyn FnOnce() -> Picture + 'a>>,
}

impl fmt::Debug for Claim<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Claim({}, input: {})", self.what, self.input)
    }
}

impl<'a> Claim<'a> {
    /// The input, as the reader should see it.
    ///
    /// Inside `proptest!` it may be left out; then the smallest failing input that proptest prints is shown.
    pub fn input(mut self, input: impl fmt::Display) -> Self {
        self.input = input.to_string();
        self
    }

    /// A picture of what is wrong; it is drawn only if the claim fails.
    pub fn picture(mut self, draw: impl FnOnce() -> Picture + 'a) -> Self {
        self.picture = Some(Box::new(draw));
        self
    }

    /// Claims that both are the same, with no tolerance.
    #[track_caller]
    pub fn equal<T: PartialEq + Show>(self, found: T, expected: T) {
        if found != expected {
            self.fail(&expected.show(), &found.show());
        }
    }

    /// Claims that both differ by at most `allowed` in the largest coordinate.
    ///
    /// `allowed` is a bound for rounding and must be derived where the test states it.
    #[track_caller]
    pub fn close<T: Distance + Show>(self, found: T, expected: T, allowed: f64) {
        let distance = found.distance(&expected);
        // A NaN is far from everything.
        if distance.is_nan() || distance > allowed {
            self.fail(&expected.show(), &found.show());
        }
    }

    /// Claims that a law holds.
    #[track_caller]
    pub fn law<T: Scalar>(mut self, sides: &Sides<T>) {
        if let Err(violation) = sides.judge() {
            self.what = format!("{}: {}", self.what, violation.claim);
            if self.input.is_empty() {
                self.input = violation.input;
            }
            self.fail(&violation.right, &violation.left);
        }
    }

    /// Claims that something is so; `expected` says what, `found` what was met instead.
    #[track_caller]
    pub fn holds(self, is_so: bool, expected: impl fmt::Display, found: impl fmt::Display) {
        if !is_so {
            self.fail(&expected.to_string(), &found.to_string());
        }
    }

    #[track_caller]
    fn fail(self, expected: &str, found: &str) -> ! {
        // The picture calls the answer again, which may panic; the claim has failed all the same.
        let picture = self
            .picture
            .and_then(|draw| catch_unwind(AssertUnwindSafe(draw)).ok());
        let finding = Finding {
            claim: self.what,
            input: self.input,
            expected: expected.to_owned(),
            found: found.to_owned(),
            picture,
        };
        let text = finding.to_string();
        LAST.with_borrow_mut(|last| *last = Some(finding));
        panic!("{text}");
    }
}

/// What an answer does on one input: the value, or that it panics.
///
/// Written by the macro [`probes!`](crate::probes).
pub fn probe<T: Show>(run: impl FnOnce() -> T) -> String {
    shown_or_panics(Box::new(|| run().show()))
}

/// The part of [`probe`] that is the same for all values: compiled here, and not anew with each probe of a test.
fn shown_or_panics(run: Box<dyn FnOnce() -> String + '_>) -> String {
    catch_unwind(AssertUnwindSafe(run)).unwrap_or_else(|_| "panics".to_owned())
}

/// What an answer does on chosen inputs: `fn probes() -> Vec<String> { cagd::probes![answer::f(1), answer::f(2)] }`.
///
/// An answer that fails is compared with the mutants on these inputs; if one does the same, the reader is told its
/// misconception. Choose inputs on which any two mutants differ.
///
/// # Examples
///
/// ```
/// fn half(n: i32) -> i32 { n / 2 }
///
/// assert_eq!(cagd::probes![half(4), half(7), [1][half(2) as usize]], ["2", "3", "panics"]);
/// ```
#[macro_export]
macro_rules! probes {
    ($($value:expr),+ $(,)?) => {
        ::std::vec![$($crate::check::probe(|| $value)),+]
    };
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_failed_claim_leaves_what_it_found() {
        let failed = catch_unwind(|| {
            claim("the sum").input("1 and 2").equal(4, 3);
        });
        assert!(failed.is_err());
        let finding = take_last_finding().expect("the claim failed");
        assert_eq!(
            (finding.expected.as_str(), finding.found.as_str()),
            ("3", "4")
        );
        assert_eq!(take_last_finding(), None);
    }

    #[test]
    fn a_claim_that_holds_leaves_nothing() {
        claim("the sum").equal(3, 3);
        claim("nearly").close(1.0, 1.5, 0.5);
        assert_eq!(take_last_finding(), None);
    }

    #[test]
    fn nan_is_not_close_to_anything() {
        for (found, expected) in [(f64::NAN, 0.0), (0.0, f64::NAN)] {
            let failed = catch_unwind(|| claim("a number").close(found, expected, 1.0));
            assert!(failed.is_err());
        }
    }

    #[test]
    fn a_picture_that_panics_does_not_hide_the_finding() {
        let failed = catch_unwind(|| {
            claim("the sum")
                .picture(|| panic!("no picture"))
                .equal(4, 3);
        });
        assert!(failed.is_err());
        let finding = take_last_finding().expect("the claim failed");
        assert_eq!(finding.picture, None);
    }
}
