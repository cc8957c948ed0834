//! The tests of an exercise, and the program that is made of them.

use std::path::{Path, PathBuf};

use proc_macro2::{Delimiter, Span, TokenStream, TokenTree};

use crate::book::error::{BookError, Problem};

/// One test of an exercise.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestItem {
    /// The name of the function.
    pub name: String,
    /// The line of `fn`, counted from 1.
    pub line: usize,
    /// Why it is there although it rejects nothing that no other test rejects: the doc comment `/// Why: …`.
    pub why: Option<String>,
}

/// The file `tests.rs`.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct TestsSource {
    /// The file, relative to the root of the package or as the pack was named.
    pub file: PathBuf,
    /// The source.
    pub text: String,
    /// The tests, in order.
    pub tests: Vec<TestItem>,
    /// Whether there is a function `probes`.
    pub has_probes: bool,
    /// Line and column, from 0, of each attribute `#[test]`.
    marks: Vec<(usize, usize)>,
}

impl TestsSource {
    /// Reads the source of `tests.rs`.
    ///
    /// # Errors
    ///
    /// A source that is no Rust or has no test, a test inside a module, an attribute that would keep a test from
    /// counting, and `use answer::*`.
    pub fn parse(file: &Path, text: &str) -> Result<Self, Vec<BookError>> {
        let tokens: TokenStream = text.parse().map_err(|e: proc_macro2::LexError| {
            let line = e.span().start().line;
            vec![mistake(
                file,
                line,
                format!("this is no Rust ({e})"),
                "mend it",
            )]
        })?;
        // The tokens may be in order and the items not.
        if let Err(e) = syn::parse2::<syn::File>(tokens.clone()) {
            let line = e.span().start().line;
            return Err(vec![mistake(
                file,
                line,
                format!("this is no Rust ({e})"),
                "mend it",
            )]);
        }
        let mut search = Search {
            file,
            tests: Vec::new(),
            marks: Vec::new(),
            has_probes: false,
            errors: Vec::new(),
        };
        search.items(tokens, true);
        if search.tests.is_empty() {
            let found = "the file has no test".to_owned();
            search.errors.push(mistake(
                file,
                1,
                found,
                "write a function with `#[test]`, or a `proptest!` block",
            ));
        }
        if search.errors.is_empty() {
            Ok(Self {
                file: file.to_owned(),
                text: text.to_owned(),
                tests: search.tests,
                has_probes: search.has_probes,
                marks: search.marks,
            })
        } else {
            Err(search.errors)
        }
    }

    /// The program that runs these tests; its lines are those of the source.
    ///
    /// The compiler would drop functions with `#[test]` from a plain program, and its own harness tells its verdict
    /// on standard output, where an answer can forge it. So the attribute gives way to one of the same length, and a
    /// `main` is written behind.
    pub fn program(&self) -> String {
        format!(
            "{}\nfn main() -> ::std::process::ExitCode {{ ::cagd::check::harness::main({}) }}\n",
            self.body(),
            self.entry()
        )
    }

    /// The same tests as a module of a program that tests several answers: those of the crate that is called `answer`
    /// there.
    pub fn module(&self, answer: &str) -> String {
        format!(
            "{}\nuse ::{answer} as answer;\n\
             pub fn workbook_entry() -> ::cagd::check::harness::Entry {{ ({}) }}\n",
            self.body(),
            self.entry()
        )
    }

    /// The source with functions that stay in a program.
    fn body(&self) -> String {
        let mut lines: Vec<String> = self.text.lines().map(str::to_owned).collect();
        for &(line, column) in &self.marks {
            let text = &mut lines[line];
            let start = text
                .char_indices()
                .nth(column)
                .map_or(text.len(), |(at, _)| at);
            if let Some(length) = text[start..].find(']') {
                text.replace_range(start..=start + length, "#[cold]");
            }
        }
        lines.join("\n")
    }

