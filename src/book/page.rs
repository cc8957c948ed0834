//! A page of the manuscript, taken apart: directives, statements, code blocks, formulas.
//!
//! Everything here keeps its line and its bytes, so that an error can name the line and an expansion can replace the
//! bytes. What stands in code is left alone.

use std::ops::Range;
use std::path::{Path, PathBuf};

use pulldown_cmark::{CodeBlockKind, Event, Options as Markdown, Parser, Tag, TagEnd};

use super::catalogue::{CHAPTERS, line_of};
use super::directive::{Action, Block, Directive, Options};
use super::error::{BookError, Problem};

/// A page of the manuscript.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Page {
    /// The file, relative to the root of the package: `book/src/bezier/shape.md`.
    pub file: PathBuf,
    /// The chapter it belongs to, from the folder it stands in; the introduction belongs to none.
    pub chapter: Option<&'static str>,
    /// The Markdown.
    pub text: String,
    /// Its directives, in order, those in code left out.
    pub directives: Vec<Directive>,
    /// Its statements, in order.
    pub statements: Vec<StatementBlock>,
    /// Its code blocks, in order.
    pub code: Vec<CodeBlock>,
    /// Its formulas, in order.
    pub formulas: Vec<Formula>,
}

/// A statement as it stands in a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct StatementBlock {
    /// The id that the directive gives.
    pub id: String,
    /// The names that the directive gives.
    pub options: Options,
    /// The bytes from the opening to the closing directive, both included.
    pub span: Range<usize>,
    /// The line of the opening directive.
    pub line: usize,
    /// Its proofs.
    pub proofs: Vec<InnerBlock>,
    /// What the lecture notes have wrong about it.
    pub errata: Vec<InnerBlock>,
    /// The figures in it: id and line.
    pub figures: Vec<(String, usize)>,
    /// Its code blocks, as indices into [`Page::code`], proofs and errata included.
    pub code: Vec<usize>,
}

/// A proof or an erratum inside a statement.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct InnerBlock {
    /// The bytes from the opening to the closing directive, both included.
    pub span: Range<usize>,
    /// The bytes between the two directives.
    pub body: Range<usize>,
    /// The line of the opening directive.
    pub line: usize,
}

/// A code block of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct CodeBlock {
    /// The info string of the fence; `None` for an indented block.
    pub info: Option<String>,
    /// The code.
    pub code: String,
    /// The bytes of the block, fences included.
    pub span: Range<usize>,
    /// The line of the opening fence.
    pub line: usize,
}

impl CodeBlock {
    /// The words of the info string.
    pub fn tags(&self) -> impl Iterator<Item = &str> {
        self.info
            .as_deref()
            .unwrap_or_default()
            .split([',', ' ', '\t'])
            .filter(|tag| !tag.is_empty())
    }

    /// Whether it is tagged `rust`.
    pub fn is_rust(&self) -> bool {
        self.tags().any(|tag| tag == "rust")
    }

    /// The error code that it must fail to compile with: `E0277` of `rust,compile_fail,E0277`.
    pub fn compile_fail(&self) -> Option<&str> {
        if !self.tags().any(|tag| tag == "compile_fail") {
            return None;
        }
        self.tags().find(|tag| {
            tag.strip_prefix('E')
                .is_some_and(|digits| digits.bytes().all(|b| b.is_ascii_digit()))
        })
    }
}

/// A formula of a page.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Formula {
    /// LaTeX.
    pub latex: String,
    /// Whether it stands on lines of its own.
    pub display: bool,
    /// The bytes it takes, dollar signs or fences included.
    pub span: Range<usize>,
    /// The line it begins in.
    pub line: usize,
}

/// Markdown as mdBook reads it, with formulas.
pub(crate) fn markdown() -> Markdown {
    Markdown::ENABLE_TABLES
        | Markdown::ENABLE_FOOTNOTES
        | Markdown::ENABLE_STRIKETHROUGH
        | Markdown::ENABLE_TASKLISTS
        | Markdown::ENABLE_HEADING_ATTRIBUTES
        | Markdown::ENABLE_DEFINITION_LIST
        | Markdown::ENABLE_GFM
        | Markdown::ENABLE_SMART_PUNCTUATION
        | Markdown::ENABLE_MATH
}

