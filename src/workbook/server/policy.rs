//! What the browser may do with a page of the book: the content-security policy and its kin.
//!
//! Everything comes from this server. The few scripts inside a page are named by their digests, so that whatever else
//! gets into a page does not run.

use axum::http::{HeaderMap, HeaderName, HeaderValue, header};
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use sha2::{Digest, Sha256};

/// For every answer, pages or not: it is what it says it is, and no other site's page may use it.
pub(super) fn set_for_all(headers: &mut HeaderMap) {
    let rules = [
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        // Not `no-referrer`: with it, the browser would hide the origin of what our own pages post.
        (header::REFERRER_POLICY, "same-origin"),
        (
            HeaderName::from_static("cross-origin-resource-policy"),
            "same-origin",
        ),
        (
            HeaderName::from_static("cross-origin-opener-policy"),
            "same-origin",
        ),
        // A browser must ask again each time: the same address changes with every edit.
        (header::CACHE_CONTROL, "no-cache"),
    ];
    for (name, value) in rules {
        headers.insert(name, HeaderValue::from_static(value));
    }
    // Whatever is no page needs nothing at all, should a browser take it for one.
    headers
        .entry(header::CONTENT_SECURITY_POLICY)
        .or_insert(HeaderValue::from_static(
            "default-src 'none'; frame-ancestors 'none'",
        ));
}

/// The policy of one page.
///
/// | allowed | for |
/// |---|---|
/// | scripts of this server, those inside the page, compiling WebAssembly | the theme, search, live figures |
/// | style in the page | drawings and formulas carry theirs |
/// | pictures as data | what a program draws is shown as a picture, in which no script runs |
/// | addresses that begin at this server | the page that says that another one is missing |
/// | frames of this server | mdBook's contents where scripts are off |
pub(super) fn of_page(page: &str) -> String {
    let digests: String = scripts_inside(page)
        .map(|script| format!(" 'sha256-{}'", STANDARD.encode(Sha256::digest(script))))
        .collect();
    format!(
        "default-src 'none'; script-src 'self' 'wasm-unsafe-eval'{digests}; style-src 'self' 'unsafe-inline'; \
         img-src 'self' data: blob:; font-src 'self' data:; connect-src 'self'; frame-src 'self'; \
         base-uri 'self'; form-action 'self'; frame-ancestors 'self'"
    )
}

/// The scripts that a page holds itself.
///
/// mdBook writes them with a bare tag; in text and code `<` is escaped.
fn scripts_inside(page: &str) -> impl Iterator<Item = &str> {
    page.split("<script>")
        .skip(1)
        .filter_map(|rest| rest.split_once("</script>"))
        .map(|(script, _)| script)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_script_inside_a_page_is_named_by_its_digest() {
        let page = "<head><script>a</script><script src=\"b.js\"></script></head>&lt;script>c&lt;/script><script>d\n</script>";
        assert_eq!(scripts_inside(page).collect::<Vec<_>>(), ["a", "d\n"]);
        let policy = of_page(page);
        // `printf a | openssl dgst -sha256 -binary | base64`
        assert!(
            policy.contains("'sha256-ypeBEsobvcr6wjGzmiPcTaeG7/gUfE5yuYB3ha/uSLs='"),
            "{policy}"
        );
        assert_eq!(policy.matches("'sha256-").count(), 2, "{policy}");
        assert!(!policy.contains("script-src 'self' 'unsafe"), "{policy}");
    }
}
