//! The pages as they are served: as they were built, with what ties them to this server.

use axum::body::{Body, to_bytes};
use axum::extract::{Request, State as Shared};
use axum::http::{HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::{Html, IntoResponse, Response};

use super::{Site, State, policy};

const RELOAD_SCRIPT: &str = include_str!("reload.html");

/// Stands above the text where the reader has not come by the link with the token.
const READ_ONLY: &str = "<p class=\"read-only\" role=\"note\">This page is open for reading. \
     To run its code and to check your answers, open the link that <code>cargo run</code> has printed in the terminal: \
     it ends in <code>?token=…</code>.</p>";

/// Adds the scripts of the server to pages, and answers with a page of its own while there is no book yet.
pub(super) async fn dress(Shared(site): Shared<Site>, request: Request, next: Next) -> Response {
    let asks_for_news = request.uri().path() == "/__workbook/state";
    let state = site.state.borrow().clone();
    if !state.ready && !asks_for_news {
        return waiting_page(&state);
    }
    let may_run = site.knows(request.headers());
    let response = next.run(request).await;
    let is_page = response
        .headers()
        .get(header::CONTENT_TYPE)
        .is_some_and(|kind| kind.as_bytes().starts_with(b"text/html"));
    if !is_page {
        return response;
    }
    let (mut head, body) = response.into_parts();
    // The pages are files of our own, so there is no reason to cap their size.
    let Ok(bytes) = to_bytes(body, usize::MAX).await else {
        return StatusCode::INTERNAL_SERVER_ERROR.into_response();
    };
    // These describe the file, not the page with the script. A browser that kept an older script by them would find
    // another version at each question and reload without end.
    for name in [
        header::CONTENT_LENGTH,
        header::ACCEPT_RANGES,
        header::ETAG,
        header::LAST_MODIFIED,
    ] {
        head.headers.remove(name);
    }
    let page = with_server(&String::from_utf8_lossy(&bytes), &state.version, may_run);
    under_policy(Response::from_parts(head, Body::empty()), page)
}

/// The page with the scripts of the server.
fn with_server(page: &str, version: &str, may_run: bool) -> String {
    // Before any other script asks whether a server answers.
    let hello = format!("<head><script>window.workbookServer = {{ mayRun: {may_run} }};</script>");
    let page = page.replacen("<head>", &hello, 1);
    let page = match may_run {
        true => page,
        false => page.replacen("<main>", &format!("<main>{READ_ONLY}"), 1),
    };
    let script = RELOAD_SCRIPT.replace("{{version}}", version);
    match page.rfind("</body>") {
        Some(end) => format!("{}{script}{}", &page[..end], &page[end..]),
        None => format!("{page}{script}"),
    }
}

/// The response with this page for its body and the policy of the page.
fn under_policy(mut response: Response, page: String) -> Response {
    // Digests and the names of the rules are plain ASCII.
    if let Ok(policy) = HeaderValue::from_str(&policy::of_page(&page)) {
        response
            .headers_mut()
            .insert(header::CONTENT_SECURITY_POLICY, policy);
    }
    *response.body_mut() = Body::from(page);
    response
}

/// A page of the server itself, where there is no page of the book.
pub(super) fn own_page(status: StatusCode, title: &str, text: &str) -> Response {
    under_policy((status, Html("")).into_response(), own_text(title, text))
}

fn own_text(title: &str, text: &str) -> String {
    format!(
        "<!DOCTYPE html><html lang=\"en\"><head><meta charset=\"utf-8\">\
         <meta name=\"viewport\" content=\"width=device-width\">\
         <meta name=\"color-scheme\" content=\"light dark\"><title>{title}</title></head>\
         <body style=\"font-family: system-ui, sans-serif; max-width: 40em; margin: 3em auto; padding: 0 1em\">\
         <h1>{title}</h1>{text}</body></html>"
    )
}

/// Stands in for every page until a build has succeeded.
fn waiting_page(state: &State) -> Response {
    let page = own_text(
        "The book cannot be built yet",
        "<p>This page turns into the book as soon as the error below is mended.</p>",
    );
    let page = with_server(&page, &state.version, false);
    let response = (StatusCode::SERVICE_UNAVAILABLE, Html("")).into_response();
    under_policy(response, page)
}