impl Page {
    /// Takes a page apart; what is wrong with it is added to `errors`.
    ///
    /// # Examples
    ///
    /// ```
    /// use cagd::book::page::Page;
    /// let text = "{{#statement bezier-blossom}}\nEach `{{#ref x}}` has a blossom $p$.\n{{/statement}}\n";
    /// let mut errors = Vec::new();
    /// let page = Page::parse("book/src/bezier/blossom.md", text, &mut errors);
    /// assert!(errors.is_empty());
    /// assert_eq!(page.chapter, Some("bezier"));
    /// assert_eq!(page.statements[0].id, "bezier-blossom");
    /// assert_eq!(page.formulas[0].latex, "p");
    /// assert_eq!(page.directives.len(), 2);
    /// ```
    pub fn parse(file: impl AsRef<Path>, text: &str, errors: &mut Vec<BookError>) -> Self {
        let file = file.as_ref();
        let chapter = CHAPTERS
            .into_iter()
            .find(|chapter| file.starts_with(Path::new("book/src").join(chapter)));
        let mut page = Self {
            file: file.to_owned(),
            chapter,
            text: text.to_owned(),
            directives: Vec::new(),
            statements: Vec::new(),
            code: Vec::new(),
            formulas: Vec::new(),
        };
        let opaque = page.read_markdown(errors);
        page.read_directives(&opaque, errors);
        page.read_blocks(errors);
        page
    }

    /// An error in the line that holds the byte `offset`.
    fn error(&self, offset: usize, problem: Problem) -> BookError {
        BookError::new(&self.file, line_of(&self.text, offset), problem)
    }

    /// Finds code blocks and formulas; returns the bytes in which no directive is looked for.
    fn read_markdown(&mut self, errors: &mut Vec<BookError>) -> Vec<Range<usize>> {
        let mut opaque = Vec::new();
        let mut open: Option<CodeBlock> = None;
        let text = std::mem::take(&mut self.text);
        let mut dollars = Vec::new();
        for (event, span) in Parser::new_ext(&text, markdown()).into_offset_iter() {
            match event {
                Event::Start(Tag::CodeBlock(kind)) => {
                    let info = match kind {
                        CodeBlockKind::Fenced(info) => Some(info.to_string()),
                        CodeBlockKind::Indented => None,
                    };
                    let line = line_of(&text, span.start);
                    let code = String::new();
                    open = Some(CodeBlock {
                        info,
                        code,
                        span,
                        line,
                    });
                }
                Event::End(TagEnd::CodeBlock) => {
                    if let Some(block) = open.take() {
                        if block.info.as_deref().map(str::trim) == Some("math") {
                            self.formulas.push(Formula {
                                latex: block.code.trim().to_owned(),
                                display: true,
                                span: block.span.clone(),
                                line: block.line,
                            });
                        }
                        opaque.push(block.span.clone());
                        self.code.push(block);
                    }
                }
                Event::Text(piece) => match &mut open {
                    Some(block) => block.code.push_str(&piece),
                    None => dollars.extend(stray_dollars(&text, span)),
                },
                Event::InlineMath(latex) => {
                    opaque.push(span.clone());
                    self.formulas.push(Formula {
                        latex: latex.to_string(),
                        display: false,
                        line: line_of(&text, span.start),
                        span,
                    });
                }
                Event::DisplayMath(_) => {
                    opaque.push(span.clone());
                    dollars.push((span.start, "$$"));
                }
                Event::Code(_) => opaque.push(span),
                Event::Html(html) | Event::InlineHtml(html) if html.starts_with("<!--") => {
                    opaque.push(span);
                }
                _ => {}
            }
        }
        self.text = text;
        for (offset, sign) in dollars {
            let remedy = match sign {
                "$$" => "write a display formula in a ```math fence",
                _ => "close the formula it opens, or write `\\$` for the sign itself",
            };
            let problem = Problem::StrayDollar { sign, remedy };
            errors.push(self.error(offset, problem));
        }
        opaque
    }

