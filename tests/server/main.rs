//! The server: who gets in, what runs, and that nothing keeps the book from being read.

mod exercises;
mod flood;
mod guard;
#[cfg(unix)]
mod run;
mod support;
