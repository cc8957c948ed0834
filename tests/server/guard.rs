//! Nobody else gets in: other hosts, other sites, other programs.

use cagd::workbook::server::Token;

use crate::support::{Answer, Server, with};

const RUN: &str = "POST /__workbook/run";
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
    for line in ["GET /", "GET /__workbook/state", FIGURE, RUN] {
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
        for line in [FIGURE, RUN] {
            let answer = server.ask(line, &with(&reader, "Origin", origin), "x");
            assert_eq!(answer.status, 403, "{line} of {origin:?}: {answer:?}");
        }
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

#[test]
fn nothing_runs_without_the_token_of_this_start() {
    let server = Server::start();
    let port = server.address.port();
    let (reader, token) = (server.reader(), server.token.text());
    let other = Token::random().expect("random bytes");
    let wrong = [
        None,
        Some(String::new()),
        Some(format!("workbook-{port}=")),
        Some(format!("workbook-{port}={}", other.text())),
        Some(format!("workbook-{port}={}", &token[..token.len() - 1])),
        Some(format!("workbook-{}={token}", port.wrapping_add(1))),
        Some(format!("workbook={token}")),
    ];
    for cookie in &wrong {
        let answer = server.ask(RUN, &with(&reader, "Cookie", cookie.as_deref()), "{}");
        assert_eq!(answer.status, 403, "{cookie:?}: {answer:?}");
        assert!(answer.body.contains("cargo run"), "{answer:?}");
    }
    // The token in the address opens the door and does nothing else.
    let line = format!("{RUN}?token={token}");
    let answer = server.ask(&line, &with(&reader, "Cookie", None), "{}");
    assert_eq!(answer.status, 405, "{answer:?}");
    // A foreign page is not told that a token would help.
    let foreign = with(
        &with(&reader, "Cookie", None),
        "Origin",
        Some("http://evil.example"),
    );
    let answer = server.ask(RUN, &foreign, "{}");
    assert!(!answer.body.contains("link"), "{answer:?}");
    // With everything in its place the request is read: it has no code.
    let answer = server.ask(RUN, &reader, "{}");
    assert_eq!(answer.status, 422, "{answer:?}");
}

#[test]
fn a_form_of_another_site_could_not_even_write_the_request() {
    let server = Server::start();
    let mut plain = server.reader();
    plain.push(("Content-Type".into(), "text/plain".into()));
    plain.push(("Content-Length".into(), "12".into()));
    let mut stream = server.send(RUN, &plain, "");
    std::io::Write::write_all(&mut stream, b"{\"code\":\"1\"}").expect("it is read");
    assert_eq!(Answer::of(stream).status, 415);
}

#[test]
fn no_path_leads_out_of_the_book() {
    let server = Server::start();
    let ways = [
        "/../secret.txt",
        "/bezier/../../secret.txt",
        "/%2e%2e/secret.txt",
        "/%2E%2E%2Fsecret.txt",
        "/..%2fsecret.txt",
        "/..%5csecret.txt",
        "/..\\secret.txt",
        "/bezier/..%2f..%2fsecret.txt",
        "/....//secret.txt",
        "/.%00./secret.txt",
        "/%252e%252e/secret.txt",
        "//etc/passwd",
        "/%2fetc%2fpasswd",
    ];
    for way in ways {
        for headers in [server.visitor(), server.reader()] {
            let answer = server.ask(&format!("GET {way}"), &headers, "");
            assert_ne!(answer.status, 200, "{way}: {answer:?}");
            assert!(!answer.body.contains("a secret"), "{way}: {answer:?}");
            assert!(!answer.body.contains("root:"), "{way}: {answer:?}");
        }
    }
    server.assert_readable();
}

#[test]
fn each_page_has_a_policy_that_runs_its_own_scripts_alone() {
    let server = Server::start();
    let answer = server.ask("GET /bezier/shape.html", &server.reader(), "");
    let policy = answer.header("content-security-policy").expect("a policy");
    assert!(policy.starts_with("default-src 'none';"), "{policy}");
    // The page's own, the one that tells of the server, the one that reloads.
    assert_eq!(policy.matches("'sha256-").count(), 3, "{policy}");
    let scripts = policy.split(';').find(|rule| rule.contains("script-src"));
    assert!(
        !scripts.expect("a rule").contains("unsafe-inline"),
        "{policy}"
    );
    let answer = server.ask("GET /__workbook/state", &server.reader(), "");
    let policy = answer.header("content-security-policy").expect("a policy");
    assert!(policy.starts_with("default-src 'none'"), "{policy}");
    assert_eq!(answer.header("x-content-type-options"), Some("nosniff"));
}