    /// Finds the directives outside the bytes `opaque`.
    fn read_directives(&mut self, opaque: &[Range<usize>], errors: &mut Vec<BookError>) {
        let mut from = 0;
        while let Some(found) = self.text[from..].find("{{") {
            let start = from + found;
            if let Some(range) = opaque.iter().find(|range| range.contains(&start)) {
                from = range.end.max(start + 2);
                continue;
            }
            let line_end = self.text[start..]
                .find('\n')
                .map_or(self.text.len(), |end| start + end);
            let Some(close) = self.text[start..line_end].find("}}") else {
                errors.push(self.error(start, Problem::UnclosedBraces));
                from = line_end;
                continue;
            };
            let span = start..start + close + 2;
            from = span.end;
            let source = &self.text[span.clone()];
            match Action::parse(source) {
                Err(problem) => errors.push(self.error(start, problem)),
                Ok(action) => {
                    let line_start = self.text[..start].rfind('\n').map_or(0, |at| at + 1);
                    let alone =
                        line_start == start && self.text[span.end..line_end].trim().is_empty();
                    if action.is_block() && !alone {
                        let found = source.to_owned();
                        errors.push(self.error(start, Problem::NotAlone { found }));
                    }
                    let line = line_of(&self.text, start);
                    self.directives.push(Directive {
                        action,
                        span,
                        line,
                        alone,
                    });
                }
            }
        }
    }

    /// Pairs opening and closing directives, and fills the statements.
    fn read_blocks(&mut self, errors: &mut Vec<BookError>) {
        let mut statement: Option<StatementBlock> = None;
        let mut inner: Option<(Block, Directive)> = None;
        for directive in &self.directives {
            let source = || self.text[directive.span.clone()].to_owned();
            let misplaced = |rule| {
                let found = source();
                self.error(directive.span.start, Problem::Misplaced { found, rule })
            };
            match &directive.action {
                Action::Statement { id, options } => {
                    self.abandon(&mut inner, errors);
                    if let Some(open) = statement.take() {
                        errors.push(self.unclosed(open.span.clone(), Block::Statement));
                    }
                    if self.chapter.is_none() {
                        errors.push(misplaced("statements stand in the folder of their chapter"));
                    }
                    statement = Some(StatementBlock {
                        id: id.clone(),
                        options: options.clone(),
                        span: directive.span.clone(),
                        line: directive.line,
                        proofs: Vec::new(),
                        errata: Vec::new(),
                        figures: Vec::new(),
                        code: Vec::new(),
                    });
                }
                Action::Proof | Action::Errata => {
                    self.abandon(&mut inner, errors);
                    if statement.is_none() {
                        errors.push(misplaced(
                            "it belongs between `{{#statement …}}` and `{{/statement}}`",
                        ));
                    }
                    let block = match directive.action {
                        Action::Proof => Block::Proof,
                        _ => Block::Errata,
                    };
                    inner = Some((block, directive.clone()));
                }
                Action::Close(Block::Statement) => {
                    self.abandon(&mut inner, errors);
                    match statement.take() {
                        Some(mut open) => {
                            open.span.end = directive.span.end;
                            self.statements.push(open);
                        }
                        None => errors.push(self.unopened(directive, "no statement is open")),
                    }
                }
                Action::Close(block) => match inner.take() {
                    Some((open, opening)) if open == *block => {
                        let found = InnerBlock {
                            span: opening.span.start..directive.span.end,
                            body: opening.span.end..directive.span.start,
                            line: opening.line,
                        };
                        if let Some(statement) = &mut statement {
                            match block {
                                Block::Proof => statement.proofs.push(found),
                                _ => statement.errata.push(found),
                            }
                        }
                    }
                    Some((open, opening)) => {
                        let state = format!(
                            "line {} opened what {} would close",
                            opening.line,
                            open.closing()
                        );
                        errors.push(self.unopened(directive, &state));
                        inner = Some((open, opening));
                    }
                    None => errors.push(self.unopened(directive, "nothing of the kind is open")),
                },
                Action::Figure { id } => {
                    if let Some(statement) = &mut statement {
                        statement.figures.push((id.clone(), directive.line));
                    }
                }
                _ => {}
            }
        }
        self.abandon(&mut inner, errors);
        if let Some(open) = statement {
            errors.push(self.unclosed(open.span, Block::Statement));
        }
        for statement in &mut self.statements {
            statement.code = (0..self.code.len())
                .filter(|&index| statement.span.contains(&self.code[index].span.start))
                .collect();
        }
    }