    /// What the harness runs: the tests with their names, and the probes.
    fn entry(&self) -> String {
        let tests: Vec<String> = self
            .tests
            .iter()
            .map(|test| format!("({:?}, {} as fn())", test.name, test.name))
            .collect();
        let probes = if self.has_probes {
            "probes"
        } else {
            "::std::vec::Vec::new"
        };
        format!("&[{}], {probes}", tests.join(", "))
    }
}

fn mistake(file: &Path, line: usize, found: impl Into<String>, remedy: &str) -> BookError {
    let (found, remedy) = (found.into(), remedy.to_owned());
    BookError::new(file, line.max(1), Problem::Exercise { found, remedy })
}

/// Walks the items of a file and of its `proptest!` blocks.
struct Search<'a> {
    file: &'a Path,
    tests: Vec<TestItem>,
    marks: Vec<(usize, usize)>,
    has_probes: bool,
    errors: Vec<BookError>,
}

/// The attributes in front of an item.
#[derive(Default)]
struct Attributes {
    test: Option<Span>,
    forbidden: Option<(String, Span)>,
    why: Option<String>,
}

impl Search<'_> {
    fn items(&mut self, tokens: TokenStream, outermost: bool) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        let mut attributes = Attributes::default();
        let mut at = 0;
        while at < tokens.len() {
            match &tokens[at..] {
                [TokenTree::Punct(hash), TokenTree::Group(group), ..]
                    if hash.as_char() == '#' && group.delimiter() == Delimiter::Bracket =>
                {
                    attributes.read(hash.span(), group.stream());
                    at += 1;
                }
                [TokenTree::Ident(keyword), TokenTree::Ident(name), ..] if keyword == "fn" => {
                    self.function(&name.to_string(), keyword.span(), &mut attributes);
                }
                [
                    TokenTree::Ident(keyword),
                    TokenTree::Ident(name),
                    TokenTree::Group(body),
                    ..,
                ] if keyword == "mod" => {
                    if holds_a_test(body.stream()) {
                        let line = keyword.span().start().line;
                        let found = format!("the module `{name}` holds a test");
                        self.errors.push(mistake(
                            self.file,
                            line,
                            found,
                            "write the tests outside of modules",
                        ));
                    }
                    attributes = Attributes::default();
                    at += 2;
                }
                [
                    TokenTree::Ident(name),
                    TokenTree::Punct(bang),
                    TokenTree::Group(body),
                    ..,
                ] if outermost && name == "proptest" && bang.as_char() == '!' => {
                    self.items(body.stream(), false);
                    attributes = Attributes::default();
                    at += 2;
                }
                [
                    TokenTree::Ident(name),
                    TokenTree::Punct(a),
                    TokenTree::Punct(b),
                    TokenTree::Punct(star),
                    ..,
                ] if name == "answer"
                    && [a.as_char(), b.as_char(), star.as_char()] == [':', ':', '*'] =>
                {
                    let line = name.span().start().line;
                    let remedy = "write `answer::` in front of each function; an answer could bring an `assert_eq!` of its own";
                    self.errors.push(mistake(
                        self.file,
                        line,
                        "everything of the answer is imported",
                        remedy,
                    ));
                }
                [TokenTree::Group(group), ..] if group.delimiter() == Delimiter::Brace => {
                    attributes = Attributes::default();
                }
                [TokenTree::Punct(end), ..] if end.as_char() == ';' => {
                    attributes = Attributes::default();
                }
                _ => {}
            }
            at += 1;
        }
    }

    fn function(&mut self, name: &str, keyword: Span, attributes: &mut Attributes) {
        let line = keyword.start().line;
        let attributes = std::mem::take(attributes);
        self.has_probes |= name == "probes";
        let Some(mark) = attributes.test else {
            return;
        };
        if let Some((found, span)) = attributes.forbidden {
            let found = format!("the test `{name}` has the attribute `{found}`");
            let remedy = "take it out; to expect a panic, call `std::panic::catch_unwind` and claim what it gives";
            self.errors
                .push(mistake(self.file, span.start().line, found, remedy));
        }
        if self.tests.iter().any(|test| test.name == name) {
            let found = format!("there are two tests `{name}`");
            self.errors
                .push(mistake(self.file, line, found, "rename one of them"));
        }
        self.tests.push(TestItem {
            name: name.to_owned(),
            line,
            why: attributes.why,
        });
        let start = mark.start();
        self.marks.push((start.line - 1, start.column));
    }
}

