//! The number types the algorithms run over.