    /// Reports a proof or erratum that is still open.
    fn abandon(&self, inner: &mut Option<(Block, Directive)>, errors: &mut Vec<BookError>) {
        if let Some((block, opening)) = inner.take() {
            errors.push(self.unclosed(opening.span, block));
        }
    }

    /// The error of an opening directive that is not closed.
    fn unclosed(&self, opening: Range<usize>, block: Block) -> BookError {
        let problem = Problem::Unclosed {
            opening: self.text[opening.clone()].to_owned(),
            closing: block.closing(),
        };
        self.error(opening.start, problem)
    }

    /// The error of a closing directive that closes nothing.
    fn unopened(&self, directive: &Directive, state: &str) -> BookError {
        let problem = Problem::Unopened {
            found: self.text[directive.span.clone()].to_owned(),
            state: state.to_owned(),
        };
        self.error(directive.span.start, problem)
    }
}

/// The dollar signs in a piece of text that are not written `\$`.
fn stray_dollars(text: &str, span: Range<usize>) -> Vec<(usize, &'static str)> {
    let mut found = Vec::new();
    let mut offset = span.start;
    while let Some(at) = text[offset..span.end].find('$') {
        let start = offset + at;
        offset = start + 1;
        if text[..start].ends_with('\\') {
            continue;
        }
        if text[offset..span.end].starts_with('$') {
            offset += 1;
            found.push((start, "$$"));
        } else {
            found.push((start, "$"));
        }
    }
    found
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The page with this text, and its errors as `line: message`.
    fn parse(text: &str) -> (Page, Vec<String>) {
        let mut errors = Vec::new();
        let page = Page::parse("book/src/bezier/x.md", text, &mut errors);
        let errors = errors
            .iter()
            .map(|e| format!("{}: {}", e.place.line, e.problem))
            .collect();
        (page, errors)
    }

    #[test]
    fn code_and_formulas_hide_directives() {
        let text = "`{{#ref a}}` and\n\n```text\n{{#ref b}}\n```\n\n$x_{{#ref c}}$ {{#ref d}}\n";
        let (page, errors) = parse(text);
        assert_eq!(errors, [""; 0]);
        assert_eq!(page.directives.len(), 1);
        assert_eq!(page.directives[0].line, 7);
    }

    #[test]
    fn a_statement_knows_its_parts() {
        let text = "{{#statement bezier-x}}\nText.\n```rust\nassert!(true);\n```\n{{#proof}}\nClear.\n{{/proof}}\n{{#figure bezier-x}}\n{{/statement}}\n";
        let (page, errors) = parse(text);
        assert_eq!(errors, [""; 0]);
        let statement = &page.statements[0];
        assert_eq!(statement.line, 1);
        assert_eq!(statement.code, [0]);
        assert_eq!(statement.proofs[0].line, 6);
        assert_eq!(&text[statement.proofs[0].body.clone()], "\nClear.\n");
        assert_eq!(statement.figures, [("bezier-x".to_owned(), 9)]);
    }

    #[test]
    fn unclosed_blocks_are_reported_with_the_line_that_opens_them() {
        let (_, errors) =
            parse("\n{{#statement bezier-x}}\n{{#proof}}\n{{/statement}}\n{{/proof}}\n");
        assert!(
            errors[0].starts_with("3: `{{#proof}}` is never closed"),
            "{errors:?}"
        );
        assert!(
            errors[1].starts_with("5: `{{/proof}}` closes nothing"),
            "{errors:?}"
        );
        let (_, errors) = parse("{{#statement bezier-x}}\n");
        assert!(errors[0].starts_with("1: `{{#statement bezier-x}}` is never closed"));
    }

    #[test]
    fn dollars_outside_formulas_are_refused() {
        let (_, errors) = parse("It costs \\$5.\n\nA $$x$$ and\n\na $ b.\n");
        assert_eq!(errors.len(), 2, "{errors:?}");
        assert!(errors[1].starts_with("5: this `$` "), "{errors:?}");
        assert!(errors[0].starts_with("3: this `$$` "), "{errors:?}");
    }
}
