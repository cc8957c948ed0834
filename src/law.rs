//! What a law is, and the judge of all laws.
