//! All of a check, for one answer.

use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use super::CheckingError;
use super::compile::{
    CompiledAnswer, Program, Source, compile_answer, compile_tests, compile_together,
};
use super::library::Library;
use super::misconception;
use super::runner::Runner;
use super::trial::{AfterTooLong, Results, WithProbes, run_probes, run_tests};
use super::verdict::{Diagnostic, Outcome, TestOutcome, Verdict};
use crate::book::exercise::{Exercise, Tested};
use crate::workbook::parallel::in_parallel;
use crate::workbook::sandbox::{Isolation, Limits};

/// An answer to be checked.
pub type Answer = Source;

/// What checks answers: the compiled library and the way of keeping programs apart.
#[derive(Debug, Clone)]
pub struct Checker {
    library: Library,
    runner: Runner,
    limits: Limits,
}

/// How many compilers work for several answers to one exercise at a time.
///
/// One exercise alone then keeps two cores busy, and many at a time do not need too much memory.
const AT_ONCE: usize = 2;

/// A program, or why there is none.
#[derive(Debug)]
pub enum Compiled {
    /// It compiles; with the warnings about the answer.
    Program(Program, Vec<Diagnostic>),
    /// The answer does not compile.
    Refused(Vec<Diagnostic>),
    /// The answer compiles, the tests do not compile with it.
    RefusedWithTests(Vec<Diagnostic>),
}

impl Checker {
    /// Builds the library of the workbook at `root` if that is needed.
    ///
    /// # Errors
    ///
    /// The library does not compile.
    pub fn new(root: &Path, isolation: Isolation) -> Result<Self, CheckingError> {
        Ok(Self::with_library(Library::build(root)?, isolation))
    }

    /// Checks with a library that is already there.
    pub fn with_library(library: Library, isolation: Isolation) -> Self {
        Self {
            library,
            runner: Runner::new(isolation),
            limits: Limits::answer(),
        }
    }

    /// The same checker with other limits for the answers.
    #[must_use]
    pub fn with_limits(mut self, limits: Limits) -> Self {
        self.limits = limits;
        self
    }

    /// The same checker for exercises to be verified: everything may take six times as long.
    ///
    /// A reader waits for his own answer. Here many answers are tried while the machine has other work, and none of
    /// them may be taken for endless because of that.
    #[must_use]
    pub fn patient(mut self) -> Self {
        const TIMES: u32 = 6;
        self.limits.time *= TIMES;
        self.runner = self.runner.patiently(TIMES);
        self
    }

    /// The same checker, which ends what it runs as soon as `stop` is true: a check is then [`CheckingError::Stopped`].
    #[must_use]
    pub fn until(mut self, stop: Arc<AtomicBool>) -> Self {
        self.runner = self.runner.until(stop);
        self
    }

    /// The compiled library.
    pub fn library(&self) -> &Library {
        &self.library
    }

    /// How programs are kept apart.
    pub fn isolation(&self) -> Isolation {
        self.runner.isolation()
    }

    /// What runs the compiler and the programs.
    pub fn runner(&self) -> &Runner {
        &self.runner
    }

    /// How much an answer may use.
    pub fn limits(&self) -> &Limits {
        &self.limits
    }

    /// Compiles an answer with the tests of its exercise.
    ///
    /// # Errors
    ///
    /// The compiler does not start.
    pub fn compile(&self, tested: &Tested, answer: &Answer) -> Result<Compiled, CheckingError> {
        match compile_answer(&self.library, answer, &self.runner)? {
            Ok(compiled) => self.with_tests(tested, &compiled),
            Err(diagnostics) => Ok(Compiled::Refused(diagnostics)),
        }
    }

