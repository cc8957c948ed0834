//! Statements, directives, evidence and the mdBook preprocessor.
