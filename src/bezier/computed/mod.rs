//! The numbers of the chapter's worked examples, computed by the library as Markdown.
//!
//! A page shows what a function gives by `{{#computed bezier NAME}}`.

mod bernstein;
mod blossom;
mod bounds;
mod de_casteljau;
mod derivatives;
mod elevation;
mod representation;
mod shape;
mod subdivision;

/// A function of this chapter by its name.
pub type Computed = (&'static str, fn() -> String);

/// Everything that the pages of the chapter can show.
#[must_use]
pub fn all() -> Vec<Computed> {
    [
        bernstein::ALL,
        blossom::ALL,
        bounds::ALL,
        de_casteljau::ALL,
        derivatives::ALL,
        elevation::ALL,
        representation::ALL,
        shape::ALL,
        subdivision::ALL,
    ]
    .concat()
}