    /// Compiles several answers with the tests of their exercise, in much less time than one by one.
    ///
    /// # Errors
    ///
    /// The compiler does not start.
    pub fn compile_all(
        &self,
        tested: &Tested,
        answers: &[&Answer],
    ) -> Result<Vec<Compiled>, CheckingError> {
        let compiled = in_parallel(answers, AT_ONCE, |answer| {
            compile_answer(&self.library, answer, &self.runner)
        })?;
        let fit: Vec<&CompiledAnswer> = compiled.iter().flatten().collect();
        let programs = match fit.len() {
            0 | 1 => None,
            _ => compile_together(&self.library, &fit, &tested.tests, &self.runner)?,
        };
        let Some(programs) = programs else {
            // One that does not fit the tests keeps them all apart.
            return in_parallel(&compiled, AT_ONCE, |compiled| match compiled {
                Ok(compiled) => self.with_tests(tested, compiled),
                Err(diagnostics) => Ok(Compiled::Refused(diagnostics.clone())),
            });
        };
        let mut programs = programs.into_iter();
        let with_program = |compiled| match compiled {
            Ok(CompiledAnswer { diagnostics, .. }) => {
                Some(Compiled::Program(programs.next()?, diagnostics))
            }
            Err(diagnostics) => Some(Compiled::Refused(diagnostics)),
        };
        // There is a program for each answer that has compiled.
        Ok(compiled.into_iter().filter_map(with_program).collect())
    }

    /// Compiles the tests with one answer.
    fn with_tests(
        &self,
        tested: &Tested,
        answer: &CompiledAnswer,
    ) -> Result<Compiled, CheckingError> {
        let tests = Source {
            shown_as: tested.tests.file.display().to_string(),
            text: tested.tests.program(),
        };
        let compiled = compile_tests(&self.library, answer, &tests, &self.runner)?;
        Ok(match compiled {
            Ok(program) => Compiled::Program(program, answer.diagnostics.clone()),
            Err(diagnostics) => Compiled::RefusedWithTests(diagnostics),
        })
    }

    /// Runs the tests of a compiled program, until one takes too long.
    ///
    /// # Errors
    ///
    /// The program does not start.
    pub fn run(
        &self,
        tested: &Tested,
        program: &Program,
        seed: u64,
    ) -> Result<Results, CheckingError> {
        let names: Vec<&str> = tested
            .tests
            .tests
            .iter()
            .map(|test| test.name.as_str())
            .collect();
        run_tests(
            program,
            &names,
            seed,
            &self.limits,
            &self.runner,
            AfterTooLong::Stop,
            WithProbes::UnlessPassed,
        )
    }

    /// What several answers do on the probe inputs; `None` for one that does not compile or ends the program.
    ///
    /// # Errors
    ///
    /// The compiler or the program does not start.
    pub fn probes(
        &self,
        tested: &Tested,
        answers: &[&Answer],
    ) -> Result<Vec<Option<Vec<String>>>, CheckingError> {
        let compiled = self.compile_all(tested, answers)?;
        in_parallel(&compiled, AT_ONCE, |compiled| match compiled {
            Compiled::Program(program, _) => run_probes(program, &self.limits, &self.runner),
            _ => Ok(None),
        })
    }

    /// Checks an answer.
    ///
    /// # Errors
    ///
    /// The compiler or the program does not start; what is wrong with the answer is part of the verdict.
    pub fn check(
        &self,
        exercise: &Exercise,
        tested: &Tested,
        answer: &Answer,
        seed: u64,
    ) -> Result<Verdict, CheckingError> {
        let start = Instant::now();
        let verdict = |outcome, diagnostics, results: Results, misconception| Verdict {
            exercise: exercise.name.clone(),
            outcome,
            diagnostics,
            tests: results.tests,
            misconception,
            checklist: None,
            output: results.output,
            seconds: start.elapsed().as_secs_f64(),
        };
        let (program, warnings) = match self.compile(tested, answer)? {
            Compiled::Program(program, warnings) => (program, warnings),
            Compiled::Refused(diagnostics) | Compiled::RefusedWithTests(diagnostics) => {
                return Ok(verdict(
                    Outcome::DoesNotCompile,
                    diagnostics,
                    Results::default(),
                    None,
                ));
            }
        };
        let mut results = self.run(tested, &program, seed)?;
        let is_passed = |test: &super::verdict::TestResult| test.outcome == TestOutcome::Passed;
        if results.tests.iter().all(is_passed) {
            return Ok(verdict(Outcome::Passed, warnings, results, None));
        }
        // A loop that never ends would take as long once more on the probe inputs.
        if results.took_too_long {
            return Ok(verdict(Outcome::Failed, warnings, results, None));
        }
        let found = match results.probes.take() {
            // An answer that has ended the program may still answer the probes.
            None => run_probes(&program, &self.limits, &self.runner)?,
            found => found,
        };
        let misconception = match found {
            Some(found) => misconception::recognise(self, exercise, tested, &found)?,
            None => None,
        };
        Ok(verdict(Outcome::Failed, warnings, results, misconception))
    }
}
