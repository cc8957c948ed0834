//! The link with the token is exchanged for a cookie and leads on to the same page without the token.

use axum::extract::{Request, State as Shared};
use axum::http::{Method, StatusCode, Uri, header};
use axum::middleware::Next;
use axum::response::{IntoResponse, Response};

use super::Site;
use super::pages::own_page;

/// The name of the token in a link.
const PARAMETER: &str = "token";

/// Opens the door for who brings the token; who brings another one is told what to do.
pub(super) async fn enter(Shared(site): Shared<Site>, request: Request, next: Next) -> Response {
    let Some(given) = token_of(request.uri()) else {
        return next.run(request).await;
    };
    if *request.method() != Method::GET {
        return StatusCode::METHOD_NOT_ALLOWED.into_response();
    }
    if !site.token.is(given) {
        return own_page(
            StatusCode::FORBIDDEN,
            "This link is no longer valid",
            "<p>Each start of the server makes a link of its own.</p>\
             <p>Open the link that <code>cargo run</code> has printed last, or \
             <a href=\"/\">read the book</a> without running its code.</p>",
        );
    }
    let headers = [
        (header::SET_COOKIE, site.token.cookie(site.port)),
        (header::LOCATION, without_token(request.uri())),
    ];
    (StatusCode::SEE_OTHER, headers).into_response()
}

/// The token in the address, if there is one.
fn token_of(address: &Uri) -> Option<&str> {
    pairs(address).find_map(|(name, value)| (name == PARAMETER).then_some(value))
}

/// The same page without the token; the rest of the question stays, since it may hold the state of a figure.
fn without_token(address: &Uri) -> String {
    let rest: Vec<&str> = address
        .query()
        .unwrap_or_default()
        .split('&')
        .filter(|pair| {
            pair.split_once('=')
                .is_none_or(|(name, _)| name != PARAMETER)
        })
        .filter(|pair| !pair.is_empty())
        .collect();
    // Two slashes at the beginning would name another host.
    let path = format!("/{}", address.path().trim_start_matches('/'));
    match rest.is_empty() {
        true => path,
        false => format!("{path}?{}", rest.join("&")),
    }
}

fn pairs(address: &Uri) -> impl Iterator<Item = (&str, &str)> {
    address
        .query()
        .unwrap_or_default()
        .split('&')
        .filter_map(|pair| pair.split_once('='))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_way_on_is_the_same_page_on_this_server() {
        let leads = |from: &'static str| without_token(&Uri::from_static(from));
        assert_eq!(leads("/?token=ab"), "/");
        assert_eq!(
            leads("/bezier/shape.html?a=1&token=ab&b=2"),
            "/bezier/shape.html?a=1&b=2"
        );
        assert_eq!(
            leads("//elsewhere.example/?token=ab"),
            "/elsewhere.example/"
        );
        assert_eq!(token_of(&Uri::from_static("/?a=1&token=ab")), Some("ab"));
        assert_eq!(token_of(&Uri::from_static("/?mytoken=ab")), None);
    }
}
