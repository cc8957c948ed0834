//! The token of one start of the server: whoever has it may run code.
//!
//! The link that the server prints holds it.
//! The browser exchanges it for a cookie, so that it stands in no address that a page could pass on.

use std::fmt;

use axum::http::{HeaderMap, header};
use sha2::{Digest, Sha256};

use super::ServerError;

/// Hands the token on when a new program takes the place of this one, so that open pages go on working.
///
/// Unlike the arguments, other users cannot read the environment of a process.
pub(crate) const VARIABLE: &str = "WORKBOOK_TOKEN";

/// How many random bytes: no number of guesses is worth mentioning.
const BYTES: usize = 32;

/// What the link holds and the cookie repeats.
#[derive(Clone)]
pub struct Token(String);

impl Token {
    /// A new token, or the one that the program before this one has handed on.
    ///
    /// # Errors
    ///
    /// [`ServerError::Token`] if the system gives no random bytes.
    pub fn for_this_start() -> Result<Self, ServerError> {
        match std::env::var(VARIABLE) {
            Ok(text) if is_token(&text) => Ok(Self(text)),
            _ => Self::random(),
        }
    }

    /// A token that nobody has had before.
    ///
    /// # Errors
    ///
    /// [`ServerError::Token`] if the system gives no random bytes.
    pub fn random() -> Result<Self, ServerError> {
        let mut bytes = [0; BYTES];
        getrandom::fill(&mut bytes)?;
        Ok(Self(
            bytes.iter().map(|byte| format!("{byte:02x}")).collect(),
        ))
    }

    /// The text, for the link and for the program that comes after this one.
    #[must_use]
    pub fn text(&self) -> &str {
        &self.0
    }

    /// Whether this is the token.
    ///
    /// Digests are compared, so that the time it takes tells nothing about the token.
    #[must_use]
    pub fn is(&self, text: &str) -> bool {
        Sha256::digest(text) == Sha256::digest(&self.0)
    }

    /// Whether a request brings the cookie with the token.
    pub(super) fn is_in(&self, headers: &HeaderMap, port: u16) -> bool {
        let name = cookie_name(port);
        headers
            .get_all(header::COOKIE)
            .iter()
            .filter_map(|line| line.to_str().ok())
            .flat_map(|line| line.split(';'))
            .filter_map(|pair| pair.trim().split_once('='))
            .any(|(found, value)| found == name && self.is(value))
    }

    /// The cookie with the token.
    ///
    /// It ends with the browser's session, no script reads it, and no other site's page sends it along.
    pub(super) fn cookie(&self, port: u16) -> String {
        let name = cookie_name(port);
        format!("{name}={}; Path=/; HttpOnly; SameSite=Strict", self.0)
    }
}

/// A token stays out of logs and messages.
impl fmt::Debug for Token {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Token(…)")
    }
}

/// Cookies know no ports: two workbooks at once would otherwise take each other's.
fn cookie_name(port: u16) -> String {
    format!("workbook-{port}")
}

fn is_token(text: &str) -> bool {
    text.len() == 2 * BYTES && text.bytes().all(|byte| byte.is_ascii_hexdigit())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_cookie_is_found_among_others_and_by_its_port() {
        let token = Token::random().expect("random bytes");
        let with = |cookies: String| {
            let mut headers = HeaderMap::new();
            headers.insert(header::COOKIE, cookies.parse().expect("a header"));
            headers
        };
        let text = token.text();
        assert!(token.is_in(
            &with(format!("theme=navy; workbook-3000={text}; a=b")),
            3000
        ));
        assert!(!token.is_in(&with(format!("workbook-3001={text}")), 3000));
        assert!(!token.is_in(&with(format!("workbook-3000={text}0")), 3000));
        assert!(!token.is_in(&HeaderMap::new(), 3000));
    }

    #[test]
    fn two_starts_have_two_tokens_which_no_message_shows() {
        let [one, other] = [(); 2].map(|()| Token::random().expect("random bytes"));
        assert!(is_token(one.text()) && one.is(one.text()));
        assert!(!one.is(other.text()) && !one.is(""));
        assert_eq!(format!("{one:?}"), "Token(…)");
    }
}