impl Attributes {
    fn read(&mut self, span: Span, tokens: TokenStream) {
        let tokens: Vec<TokenTree> = tokens.into_iter().collect();
        match tokens.as_slice() {
            [TokenTree::Ident(name)] if name == "test" => self.test = Some(span),
            [TokenTree::Ident(name), ..]
                if name == "ignore" || name == "should_panic" || name == "cfg" =>
            {
                self.forbidden = Some((name.to_string(), span));
            }
            [TokenTree::Ident(name), _, TokenTree::Literal(text)] if name == "doc" => {
                let text = syn::parse_str::<syn::LitStr>(&text.to_string())
                    .map(|text| text.value())
                    .unwrap_or_default();
                match (&mut self.why, text.trim().strip_prefix("Why:")) {
                    (_, Some(why)) => self.why = Some(why.trim().to_owned()),
                    (Some(why), None) => {
                        why.push(' ');
                        why.push_str(text.trim());
                    }
                    (None, None) => {}
                }
            }
            _ => {}
        }
    }
}

/// Whether `#[test]` stands anywhere inside.
fn holds_a_test(tokens: TokenStream) -> bool {
    tokens.into_iter().any(|token| match token {
        TokenTree::Group(group) => {
            let text = group.stream().to_string();
            (group.delimiter() == Delimiter::Bracket && text == "test")
                || holds_a_test(group.stream())
        }
        _ => false,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    const SOURCE: &str = r#"//! Tests.
use cagd::check::claim;

fn probes() -> Vec<String> {
    cagd::probes![answer::half(4)]
}

/// Why: it is the first thing a reader tries,
/// and easy to read.
#[test]
fn four() {
    claim("half of 4").equal(answer::half(4), 2);
}

proptest::proptest! {
    #![proptest_config(Default::default())]

    /// Any.
    #[test] fn any(n in 0..10) { let ü = n; claim("half").equal(answer::half(2 * ü), n) }
}
"#;

    fn parse(text: &str) -> Result<TestsSource, Vec<BookError>> {
        TestsSource::parse(Path::new("tests.rs"), text)
    }

    #[test]
    fn tests_are_found_with_their_reasons() {
        let source = parse(SOURCE).expect("the tests are right");
        let names: Vec<_> = source
            .tests
            .iter()
            .map(|t| (t.name.as_str(), t.line))
            .collect();
        assert_eq!(names, [("four", 11), ("any", 19)]);
        let why = "it is the first thing a reader tries, and easy to read.";
        assert_eq!(source.tests[0].why.as_deref(), Some(why));
        assert_eq!(source.tests[1].why, None);
        assert!(source.has_probes);
    }

    #[test]
    fn the_program_keeps_the_lines() {
        let program = parse(SOURCE).expect("the tests are right").program();
        assert!(!program.contains("#[test]"));
        assert_eq!(program.lines().nth(9), Some("#[cold]"));
        assert!(
            program
                .lines()
                .nth(18)
                .is_some_and(|line| line.starts_with("    #[cold] fn any("))
        );
        assert!(program.ends_with(
            "harness::main(&[(\"four\", four as fn()), (\"any\", any as fn())], probes) }\n"
        ));
    }

    #[test]
    fn what_would_not_count_is_refused() {
        let line = |text: &str| parse(text).expect_err("a mistake")[0].place.line;
        assert_eq!(line("fn f() {}\n"), 1);
        assert_eq!(line("fn f( {}\n"), 1);
        assert_eq!(line("#[test]\n#[ignore]\nfn f() {}\n"), 2);
        assert_eq!(
            line("#[test]\nfn f() {}\nmod m {\n#[test] fn g() {}\n}\n"),
            3
        );
        assert_eq!(line("use answer::*;\n#[test] fn f() {}\n"), 1);
        assert_eq!(line("#[test] fn f() {}\n#[test] fn f() {}\n"), 2);
    }
}
