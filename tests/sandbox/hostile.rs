//! A program that does what it is told, mostly something bad.
//!
//! It is no part of the tests but compiled by them. The first argument is the deed; the last one is the scratch
//! folder, by which the tests find processes that are left.

use std::fs;
use std::io::{Read, Write};
use std::process::Command;
use std::time::Duration;

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let rest: Vec<&str> = words[2..].iter().map(String::as_str).collect();
    let said = match (words[1].as_str(), rest.as_slice()) {
        ("say", [text, ..]) => Ok((*text).to_owned()),
        ("exit", [status, ..]) => std::process::exit(status.parse().expect("a status")),
        ("abort", _) => std::process::abort(),
        ("panic-while-unwinding", _) => {
            let _loud = Loud;
            panic!("first");
        }
        ("loop", _) => loop {
            std::hint::spin_loop();
        },
        ("sleep", _) => sleep_forever(),
        ("print", _) => loop {
            println!("{}", "x".repeat(10_000));
        },
        ("complain", _) => loop {
            eprintln!("{}", "x".repeat(10_000));
        },
        ("allocate", [mebibytes, ..]) => {
            let bytes: usize = mebibytes.parse::<usize>().expect("a size") << 20;
            let memory = vec![1_u8; bytes];
            Ok(format!("{}", memory[bytes / 2]))
        }
        // Each process stays below the limit; together they do not.
        ("share", [children, mebibytes, ..]) => {
            let children: usize = children.parse().expect("a number");
            for _ in 0..children {
                again(&["hold", mebibytes], &words);
            }
            sleep_forever()
        }
        ("hold", [mebibytes, ..]) => {
            let bytes: usize = mebibytes.parse::<usize>().expect("a size") << 20;
            let memory = vec![1_u8; bytes];
            std::hint::black_box(&memory);
            sleep_forever()
        }
        // Bounded by itself, so that a sandbox that fails to end it does no harm: 1 + 15 + 15² processes in all.
        ("bomb", generations) => {
            if generations.len() < 3 {
                let next = vec!["bomb"; generations.len() + 1];
                for _ in 0..15 {
                    again(&next, &words);
                }
            }
            sleep_forever()
        }
        ("threads", _) => {
            for _ in 0..500 {
                let thread = std::thread::Builder::new().stack_size(16 << 10);
                if thread.spawn(|| sleep_forever().is_ok()).is_err() {
                    break;
                }
            }
            sleep_forever()
        }
        ("spawn", [program, ..]) => Command::new(program)
            .arg("hello")
            .output()
            .map(|_| "done".to_owned()),
        ("read", [path, ..]) => fs::read_to_string(path),
        ("list", [path, ..]) => fs::read_dir(path).map(|entries| {
            let names = entries
                .flatten()
                .map(|entry| entry.file_name().to_string_lossy().into_owned());
            names.collect::<Vec<_>>().join(" ")
        }),
        ("write", [path, ..]) => fs::write(path, "written").map(|()| "done".to_owned()),
        ("delete", [path, ..]) => fs::remove_dir_all(path).map(|()| "done".to_owned()),
        ("flood", [files, mebibytes, ..]) => {
            let bytes = mebibytes.parse::<usize>().expect("a size") << 20;
            for file in 0..files.parse::<usize>().expect("a number") {
                fs::write(format!("file-{file}"), vec![1; bytes]).expect("a file");
            }
            sleep_forever()
        }
        // Files that no folder shows.
        ("hide", [files, mebibytes, ..]) => {
            let bytes = mebibytes.parse::<usize>().expect("a size") << 20;
            let mut open = Vec::new();
            for _ in 0..files.parse::<usize>().expect("a number") {
                let mut file = fs::File::create("hidden").expect("a file");
                fs::remove_file("hidden").expect("it is there");
                file.write_all(&vec![1; bytes]).expect("it can be written");
                open.push(file);
            }
            sleep_forever()
        }
        // Files below so many folders that no path leads to them.
        ("bury", _) => {
            for _ in 0..100 {
                let name = "d".repeat(200);
                fs::create_dir(&name).expect("a folder");
                std::env::set_current_dir(&name).expect("it is there");
            }
            sleep_forever()
        }
        ("connect", [address, ..]) => {
            std::net::TcpStream::connect(address).map(|_| "done".to_owned())
        }
        ("stdin", _) => std::io::read_to_string(std::io::stdin()),
        ("environment", _) => Ok(std::env::vars()
            .map(|(name, value)| format!("{name}={value}\n"))
            .collect()),
        ("folder", _) => std::env::current_dir().map(|folder| folder.display().to_string()),
        ("talk", [path, ..]) => {
            std::os::unix::net::UnixStream::connect(path).and_then(|mut socket| {
                socket.write_all(b"question\n")?;
                let mut answer = [0; 6];
                socket.read_exact(&mut answer)?;
                Ok(String::from_utf8_lossy(&answer).into_owned())
            })
        }
        // Twice away from its parent, in a session of its own, as daemons are started.
        ("daemon", [file, milliseconds, ..]) => {
            // SAFETY: there is one thread, and the copies only sleep and write a file.
            unsafe {
                if fork() == 0 {
                    setsid();
                    if fork() == 0 {
                        for descriptor in 0..3 {
                            close(descriptor);
                        }
                        std::thread::sleep(Duration::from_millis(
                            milliseconds.parse().expect("a time"),
                        ));
                        let _ = fs::write(file, "the daemon was here");
                    }
                    std::process::exit(0);
                }
            }
            std::thread::sleep(Duration::from_millis(100));
            Ok("away".to_owned())
        }
        ("kill-parent", _) => {
            // SAFETY: both only send a signal.
            unsafe {
                kill(getppid(), 9);
            }
            sleep_forever()
        }
        ("is-open", [descriptor, ..]) => {
            // SAFETY: it only asks for the flags (F_GETFD is 1).
            let flags = unsafe { fcntl(descriptor.parse().expect("a number"), 1) };
            Ok(if flags < 0 { "closed" } else { "open" }.to_owned())
        }
        (deed, _) => panic!("I do not know how to {deed}"),
    };
    match said {
        Ok(text) => println!("{text}"),
        Err(error) => {
            eprintln!("{error}");
            std::process::exit(7);
        }
    }
}

unsafe extern "C" {
    fn fork() -> i32;
    fn setsid() -> i32;
    fn close(descriptor: i32) -> i32;
    fn kill(process: i32, signal: i32) -> i32;
    fn getppid() -> i32;
    fn fcntl(descriptor: i32, command: i32, ...) -> i32;
}

/// Sleeps longer than any sandbox allows, and then ends, whatever the sandbox did.
fn sleep_forever() -> std::io::Result<String> {
    std::thread::sleep(Duration::from_secs(30));
    std::process::exit(9);
}

/// Starts this program once more, with the same last argument.
fn again(deed: &[&str], words: &[String]) {
    let mut command = Command::new(&words[0]);
    command.args(deed).arg(&words[words.len() - 1]);
    if let Err(error) = command.spawn() {
        eprintln!("{error}");
        std::process::exit(7);
    }
}

struct Loud;

impl Drop for Loud {
    fn drop(&mut self) {
        panic!("second");
    }
}
