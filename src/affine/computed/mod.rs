//! The numbers of the chapter's worked examples, computed by the library as Markdown.
//!
//! A page shows what a function gives by `{{#computed affine NAME}}`.

mod areas;
mod barycentric;
mod combinations;
mod convexity;
mod maps;
mod points_and_vectors;

/// A function of this chapter by its name.
pub type Computed = (&'static str, fn() -> String);

/// Everything that the pages of the chapter can show.
#[must_use]
pub fn all() -> Vec<Computed> {
    [
        areas::ALL,
        barycentric::ALL,
        combinations::ALL,
        convexity::ALL,
        maps::ALL,
        points_and_vectors::ALL,
    ]
    .concat()
}
