//! What a test program tells the workbook, line by line.
//!
//! Each [`Message`] is one line of fields between tabs; tabs, line ends and backslashes inside a field are escaped.
//! Both sides of the channel use this file, so they cannot drift apart.

use std::fmt;

use super::picture::{Picture, Role, Stroke};

/// What a failed claim found.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Finding {
    /// What was tested.
    pub claim: String,
    /// With which input; empty if the test does not say.
    pub input: String,
    /// What is right.
    pub expected: String,
    /// What the answer gave.
    pub found: String,
    /// The wrong curve beside the right one.
    pub picture: Option<Picture>,
}

impl fmt::Display for Finding {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "tested: {}", self.claim)?;
        if !self.input.is_empty() {
            write!(f, "\ninput: {}", self.input)?;
        }
        write!(f, "\nexpected: {}\nfound: {}", self.expected, self.found)
    }
}

/// Why a test failed.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Failure {
    /// The words of the panic.
    pub message: String,
    /// Where it panicked, `file:line`; empty if unknown.
    pub place: String,
    /// What the claim found, if the test made one.
    pub finding: Option<Finding>,
}

/// One line of the channel.
#[derive(Debug, Clone, PartialEq)]
pub enum Message {
    /// The test of this name begins.
    Begin(String),
    /// It passed.
    Passed(String),
    /// It failed.
    Failed(String, Failure),
    /// What the answer does on the probe inputs.
    Probes(Vec<String>),
    /// All that was asked for has run.
    Done,
}

impl Message {
    /// The message as one line, without its end.
    #[must_use]
    pub fn to_line(&self) -> String {
        let fields: Vec<String> = match self {
            Self::Begin(test) => vec!["begin".into(), test.clone()],
            Self::Passed(test) => vec!["passed".into(), test.clone()],
            Self::Failed(test, failure) => {
                let mut fields = vec![
                    "failed".into(),
                    test.clone(),
                    failure.message.clone(),
                    failure.place.clone(),
                ];
                if let Some(finding) = &failure.finding {
                    fields.extend([
                        finding.claim.clone(),
                        finding.input.clone(),
                        finding.expected.clone(),
                        finding.found.clone(),
                    ]);
                    fields.extend(finding.picture.as_ref().map(picture_to_text));
                }
                fields
            }
            Self::Probes(values) => std::iter::once("probes".to_owned())
                .chain(values.iter().cloned())
                .collect(),
            Self::Done => vec!["done".into()],
        };
        let escaped: Vec<String> = fields.iter().map(|field| escape(field)).collect();
        escaped.join("\t")
    }

    /// The message of a line; `None` if no program of ours has written it.
    #[must_use]
    pub fn from_line(line: &str) -> Option<Self> {
        let fields: Vec<String> = line.split('\t').map(unescape).collect();
        let fields: Vec<&str> = fields.iter().map(String::as_str).collect();
        match fields.as_slice() {
            ["begin", test] => Some(Self::Begin((*test).into())),
            ["passed", test] => Some(Self::Passed((*test).into())),
            ["failed", test, message, place, finding @ ..] => {
                let finding = match finding {
                    [] => None,
                    [claim, input, expected, found, picture @ ..] => Some(Finding {
                        claim: (*claim).into(),
                        input: (*input).into(),
                        expected: (*expected).into(),
                        found: (*found).into(),
                        picture: match picture {
                            [] => None,
                            [text] => Some(picture_from_text(text)?),
                            _ => return None,
                        },
                    }),
                    _ => return None,
                };
                let failure = Failure {
                    message: (*message).into(),
                    place: (*place).into(),
                    finding,
                };
                Some(Self::Failed((*test).into(), failure))
            }
            ["probes", values @ ..] => {
                Some(Self::Probes(values.iter().map(|&v| v.into()).collect()))
            }
            ["done"] => Some(Self::Done),
            _ => None,
        }
    }
}

fn escape(field: &str) -> String {
    field
        .replace('\\', r"\\")
        .replace('\t', r"\t")
        .replace('\n', r"\n")
        .replace('\r', r"\r")
}

fn unescape(field: &str) -> String {
    let mut text = String::with_capacity(field.len());
    let mut letters = field.chars();
    while let Some(letter) = letters.next() {
        text.push(match letter {
            '\\' => match letters.next() {
                Some('t') => '\t',
                Some('n') => '\n',
                Some('r') => '\r',
                Some(other) => other,
                None => break,
            },
            other => other,
        });
    }
    text
}

/// `given 0,0 1,2;found 0.5,1`
fn picture_to_text(picture: &Picture) -> String {
    let strokes: Vec<String> = picture
        .strokes
        .iter()
        .map(|stroke| {
            let role = match stroke.role {
                Role::Given => "given",
                Role::Expected => "expected",
                Role::Found => "found",
            };
            let points = stroke.points.iter().map(|[x, y]| format!(" {x},{y}"));
            std::iter::once(role.to_owned()).chain(points).collect()
        })
        .collect();
    strokes.join(";")
}

fn picture_from_text(text: &str) -> Option<Picture> {
    let mut picture = Picture::new();
    for stroke in text.split(';').filter(|stroke| !stroke.is_empty()) {
        let mut words = stroke.split(' ');
        let role = match words.next()? {
            "given" => Role::Given,
            "expected" => Role::Expected,
            "found" => Role::Found,
            _ => return None,
        };
        let points = words
            .map(|word| {
                let (x, y) = word.split_once(',')?;
                Some([x.parse().ok()?, y.parse().ok()?])
            })
            .collect::<Option<_>>()?;
        picture.strokes.push(Stroke { role, points });
    }
    Some(picture)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_message_survives_the_channel() {
        let mut picture = Picture::new();
        picture.strokes.push(Stroke {
            role: Role::Found,
            points: vec![[0.1, -2.0], [f64::INFINITY, 1e-300]],
        });
        let finding = Finding {
            claim: "b(½)\tof\nall \\n".into(),
            input: String::new(),
            expected: "1/2".into(),
            found: "\\".into(),
            picture: Some(picture),
        };
        let failure = |finding| Failure {
            message: "line\r\n\tline".into(),
            place: "tests.rs:3".into(),
            finding,
        };
        for message in [
            Message::Begin("a".into()),
            Message::Passed("a".into()),
            Message::Failed("a".into(), failure(None)),
            Message::Failed("a".into(), failure(Some(Finding::default()))),
            Message::Failed("a".into(), failure(Some(finding))),
            Message::Probes(vec!["1/2".into(), String::new()]),
            Message::Done,
        ] {
            let line = message.to_line();
            assert!(!line.contains('\n'), "{line}");
            assert_eq!(Message::from_line(&line), Some(message));
        }
    }

    #[test]
    fn foreign_lines_are_no_messages() {
        for line in [
            "",
            "test result: ok",
            "passed",
            "passed\ta\tb",
            "failed\ta\tm\tp\tclaim",
        ] {
            assert_eq!(Message::from_line(line), None, "{line}");
        }
    }
}
