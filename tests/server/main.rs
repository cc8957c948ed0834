//! The server: who gets in, what runs, and that nothing keeps the book from being read.

mod exercises;
mod guard;
mod support;
