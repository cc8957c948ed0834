//! How much a run may use, and why that much.

use std::time::Duration;

const MEBIBYTE: u64 = 1 << 20;

/// How much a run may use.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Limits {
    /// The time from start to end; each process may use that much on all cores together.
    pub time: Duration,
    /// The address space of each process, and the memory that all of them hold together, in bytes; at least
    /// [`Limits::LEAST_MEMORY`].
    ///
    /// Counted is what processes have mapped, and files that have no name.
    /// System V shared memory that nobody has attached is not seen.
    pub memory: u64,
    /// The bytes printed on standard output and standard error together.
    pub output: usize,
    /// The processes and threads at one time.
    pub processes: usize,
    /// The size of one file, in bytes.
    pub file_size: u64,
    /// What the scratch folder may hold altogether, in bytes; each file counts at least 4096.
    pub scratch: u64,
}

impl Limits {
    /// The supervisor obeys the limit too: the workbook's program with its threads takes about 100 MiB of address
    /// space.
    pub const LEAST_MEMORY: u64 = 256 * MEBIBYTE;

    /// For a run of the compiler on an answer.
    ///
    /// | limit | because |
    /// |---|---|
    /// | 20 s | an answer compiles in 0.3 s; a busy machine of a class is some ten times slower |
    /// | 4 GiB | the compiler maps about 0.7 GiB before it begins, and each thread reserves 64 MiB more |
    /// | 1 MiB of output | thousands of errors; a reader reads the first |
    /// | 256 processes and threads | compiler and linker start one for each core, the compiler at most 32 |
    /// | files of 256 MiB | a test program with the library and its debug information has about 10 MiB |
    /// | 512 MiB of files | objects and program, and as much again while linking |
    #[must_use]
    pub const fn compiler() -> Self {
        Limits {
            time: Duration::from_secs(20),
            memory: 4096 * MEBIBYTE,
            output: 1 << 20,
            processes: 256,
            file_size: 256 * MEBIBYTE,
            scratch: 512 * MEBIBYTE,
        }
    }

    /// For a run of a test program.
    ///
    /// | limit | because |
    /// |---|---|
    /// | 10 s | the tests of an answer take milliseconds; a loop that never ends is noticed while one still looks |
    /// | 1 GiB | the tests hold a few MiB; each thread reserves 64 MiB of address space |
    /// | 256 KiB of output | some thousand lines; nobody reads more |
    /// | 64 processes and threads | the test harness has one for each core |
    /// | files of 16 MiB | a picture has some KiB |
    /// | 64 MiB of files | four of the largest |
    #[must_use]
    pub const fn answer() -> Self {
        Limits {
            time: Duration::from_secs(10),
            memory: 1024 * MEBIBYTE,
            output: 256 << 10,
            processes: 64,
            file_size: 16 * MEBIBYTE,
            scratch: 64 * MEBIBYTE,
        }
    }
}
