//! The server: who gets in, what runs, and that nothing keeps the book from being read.

mod guard;
mod support;
