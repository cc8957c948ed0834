//! The book builds, its pages hold what they should, and what is wrong with a book is told with file and line.

mod chapter_doctests;
mod errors;
mod exercises;
mod fixture;
mod output;
mod pages;
mod stock;
