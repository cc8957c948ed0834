//! Too much at once, too large, too slow: it is refused, and the book stays readable.

use std::io::{Read, Write};
use std::net::TcpStream;
use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use cagd::workbook::server::guard::LARGEST_REQUEST;
use cagd::workbook::server::queue::{AT_ONCE, WAITING};
use cagd::workbook::server::{Queue, QueueError};
use tokio::sync::watch;

use crate::support::{Answer, Server};

const RUN: &str = "POST /__workbook/run";

/// Writes zeros until the server has had enough; returns how many it took.
fn pour(stream: &mut TcpStream, bytes: usize) -> usize {
    let chunk = [0; 1 << 16];
    let mut poured = 0;
    while poured < bytes {
        match stream.write(&chunk) {
            Ok(taken) => poured += taken,
            // It has closed the connection, or does not read any more.
            Err(_) => break,
        }
    }
    poured
}

#[test]
fn a_body_of_100_megabytes_is_not_read() {
    let server = Server::start();
    let size: usize = 100 << 20;
    for told in [true, false] {
        let mut headers = server.reader();
        headers.push(match told {
            true => ("Content-Length".into(), size.to_string()),
            // Chunks of unknown number; the first one is announced as larger than everything.
            false => ("Transfer-Encoding".into(), "chunked".into()),
        });
        let mut stream = server.send(RUN, &headers, "");
        let patience = Some(Duration::from_secs(5));
        stream.set_write_timeout(patience).expect("a time limit");
        if !told {
            stream.write_all(b"8000000\r\n").expect("it is read");
        }
        let poured = pour(&mut stream, size);
        // What fits into the buffers of the system in between is not much more than the limit.
        assert!(poured < size / 4, "the server has taken {poured} bytes");
        let mut answer = String::new();
        // A connection that the server has closed early may be reset before its answer is read.
        if stream.read_to_string(&mut answer).is_ok() && !answer.is_empty() {
            assert!(answer.starts_with("HTTP/1.1 413"), "{answer}");
        }
        server.assert_readable();
    }
    // Just above the limit the answer can always be read.
    let answer = server.ask(RUN, &server.reader(), &"x".repeat(LARGEST_REQUEST + 1));
    assert_eq!(answer.status, 413, "{answer:?}");
}

#[test]
fn a_request_that_does_not_arrive_is_given_up() {
    let server = Server::start();
    let mut headers = server.reader();
    headers.push(("Content-Length".into(), "1000".into()));
    let slow = server.send(RUN, &headers, "");
    server.assert_readable();
    assert_eq!(Answer::of(slow).status, 408);
}

#[cfg(unix)]
#[test]
fn of_200_programs_at_once_some_run_and_the_others_are_told_to_come_again() {
    let server = Server::start();
    let body = crate::run::asking("println!(\"done\");");
    let reader = server.reader();
    let waiting: Vec<_> = (0..200).map(|_| server.send(RUN, &reader, &body)).collect();
    server.assert_readable();
    let answers: Vec<Answer> = waiting.into_iter().map(Answer::of).collect();
    let ran = answers.iter().filter(|answer| answer.status == 200).count();
    let refused: Vec<_> = answers
        .iter()
        .filter(|answer| answer.status == 503)
        .collect();
    assert_eq!(ran + refused.len(), 200, "{answers:?}");
    // As many as have a place; more if some were done before the last ones came.
    assert!(ran >= AT_ONCE + WAITING, "only {ran} ran");
    assert!(!refused.is_empty(), "the queue has no end");
    for answer in refused {
        assert_eq!(answer.header("retry-after"), Some("1"));
        assert!(answer.body.contains("next step"), "{answer:?}");
    }
    for answer in answers.iter().filter(|answer| answer.status == 200) {
        assert!(answer.body.contains("done\\n"), "{answer:?}");
    }
    let answer = server.ask(RUN, &reader, &body);
    assert_eq!(answer.status, 200, "{answer:?}");
}

#[test]
fn two_hundred_readers_at_once_all_read() {
    let server = Server::start();
    let line = "GET /bezier/shape.html";
    let asked: Vec<_> = (0..200)
        .map(|_| server.send(line, &server.visitor(), ""))
        .collect();
    for answer in asked.into_iter().map(Answer::of) {
        assert_eq!(answer.status, 200, "{answer:?}");
    }
}

#[tokio::test(flavor = "multi_thread")]
async fn never_more_than_two_run_and_no_more_wait_than_have_a_place() {
    let (_end, closing) = watch::channel(false);
    let queue = Queue::new(closing);
    let (now, most) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicUsize::new(0)));
    let tasks: Vec<_> = (0..200)
        .map(|_| {
            let (queue, now, most) = (queue.clone(), Arc::clone(&now), Arc::clone(&most));
            tokio::spawn(async move {
                let work = move |_| {
                    most.fetch_max(now.fetch_add(1, Ordering::SeqCst) + 1, Ordering::SeqCst);
                    std::thread::sleep(Duration::from_millis(20));
                    now.fetch_sub(1, Ordering::SeqCst);
                };
                queue.run(work).await
            })
        })
        .collect();
    let mut done = 0;
    for task in tasks {
        match task.await.expect("no panic") {
            Ok(()) => done += 1,
            Err(error) => assert_eq!(error, QueueError::Full),
        }
    }
    assert_eq!(most.load(Ordering::SeqCst), AT_ONCE);
    assert!((AT_ONCE + WAITING..200).contains(&done), "{done} ran");
}

#[tokio::test(flavor = "multi_thread")]
async fn work_is_told_to_stop_when_its_request_is_given_up_or_the_server_ends() {
    for server_ends in [false, true] {
        let (end, closing) = watch::channel(false);
        let queue = Queue::new(closing);
        let (tell, mut ended) = tokio::sync::mpsc::unbounded_channel();
        let begun = Arc::new(AtomicUsize::new(0));
        let request = tokio::spawn({
            let (queue, begun) = (queue.clone(), Arc::clone(&begun));
            async move {
                let work = move |stop: cagd::workbook::server::queue::Stop| {
                    begun.store(1, Ordering::SeqCst);
                    let patience = Instant::now() + Duration::from_secs(10);
                    while !stop.load(Ordering::Relaxed) && Instant::now() < patience {
                        std::thread::sleep(Duration::from_millis(1));
                    }
                    let told = stop.load(Ordering::Relaxed);
                    tell.send(told).expect("the test listens");
                };
                queue.run(work).await
            }
        });
        while begun.load(Ordering::SeqCst) == 0 {
            tokio::time::sleep(Duration::from_millis(1)).await;
        }
        match server_ends {
            true => end.send(true).expect("the queue listens"),
            false => request.abort(),
        }
        assert_eq!(ended.recv().await, Some(true));
    }
}
