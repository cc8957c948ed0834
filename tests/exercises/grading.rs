//! Grading: what students hand in, harmless and not.

mod class;
mod commands;
mod folder;
mod hidden;
mod hostile;
