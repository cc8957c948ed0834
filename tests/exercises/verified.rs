//! Every exercise of the book is proved sound.

use cagd::book::exercise::Exercise;
use cagd::workbook::verify::text::Text;
use cagd::workbook::verify::verify;

/// What has been verified before is not tried again; `cargo run -- verify` shows how far it is.
#[test]
fn every_exercise_is_sound() {
    let exercises = crate::exercises();
    let all: Vec<&Exercise> = exercises.iter().collect();
    let mut verified = verify(&crate::checker().patient(), &all, true, &|_| {})
        .unwrap_or_else(|error| panic!("{error}"));
    verified.retain(|verified| !verified.report.is_sound());
    let text = Text {
        verified: &verified,
        matrix: true,
    };
    assert!(
        verified.is_empty(),
        "\n{}",
        anstream::adapter::strip_str(&text.to_string())
    );
}
