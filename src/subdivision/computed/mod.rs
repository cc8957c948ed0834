//! The numbers of the chapter's worked examples, computed by the library as Markdown.
//!
//! A page shows what a function gives by `{{#computed subdivision NAME}}`.

mod corner_cutting;
mod four_point;
mod limit_points;
mod uniform_splines;

/// A function of this chapter by its name.
pub type Computed = (&'static str, fn() -> String);

/// Everything that the pages of the chapter can show.
#[must_use]
pub fn all() -> Vec<Computed> {
    [
        corner_cutting::ALL,
        four_point::ALL,
        limit_points::ALL,
        uniform_splines::ALL,
    ]
    .concat()
}
