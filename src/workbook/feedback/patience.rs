//! A sign of life while something takes long.

use std::io::{IsTerminal, stderr};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::thread;
use std::time::Duration;

use indicatif::ProgressBar;

/// What ends within this time needs no sign of life.
const AT_ONCE: Duration = Duration::from_millis(700);

/// Does something and, if it takes longer than a moment, says what is being done.
///
/// On a terminal the line has the seconds and goes away in the end; elsewhere it is printed once.
pub fn patiently<T>(what: &str, work: impl FnOnce() -> T) -> T {
    let (done, is_done) = channel::<()>();
    let what = format!("{what} …");
    let sign = thread::spawn(move || {
        if is_done.recv_timeout(AT_ONCE) != Err(RecvTimeoutError::Timeout) {
            return;
        }
        if !stderr().is_terminal() {
            eprintln!("{what}");
            return;
        }
        let spinner = ProgressBar::new_spinner().with_message(what);
        if let Ok(style) = indicatif::ProgressStyle::with_template("{spinner} {msg} {elapsed}") {
            spinner.set_style(style);
        }
        spinner.enable_steady_tick(Duration::from_millis(120));
        let _ = is_done.recv();
        spinner.finish_and_clear();
    });
    let value = work();
    drop(done);
    // The line must be gone before anything else is printed.
    let _ = sign.join();
    value
}
