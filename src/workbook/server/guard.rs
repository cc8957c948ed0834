//! Who may do what: three questions before a request gets anywhere.
//!
//! | question | asked of | otherwise |
//! |---|---|---|
//! | Is the host this machine, by a name that nobody else can own? | every request | 421: another site's name leads here (DNS rebinding) |
//! | Does it come from a page of this server? | what a page posts | 403: another site's page asks through the reader's browser |
//! | Does it bring the token of this start? | what runs code or shows answers | 403: any program on this machine could ask |
//!
//! Then the whole request is read, within a limit of size and time, before anything runs.

use std::time::Duration;

use axum::Router;
use axum::body::{Body, to_bytes};
use axum::extract::{Request, State as Shared};
use axum::http::{HeaderMap, Method, StatusCode, header};
use axum::middleware::{self, Next};
use axum::response::{IntoResponse, Response};
use thiserror::Error;

use super::Site;

/// The largest request: a program has some kilobytes.
pub const LARGEST_REQUEST: usize = 256 << 10;

/// How long a request may take to arrive; on one machine it takes no time.
pub const LONGEST_ARRIVAL: Duration = Duration::from_secs(10);

/// Why a request is refused.
#[derive(Debug, Error, Clone, Copy, PartialEq, Eq)]
pub enum Refusal {
    /// The name in the address is another.
    #[error(
        "this server answers only to 127.0.0.1 and localhost\nnext step: open the link that `cargo run` has printed"
    )]
    Host,
    /// A page of another site asks.
    #[error("only the pages of this book may ask for this")]
    Origin,
    /// The token is missing or of an earlier start.
    #[error(
        "this page can be read, but it may not run code: it was opened without the link that `cargo run` has printed, or the server was started anew\n\
         next step: open that link from the terminal"
    )]
    Token,
    /// The body is too large.
    #[error("a request may have {} KiB\nnext step: shorten the program", LARGEST_REQUEST >> 10)]
    TooLarge,
    /// The body does not arrive.
    #[error("the request did not arrive within {} s", LONGEST_ARRIVAL.as_secs())]
    TooSlow,
}

impl IntoResponse for Refusal {
    fn into_response(self) -> Response {
        let status = match self {
            Self::Host => StatusCode::MISDIRECTED_REQUEST,
            Self::Origin | Self::Token => StatusCode::FORBIDDEN,
            Self::TooLarge => StatusCode::PAYLOAD_TOO_LARGE,
            Self::TooSlow => StatusCode::REQUEST_TIMEOUT,
        };
        (status, self.to_string()).into_response()
    }
}

/// Puts routes behind all three questions and the limits of a request.
///
/// A handler behind it takes the body as `String`, `Bytes` or `Json`; what it runs goes through [`super::Queue::run`].
pub(super) fn for_the_reader(routes: Router<Site>, site: &Site) -> Router<Site> {
    routes.route_layer(middleware::from_fn_with_state(site.clone(), ask_for_token))
}

/// Puts routes behind the questions after host and origin, for what any reader of the pages may do.
pub(super) fn for_our_pages(routes: Router<Site>, site: &Site) -> Router<Site> {
    routes.route_layer(middleware::from_fn_with_state(site.clone(), ask_for_origin))
}

async fn ask_for_token(Shared(site): Shared<Site>, request: Request, next: Next) -> Response {
    if !site.knows(request.headers()) {
        // The other refusal comes first: a foreign page learns nothing about tokens.
        return match comes_from_our_page(&request) {
            true => Refusal::Token.into_response(),
            false => Refusal::Origin.into_response(),
        };
    }
    admit(request, next).await
}

async fn ask_for_origin(request: Request, next: Next) -> Response {
    admit(request, next).await
}

/// Asks where the request comes from, and reads all of it.
async fn admit(request: Request, next: Next) -> Response {
    if !comes_from_our_page(&request) {
        return Refusal::Origin.into_response();
    }
    let (head, body) = request.into_parts();
    let arrival = tokio::time::timeout(LONGEST_ARRIVAL, to_bytes(body, LARGEST_REQUEST));
    match arrival.await {
        Ok(Ok(bytes)) => next.run(Request::from_parts(head, Body::from(bytes))).await,
        Ok(Err(_)) => Refusal::TooLarge.into_response(),
        Err(_) => Refusal::TooSlow.into_response(),
    }
}

/// Lets only requests pass that name this machine.
pub(super) async fn ask_for_host(
    Shared(site): Shared<Site>,
    request: Request,
    next: Next,
) -> Response {
    let in_address = request
        .uri()
        .authority()
        .map(|authority| authority.as_str());
    let named = one(request.headers(), header::HOST);
    let is_ours = |host: &str| site.hosts.iter().any(|ours| ours == host);
    if named.is_some_and(is_ours) && in_address.is_none_or(is_ours) {
        next.run(request).await
    } else {
        Refusal::Host.into_response()
    }
}

/// Whether the browser says that a page of this server asks.
///
/// A browser names the origin of whatever is posted. Of a question it names it only if another site asks,
/// or says so in `Sec-Fetch-Site`.
fn comes_from_our_page(request: &Request) -> bool {
    let headers = request.headers();
    let host = one(headers, header::HOST).unwrap_or_default();
    let only_asks = matches!(*request.method(), Method::GET | Method::HEAD);
    let origin = match headers.contains_key(header::ORIGIN) {
        true => one(headers, header::ORIGIN)
            .and_then(|origin| origin.strip_prefix("http://"))
            .is_some_and(|origin| origin == host),
        false => only_asks,
    };
    let site = one(headers, header::HeaderName::from_static("sec-fetch-site"));
    // A reader who types the address asks by himself: "none".
    origin && site.is_none_or(|site| site == "same-origin" || (only_asks && site == "none"))
}

/// The value of a header that stands there exactly once.
fn one(headers: &HeaderMap, name: header::HeaderName) -> Option<&str> {
    let mut values = headers.get_all(name).iter();
    match (values.next(), values.next()) {
        (Some(value), None) => value.to_str().ok(),
        _ => None,
    }
}
