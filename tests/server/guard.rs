//! Nobody else gets in: other hosts, other sites, other programs.

use crate::support::{Server, with};

const FIGURE: &str = "POST /__workbook/figure";

#[test]
fn the_link_is_exchanged_for_a_cookie_that_no_script_and_no_other_site_gets() {
    let server = Server::start();
    let link = format!("GET /bezier/shape.html?a=1&token={}", server.token.text());
    let answer = server.ask(&link, &server.visitor(), "");
    assert_eq!(answer.status, 303, "{answer:?}");
    assert_eq!(answer.header("location"), Some("/bezier/shape.html?a=1"));
    let cookie = answer.header("set-cookie").expect("a cookie");
    let name = format!(
        "workbook-{}={};",
        server.address.port(),
        server.token.text()
    );
    assert!(cookie.starts_with(&name), "{cookie}");
    for rule in ["httponly", "samesite=strict", "path=/"] {
        assert!(cookie.contains(rule), "{cookie}");
    }
    assert!(!cookie.contains("domain"), "{cookie}");
}

#[test]
fn a_link_of_an_earlier_start_is_told_and_gives_no_cookie() {
    let server = Server::start();
    let answer = server.ask("GET /?token=0123", &server.visitor(), "");
    assert_eq!(answer.status, 403, "{answer:?}");
    assert!(answer.header("set-cookie").is_none(), "{answer:?}");
    assert!(answer.body.contains("cargo run"), "{answer:?}");
}

#[test]
fn without_the_token_the_book_is_read_and_says_where_the_link_is() {
    let server = Server::start();
    server.assert_readable();
    let answer = server.ask("GET /", &server.visitor(), "");
    assert!(answer.body.contains("mayRun: false"), "{answer:?}");
    assert!(answer.body.contains("?token=…"), "{answer:?}");
    let answer = server.ask("GET /", &server.reader(), "");
    assert!(answer.body.contains("mayRun: true"), "{answer:?}");
    assert!(!answer.body.contains("?token=…"), "{answer:?}");
}

#[test]
fn another_host_is_refused_whatever_it_asks() {
    let server = Server::start();
    let port = server.address.port();
    let foreign = [
        "evil.example".to_owned(),
        format!("evil.example:{port}"),
        "127.0.0.1".to_owned(),
        format!("127.0.0.1.evil.example:{port}"),
        String::new(),
    ];
    for line in ["GET /", "GET /__workbook/state", FIGURE] {
        for host in &foreign {
            let answer = server.ask(line, &with(&server.reader(), "Host", Some(host)), "");
            assert_eq!(answer.status, 421, "{line} of {host}: {answer:?}");
            assert!(!answer.body.contains("Read me."), "{answer:?}");
        }
    }
    // In the request's own line as well.
    let line = format!("GET http://evil.example:{port}/");
    assert_eq!(server.ask(&line, &server.reader(), "").status, 421);
    let localhost = format!("localhost:{port}");
    let answer = server.ask(
        "GET /",
        &with(&server.reader(), "Host", Some(&localhost)),
        "",
    );
    assert_eq!(answer.status, 200, "{answer:?}");
}

#[test]
fn another_origin_is_refused() {
    let server = Server::start();
    let reader = server.reader();
    let port = server.address.port();
    let neighbour = format!("http://127.0.0.1:{}", port.wrapping_add(1));
    let secure = format!("https://127.0.0.1:{port}");
    let foreign = ["http://evil.example", "null", &neighbour, &secure, ""];
    for origin in foreign.map(Some).into_iter().chain([None]) {
        let answer = server.ask(FIGURE, &with(&reader, "Origin", origin), "x");
        assert_eq!(answer.status, 403, "{origin:?}: {answer:?}");
    }
    let mut cross = reader.clone();
    cross.push(("Sec-Fetch-Site".into(), "same-site".into()));
    assert_eq!(server.ask(FIGURE, &cross, "x").status, 403);
    assert_eq!(server.ask(FIGURE, &reader, "x").status, 200);
    // The reader's browser is told to let no other site read or frame anything.
    let answer = server.ask("GET /", &reader, "");
    assert!(answer.header("access-control-allow-origin").is_none());
    assert_eq!(
        answer.header("cross-origin-resource-policy"),
        Some("same-origin")
    );
}
