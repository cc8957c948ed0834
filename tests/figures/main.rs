//! Figures: what they plot is right, wrong plots are refused, and the pictures are the reviewed ones.
//!
//! A figure's test is named as the figure's function, in the module of its section:
//!
//! ```text
//! figure_test(figure_hull(), |plot| …)                          // what must hold of what is plotted
//!     .rejects("a hull that is too small", |plot| …)            // at least one wrong plot that the check refuses
//!     .snapshot();                                              // snapshots/<chapter>/<id>.snap.svg
//! ```
//!
//! To accept a new or a changed picture: `INSTA_UPDATE=always cargo test --test figures NAME`,
//! then look at `snapshots/<chapter>/<id>.snap.svg` in a browser, light and dark, before you commit it.

mod affine;
mod bezier;
mod every_figure;
mod interface;
#[cfg(feature = "book")]
#[path = "../support/listed.rs"]
mod listed;
mod readings;
mod subdivision;
mod support;
