//! The server: what it answers, and what an edit does to it.

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Stdio};
use std::time::{Duration, Instant};

use super::house::{House, PAGE};

/// A server on a free port, ended with the test.
struct Server {
    child: Child,
    address: String,
}

impl Server {
    fn of(house: &House) -> Self {
        let mut child = house
            .command(&["--port", "0"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("the server starts");
        let mut lines = BufReader::new(child.stdout.take().expect("it is piped")).lines();
        let address = lines
            .by_ref()
            .map_while(Result::ok)
            .find_map(|line| {
                let (_, rest) = line.split_once("http://")?;
                Some(rest.split('/').next()?.to_owned())
            })
            .expect("the server tells its address");
        // What it prints later must not fill the pipe.
        std::thread::spawn(move || lines.for_each(drop));
        Self { child, address }
    }

    /// The status line with the headers, and the body.
    fn get(&self, path: &str) -> (String, String) {
        let mut stream = TcpStream::connect(&self.address).expect("the server listens");
        let request = format!(
            "GET {path} HTTP/1.1\r\nHost: {}\r\nConnection: close\r\n\r\n",
            self.address
        );
        stream
            .write_all(request.as_bytes())
            .expect("it reads the request");
        let mut answer = Vec::new();
        stream.read_to_end(&mut answer).expect("it answers");
        let answer = String::from_utf8_lossy(&answer).into_owned();
        let (head, body) = answer.split_once("\r\n\r\n").expect("an HTTP answer");
        (head.to_owned(), body.to_owned())
    }

    fn state(&self) -> serde_json::Value {
        let (_, body) = self.get("/__workbook/state");
        serde_json::from_str(&body).expect("the state is JSON")
    }

    /// Asks for the state until it fits; gives up after a time that no healthy build needs.
    #[track_caller]
    fn wait_until(&self, fits: impl Fn(&serde_json::Value) -> bool) -> serde_json::Value {
        let end = Instant::now() + Duration::from_secs(60);
        loop {
            let state = self.state();
            if fits(&state) {
                return state;
            }
            assert!(Instant::now() < end, "the server stays at {state}");
            std::thread::sleep(Duration::from_millis(50));
        }
    }
}

impl Drop for Server {
    fn drop(&mut self) {
        // It may have ended by itself; then there is nothing to do.
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

/// The addresses of what a page loads, as opposed to what it links to.
fn loaded(page: &str) -> Vec<&str> {
    let attributes = ["src=\"", "<link rel=\"stylesheet\" href=\"", "url("];
    attributes
        .iter()
        .flat_map(|attribute| page.split(attribute).skip(1))
        .filter_map(|rest| rest.split(['"', ')']).next())
        .collect()
}

#[test]
fn it_answers_on_loopback_and_loads_nothing_from_outside() {
    let house = House::new();
    let server = Server::of(&house);
    assert!(
        server.address.starts_with("127.0.0.1:"),
        "{}",
        server.address
    );
    for path in ["/", "/bezier/de-casteljau.html"] {
        let (head, page) = server.get(path);
        assert!(head.starts_with("HTTP/1.1 200"), "{path}: {head}");
        // A page kept from an earlier run would reload without end.
        let head = head.to_lowercase();
        assert!(
            !head.contains("etag") && !head.contains("last-modified"),
            "{head}"
        );
        let outside: Vec<&str> = loaded(&page)
            .into_iter()
            .filter(|address| address.contains("//"))
            .collect();
        assert!(outside.is_empty(), "{path} loads {outside:?}");
    }
    let (head, page) = server.get("/no-such-page.html");
    assert!(head.starts_with("HTTP/1.1 404"), "{head}");
    assert!(
        page.contains("</html>"),
        "the book has a page for what is missing"
    );
    let (head, body) = server.get("/../Cargo.toml");
    assert!(
        !body.contains("[package]"),
        "the server leaves its folder: {head}"
    );
}

#[test]
fn a_broken_edit_is_shown_and_the_last_good_book_stays() {
    let house = House::new();
    let server = Server::of(&house);
    let good = server.wait_until(|state| state["error"].is_null());
    let text = house.read(PAGE);

    house.write(PAGE, &format!("{text}\n{{{{#ref no-such-id}}}}\n"));
    let broken = server.wait_until(|state| !state["error"].is_null());
    let error = broken["error"].as_str().expect("the error is text");
    let place = format!("{PAGE}:{}", text.lines().count() + 2);
    assert!(error.contains(&place), "`{place}` is not in: {error}");
    assert_eq!(broken["version"], good["version"]);
    let (head, page) = server.get("/bezier/de-casteljau.html");
    assert!(head.starts_with("HTTP/1.1 200"), "{head}");
    assert!(page.contains("<main"), "the page is gone");

    house.write(PAGE, &format!("{text}\nA mended sentence.\n"));
    let mended = server.wait_until(|state| state["error"].is_null());
    assert_ne!(mended["version"], good["version"]);
    let (_, page) = server.get("/bezier/de-casteljau.html");
    assert!(page.contains("A mended sentence."));
}

#[test]
fn a_book_that_was_never_good_gives_a_page_that_waits() {
    let house = House::new();
    let text = house.read(PAGE);
    house.write(PAGE, &format!("{text}\n{{{{#ref no-such-id}}}}\n"));
    let server = Server::of(&house);
    let (head, page) = server.get("/");
    assert!(head.starts_with("HTTP/1.1 503"), "{head}");
    assert!(page.contains("/__workbook/state"), "{page}");
    house.write(PAGE, &text);
    server.wait_until(|state| state["ready"] == true);
    let (head, _) = server.get("/");
    assert!(head.starts_with("HTTP/1.1 200"), "{head}");
}
