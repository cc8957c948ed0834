//! The answers that an exercise brings.

use std::fmt;

use crate::book::exercise::{Exercise, Tested, Variant};
use crate::workbook::checking::compile::Source;

/// What an answer is there for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// What the reader begins with; the tests must reject it.
    Starter,
    /// What must pass.
    Solution,
    /// A wrong answer; the tests must reject it.
    Mutant,
    /// Another right answer; it must pass.
    Alternative,
    /// A wrong answer that only hidden tests must reject.
    HiddenMutant,
}

/// An answer that an exercise brings.
#[derive(Debug, Clone)]
pub struct Candidate {
    /// What it is there for.
    pub role: Role,
    /// The name of its file without `.rs`; empty for starter and solution, which an exercise has once.
    pub name: String,
    /// Its source.
    pub source: Source,
}

impl Candidate {
    /// All answers of an exercise: solution, starter, mutants, alternatives.
    pub fn all(exercise: &Exercise, tested: &Tested) -> Vec<Self> {
        let marked = exercise.folder.join("answer.rs");
        let from_marked = |role, text: &str| Self {
            role,
            name: String::new(),
            source: Source {
                shown_as: format!("{role} of {}", marked.display()),
                text: text.to_owned(),
            },
        };
        let mut all = vec![
            from_marked(Role::Solution, &tested.answer.solution),
            from_marked(Role::Starter, &tested.answer.starter),
        ];
        let variants = [
            (Role::Mutant, &tested.mutants),
            (Role::Alternative, &tested.alternatives),
        ];
        for (role, variants) in variants {
            all.extend(variants.iter().map(|variant| Self::of(role, variant)));
        }
        all
    }

    /// The answer of a file of its own.
    pub fn of(role: Role, variant: &Variant) -> Self {
        Self {
            role,
            name: variant.name.clone(),
            source: Source::from(variant),
        }
    }

    /// Whether tests must reject it.
    pub fn is_wrong(&self) -> bool {
        !matches!(self.role, Role::Solution | Role::Alternative)
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Starter => "starter",
            Self::Solution => "solution",
            Self::Mutant => "mutant",
            Self::Alternative => "alternative",
            Self::HiddenMutant => "hidden mutant",
        })
    }
}

impl fmt::Display for Candidate {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.name.is_empty() {
            write!(f, "{}", self.role)
        } else {
            write!(f, "{} {}", self.role, self.name)
        }
    }
}
